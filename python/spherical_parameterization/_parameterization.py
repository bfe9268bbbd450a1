from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import check_word, read_density, read_faces, read_points, read_run, refuse
from ._meshes import accepts_mesh


MAX_DEVIATION_OF_AREAS = 0.01  # above it, a warning is issued; areas count as reached up to 0.001


@dataclass(frozen=True)
class Areas:
    """Accuracy of prescribed areas, as reached by `parameterize`.

    The cell of a vertex is a third of each spherical triangle around it.

    Attributes
    ----------
    ratios : (n,) ndarray of float64
        Area of the cell of each vertex over the prescribed area; 1 for vertices without a face.
    deviation : float
        Standard deviation of the ratios over their mean.
    largest_deviation : float
        Largest difference of a ratio from 1.
    number_of_off_vertices : int
        Vertices whose ratio differs from 1 by more than 0.01.
    number_of_raised_faces : int
        Faces whose area times density is below a millionth of the mean. This millionth is prescribed for them instead;
        ratios and `is_reached` refer to it.
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
    """Report of a run of `parameterize`.

    Attributes
    ----------
    number_of_vertices, number_of_faces : int
        Mapped vertices and faces.
    number_of_isolated_vertices : int
        Vertices without a face, which have no image.
    number_of_flat_faces : int
        Faces (nearly) without area, mapped as if they were slightly less flat.
    radius : float
        Radius of the sphere, in the unit of length of the mesh.
    stop_reason : str
        Why the run ended: "converged", "iteration limit", "time limit", "stopped by the visitor" (by the callback or an
        interruption) or "no acceptable step left". It does not state whether prescribed areas are reached.
    number_of_levels : int
        Levels of the hierarchy that computed the initial map.
    used_last_resort : bool
        Whether the hierarchy found no map, so that the initial map is Schnyder's, which always exists.
    number_of_iterations : int
        Sweeps over the mesh.
    initial_energy, average_energy, largest_energy : float
        Energy per face: the mean of the initial map, and the mean and the maximum of the final map.
    seconds : float
        Duration of the run.
    areas : Areas or None
        Accuracy of the prescribed areas if `density` was given.
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
    """Map a closed triangle mesh of genus 0 bijectively to a sphere around the origin, with low distortion.

    Exact arithmetic certifies that the map is bijective, even if the run was stopped early. Every closed triangle mesh of
    genus 0 has such a map in double precision; for up to 10,000,000 vertices, this is a theorem.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle, counterclockwise as seen from outside.
    prefer : {"balance", "average", "worst", "sampling"}
        Objective: the lowest average distortion, the lowest worst distortion, or a balance of both. "sampling" makes
        samples that are even on the sphere as even as possible on the surface, for `remesh` and `transfer`.
    energy : {"symmetric-dirichlet", "isometric", "conformal", "stretch"}
        Minimized energy. "conformal" preserves angles, on a sphere of radius 1 unless `density` is given. It works against
        a `density`: on most surfaces with extremities, the prescribed areas are then missed. ``prefer="sampling"`` has its
        own energy, "stretch".
    initial : (n, 3) array_like of float or "schnyder", optional
        Initial map, bijective, which need not be normalized; or Schnyder's map, which depends only on the connectivity and is
        bijective by a theorem. By default, a hierarchy computes the initial map.
    density : (n,) or (m,) array_like of float or "equal", optional
        Prescribed areas: a density for each vertex or for each face, finite, at least 0 and in any unit. Each part of the
        surface gets the fraction of the sphere's area that is proportional to its area times its density. "equal" is 1
        everywhere. The density of a face is the mean over its vertices. Faces that would get less than a millionth of the
        mean area, for example with density 0, get a millionth. The prescribed areas are those of the cells of vertices, see
        `Areas`. Smooth densities are reached up to a contrast of a million. Densities with steps may be missed, which
        `Areas` reports. It cannot be combined with `initial`, and takes several times longer.
    threads : int, optional
        Maximum number of threads. By default, all cores. The map has the same bits for any number.
    time_limit : float, optional
        Time in seconds after which the current map is returned. The initial map is always completed.
    callback : callable, optional
        Called after each sweep over the mesh as ``callback(iteration, energy, radius)``. If it returns a false value
        other than None, the current map is returned. Its exceptions reach the caller.
    on_interrupt : {"raise", "return"}
        Effect of Ctrl-C: raise KeyboardInterrupt, or return the current map. It takes effect between two sweeps, and
        between the levels of the initial map.

    Returns
    -------
    sphere : (n, 3) ndarray of float64
        Images of the vertices, in the unit of length of the mesh; NaN for vertices without a face.
    report : Report
        Report of the run. With a `density`, ``report.areas.is_reached`` states whether the prescribed areas are reached.

    Raises
    ------
    Error
        If the mesh has a defect, see `find_defect`; if `initial` is not bijective; or if a parameter is out of range.

    Warns
    -----
    RuntimeWarning
        If the areas deviate from those prescribed by a `density` by more than 0.01.

    See Also
    --------
    find_defect : Check whether a mesh can be mapped.
    repair_surface : Make a surface that can be mapped.
    measure_distortion : Measure the distortion of the map.

    Notes
    -----
    The method extends that of [1]_. Time and memory are nearly linear: about 10 microseconds per vertex on two cores, and
    about 500 bytes per vertex.

    References
    ----------
    .. [1] C. Wang, X. Hu, X. Fu, L. Liu: Bijective spherical parametrization with low distortion. Computers & Graphics 58,
       2016.

    Examples
    --------
    >>> sphere, report = sp.parameterize(vertices, faces)
    >>> sp.is_bijective(faces, sphere), report.stop_reason
    (True, 'converged')

    Each vertex gets the same fraction of the sphere as of the surface:

    >>> sphere, report = sp.parameterize(vertices, faces, density="equal")
    >>> report.areas.is_reached
    True
    """
    check_word("prefer", prefer, ("balance", "average", "worst", "sampling"))
    check_word("energy", energy, ("symmetric-dirichlet", "isometric", "conformal", "stretch"))
    if prefer == "sampling":
        if energy not in ("symmetric-dirichlet", "stretch"):
            refuse('prefer="sampling" has its own energy: leave out energy')
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
            f"the prescribed areas are not reached: their deviation is {result.areas.deviation:.2g}, "
            f"the largest {result.areas.largest_deviation:.2g} (report.areas; stop reason: {result.stop_reason})."
            + (' energy="conformal" works against them: leave it out.' if energy == "conformal" else ""),
            RuntimeWarning,
            stacklevel=2,
        )
    return sphere, result
