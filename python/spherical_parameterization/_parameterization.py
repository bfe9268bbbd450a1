from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import check_word, read_faces, read_points, read_surface, refuse
from ._errors import Error


@dataclass(frozen=True)
class Report:
    """What `parameterize` did.

    Attributes
    ----------
    number_of_vertices, number_of_faces : int
        What was mapped.
    number_of_isolated_vertices : int
        Vertices without a face, which have no image.
    number_of_flat_faces : int
        Faces (nearly) without area, mapped as if they were a little less flat.
    radius : float
        The radius of the sphere, in the unit of length of the mesh.
    stop_reason : str
        Why the run ended: "converged", "iteration limit", "time limit", "stopped by the visitor" (the callback or an
        interruption) or "no acceptable step left".
    number_of_levels : int
        Levels of the hierarchy that the first map was made by.
    number_of_iterations : int
        Sweeps over the mesh.
    initial_energy, average_energy, largest_energy : float
        The energy of a face: the average of the first map, the average and the largest of the last one.
    seconds : float
        The time of the run.
    """

    number_of_vertices: int
    number_of_faces: int
    number_of_isolated_vertices: int
    number_of_flat_faces: int
    radius: float
    stop_reason: str
    number_of_levels: int
    number_of_iterations: int
    initial_energy: float
    average_energy: float
    largest_energy: float
    seconds: float


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


def parameterize(
    vertices: ArrayLike,
    faces: ArrayLike,
    prefer: str = "balance",
    energy: str = "symmetric-dirichlet",
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    callback: Optional[Callable[[int, float, float], Any]] = None,
    initial: Optional[ArrayLike] = None,
    on_interrupt: str = "raise",
) -> Tuple[NDArray[np.float64], Report]:
    """Maps a closed triangle mesh without handles one-to-one to a sphere around the origin, with low distortion.

    The map is certified by exact arithmetic, also if it was stopped early. It has the same bits for any number of
    threads.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle, counterclockwise as seen from outside.
    prefer : {"balance", "average", "worst", "sampling"}
        The lowest average distortion, the lowest worst, or a balance of both. Or samples that are even on the sphere
        and as even as possible on the surface, for `remesh` and `transfer`.
    energy : {"symmetric-dirichlet", "isometric", "conformal", "stretch"}
        What is lowered. "conformal" keeps angles, and its sphere has the radius 1. ``prefer="sampling"`` has an energy
        of its own, "stretch".
    threads : int, optional
        The largest number of threads; by default all cores.
    time_limit : float, optional
        The time in seconds after which the map reached by then is returned. The first map is completed in any case.
    callback : callable, optional
        Called after each sweep over the mesh as ``callback(iteration, energy, radius)``. If it returns a false value
        other than None, the map reached by then is returned. What it raises reaches the caller.
    initial : (n, 3) array_like of numbers, optional
        The map to start from, one-to-one, at any distance from the origin.
    on_interrupt : {"raise", "return"}
        What Ctrl-C does: raise KeyboardInterrupt, or return the map reached by then. It is noticed between two sweeps,
        and between the levels of the first map.

    Returns
    -------
    sphere : (n, 3) ndarray of float64
        The images of the vertices; NaN for vertices without a face.
    report : Report
        What the run did.

    Raises
    ------
    Error
        If the mesh has no such map, see `find_defect`; if `initial` is not one-to-one; if a parameter is out of its
        range.
    """
    check_word("prefer", prefer, ("balance", "average", "worst", "sampling"))
    check_word("energy", energy, ("symmetric-dirichlet", "isometric", "conformal", "stretch"))
    if prefer == "sampling":
        if energy not in ("symmetric-dirichlet", "stretch"):
            refuse('prefer="sampling" has an energy of its own: leave out energy')
        energy = "stretch"
    check_word("on_interrupt", on_interrupt, ("raise", "return"))
    max_threads = 0 if threads is None else operator.index(threads)
    if threads is not None and not 1 <= max_threads < 2**31:
        refuse(f"threads is {threads}; it has to be at least 1")
    max_seconds = 0.0 if time_limit is None else float(time_limit)
    if time_limit is not None and not max_seconds > 0:
        refuse(f"time_limit is {time_limit}; it has to be positive")
    if callback is not None and not callable(callback):
        raise TypeError(f"callback is {callback!r}; it has to be a function")
    points = read_points("vertices", vertices)
    first_images = None if initial is None else read_points("initial", initial, len(points))
    sphere, report = _core.parameterize(
        points,
        read_faces("faces", faces),
        prefer,
        energy,
        max_threads,
        max_seconds,
        callback,
        first_images,
        on_interrupt == "return",
    )
    return sphere, Report(**report)


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


def is_bijective(sphere: ArrayLike, faces: ArrayLike) -> bool:
    """Returns whether a map from a mesh to the sphere is one-to-one, by exact arithmetic.

    Parameters
    ----------
    sphere : (n, 3) array_like of numbers
        The images of the vertices, at any distance from the origin; those of vertices without a face do not matter.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.

    Returns
    -------
    bool
        False as well if the faces are no closed surface without handles, or a coordinate is not finite.

    Raises
    ------
    Error
        If the arrays are no mesh: they have another shape, or an index is out of its range.
    """
    return _core.is_bijective(read_points("sphere", sphere), read_faces("faces", faces))


def measure_distortion(vertices: ArrayLike, faces: ArrayLike, sphere: ArrayLike) -> Distortion:
    """Measures how much a map to the sphere distorts the faces of a mesh, each one and all together.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle. They need not be a closed surface.
    sphere : (n, 3) array_like of numbers
        The images of the vertices.

    Returns
    -------
    Distortion
        The measures, face by face, and their statistics.

    Raises
    ------
    Error
        If the arrays are no mesh, there is no face, or two faces use an edge in the same direction.
    """
    result = _core.measure_distortion(*read_surface(vertices, faces, sphere))
    for name in ("isometric", "area", "angle"):
        result[name] = Measure(*result[name])
    return Distortion(**result)
