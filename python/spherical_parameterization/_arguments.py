"""Checks what the caller gives, and turns it into what the compiled part reads."""

from __future__ import annotations

from typing import Any, NoReturn, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import ErrorCode
from ._errors import Error


def refuse(message: str) -> NoReturn:
    raise Error(message, ErrorCode.WRONG_PARAMETER)


def _rows_of_three(name: str, array: NDArray[Any], what: str) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        refuse(f"{name} has the shape {array.shape}; it has to be {what}")


def read_points(name: str, value: ArrayLike, n: Optional[int] = None) -> NDArray[np.float64]:
    """Returns an array with `n` rows of three coordinates, the array itself if possible."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has the type {array.dtype}; it has to hold real numbers")
    _rows_of_three(name, array, "(n, 3): x, y and z in each row")
    if n is not None and len(array) != n:
        refuse(f"{name} has {len(array)} rows; it has to have {n}, one for each vertex")
    return np.ascontiguousarray(array, dtype=np.float64)


def read_faces(name: str, value: ArrayLike) -> NDArray[np.int64]:
    """Returns an array with rows of three vertices, the array itself if possible."""
    array = np.asarray(value)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has the type {array.dtype}; it has to hold integers, the rows of vertices")
    _rows_of_three(
        name, array, "(m, 3): the three vertices of a triangle in each row (of PyVista, faces.reshape(-1, 4)[:, 1:])"
    )
    return np.ascontiguousarray(array, dtype=np.int64)


def read_surface(
    vertices: ArrayLike, faces: ArrayLike, sphere: ArrayLike, suffix: str = ""
) -> Tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    points = read_points("vertices" + suffix, vertices)
    return points, read_faces("faces" + suffix, faces), read_points("sphere" + suffix, sphere, len(points))


def check_word(name: str, value: object, words: Sequence[str]) -> None:
    if value not in words:
        refuse(f"{name} is {value!r}; it has to be one of {', '.join(map(repr, words))}")
