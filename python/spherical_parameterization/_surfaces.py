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
        The largest value.
    average_over_first, average_over_second : float
        The mean, weighted with areas on the first surface, and on the second one.
    """

    maximum: float
    average_over_first: float
    average_over_second: float


@dataclass(frozen=True)
class DistortionBetween:
    """How much a map between two surfaces, both scaled to the same area, distorts the triangles of their refinement.

    With s1 <= s2 the singular values of the map of a triangle, all measures are the same for the map and for its inverse.

    Attributes
    ----------
    isometric : MeasureBetween
        max(s2, 1 / s1), the largest factor by which a length is wrong: 1 for an isometry.
    area : MeasureBetween
        s1 s2 + 1 / (s1 s2): 2 if the area stays the same.
    angle : MeasureBetween
        s1 / s2 + s2 / s1: 2 if the angles stay the same.
    energy : MeasureBetween
        (s1**2 + s2**2 + 1 / s1**2 + 1 / s2**2) / 2, the symmetric Dirichlet energy: 2 for an isometry.
    number_of_triangles, number_of_slivers : int
        The triangles of the refinement, and those that are left out because they are too small.
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
    """What `map_surface` has found.

    Attributes
    ----------
    energy : float
        The symmetric Dirichlet energy of the map, measured on the common refinement: the mean of both directions. 2 is an
        isometry, up to scale.
    distortion : DistortionBetween or None
        What `measure_distortion_between` would return for the map; None if the energy has not been measured, or by samples.
    is_energy_sampled : bool
        Whether it has been measured at places in each face instead, as the refinement has more vertices than `overlay` makes
        by default. That misses a part of what is near vertices: 5 to 15 percent of the energy where both were measured.
    agreement : float
        How well features agree after the surfaces have been aligned on coarse levels, a correlation, at most 1; 0 if
        landmarks alone turned the spheres, as features did not agree.
    margin : float
        How much better the alignment is than the next best one that differs from it: those that are nearly as good on coarse
        surfaces are compared on a finer level, in agreement less 0.15 times how much is stretched, the mean root of the
        logarithm of the symmetric Dirichlet energy. At least 0.15 if no other one came that near.
    expected_error : float or None
        How far the images of vertices are expected to be from where they should be, over the root of the area of the second
        surface, in the mean over the first one. None for features of a caller, if landmarks alone rotated the spheres, or if the run
        was stopped before surfaces were aligned.
    expected_errors : (n1,) ndarray of float64, or None
        The same for each vertex of the first surface; NaN for vertices without a face. It is estimated from how far features
        differ, over how fast they change on the surface; how far images have moved during the descent; how well the surfaces
        agree; and how far away images are by other alignments that are nearly as good.
    is_uncertain : bool
        Whether the alignment is ambiguous, so that the map may have exchanged sides: the expected error is above 0.105. For
        features of a caller: they agree by less than 0.73, or the margin is below 0.1. Look at the map, or give landmarks. It
        is never so if landmarks alone rotated the spheres.
    landmark_distances : (k,) ndarray of float64
        How far the image of each landmark is from where it should be, in the unit of length of the second surface.
    number_of_missed_landmarks : int
        How many landmarks could not be met, though no `landmark_weight` was given.
    stop_reason : str
        Why the sweeps ended, as for `parameterize`.
    number_of_sweeps : int
        Sweeps over levels of the first surface.
    seconds_for_reading, seconds_for_alignment, seconds_for_descent, seconds_for_overlay : float
        The time to read and certify both surfaces with their maps, to find out how the surfaces lie on each other, to
        lower the energy, and to measure it.
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
    """Maps a surface one-to-one onto another one, with low distortion in both directions, by maps to the sphere.

    The map is a direction for each vertex of the first surface. As a map to the sphere of the second one, the directions
    are certified by exact arithmetic, also if the run was stopped early. What lies in a direction is found with a `Locator` of
    the second sphere; `remesh` gives the second surface with the faces of the first one, `transfer` carries values over,
    `overlay` is the common refinement, and `measure_distortion_between` tells more of the map than its report.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: its points, (n, 3) numbers; its triangles, (m, 3) integers; and the images of its vertices, (n, 3)
        numbers, a one-to-one map, at any distance from the origin. An atlas that is a sphere with features, and no surface
        otherwise, is ``(sphere, faces, sphere)``.
    landmarks : (k, 2) array_like of integers, optional
        Vertices that correspond, of the first surface and of the second one. They lead the alignment of the surfaces together with
        features, and choose among what is found. If features agree by less than 0.5 in the end, and there are two or more in
        different directions, these alone turn the spheres.
    landmark_weight : float, optional
        Without it, landmarks are met exactly, but where straight edges do not allow for it. With a weight, they are soft: what
        is lowered is the mean energy plus this weight times the mean of their squared distances on the unit sphere. It is
        positive; 10 is a strong one.
    features : sequence of pairs of array_like
        Pairs of (n1,) and (n2,) numbers: features of the vertices of each surface that are to agree, in place of those of
        the package. Only the order of their values counts, unless `compare_values` is set.
    feature_weight : float
        Once features have aligned the spheres, what is lowered is the mean energy plus this weight times the mean of the
        squared differences of their ranks, which are from -1 to 1. The weight of the package's own features is multiplied
        with the fourth power of their agreement as well. At least 0; with 0, features only align the spheres.
    feature_weights : sequence of float, optional
        How much each of `features` counts beside the others, at least 0 and not all 0. By default all count the same.
    compare_values : bool
        Whether the values of `features` are compared and not their ranks: less the mean over both surfaces, in units of the root
        of three times their variance, such that they spread as ranks do.
    masks : ((n1,) array_like, (n2,) array_like), optional
        Where the surfaces count: true or not 0 for vertices where features are to be compared. Elsewhere, as on the medial wall of
        a cortex, the map is a bijection of low distortion all the same.
    threads : int, optional
        The largest number of threads; by default all cores. The map has the same bits with any number.
    time_limit : float, optional
        The time in seconds after which the map reached by then is returned, certified. Landmarks may be missed then that
        more sweeps would have met.
    callback : callable, optional
        Called every few milliseconds while the spheres are aligned, as ``callback(0, 0.0)``, and so before each level of the
        hierarchy is made; then before every sweep over a level, as ``callback(number_of_vertices, energy)``: the vertices of the level before, 0 on the
        coarsest one, and the average energy of this one; in the end, while the energy of the map is measured, as
        ``callback(number_of_vertices, 0.0)`` with all vertices. If it returns a false value other than None, the map reached
        by then is returned. What it raises reaches the caller.
    on_interrupt : {"raise", "return"}
        What Ctrl-C does: raise KeyboardInterrupt, or return the map reached by then. It is noticed where `callback` is called.

    Returns
    -------
    directions : (n1, 3) ndarray of float64
        Points of the unit sphere, one for each vertex of the first surface; NaN for vertices without a face.
    report : SurfaceMapReport
        How good the map is.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one; if a landmark is no vertex of a face, or a vertex
        has two; if a feature is not finite, or a mask leaves nothing; if a parameter is out of its range.

    Notes
    -----
    Features turn the spheres against each other, see `align_spheres`, and extremities that may be the same, by how
    far their ends are from each other along the surfaces; several such starts are taken through the descent on coarse levels,
    and the best one to the finest level. The symmetric Dirichlet energy of the map, over both surfaces, is lowered on the levels of a hierarchy;
    Schmidt et al. [1]_ optimize maps between surfaces of genus 0 on the sphere, too. The time is nearly linear: for 26,000
    vertices each, some four seconds on two cores.

    References
    ----------
    .. [1] P. Schmidt, M. Campen, J. Born, L. Kobbelt: Inter-surface maps via constant-curvature metrics. ACM Transactions on
       Graphics 39(4), 2020.

    Examples
    --------
    The second surface with the faces of the first one, and what is known of its vertices for those of the first one:

    >>> cat, horse = (vertices1, faces1, sphere1), (vertices2, faces2, sphere2)
    >>> directions, report = sp.map_surface(cat, horse)
    >>> result = sp.remesh(*horse, (faces1, directions))
    >>> values = sp.transfer(horse, (faces1, directions), values_of_horse)
    """
    surfaces = read_two_surfaces(surface1, surface2)
    rows = read_vertices(
        "landmarks", () if landmarks is None else landmarks, 2, "(k, 2): a vertex of each surface in each row"
    )
    if landmark_weight is not None and landmarks is None:
        refuse("landmark_weight goes with landmarks")
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
    """The rotations that bring one sphere onto another one: what `align_spheres` has found.

    Attributes
    ----------
    rotations : (k, 3, 3) ndarray of float64
        The best rotations of the first sphere, 1 to 4 that differ by 20 degrees or more, the best one first.
        ``sphere1 @ rotations[0].T`` is the sphere that is turned.
    scores : (k,) ndarray of float64
        How well the surfaces agree by each: the correlation of their features, at most 1.
    is_stopped : bool
        Whether the search was ended early: the rotations are the best of those that had been tried by then, at worst the
        identity alone, with the score 0.
    """

    rotations: NDArray[np.float64]
    scores: NDArray[np.float64]
    is_stopped: bool

    @property
    def margin(self) -> float:
        """How much higher the best score is than the second best, or than 0 if there is one only.

        Below 0.1 or so, the surface has a symmetry, or nearly: then look at both.
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
    """Finds the rotations that bring the sphere of one surface onto that of another one such that the surfaces agree best.

    All rotations are searched, without a start. It is meant for surfaces that are nearly isometric, such as poses of a body,
    with maps made in the same way. `map_surface` does it itself.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: its points, (n, 3) numbers; its triangles, (m, 3) integers; and the images of its vertices, (n, 3)
        numbers, a one-to-one map, at any distance from the origin.
    features : sequence of pairs of array_like
        What is compared: pairs of (n1,) and (n2,) numbers, of the vertices of each surface. Only the order of their values
        counts. By default features that do not depend on how the surfaces lie in space: how much the maps change areas; the
        average geodesic distance of a place from all others [1]_; and the mean curvature at two scales.
    threads : int, optional
        The largest number of threads; by default all cores.
    time_limit : float, optional
        The time in seconds after which the best rotations so far are returned.
    callback : callable, optional
        Called every few milliseconds as ``callback(0, 0.0)``, as by `map_surface` while it does this. If it returns a false
        value other than None, the best rotations so far are returned. What it raises reaches the caller.
    on_interrupt : {"raise", "return"}
        What Ctrl-C does: raise KeyboardInterrupt, or return the best rotations so far.

    Returns
    -------
    SphereAlignment
        The rotations, and how good they are.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one; if a feature is not finite.

    Notes
    -----
    12,000 rotations are tried [2]_ at 492 directions, and the best ones refined to about 0.2 degrees. None
    exchanges a surface and its mirror image. The result has the same bits for any number of threads. The time is linear in
    the size of the meshes, and for less than 100,000 vertices, that of the comparison.

    References
    ----------
    .. [1] M. Hilaga, Y. Shinagawa, T. Kohmura, T. L. Kunii: Topology matching for fully automatic similarity estimation of 3D
       shapes. SIGGRAPH 2001.
    .. [2] M. Alexa: Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3). CVPR 2022.
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
    """The common refinement of two surfaces: triangles, each a part of one face of either.

    Attributes
    ----------
    vertices1, vertices2 : (k, 3) ndarray of float64
        The places of each vertex on the first surface and on the second one. What is between them is a morph.
    faces : (l, 3) ndarray of int64
        The vertices of each triangle.
    faces1, faces2 : (l,) ndarray of int64
        The face of the first surface and that of the second one which each triangle is a part of.
    """

    vertices1: NDArray[np.float64]
    vertices2: NDArray[np.float64]
    faces: NDArray[np.int64]
    faces1: NDArray[np.int64]
    faces2: NDArray[np.int64]


def overlay(
    surface1: Surface, surface2: Surface, *, max_vertices: Optional[int] = None, threads: Optional[int] = None
) -> Overlay:
    """Makes the common refinement of two surfaces that have maps to the same sphere. Its connectivity is exact.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: its points, (n, 3) numbers; its triangles, (m, 3) integers; and the images of its vertices, (n, 3)
        numbers, a one-to-one map, at any distance from the origin.
        For a map of `map_surface`, ``(vertices1, faces1, directions)`` and the second surface.
    max_vertices : int, optional
        The largest number of vertices of the refinement, which takes some 200 bytes each: vertices of high degree that meet
        can have millions of crossings. By default 4,194,304, or 32 times the vertices of both surfaces, whichever is more.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    Overlay
        The refinement.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one; if the refinement would have more than `max_vertices`.

    Notes
    -----
    Which edges cross, and where vertices are, is decided by exact arithmetic, and the result is certified; points of crossings
    are rounded. Where vertices or edges coincide, triangles have no area. The time is O(n log n) for n faces and crossings,
    of which long and narrow faces have many.
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
    """Measures how much the map between two surfaces that have maps to the same sphere distorts, in their `overlay`.

    Parameters
    ----------
    surface1, surface2 : (vertices, faces, sphere)
        Each surface: its points, (n, 3) numbers; its triangles, (m, 3) integers; and the images of its vertices, (n, 3)
        numbers, a one-to-one map, at any distance from the origin.
        For a map of `map_surface`, ``(vertices1, faces1, directions)`` and the second surface.
    smallest_area : float
        Triangles of the refinement with less than this share of the area on one of the surfaces, from 0 to below 1, are left
        out and counted: of those that ties or rounding make, nothing can be said.
    max_vertices : int, optional
        The largest number of vertices of the refinement, which takes some 200 bytes each: vertices of high degree that meet
        can have millions of crossings. By default 4,194,304, or 32 times the vertices of both surfaces, whichever is more.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    DistortionBetween
        The measures. They are infinite if a surface has no area, or all triangles are left out.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one; if the refinement would have more than `max_vertices`;
        if `smallest_area` is out of its range.

    Notes
    -----
    The time is that of `overlay`.
    """
    if not 0 <= smallest_area < 1:
        refuse(f"smallest_area is {smallest_area}; it has to be from 0 to below 1")
    first, second = read_two_surfaces(surface1, surface2)
    result = _core.measure_distortion_between(
        *first, *second, float(smallest_area), read_max_vertices(max_vertices), read_threads(threads)
    )
    return _to_distortion(result)
