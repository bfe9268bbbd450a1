"""Check the arguments of the public functions and convert them to the types that the compiled part takes."""

from __future__ import annotations

import operator
import sys
from typing import Any, Callable, List, NoReturn, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import ErrorCode
from ._errors import Error
from ._meshes import Mesh, is_mesh, split_mesh

Surface = Union[Tuple[ArrayLike, ArrayLike, ArrayLike], Tuple[Mesh, ArrayLike]]  # vertices, faces, sphere
SurfaceArrays = Tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]
Callback = Optional[Callable[..., Any]]
Features = Sequence[Tuple[ArrayLike, ArrayLike]]


def refuse(message: str) -> NoReturn:
    raise Error(message, ErrorCode.WRONG_PARAMETER)


def to_array(name: str, value: ArrayLike, columns: Optional[int] = None) -> NDArray[Any]:
    """Return the value as an array. An empty list, which has neither a type nor columns, gets `columns` if that is given."""
    is_nested = isinstance(value, (list, tuple))
    if np.ma.is_masked(value) or (is_nested and any(np.ma.is_masked(row) for row in value)):  # type: ignore[union-attr]
        refuse(f"{name} has masked values, which cannot be ignored: replace them, for example with filled()")
    try:
        array = np.asarray(value)
    except ValueError:
        refuse(f"{name} is not an array: its parts differ in shape")
    return np.empty((0, columns), int) if columns and array.shape == (0,) else array


def _rows(name: str, array: NDArray[Any], columns: int, what: str) -> None:
    if array.ndim != 2 or array.shape[1] != columns:
        refuse(f"{name} has the shape {array.shape}; it has to be {what}")


def read_points(name: str, value: ArrayLike, n: Optional[int] = None) -> NDArray[np.float64]:
    """Return an array with `n` rows of three coordinates, the array itself if possible."""
    array = to_array(name, value, 3)
    if array.dtype.kind not in "bfiu":
        raise TypeError(f"{name} has the type {array.dtype}; it has to hold real numbers")
    _rows(name, array, 3, "(n, 3): x, y and z in each row")
    if n is not None and len(array) != n:
        refuse(f"{name} has {len(array)} rows; it has to have {n}, one for each vertex")
    return np.ascontiguousarray(array, dtype=np.float64)


def read_vertices(name: str, value: ArrayLike, columns: int, what: str) -> NDArray[np.int64]:
    """Return an array with rows of vertices, the array itself if possible."""
    array = to_array(name, value, columns)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has the type {array.dtype}; it has to hold integers, the indices of vertices")
    _rows(name, array, columns, what)
    too_large = np.argwhere(array > np.iinfo(np.int64).max) if array.dtype == np.uint64 else ()
    if len(too_large):
        row, column = too_large[0]
        refuse(f"{name}: row {row} has the vertex {array[row, column]}, but there are fewer vertices.\n(Rows are counted from 0.)")
    return np.ascontiguousarray(array, dtype=np.int64)


def read_faces(name: str, value: ArrayLike) -> NDArray[np.int64]:
    what = "(m, 3): the three vertices of a triangle in each row (of PyVista, faces.reshape(-1, 4)[:, 1:])"
    return read_vertices(name, value, 3, what)


def read_surface(vertices: ArrayLike, faces: ArrayLike, sphere: ArrayLike, prefix: str = "") -> SurfaceArrays:
    points = read_points(prefix + "vertices", vertices)
    return points, read_faces(prefix + "faces", faces), read_points(prefix + "sphere", sphere, len(points))


def read_tuple(name: str, value: Any, *parts: str) -> Sequence[Any]:
    """Return the parts of a tuple. A mesh object may replace the first two."""
    if isinstance(value, (tuple, list)) and 0 < len(value) < len(parts) and is_mesh(value[0]):
        value = (*split_mesh(value[0]), *value[1:])
    # An array with this number of rows would otherwise pass as a tuple.
    if not isinstance(value, (tuple, list)) or len(value) != len(parts):
        raise TypeError(f"{name} has to be a tuple: ({', '.join(parts)})")
    return value


def read_named_surface(name: str, value: Surface) -> SurfaceArrays:
    return read_surface(*read_tuple(name, value, "vertices", "faces", "sphere"), f"{name}: ")


def read_two_surfaces(surface1: Surface, surface2: Surface) -> Tuple[SurfaceArrays, SurfaceArrays]:
    return read_named_surface("surface1", surface1), read_named_surface("surface2", surface2)


ValuesOfBoth = Tuple[NDArray[np.float64], NDArray[np.float64]]


def _read_values(name: str, value: Any, kinds: str, *surfaces: SurfaceArrays) -> ValuesOfBoth:
    """Return a pair of arrays with a number for each vertex of each surface; `kinds` are the accepted kinds of types."""

    def read(name: str, value: ArrayLike, n: int) -> NDArray[np.float64]:
        array = to_array(name, value)
        if array.dtype.kind not in kinds:
            raise TypeError(f"{name} has the type {array.dtype}; it has to hold real numbers")
        if array.shape != (n,):
            refuse(f"{name} has the shape {array.shape}; it has to be ({n},): a number for each vertex")
        if not np.isfinite(array).all():
            refuse(f"{name} is infinite or not a number at vertex {np.flatnonzero(~np.isfinite(array))[0]}")
        return np.ascontiguousarray(array, dtype=np.float64)

    pair = read_tuple(name, value, "values of surface1", "values of surface2")
    values1, values2 = (read(f"{name}[{i}]", pair[i], len(surfaces[i][0])) for i in (0, 1))
    return values1, values2


def read_features(features: Features, *surfaces: SurfaceArrays) -> List[ValuesOfBoth]:
    return [_read_values(f"features[{k}]", feature, "fiu", *surfaces) for k, feature in enumerate(features)]


def read_feature_weights(weights: Optional[Sequence[float]], n: int) -> List[float]:
    if weights is None:
        return []
    result = [float(w) for w in weights]
    if len(result) != n:
        refuse(f"feature_weights has {len(result)} numbers; it has to have {n}, one for each feature")
    if not all(0 <= w < np.inf for w in result) or not any(result):
        refuse(f"feature_weights is {result}; the numbers have to be 0 or more, and not all 0")
    return result


def read_masks(masks: Optional[Tuple[ArrayLike, ArrayLike]], *surfaces: SurfaceArrays) -> List[ValuesOfBoth]:
    if masks is None:
        return []
    pair = _read_values("masks", masks, "bfiu", *surfaces)
    for i in (0, 1):
        if not pair[i].any():
            refuse(f"masks[{i}] is false for all vertices: it excludes the whole surface")
    return [pair]


def read_density(density: Any, n_vertices: int, n_faces: int) -> Tuple[Optional[NDArray[np.float64]], bool]:
    """Return the densities, empty if all are equal, and whether they belong to faces."""
    if density is None:
        return None, False
    if isinstance(density, str):
        check_word("density", density, ("equal",))
        return np.empty(0), False
    array = to_array("density", density)
    if array.dtype.kind not in "bfiu":
        raise TypeError(f"density has the type {array.dtype}; it has to hold real numbers")
    if array.shape not in ((n_vertices,), (n_faces,)):
        refuse(
            f"density has the shape {array.shape}; it has to be ({n_vertices},), a number for each vertex, "
            f"or ({n_faces},), one for each face"
        )
    is_of_faces = array.shape != (n_vertices,)
    is_wrong = ~((array >= 0) & (array < np.inf))
    if is_wrong.any():
        k = np.flatnonzero(is_wrong)[0]
        what = f"face {k}" if is_of_faces else f"vertex {k}"
        raise Error(
            f"the density of {what} is {array[k]}; it has to be 0 or more, and finite.\n(Rows are counted from 0.)",
            ErrorCode.INVALID_DENSITY,
            **{"face" if is_of_faces else "vertex": int(k)},
        )
    if len(array) and not array.any():
        raise Error("density is 0 everywhere: it prescribes no area for any part of the surface", ErrorCode.INVALID_DENSITY)
    return np.ascontiguousarray(array, dtype=np.float64), is_of_faces


def carry_rows(
    values: NDArray[Any], shape: Tuple[int, ...], carry: Callable[[NDArray[Any]], NDArray[Any]]
) -> NDArray[Any]:
    """Transfer values: floating-point numbers as a table of doubles, labels (rows of any other type) by their indices.

    `carry` takes and returns such tables. The index of a missing label is negative.
    """
    rows = values.reshape(len(values), int(np.prod(shape[1:])))
    if values.dtype.kind == "f":
        return carry(np.ascontiguousarray(rows, dtype=np.float64)).astype(values.dtype).reshape(shape)
    if values.dtype.kind not in "biuSU":
        raise TypeError(f"values has the type {values.dtype}; it has to hold real numbers, bools or strings")
    labels, codes = np.unique(rows, axis=0, return_inverse=True)
    carried = carry(codes.reshape(len(rows), 1).astype(np.int64))[:, 0]
    result = np.zeros((len(carried), rows.shape[1]), dtype=values.dtype)
    result[carried >= 0] = labels[carried[carried >= 0]]
    return result.reshape(shape)


def check_word(name: str, value: object, words: Sequence[str]) -> None:
    if value not in words:
        refuse(f"{name} is {value!r}; it has to be one of {', '.join(map(repr, words))}")


def read_threads(threads: Optional[int]) -> int:
    """Return the maximum number of threads, or 0 for all cores."""
    if threads is None:
        return 0
    n = operator.index(threads)
    if n < 1:
        refuse(f"threads is {threads}; it has to be at least 1")
    return min(n, sys.maxsize)


def read_max_vertices(max_vertices: Optional[int]) -> Optional[int]:
    """Return the maximum number of vertices of a refinement, or None for the default."""
    if max_vertices is None:
        return None
    n = operator.index(max_vertices)
    if n < 0:
        refuse(f"max_vertices is {max_vertices}; it has to be at least 0")
    return min(n, 2**32 - 2)


def read_run(
    threads: Optional[int], time_limit: Optional[float], callback: Callback, on_interrupt: str
) -> Tuple[int, float, Callback, bool]:
    """Return the arguments that the compiled part takes for a run that can be stopped."""
    seconds = 0.0 if time_limit is None else float(time_limit)
    if time_limit is not None and not seconds > 0:
        refuse(f"time_limit is {time_limit}; it has to be positive")
    if callback is not None and not callable(callback):
        raise TypeError(f"callback is {callback!r}; it has to be a function")
    check_word("on_interrupt", on_interrupt, ("raise", "return"))
    return read_threads(threads), seconds, callback, on_interrupt == "return"
