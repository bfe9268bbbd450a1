from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import check_word, read_density, read_faces, read_points, read_run, refuse
from ._meshes import accepts_mesh


MAX_DEVIATION_OF_AREAS = 0.01  # from which on a warning is given; they count as reached up to 0.001


@dataclass(frozen=True)
class Areas:
    """How near `parameterize` has come to the areas that were wanted.

    Attributes
    ----------
    ratios : (n,) ndarray of float64
        The area of the cell of each vertex on the sphere, a third of that of the spherical triangles around it, over the
        area that was wanted; 1 for vertices without a face.
    deviation : float
        The standard deviation of the ratios over their mean.
    largest_deviation : float
        The largest difference of a ratio from 1.
    number_of_off_vertices : int
        Vertices whose ratio differs from 1 by more than 0.01.
    number_of_raised_faces : int
        Faces whose area times density is below a millionth of the mean, which was wanted for them instead: ratios and
        `is_reached` are about that.
    number_of_steps : int
        Steps of all vertices together, after the sweeps.
    is_reached : bool
        Whether the deviation is at most 0.001.
    """

    ratios: NDArray[np.float64]
    deviation: float
    largest_deviation: float
    number_of_off_vertices: int
    number_of_raised_faces: int
    number_of_steps: int
    is_reached: bool


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
        Why the run ended, which does not tell whether areas are as wanted: "converged", "iteration limit", "time limit", "stopped by the visitor" (the callback or an
        interruption) or "no acceptable step left".
    number_of_levels : int
        Levels of the hierarchy that the first map was made by.
    used_last_resort : bool
        Whether the hierarchy has found no map, so that the first one is Schnyder's, which always exists.
    number_of_iterations : int
        Sweeps over the mesh.
    initial_energy, average_energy, largest_energy : float
        The energy of a face: the average of the first map, the average and the largest of the last one.
    seconds : float
        The time of the run.
    areas : Areas or None
        How near the areas are to what was wanted, if `density` was given.
    """

    number_of_vertices: int
    number_of_faces: int
    number_of_isolated_vertices: int
    number_of_flat_faces: int
    radius: float
    stop_reason: str
    number_of_levels: int
    used_last_resort: bool
    number_of_iterations: int
    initial_energy: float
    average_energy: float
    largest_energy: float
    seconds: float
    areas: Optional[Areas] = None


@accepts_mesh
def parameterize(
    vertices: ArrayLike,
    faces: ArrayLike,
    *,
    prefer: str = "balance",
    energy: str = "symmetric-dirichlet",
    initial: Union[ArrayLike, str, None] = None,
    density: Union[ArrayLike, str, None] = None,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    callback: Optional[Callable[[int, float, float], Any]] = None,
    on_interrupt: str = "raise",
) -> Tuple[NDArray[np.float64], Report]:
    """Maps a closed triangle mesh without handles one-to-one to a sphere around the origin, with low distortion.

    The map is certified by exact arithmetic, also if it was stopped early. Every closed triangle mesh without handles has
    one, also in double precision, by a theorem up to 10,000,000 vertices.

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
        What is lowered. "conformal" keeps angles, on a sphere of the radius 1 unless there is a `density`, against which it
        works: with it, areas are missed on most surfaces with extremities. ``prefer="sampling"`` has an energy of its own, "stretch".
    initial : (n, 3) array_like of numbers or "schnyder", optional
        The map to start from, one-to-one, at any distance from the origin; or Schnyder's, which the connectivity decides, and which
        is one-to-one by a theorem. By default, a hierarchy finds one.
    density : (n,) or (m,) array_like of numbers or "equal", optional
        What share of the sphere each part of the surface gets: that of its area times a density, finite, at least 0, and in any
        unit; "equal" is 1 everywhere. It is given for each face, or for each vertex, whose mean over the three of a face is that
        of the face. Faces that are to get less than a millionth of the mean area, as by a density of 0, get a millionth. The
        areas are those of the cells of vertices, see `Areas`; smooth densities are met up to a contrast of a million, those with
        steps may be missed, which `Areas` tells. Not with `initial`; it takes some times longer.
    threads : int, optional
        The largest number of threads; by default all cores. The map has the same bits with any number.
    time_limit : float, optional
        The time in seconds after which the map reached by then is returned. The first map is completed in any case.
    callback : callable, optional
        Called after each sweep over the mesh as ``callback(iteration, energy, radius)``. If it returns a false value
        other than None, the map reached by then is returned. What it raises reaches the caller.
    on_interrupt : {"raise", "return"}
        What Ctrl-C does: raise KeyboardInterrupt, or return the map reached by then. It is noticed between two sweeps,
        and between the levels of the first map.

    Returns
    -------
    sphere : (n, 3) ndarray of float64
        The images of the vertices, in the unit of length of the mesh; NaN for vertices without a face.
    report : Report
        What the run did; with a `density`, ``report.areas.is_reached`` says whether the areas are as wanted.

    Warns
    -----
    RuntimeWarning
        If the areas of a `density` are missed by a deviation above 0.01.

    Raises
    ------
    Error
        If the mesh has no such map, see `find_defect`; if `initial` is not one-to-one; if a parameter is out of its
        range.

    Notes
    -----
    The method takes further that of [1]_. Its time is nearly linear, some 10 microseconds a vertex on two cores, and so is
    its memory, some 500 bytes a vertex.

    References
    ----------
    .. [1] C. Wang, X. Hu, X. Fu, L. Liu: Bijective spherical parametrization with low distortion. Computers & Graphics 58,
       2016.
    """
    check_word("prefer", prefer, ("balance", "average", "worst", "sampling"))
    check_word("energy", energy, ("symmetric-dirichlet", "isometric", "conformal", "stretch"))
    if prefer == "sampling":
        if energy not in ("symmetric-dirichlet", "stretch"):
            refuse('prefer="sampling" has an energy of its own: leave out energy')
        energy = "stretch"
    run = read_run(threads, time_limit, callback, on_interrupt)
    points = read_points("vertices", vertices)
    corners = read_faces("faces", faces)
    if density is not None and initial is not None:
        refuse("density and initial cannot be combined: leave out one of them")
    densities, is_of_faces = read_density(density, len(points), len(corners))
    first_images = None
    if isinstance(initial, str):
        check_word("initial", initial, ("schnyder",))
    elif initial is not None:
        first_images = read_points("initial", initial, len(points))
    sphere, report, areas = _core.parameterize(
        points, corners, prefer, energy, first_images, isinstance(initial, str), densities, is_of_faces, *run
    )
    result = Report(**report, areas=None if areas is None else Areas(**areas))
    if result.areas is not None and result.areas.deviation > MAX_DEVIATION_OF_AREAS:
        warnings.warn(
            f"the areas are not as wanted: their deviation is {result.areas.deviation:.2g}, the largest {result.areas.largest_deviation:.2g}"
            f" (report.areas; the run ended for this reason: {result.stop_reason})."
            + (' energy="conformal" works against them: leave it out.' if energy == "conformal" else ""),
            RuntimeWarning,
            stacklevel=2,
        )
    return sphere, result
