from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (
    carry_rows,
    check_word,
    read_faces,
    read_points,
    read_threads,
    read_tuple,
    refuse,
    to_array,
)

Sphere = Tuple[ArrayLike, ArrayLike]  # faces, sphere


def _read_sphere(name: str, value: Sphere) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
    faces, sphere = read_tuple(name, value, "faces", "sphere")
    return read_faces(f"{name}: faces", faces), read_points(f"{name}: sphere", sphere)


def _read_areas(name: str, value: ArrayLike, faces: NDArray[np.int64], n: int) -> NDArray[np.float64]:
    """Return the areas around vertices, computed from the points of a surface if those are given."""
    array = to_array(name, value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has the type {array.dtype}; it has to hold real numbers")
    if array.shape not in ((n,), (n, 3)):
        refuse(f"{name} has the shape {array.shape}; it has to be ({n},), an area for each vertex, or ({n}, 3), its point")
    if array.ndim == 2:
        if faces.size and not 0 <= faces.min() <= faces.max() < n:
            return np.zeros(n)  # the compiled part refuses the faces
        u, v, w = np.moveaxis(array.astype(np.float64)[faces], 1, 0)
        of_faces = np.linalg.norm(np.cross(v - u, w - u), axis=1) / 6
        array = np.bincount(faces.ravel(), np.repeat(of_faces, 3), n)
    wrong = ~(np.isfinite(array) & (array >= 0))
    if wrong.any():
        refuse(f"{name} is negative or not finite at vertex {np.flatnonzero(wrong)[0]}")
    return np.ascontiguousarray(array, dtype=np.float64)


def resample(
    source: Sphere,
    target: Sphere,
    values: ArrayLike,
    *,
    method: Optional[str] = None,
    areas: Optional[Tuple[ArrayLike, ArrayLike]] = None,
    mask: Optional[ArrayLike] = None,
    return_valid: bool = False,
    threads: Optional[int] = None,
) -> Any:
    """Resample values from the vertices of one sphere to those of another one that is registered to it.

    Values of floating-point types are interpolated or averaged. Rows of integers, bools or strings are labels: each target
    vertex gets the label with the largest sum of weights.

    Parameters
    ----------
    source, target : (faces, sphere)
        The sphere that has the values and the sphere that gets them, in register: to resample from a subject to an atlas,
        `source` is the *registered* sphere of the subject, not its sphere before the registration. Each: triangles, (m, 3)
        int, and vertices, (n, 3) float, a bijective map, which need not be normalized.
    values : (n, ...) array_like
        Values of each source vertex, such as (n,) or (n, k).
    method : {"barycentric", "adaptive", "nearest", "largest"}, optional
        "barycentric", the default without `areas`, interpolates in the source triangle. "adaptive", the default with
        `areas`, also averages, weighted by areas, where the target is coarser. "nearest" and "largest" take the value of
        the source vertex with the largest weight of "barycentric" and "adaptive", respectively.
    areas : (areas of source, areas of target), optional
        Areas around the vertices of both spheres, (n,) and (k,) float, for "adaptive" and "largest"; or the points of the
        vertices on a surface, (n, 3) and (k, 3) float: the midthickness, or else the white surface.
    mask : (n,) array_like of bool, optional
        Source vertices to use. By default, all.
    return_valid : bool
        Whether to also return which target vertices get a value. Recommended with a `mask`: a vertex without a value gets 0,
        which is no thickness, for example.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    resampled : (k, ...) ndarray
        Values of the target, of the same type; the zero of their type for a vertex that gets no value.
    valid : (k,) ndarray of bool
        Target vertices that get a value, if `return_valid`.

    Raises
    ------
    Error
        If a sphere is not bijective, or if the number of rows of an array is not that of the vertices.

    See Also
    --------
    transfer : Transfer values without such settings, between surfaces.

    Notes
    -----
    The definitions are those of Connectome Workbench [1]_: "adaptive" is its ADAP_BARY_AREA. Time and memory are linear in
    the size of the spheres, unless triangles are long and narrow.

    References
    ----------
    .. [1] M. F. Glasser et al.: The minimal preprocessing pipelines for the Human Connectome Project. NeuroImage 80, 2013.

    Examples
    --------
    >>> even = sp.remesh(vertices, faces, sphere, ("octahedron", 4))
    >>> height = vertices[:, 2]
    >>> sp.resample((faces, sphere), (even.faces, even.sphere), height, areas=(vertices, even.vertices)).shape
    (66,)
    """
    from_faces, from_sphere = _read_sphere("source", source)
    to_faces, to_sphere = _read_sphere("target", target)
    n, n_target = len(from_sphere), len(to_sphere)
    word = method if method is not None else "barycentric" if areas is None else "adaptive"
    check_word("method", word, ("barycentric", "adaptive", "nearest", "largest"))
    if (areas is None) == (word in ("adaptive", "largest")):
        refuse(f"method is {word!r}, which {'needs areas' if areas is None else 'takes no areas'}")
    both = (np.empty(0), np.empty(0))
    if areas is not None:
        first, second = read_tuple("areas", areas, "areas of source", "areas of target")
        both = (
            _read_areas("areas[0]", first, from_faces, n),
            _read_areas("areas[1]", second, to_faces, n_target),
        )
    counts = np.empty(0, bool)
    if mask is not None:
        counts = to_array("mask", mask)
        if counts.dtype != bool:
            raise TypeError(f"mask has the type {counts.dtype}; it has to hold bools")
        if counts.shape != (n,):
            refuse(f"mask has the shape {counts.shape}; it has to be ({n},)")
    array = to_array("values", values)
    if array.ndim == 0 or len(array) != n:
        refuse(f"values has the shape {array.shape}; it has to have {n} rows, one for each vertex")
    valid = np.empty(0, bool)

    def carry(table: NDArray[Any]) -> NDArray[Any]:
        nonlocal valid
        result, valid = _core.resample(
            table,
            from_faces,
            from_sphere,
            to_faces,
            to_sphere,
            word,
            *both,
            np.ascontiguousarray(counts),
            read_threads(threads),
        )
        if table.dtype.kind != "f":
            result[~valid] = -1
        return result

    resampled = carry_rows(array, (n_target, *array.shape[1:]), carry)
    return (resampled, valid) if return_valid else resampled


def resample_sphere(
    source: Sphere, registered: ArrayLike, target: Sphere, *, threads: Optional[int] = None
) -> NDArray[np.float64]:
    """Transfer a sphere through the registration of another one.

    The command -surface-sphere-project-unproject of Connectome Workbench does the same.

    Parameters
    ----------
    source : (faces, sphere)
        Sphere before its registration, or after it: triangles, (m, 3) int, and vertices, (n, 3) float, a bijective map.
    registered : (n, 3) array_like of float
        Its vertices after the registration, or before it.
    target : (faces, sphere)
        Sphere that is registered to `source`: triangles, (l, 3) int, and vertices, (k, 3) float, a bijective map.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    (k, 3) ndarray of float64
        Vertices of the target, each at the location on `registered` that it has on `source`. The result may have inverted
        triangles where the triangles of the target are large; `is_bijective` checks this.

    Raises
    ------
    Error
        If `source` or `target` is not bijective.

    Examples
    --------
    >>> even = sp.remesh(vertices, faces, sphere, ("octahedron", 4))
    >>> rotated = sp.resample_sphere((faces, sphere), sphere[:, [1, 2, 0]], (even.faces, even.sphere))
    >>> rotated.shape
    (66, 3)
    """
    faces, sphere = _read_sphere("source", source)
    points = read_points("registered", registered, len(sphere))
    return _core.resample_sphere(faces, sphere, points, *_read_sphere("target", target), read_threads(threads))
