"""Mesh objects of other libraries, which may replace vertices and faces."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Callable, Protocol, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._core import ErrorCode
from ._errors import Error



class Mesh(Protocol):
    """An object that has `faces` and either `vertices` (trimesh) or `points` (PyVista)."""

    @property
    def faces(self) -> Any: ...


if TYPE_CHECKING:
    from typing import TypeVar, overload

    from typing_extensions import Concatenate, ParamSpec

    P = ParamSpec("P")
    R = TypeVar("R", covariant=True)

    class OfMesh(Protocol[P, R]):
        @overload
        def __call__(self, mesh: Mesh, *args: P.args, **kwargs: P.kwargs) -> R: ...
        @overload
        def __call__(self, vertices: ArrayLike, faces: ArrayLike, *args: P.args, **kwargs: P.kwargs) -> R: ...


def is_mesh(value: Any) -> bool:
    return hasattr(value, "faces") and (hasattr(value, "vertices") or hasattr(value, "points"))


def split_mesh(mesh: Any) -> Tuple[ArrayLike, ArrayLike]:
    """Return the vertices and faces of a mesh. PyVista has a flat array of faces, each preceded by its number of vertices."""
    faces = mesh.faces
    if isinstance(faces, np.ndarray) and faces.ndim == 1 and len(faces):
        if len(faces) % 4 or (faces[::4] != 3).any():
            raise Error("the mesh has faces that are not triangles: triangulate it first", ErrorCode.NON_TRIANGULAR_MESH)
        faces = faces.reshape(-1, 4)[:, 1:]
    return mesh.vertices if hasattr(mesh, "vertices") else mesh.points, faces


def accepts_mesh(function: Callable[Concatenate[ArrayLike, ArrayLike, P], R]) -> OfMesh[P, R]:
    """Let a mesh object replace the first two arguments of a function, `vertices` and `faces`."""

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        if args and is_mesh(args[0]):
            args = (*split_mesh(args[0]), *args[1:])
        return function(*args, **kwargs)

    return call
