from __future__ import annotations

from typing import Optional

from ._core import ErrorCode


class Error(ValueError):
    """Error in a mesh, a map, a file or a parameter.

    ``str(error)`` states the error, its location and a remedy.

    Attributes
    ----------
    code : ErrorCode
        Kind of error.
    vertex, other_vertex, face : int or None
        Location: rows of the arrays, as far as they apply. For an edge, the vertices are its ends. For a direction,
        `vertex` is its row.
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
        # pickle reconstructs the error from all of these arguments.
        super().__init__(message, code, vertex, other_vertex, face)
        self.code = code
        self.vertex = vertex
        self.other_vertex = other_vertex
        self.face = face

    def __str__(self) -> str:
        return str(self.args[0])
