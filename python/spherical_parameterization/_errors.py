from __future__ import annotations

from typing import Optional

from ._core import ErrorCode


class Error(ValueError):
    """What is wrong with a mesh, a map or a parameter. ``str()`` of it says where, and what helps.

    Attributes
    ----------
    code : ErrorCode
        What is wrong.
    vertex, other_vertex, face : int or None
        Where: rows of the arrays, as far as they apply. If an edge is wrong, the vertices are its ends; if a direction
        is, `vertex` is its row.
    """

    code: ErrorCode
    vertex: Optional[int]
    other_vertex: Optional[int]
    face: Optional[int]

    def __init__(
        self,
        message: str,
        code: ErrorCode,
        vertex: Optional[int] = None,
        other_vertex: Optional[int] = None,
        face: Optional[int] = None,
    ) -> None:
        # All of them, as a copy for another process is made of them.
        super().__init__(message, code, vertex, other_vertex, face)
        self.code = code
        self.vertex = vertex
        self.other_vertex = other_vertex
        self.face = face

    def __str__(self) -> str:
        return str(self.args[0])
