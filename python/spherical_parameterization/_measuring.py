from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import read_faces, read_points, read_surface, read_threads, read_tuple, refuse
from ._errors import Error
from ._meshes import Mesh, accepts_mesh, is_mesh


@dataclass(frozen=True)
class Measure:
    """One measure of distortion: its value for each face, and their statistics, without degenerate faces.

    Attributes
    ----------
    values : (m,) ndarray of float64
        Infinite for faces that have no area, in space or on the sphere.
    maximum, average, deviation : float
        Each face counts the same.
    """

    values: NDArray[np.float64]
    maximum: float
    average: float
    deviation: float


@dataclass(frozen=True)
class Distortion:
    """How much a map distorts faces. With s1 <= s2 the singular values of the map of a face:

    Attributes
    ----------
    isometric : Measure
        max(s2, 1 / s1), the largest factor by which a length is wrong: 1 for an isometry.
    area : Measure
        s1 s2 + 1 / (s1 s2): 2 if the area stays the same.
    angle : Measure
        s1 / s2 + s2 / s1: 2 if the angles stay the same.
    is_inverted : (m,) ndarray of bool
        Whether a face is not positively oriented as seen from the origin, by an exact predicate.
    radius : float
        The average distance of the images from the origin.
    number_of_inverted_faces, number_of_degenerate_faces : int
        Degenerate faces are too thin to have a distortion, and left out of the statistics; if all are, these are infinite.
    """

    isometric: Measure
    area: Measure
    angle: Measure
    is_inverted: NDArray[np.bool_]
    radius: float
    number_of_inverted_faces: int
    number_of_degenerate_faces: int


@accepts_mesh
def find_defect(vertices: ArrayLike, faces: ArrayLike) -> Optional[Error]:
    """Returns what keeps a mesh from being mapped to the sphere, or None if nothing does.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.

    Returns
    -------
    Error or None
        What `parameterize` would raise: what is wrong, where, and what helps.

    Raises
    ------
    Error
        If the arrays are no mesh: they have another shape, or an index is out of its range.
    """
    try:
        _core.find_defect(read_points("vertices", vertices), read_faces("faces", faces))
    except Error as error:
        if error.code == _core.ErrorCode.WRONG_PARAMETER:
            raise
        return error.with_traceback(None)
    return None


def is_bijective(faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> bool:
    """Returns whether a map from a mesh to the sphere is one-to-one, by exact arithmetic.

    Parameters
    ----------
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    sphere : (n, 3) array_like of numbers
        The images of the vertices, at any distance from the origin; those of vertices without a face do not matter.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    bool
        False as well if the faces are no closed surface without handles, or a coordinate is not finite.

    Raises
    ------
    Error
        If the arrays are no mesh: they have another shape, or an index is out of its range.

    Notes
    -----
    A map is one-to-one if and only if every face is positively oriented as seen from the origin and the faces cover the
    sphere once. The time is linear in the number of faces.
    """
    return _core.is_bijective(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))


def round_to_float(faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> NDArray[np.float32]:
    """Rounds a map to the sphere to numbers of 32 bits, as many files hold them, such that it stays one-to-one.

    Parameters
    ----------
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    sphere : (n, 3) array_like of numbers
        The images of the vertices, a one-to-one map.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    (n, 3) numpy.ndarray of float32
        The images, by exact arithmetic one-to-one as they are: the nearest numbers, or, where these fold a face, others
        nearby. Those of vertices without a face are rounded.

    Raises
    ------
    Error
        If the map is not one-to-one, or no such images were found, as where hundreds of vertices have less room than these
        numbers tell apart; or if the arrays are no closed mesh.
    """
    return _core.round_to_float(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))


class SulcalMeasures(NamedTuple):
    """How a surface is folded: a number for each vertex, positive in furrows and negative on ridges.

    Attributes
    ----------
    curvature : (n,) ndarray of float64
        Mean curvature, in units of one over that of the coordinates.
    depth : (n,) ndarray of float64
        How far the vertex is inside of the smoothed surface, in the unit of the coordinates; 0 on average.
    inflated_curvature : (n,) ndarray of float64
        Mean curvature of the smoothed surface, which has the lobes and the deepest furrows alone.
    """

    curvature: NDArray[np.float64]
    depth: NDArray[np.float64]
    inflated_curvature: NDArray[np.float64]


@accepts_mesh
def compute_sulcal_measures(vertices: ArrayLike, faces: ArrayLike, *, threads: Optional[int] = None) -> SulcalMeasures:
    """Measures the curvature and the depth of the folds of a surface, such as a cortex: features for `map_surface`.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points.
    faces : (m, 3) array_like of integers
        The vertices of each triangle, counterclockwise as seen from outside.
    threads : int, optional
        The largest number of threads; by default all cores. The result does not depend on it.

    Returns
    -------
    SulcalMeasures
        0 for vertices without a face.

    Raises
    ------
    Error
        If the arrays are no closed surface without handles.

    Notes
    -----
    The surface is smoothed by heat that is conducted on it, for times in units of its area: 1.5e-5 for the curvature and
    1e-3 for the depth. So the values do not depend on where the surface is and how it is sampled.

    Examples
    --------
    The folds of two cortical surfaces lead a map from one to the other:

    >>> folding1, folding2 = sp.compute_sulcal_measures(vertices1, faces1), sp.compute_sulcal_measures(vertices2, faces2)
    >>> features = [(folding1.depth, folding2.depth), (folding1.inflated_curvature, folding2.inflated_curvature)]
    >>> directions, report = sp.map_surface(surface1, surface2, features=features, feature_weight=2, compare_values=True)
    """
    return SulcalMeasures(
        *_core.compute_sulcal_measures(read_points("vertices", vertices), read_faces("faces", faces), read_threads(threads))
    )


@accepts_mesh
def measure_distortion(
    vertices: ArrayLike, faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None
) -> Distortion:
    """Measures how much a map to the sphere distorts the faces of a mesh, each one and all together.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle. They need not be a closed surface.
    sphere : (n, 3) array_like of numbers
        The images of the vertices.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    Distortion
        The measures, face by face, and their statistics.

    Raises
    ------
    Error
        If the arrays are no mesh, there is no face, or two faces use an edge in the same direction.

    Notes
    -----
    The measures are those of equations 12 to 14 of [1]_. The time is linear in the number of faces.

    References
    ----------
    .. [1] C. Wang, X. Hu, X. Fu, L. Liu: Bijective spherical parametrization with low distortion. Computers & Graphics 58,
       2016.
    """
    result = _core.measure_distortion(*read_surface(vertices, faces, sphere), read_threads(threads))
    for name in ("isometric", "area", "angle"):
        result[name] = Measure(*result[name])
    return Distortion(**result)


class OneWayDistance(NamedTuple):
    """Distances from places of one surface to the nearest places of another one, in their unit of length.

    Attributes
    ----------
    root_mean_square : float
        The root of the mean of their squares.
    maximum : float
        The largest one.
    """

    root_mean_square: float
    maximum: float


@dataclass(frozen=True)
class SurfaceDistance:
    """How far two surfaces are apart.

    Attributes
    ----------
    from_first, from_second : OneWayDistance
        From places of the first surface to the second one, and the other way.
    diagonal : float
        The diagonal of the bounding box of the first surface.
    """

    from_first: OneWayDistance
    from_second: OneWayDistance
    diagonal: float

    @property
    def psnr(self) -> float:
        """The peak signal-to-noise ratio in decibels, 20 log10 of the diagonal over the larger root mean square."""
        error = max(self.from_first.root_mean_square, self.from_second.root_mean_square)
        with np.errstate(all="ignore"):  # infinite for a distance of 0
            return float(20 * np.log10(np.divide(self.diagonal, error)))


def measure_distance(
    surface1: Union[Tuple[ArrayLike, ArrayLike], Mesh],
    surface2: Union[Tuple[ArrayLike, ArrayLike], Mesh],
    *,
    number_of_points: int = 30000,
    threads: Optional[int] = None,
) -> SurfaceDistance:
    """Measures how far two surfaces are apart, such as a surface and its remesh.

    From places of each, spread evenly over its area, the distances to the nearest places of the other one are measured. The
    places are always the same for the same meshes, so that the result is, too.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces)
        Each surface: its points, (n, 3) numbers, and its triangles, (m, 3) integers. They need not be closed.
    number_of_points : int
        The number of places on each surface, at least 1.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    SurfaceDistance
        The distances, in the unit of length of the surfaces.

    Raises
    ------
    Error
        If arrays are no mesh, there is no face, two faces use an edge in the same direction, or a point is not finite.

    Notes
    -----
    The maximum is a lower bound of the Hausdorff distance, as it is that of the places. The time is O((n + k) log n) for n
    faces and k places, as a rule.
    """
    n = operator.index(number_of_points)
    if not 1 <= n < 2**31:
        refuse(f"number_of_points is {n}; it has to be from 1 to {2**31 - 1}")
    arrays = []
    for name, surface in (("surface1", surface1), ("surface2", surface2)):
        vertices, faces = read_tuple(name, (surface,) if is_mesh(surface) else surface, "vertices", "faces")
        arrays += [read_points(f"{name}: vertices", vertices), read_faces(f"{name}: faces", faces)]
    from_first, from_second, diagonal = _core.measure_distance(*arrays, n, read_threads(threads))
    return SurfaceDistance(OneWayDistance(*from_first), OneWayDistance(*from_second), diagonal)
