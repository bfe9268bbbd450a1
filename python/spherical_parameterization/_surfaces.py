from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (
    Features,
    Surface,
    read_feature_weights,
    read_features,
    read_masks,
    read_max_vertices,
    read_run,
    read_threads,
    read_two_surfaces,
    read_vertices,
    refuse,
)


class MeasureBetween(NamedTuple):
    """One measure of the distortion between two surfaces.

    Attributes
    ----------
    maximum : float
        Maximum value.
    average_over_first, average_over_second : float
        Mean, weighted by areas on the first surface and on the second one.
    """

    maximum: float
    average_over_first: float
    average_over_second: float


@dataclass(frozen=True)
class DistortionBetween:
    """Distortion of a map between two surfaces, in the triangles of their common refinement.

    Both surfaces are scaled to the same area. With s1 <= s2 the singular values of the map of a triangle, all measures are
    the same for the map and its inverse.

    Attributes
    ----------
    isometric : MeasureBetween
        max(s2, 1 / s1), the largest factor by which a length changes: 1 for an isometry.
    area : MeasureBetween
        s1 s2 + 1 / (s1 s2): 2 if the area is preserved.
    angle : MeasureBetween
        s1 / s2 + s2 / s1: 2 if the angles are preserved.
    energy : MeasureBetween
        (s1**2 + s2**2 + 1 / s1**2 + 1 / s2**2) / 2, the symmetric Dirichlet energy: 2 for an isometry.
    number_of_triangles, number_of_slivers : int
        Triangles of the refinement, and those that are excluded because they are too small.
    """

    isometric: MeasureBetween
    area: MeasureBetween
    angle: MeasureBetween
    energy: MeasureBetween
    number_of_triangles: int
    number_of_slivers: int


def _to_distortion(figures: Dict[str, Any]) -> DistortionBetween:
    for name in ("isometric", "area", "angle", "energy"):
        figures[name] = MeasureBetween(*figures[name])
    return DistortionBetween(**figures)


@dataclass(frozen=True)
class SurfaceMapReport:
    """Report of a run of `map_surface`.

    Attributes
    ----------
    energy : float
        Symmetric Dirichlet energy of the map, measured on the common refinement: the mean over both directions. 2 is an
        isometry, up to scale. Infinite if a surface has no area; 0 if it was not measured because the run was stopped.
    distortion : DistortionBetween or None
        Result of `measure_distortion_between` for the map; None if the energy was not measured, or by samples.
    is_energy_sampled : bool
        Whether the energy was measured at samples in each face, because the refinement has more vertices than the default
        limit of `overlay`. Samples miss a part of the energy near vertices: 5 to 15 percent where both were measured.
    agreement : float
        Agreement of the features after the alignment on coarse levels, a correlation, at most 1. 0 if landmarks alone
        determined the rotations because features did not agree.
    margin : float
        Advantage of the alignment over the next best different one. Alignments that are nearly as good on coarse surfaces
        are compared on a finer level: the score is the agreement of the features, among which the mean curvatures at the
        two finest scales count ten times unless the caller provides features. 0.15 if no other alignment came that near.
    expected_error : float or None
        Expected distance of the images of vertices from their correct positions, over the square root of the area of the
        second surface; the mean over the first surface. None for features of the caller, if landmarks alone determined the
        rotations, or if the run was stopped before the alignment.
    expected_errors : (n1,) ndarray of float64, or None
        Expected error of each vertex of the first surface; NaN for vertices without a face. The estimate uses the
        differences of features over their gradients on the surface, the displacement of the images during the descent, the
        agreement of the surfaces, and the distances from the images by other alignments that are nearly as good.
    is_uncertain : bool
        Whether the alignment is ambiguous, so that the map may be off by a half-turn (front-back and left-right exchanged):
        the expected error is above 0.105. For features of the caller: the agreement is below 0.73, or the margin is below
        0.1. Also True if the alignment was stopped, always False if landmarks alone determined the rotations. If True,
        inspect the map, or give landmarks.
    landmark_distances : (k,) ndarray of float64
        Distance of the image of each landmark from its target, in the unit of length of the second surface.
    number_of_missed_landmarks : int
        Landmarks that could not be met although no `landmark_weight` was given.
    stop_reason : str
        Why the sweeps ended, as for `parameterize`.
    number_of_sweeps : int
        Sweeps over levels of the first surface.
    seconds_for_reading, seconds_for_alignment, seconds_for_descent, seconds_for_overlay : float
        Time to read and certify both surfaces with their maps, to align them, to minimize the energy, and to measure it.
    """

    energy: float
    distortion: Optional[DistortionBetween]
    is_energy_sampled: bool
    agreement: float
    margin: float
    expected_error: Optional[float]
    expected_errors: Optional[NDArray[np.float64]]
    is_uncertain: bool
    landmark_distances: NDArray[np.float64]
    number_of_missed_landmarks: int
    stop_reason: str
    number_of_sweeps: int
    seconds_for_reading: float
    seconds_for_alignment: float
    seconds_for_descent: float
    seconds_for_overlay: float


def map_surface(
    surface1: Surface,
    surface2: Surface,
    *,
    landmarks: Optional[ArrayLike] = None,
    landmark_weight: Optional[float] = None,
    features: Features = (),
    feature_weight: float = 4.0,
    feature_weights: Optional[Sequence[float]] = None,
    compare_values: bool = False,
    masks: Optional[Tuple[ArrayLike, ArrayLike]] = None,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    callback: Optional[Callable[[int, float], Any]] = None,
    on_interrupt: str = "raise",
) -> Tuple[NDArray[np.float64], SurfaceMapReport]:
    """Map a surface bijectively onto another one, with low distortion in both directions.

    The map is a direction for each vertex of the first surface. Exact arithmetic certifies that the directions are a
    bijective map of the first surface to the sphere of the second one, even if the run was stopped early. To use the map:

    - A `Locator` of the second sphere finds the points of the second surface.
    - `remesh` returns the second surface with the faces of the first one.
    - `transfer` transfers values.
    - `overlay` returns the common refinement.
    - `measure_distortion_between` measures more of the distortion than the report contains.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: points, (n, 3) float; triangles, (m, 3) int; and images of the vertices, (n, 3) float, a bijective map,
        which need not be normalized. A mesh object may replace the points and triangles. An atlas that is only a sphere with
        features is ``(sphere, faces, sphere)``.
    landmarks : (k, 2) array_like of int, optional
        Corresponding vertices of the first and of the second surface. Together with features, they guide the alignment and
        select among its candidates. If features finally agree by less than 0.5, and there are two or more landmarks in
        different directions, landmarks alone determine the rotations.
    landmark_weight : float, optional
        By default, landmarks are met exactly, except where straight edges prevent it. With a weight, landmarks are soft: the
        objective is the mean energy plus this weight times the mean of the squared distances of landmarks on the unit
        sphere. The weight is positive; 10 is a strong one.
    features : sequence of pairs of array_like
        Pairs of (n1,) and (n2,) float: values at the vertices of both surfaces that should agree, instead of the built-in
        features. They are compared by rank, unless `compare_values` is set.
    feature_weight : float
        Weight w of features, at least 0: the objective is the mean energy plus w times the mean squared difference of their
        ranks, from -1 to 1. With 0, features only align the spheres. Built-in features have the weight w times the fourth
        power of their agreement.
    feature_weights : sequence of float, optional
        Relative weights of `features`, at least 0 and not all 0. By default, all are equal.
    compare_values : bool
        Whether to compare the values of `features` instead of their ranks. Values are standardized: the mean over both
        surfaces is subtracted, and the unit is the root of three times their variance, so that they spread as ranks do.
    masks : ((n1,) array_like, (n2,) array_like), optional
        For each surface, true or nonzero at vertices where features are compared. Elsewhere, the map is still a bijection
        of low distortion. For a cortical surface without its medial wall, the vertices of a file such as lh.cortex.label:
        ``numpy.isin(numpy.arange(n), nibabel.freesurfer.read_label(file))``.
    threads : int, optional
        Maximum number of threads. By default, all cores. The map has the same bits for any number.
    time_limit : float, optional
        Time in seconds after which the current map is returned, certified. It may miss landmarks that more sweeps would have
        met.
    callback : callable, optional
        Called as ``callback(number_of_vertices, energy)``. Every few milliseconds during the alignment, and before each level
        of the hierarchy is made, both are 0. Before each sweep over a level, they are the vertices of the previous level (0
        on the coarsest one) and the average energy of this level. While the energy is measured, they are all vertices and
        0. If it returns a false value other than None, the current map is returned. Its exceptions reach the caller.
    on_interrupt : {"raise", "return"}
        Effect of Ctrl-C: raise KeyboardInterrupt, or return the current map. It takes effect where `callback` is called.

    Returns
    -------
    directions : (n1, 3) ndarray of float64
        Points of the unit sphere, one for each vertex of the first surface; NaN for vertices without a face.
    report : SurfaceMapReport
        Quality of the map.

    Raises
    ------
    Error
        If a mesh has a defect, see `find_defect`; if a map is not bijective; if a landmark is not a vertex of a face, or a
        vertex has two landmarks; if a feature is not finite; if a mask excludes all vertices; or if a parameter is out of
        range.

    See Also
    --------
    align_spheres : Find the rotations only.

    Notes
    -----
    Features determine rotations of the spheres, see `align_spheres`. Candidates also come from extremities that may
    correspond, by the distances between their tips along the surfaces. Several initial maps are optimized on coarse levels,
    and the best one is refined to the finest level. The symmetric Dirichlet energy of the map, over both surfaces, is
    minimized on the levels of a hierarchy. Schmidt et al. [1]_ also optimize maps between surfaces of genus 0 on the sphere.
    The time is nearly linear: about four seconds on two cores for surfaces of 26,000 vertices each.

    References
    ----------
    .. [1] P. Schmidt, M. Campen, J. Born, L. Kobbelt: Inter-surface maps via constant-curvature metrics. ACM Transactions on
       Graphics 39(4), 2020.

    Examples
    --------
    The second surface with the faces of the first one, and values of its vertices at the vertices of the first one:

    >>> first = (vertices, faces, sphere)
    >>> second = sp.remesh(vertices, faces, sphere, ("icosahedron", 5))
    >>> directions, report = sp.map_surface(first, second)
    >>> result = sp.remesh(*second, (faces, directions))
    >>> values = sp.transfer(second, (faces, directions), second.vertices[:, 2])
    >>> values.shape
    (258,)
    """
    surfaces = read_two_surfaces(surface1, surface2)
    rows = read_vertices(
        "landmarks", () if landmarks is None else landmarks, 2, "(k, 2): a vertex of each surface in each row"
    )
    if landmark_weight is not None and landmarks is None:
        refuse("landmark_weight needs landmarks")
    if landmark_weight is not None and not 0 < landmark_weight < np.inf:
        refuse(f"landmark_weight is {landmark_weight}; it has to be positive")
    if not 0 <= feature_weight < np.inf:
        refuse(f"feature_weight is {feature_weight}; it has to be 0 or more")
    pairs = read_features(features, *surfaces)
    directions, report = _core.map_surface(
        *surfaces[0],
        *surfaces[1],
        rows,
        None if landmark_weight is None else float(landmark_weight),
        pairs,
        float(feature_weight),
        read_feature_weights(feature_weights, len(pairs)),
        bool(compare_values),
        read_masks(masks, *surfaces),
        *read_run(threads, time_limit, callback, on_interrupt),
    )
    if report["distortion"] is not None:
        report["distortion"] = _to_distortion(report["distortion"])
    return directions, SurfaceMapReport(**report)


@dataclass(frozen=True)
class SphereAlignment:
    """Rotations that align one sphere with another one, as found by `align_spheres`.

    Attributes
    ----------
    rotations : (k, 3, 3) ndarray of float64
        Best rotations of the first sphere, 1 to 4 that differ by 20 degrees or more, the best one first.
        ``sphere1 @ rotations[0].T`` is the rotated sphere.
    scores : (k,) ndarray of float64
        Agreement of the surfaces for each rotation: the correlation of their features, at most 1.
    is_stopped : bool
        Whether the search was stopped early. The rotations are then the best of those tried so far: at worst the identity
        alone, with score 0.
    """

    rotations: NDArray[np.float64]
    scores: NDArray[np.float64]
    is_stopped: bool

    @property
    def margin(self) -> float:
        """Best score minus the second best one, which is 0 if there is only one rotation.

        A margin below about 0.1 indicates an ambiguous alignment of a (nearly) symmetric surface: inspect both rotations.
        """
        return float(self.scores[0] - (self.scores[1] if len(self.scores) > 1 else 0))


def align_spheres(
    surface1: Surface,
    surface2: Surface,
    *,
    features: Features = (),
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    callback: Optional[Callable[[int, float], Any]] = None,
    on_interrupt: str = "raise",
) -> SphereAlignment:
    """Find the rotations of the sphere of one surface that best align it with the sphere of another one.

    The search covers all rotations and needs no initial one. It suits nearly isometric surfaces, such as poses of a body,
    whose maps were computed in the same way. `map_surface` calls it.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: points, (n, 3) float; triangles, (m, 3) int; and images of the vertices, (n, 3) float, a bijective map,
        which need not be normalized. A mesh object may replace the points and triangles.
    features : sequence of pairs of array_like
        Pairs of (n1,) and (n2,) float: features of the vertices of each surface. Only the order of their values counts. The
        default features are independent of the pose of the surfaces in space: the area distortion of the maps, the average
        geodesic distance of a point from all others [1]_, and the mean curvature at two scales.
    threads : int, optional
        Maximum number of threads. By default, all cores.
    time_limit : float, optional
        Time in seconds after which the best rotations so far are returned.
    callback : callable, optional
        Called every few milliseconds as ``callback(0, 0.0)``, as `map_surface` does during its alignment. If it returns a
        false value other than None, the best rotations so far are returned. Its exceptions reach the caller.
    on_interrupt : {"raise", "return"}
        Effect of Ctrl-C: raise KeyboardInterrupt, or return the best rotations so far.

    Returns
    -------
    SphereAlignment
        The rotations and their scores.

    Raises
    ------
    Error
        If a mesh has a defect, see `find_defect`; if a map is not bijective; or if a feature is not finite.

    Notes
    -----
    12,000 rotations [2]_ are evaluated at 492 directions. The best ones are refined to about 0.2 degrees. None is a
    reflection. The result has the same bits for any number of threads. The time is linear in the size of the meshes; below
    100,000 vertices, the comparison dominates.

    References
    ----------
    .. [1] M. Hilaga, Y. Shinagawa, T. Kohmura, T. L. Kunii: Topology matching for fully automatic similarity estimation of 3D
       shapes. SIGGRAPH 2001.
    .. [2] M. Alexa: Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3). CVPR 2022.

    Examples
    --------
    >>> second = sp.remesh(vertices, faces, sphere, ("icosahedron", 5))
    >>> alignment = sp.align_spheres((vertices, faces, sphere), second)
    >>> rotated = sphere @ alignment.rotations[0].T
    """
    surfaces = read_two_surfaces(surface1, surface2)
    return SphereAlignment(
        *_core.align_spheres(
            *surfaces[0],
            *surfaces[1],
            read_features(features, *surfaces),
            *read_run(threads, time_limit, callback, on_interrupt),
        )
    )


class Overlay(NamedTuple):
    """Common refinement of two surfaces: each triangle is a part of one face of each surface.

    Attributes
    ----------
    vertices1, vertices2 : (k, 3) ndarray of float64
        Points of each vertex on the first surface and on the second one. Interpolation between them is a morph.
    faces : (l, 3) ndarray of int64
        Vertices of each triangle.
    faces1, faces2 : (l,) ndarray of int64
        Faces of the first surface and of the second one that contain each triangle.
    """

    vertices1: NDArray[np.float64]
    vertices2: NDArray[np.float64]
    faces: NDArray[np.int64]
    faces1: NDArray[np.int64]
    faces2: NDArray[np.int64]


def overlay(
    surface1: Surface, surface2: Surface, *, max_vertices: Optional[int] = None, threads: Optional[int] = None
) -> Overlay:
    """Compute the common refinement of two surfaces that have maps to the same sphere.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: points, (n, 3) float; triangles, (m, 3) int; and images of the vertices, (n, 3) float, a bijective map,
        which need not be normalized. A mesh object may replace the points and triangles. For a map of `map_surface`, give
        ``(vertices1, faces1, directions)`` and the second surface.
    max_vertices : int, optional
        Maximum number of vertices of the refinement, each of which takes about 200 bytes. Coincident vertices of high degree
        can cause millions of crossings. The default is 4,194,304, or 32 times the vertices of both surfaces if that is more.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    Overlay
        The refinement.

    Raises
    ------
    Error
        If a mesh has a defect, see `find_defect`; if a map is not bijective; or if the refinement would have more than
        `max_vertices` vertices.

    See Also
    --------
    measure_distortion_between : Measure the distortion in the triangles of the refinement.

    Notes
    -----
    The connectivity is exact: exact arithmetic determines which edges cross and which faces contain the vertices, and the
    result is certified. The points of crossings are rounded. Where vertices or edges coincide, triangles have no area. The
    time is O(n log n) for n faces and crossings; long and narrow faces have many crossings.

    Examples
    --------
    >>> second = sp.remesh(vertices, faces, sphere, ("icosahedron", 5))
    >>> refinement = sp.overlay((vertices, faces, sphere), second)
    >>> halfway = (refinement.vertices1 + refinement.vertices2) / 2
    """
    first, second = read_two_surfaces(surface1, surface2)
    return Overlay(*_core.overlay(*first, *second, read_max_vertices(max_vertices), read_threads(threads)))


def measure_distortion_between(
    surface1: Surface,
    surface2: Surface,
    *,
    smallest_area: float = 1e-10,
    max_vertices: Optional[int] = None,
    threads: Optional[int] = None,
) -> DistortionBetween:
    """Measure the distortion of the map between two surfaces that have maps to the same sphere.

    The distortion is measured in the triangles of their `overlay`.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: points, (n, 3) float; triangles, (m, 3) int; and images of the vertices, (n, 3) float, a bijective map,
        which need not be normalized. A mesh object may replace the points and triangles. For a map of `map_surface`, give
        ``(vertices1, faces1, directions)`` and the second surface.
    smallest_area : float
        Triangles of the refinement with less than this fraction of the area of one of the surfaces are excluded and counted:
        coincidences and rounding errors determine their shapes. At least 0 and below 1.
    max_vertices : int, optional
        Maximum number of vertices of the refinement, see `overlay`.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    DistortionBetween
        The measures. They are infinite if a surface has no area, or if all triangles are excluded.

    Raises
    ------
    Error
        If a mesh has a defect, see `find_defect`; if a map is not bijective; if the refinement would have more than
        `max_vertices` vertices; or if `smallest_area` is out of range.

    Notes
    -----
    The time is that of `overlay`.

    Examples
    --------
    >>> second = sp.remesh(vertices, faces, sphere, ("icosahedron", 5))
    >>> distortion = sp.measure_distortion_between((vertices, faces, sphere), second)
    >>> distortion.energy.average_over_first >= 2
    True
    """
    if not 0 <= smallest_area < 1:
        refuse(f"smallest_area is {smallest_area}; it has to be from 0 to below 1")
    first, second = read_two_surfaces(surface1, surface2)
    result = _core.measure_distortion_between(
        *first, *second, float(smallest_area), read_max_vertices(max_vertices), read_threads(threads)
    )
    return _to_distortion(result)
