from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import check_word, read_surface, refuse


@dataclass(frozen=True)
class SurfaceMapReport:
    """What `map_surface` has found.

    Attributes
    ----------
    energy : float
        The symmetric Dirichlet energy of the map, measured on the common refinement: the mean of both directions. 2 is an
        isometry, up to scale.
    agreement : float
        How well features agree after the spheres have been aligned, a correlation, at most 1; 0 if landmarks aligned them.
    margin : float
        How much better they agree than by the next best way to turn the spheres. Below 0.1 or so, the surface has a
        symmetry, or nearly, and the map may have exchanged its sides.
    landmark_distances : (k,) ndarray of float64
        How far the image of each landmark is from where it should be, in the unit of length of the second surface.
    number_of_missed_landmarks : int
        How many landmarks could not be met, though no `landmark_weight` was given.
    stop_reason : str
        Why the sweeps ended, as for `parameterize`.
    number_of_sweeps : int
        Sweeps over levels of the first surface.
    """

    energy: float
    agreement: float
    margin: float
    landmark_distances: NDArray[np.float64]
    number_of_missed_landmarks: int
    stop_reason: str
    number_of_sweeps: int


def map_surface(
    vertices1: ArrayLike,
    faces1: ArrayLike,
    sphere1: ArrayLike,
    vertices2: ArrayLike,
    faces2: ArrayLike,
    sphere2: ArrayLike,
    landmarks: Optional[ArrayLike] = None,
    landmark_weight: Optional[float] = None,
    features: Sequence[Tuple[ArrayLike, ArrayLike]] = (),
    feature_weight: float = 4.0,
    on_interrupt: str = "raise",
) -> Tuple[NDArray[np.float64], SurfaceMapReport]:
    """Maps a surface one-to-one onto another one, with low distortion in both directions, by maps to the sphere.

    The map is a direction for each vertex of the first surface. As a map to the sphere of the second one, the directions
    are certified by exact arithmetic. What lies in a direction is found with a `Locator` of `sphere2`; `remesh` gives the
    second surface with the faces of the first one, `transfer` carries values over, `overlay` is the common refinement.

    Parameters
    ----------
    vertices1, vertices2 : (n, 3) array_like of numbers
        The points of each surface.
    faces1, faces2 : (m, 3) array_like of integers
        The vertices of its triangles.
    sphere1, sphere2 : (n, 3) array_like of numbers
        The images of its vertices, a one-to-one map.
    landmarks : (k, 2) array_like of integers, optional
        Vertices that correspond, of the first surface and of the second one. With two or more in different directions,
        they alone decide how the spheres are turned.
    landmark_weight : float, optional
        Without it, landmarks are met exactly, but where straight edges do not allow for it. With a weight, they are soft:
        the mean of their squared distances on the unit sphere is added to the energy, so many times. 10 is a strong one.
    features : sequence of pairs of array_like
        Pairs of (n1,) and (n2,) numbers: features of the vertices of each surface that are to agree, in place of those of
        the package. Only the order of their values counts.
    feature_weight : float
        Features align the spheres, and then the mean of the squared differences of their ranks, which are from -1 to 1,
        is added to the energy, so many times; those of the package the less, the less they agree. With 0, features only
        align the spheres.
    on_interrupt : {"raise", "return"}
        What Ctrl-C does: raise KeyboardInterrupt, or return the map reached by then. It is noticed between two sweeps.

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
        has two; if a feature is not finite.

    Examples
    --------
    The second surface with the faces of the first one:

    >>> directions, report = sp.map_surface(*cat, cat_sphere, *horse, horse_sphere)
    >>> result = sp.remesh(*horse, horse_sphere, (directions, cat[1]))
    """
    surfaces = (*read_surface(vertices1, faces1, sphere1, "1"), *read_surface(vertices2, faces2, sphere2, "2"))
    rows = np.asarray(np.empty((0, 2), int) if landmarks is None else landmarks)
    if rows.dtype.kind not in "iu":
        raise TypeError(f"landmarks has the type {rows.dtype}; it has to hold integers, the rows of vertices")
    if rows.ndim != 2 or rows.shape[1] != 2:
        refuse(f"landmarks has the shape {rows.shape}; it has to be (k, 2): a vertex of each surface in each row")
    if landmark_weight is not None and not 0 < landmark_weight < np.inf:
        refuse(f"landmark_weight is {landmark_weight}; it has to be positive")

    if not 0 <= feature_weight < np.inf:
        refuse(f"feature_weight is {feature_weight}; it has to be 0 or more")
    check_word("on_interrupt", on_interrupt, ("raise", "return"))

    def read_feature(name: str, value: ArrayLike, n: int) -> NDArray[np.float64]:
        array = np.asarray(value)
        if array.dtype.kind not in "fiu":
            raise TypeError(f"{name} has the type {array.dtype}; it has to hold real numbers")
        if array.shape != (n,):
            refuse(f"{name} has the shape {array.shape}; it has to be ({n},): a number for each vertex")
        if not np.isfinite(array).all():
            refuse(f"{name} is infinite or not a number at vertex {np.flatnonzero(~np.isfinite(array))[0]}")
        return np.ascontiguousarray(array, dtype=np.float64)

    pairs = []
    for k, pair in enumerate(features):
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise TypeError(f"features[{k}] has to be a pair: the values of the first surface, and of the second one")
        values1, values2 = (read_feature(f"features[{k}][{i}]", pair[i], len(surfaces[3 * i])) for i in (0, 1))
        pairs.append((values1, values2))
    weight = None if landmark_weight is None else float(landmark_weight)
    directions, report = _core.map_surface(
        *surfaces,
        np.ascontiguousarray(rows, dtype=np.int64),
        weight,
        pairs,
        float(feature_weight),
        on_interrupt == "return",
    )
    return directions, SurfaceMapReport(**report)


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
    vertices1: ArrayLike,
    faces1: ArrayLike,
    sphere1: ArrayLike,
    vertices2: ArrayLike,
    faces2: ArrayLike,
    sphere2: ArrayLike,
) -> Overlay:
    """Makes the common refinement of two surfaces that have maps to the same sphere. Its connectivity is exact.

    Parameters
    ----------
    vertices1, vertices2 : (n, 3) array_like of numbers
        The points of each surface.
    faces1, faces2 : (m, 3) array_like of integers
        The vertices of its triangles.
    sphere1, sphere2 : (n, 3) array_like of numbers
        The images of its vertices, a one-to-one map: of the first surface the directions of `map_surface`, for example.

    Returns
    -------
    Overlay
        The refinement.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one.
    """
    return Overlay(
        *_core.overlay(*read_surface(vertices1, faces1, sphere1, "1"), *read_surface(vertices2, faces2, sphere2, "2"))
    )
