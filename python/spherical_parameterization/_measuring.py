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
    """One measure of distortion: its value for each face, and statistics over the faces.

    Degenerate faces are excluded from the statistics.

    Attributes
    ----------
    values : (m,) ndarray of float64
        Values of the faces; infinite for faces without area, in space or on the sphere.
    maximum, average, deviation : float
        Maximum, mean and standard deviation. Each face counts the same.
    """

    values: NDArray[np.float64]
    maximum: float
    average: float
    deviation: float


@dataclass(frozen=True)
class Distortion:
    """Distortion of the faces of a mesh by a map to the sphere.

    With s1 <= s2 the singular values of the map of a face:

    Attributes
    ----------
    isometric : Measure
        max(s2, 1 / s1), the largest factor by which a length changes: 1 for an isometry.
    area : Measure
        s1 s2 + 1 / (s1 s2): 2 if the area is preserved.
    angle : Measure
        s1 / s2 + s2 / s1: 2 if the angles are preserved.
    is_inverted : (m,) ndarray of bool
        Whether a face is not positively oriented as seen from the origin, by an exact predicate.
    radius : float
        Mean distance of the images from the origin.
    number_of_inverted_faces, number_of_degenerate_faces : int
        Degenerate faces are too thin to have a distortion. They are excluded from the statistics. If all faces are
        degenerate, the statistics are infinite.
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
    """Find the defect that prevents a mesh from being mapped to the sphere.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle.

    Returns
    -------
    Error or None
        The error that `parameterize` would raise, with the defect, its location and a remedy; None if the mesh can be
        mapped.

    Raises
    ------
    Error
        If the arrays are not a mesh: their shapes are wrong, or an index is out of range.

    See Also
    --------
    repair_surface : Repair defects.

    Notes
    -----
    The time is linear in the size of the mesh.

    Examples
    --------
    >>> sp.find_defect(vertices, faces) is None
    True
    >>> sp.find_defect(vertices, faces[1:]).code.name
    'NON_CLOSED_MESH'
    """
    try:
        _core.find_defect(read_points("vertices", vertices), read_faces("faces", faces))
    except Error as error:
        if error.code == _core.ErrorCode.WRONG_PARAMETER:
            raise
        return error.with_traceback(None)
    return None


def is_bijective(faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> bool:
    """Check by exact arithmetic whether a map to the sphere is bijective.

    Parameters
    ----------
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    sphere : (n, 3) array_like of float
        Images of the vertices, which need not be normalized. Images of vertices without a face are ignored.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    bool
        Whether the map is bijective. Also False if the faces are not a closed surface of genus 0, or if a coordinate is
        not finite.

    Raises
    ------
    Error
        If the arrays are not a mesh: their shapes are wrong, or an index is out of range.

    Notes
    -----
    A map is bijective if and only if every face is positively oriented as seen from the origin and the faces cover the
    sphere once. The time is linear in the number of faces.

    Examples
    --------
    >>> sp.is_bijective(faces, sphere)
    True
    >>> sp.is_bijective(faces, -sphere)
    False
    """
    return _core.is_bijective(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))


def round_to_float(faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> NDArray[np.float32]:
    """Round a map to the sphere to single precision and keep it bijective.

    Many file formats hold coordinates in single precision.

    Parameters
    ----------
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    sphere : (n, 3) array_like of float
        Images of the vertices, a bijective map.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    (n, 3) ndarray of float32
        Rounded images, certified bijective by exact arithmetic: the nearest single-precision coordinates or, where these
        invert a face, others nearby. Images of vertices without a face are rounded to the nearest.

    Raises
    ------
    Error
        If the map is not bijective; if no such images were found, for example where hundreds of vertices are closer to each
        other than the resolution of single precision; or if the arrays are not a closed mesh.

    Examples
    --------
    >>> rounded = sp.round_to_float(faces, sphere)
    >>> sp.is_bijective(faces, rounded)
    True
    """
    return _core.round_to_float(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))


class SulcalMeasures(NamedTuple):
    """Curvature and depth at each vertex: positive in sulci, negative on gyri.

    Attributes
    ----------
    curvature : (n,) ndarray of float64
        Mean curvature, in the reciprocal of the unit of the coordinates.
    depth : (n,) ndarray of float64
        Depth of the vertex below the smoothed surface, in the unit of the coordinates; its mean is 0.
    inflated_curvature : (n,) ndarray of float64
        Mean curvature of the smoothed surface, which has only the lobes and the deepest sulci.
    """

    curvature: NDArray[np.float64]
    depth: NDArray[np.float64]
    inflated_curvature: NDArray[np.float64]


@accepts_mesh
def compute_sulcal_measures(vertices: ArrayLike, faces: ArrayLike, *, threads: Optional[int] = None) -> SulcalMeasures:
    """Compute the curvature and the sulcal depth of a surface, such as a cortical surface.

    The measures can be features for `map_surface`.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle, counterclockwise as seen from outside.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    SulcalMeasures
        The measures; 0 for vertices without a face.

    Raises
    ------
    Error
        If the mesh is not a closed surface of genus 0, see `find_defect`.

    Notes
    -----
    The surface is smoothed by implicit mean curvature flow, in units in which its area is 1: for the time 1.5e-5 for the
    curvature and 1e-3 for the depth. The measures are invariant under rigid motions and, up to sampling errors,
    independent of the triangulation. The time is O(n**1.5).

    Examples
    --------
    The measures of two cortical surfaces guide the map from one to the other:

    >>> first = sp.compute_sulcal_measures(vertices, faces)
    >>> other = sp.remesh(vertices, faces, sphere, ("icosahedron", 5))
    >>> second = sp.compute_sulcal_measures(other.vertices, other.faces)
    >>> features = [(first.depth, second.depth), (first.inflated_curvature, second.inflated_curvature)]
    >>> directions, report = sp.map_surface(
    ...     (vertices, faces, sphere), other, features=features, feature_weight=2, compare_values=True
    ... )
    """
    return SulcalMeasures(
        *_core.compute_sulcal_measures(read_points("vertices", vertices), read_faces("faces", faces), read_threads(threads))
    )


@accepts_mesh
def measure_distortion(
    vertices: ArrayLike, faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None
) -> Distortion:
    """Measure how much a map to the sphere distorts the faces of a mesh.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle. They need not form a closed surface.
    sphere : (n, 3) array_like of float
        Images of the vertices.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    Distortion
        The measures of each face and their statistics.

    Raises
    ------
    Error
        If the arrays are not a mesh, if there is no face, or if two faces traverse an edge in the same direction.

    Notes
    -----
    The measures are those of equations 12 to 14 of [1]_. The time is linear in the number of faces.

    References
    ----------
    .. [1] C. Wang, X. Hu, X. Fu, L. Liu: Bijective spherical parametrization with low distortion. Computers & Graphics 58,
       2016.

    Examples
    --------
    >>> distortion = sp.measure_distortion(vertices, faces, sphere)
    >>> distortion.isometric.values.shape, distortion.number_of_inverted_faces
    ((512,), 0)
    """
    result = _core.measure_distortion(*read_surface(vertices, faces, sphere), read_threads(threads))
    for name in ("isometric", "area", "angle"):
        result[name] = Measure(*result[name])
    return Distortion(**result)


class OneWayDistance(NamedTuple):
    """Distances from points of one surface to the nearest points of another one.

    Attributes
    ----------
    root_mean_square : float
        Root mean square distance, in the unit of the surfaces.
    maximum : float
        Maximum distance, in the unit of the surfaces.
    """

    root_mean_square: float
    maximum: float


@dataclass(frozen=True)
class SurfaceDistance:
    """Distance between two surfaces.

    Attributes
    ----------
    from_first, from_second : OneWayDistance
        Distances from points of the first surface to the second one, and from points of the second one to the first.
    diagonal : float
        Diagonal of the bounding box of the first surface.
    """

    from_first: OneWayDistance
    from_second: OneWayDistance
    diagonal: float

    @property
    def psnr(self) -> float:
        """Peak signal-to-noise ratio in decibels: 20 log10 of the diagonal over the larger root mean square distance."""
        error = max(self.from_first.root_mean_square, self.from_second.root_mean_square)
        with np.errstate(all="ignore"):  # infinite if the distance is 0
            return float(20 * np.log10(np.divide(self.diagonal, error)))


def measure_distance(
    surface1: Union[Tuple[ArrayLike, ArrayLike], Mesh],
    surface2: Union[Tuple[ArrayLike, ArrayLike], Mesh],
    *,
    number_of_points: int = 30000,
    threads: Optional[int] = None,
) -> SurfaceDistance:
    """Measure the distance between two surfaces, such as a surface and its remesh.

    Points are spread evenly over the area of each surface. The distance from each point to the nearest point of the other
    surface is measured. The points, and so the result, are always the same for the same meshes.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces)
        Each surface: its points, (n, 3) float, and its triangles, (m, 3) int; or a mesh object. They need not be closed.
    number_of_points : int
        Number of points on each surface, at least 1.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    SurfaceDistance
        The distances, in the unit of length of the surfaces.

    Raises
    ------
    Error
        If arrays are not a mesh, if there is no face, if two faces traverse an edge in the same direction, or if a point is
        not finite.

    Notes
    -----
    The maximum is a lower bound of the Hausdorff distance, because it is that of the sampled points. The time is usually
    O((n + k) log n) for n faces and k points.

    Examples
    --------
    >>> even = sp.remesh(vertices, faces, sphere, ("octahedron", 16))
    >>> sp.measure_distance((vertices, faces), (even.vertices, even.faces)).psnr > 30
    True
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
