from __future__ import annotations

from typing import Optional

from ._core import ErrorCode


# What helps, where the compiled part names functions of C++.
_IN_PYTHON = (
    ("duplicate the edge, for example with CGAL::Polygon_mesh_processing::orient_polygon_soup()",
     "duplicate the edge, for example with meshing_repair_non_manifold_edges() of pymeshlab"),
    ("CGAL::Polygon_mesh_processing::orient_polygon_soup()", "trimesh.repair.fix_winding()"),
    ("CGAL::Polygon_mesh_processing::repair_polygon_soup()", "trimesh.Trimesh(vertices, faces, validate=True)"),
    ("CGAL::Polygon_mesh_processing::stitch_borders()", "merge_vertices() of trimesh"),
    ("CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()",
     "meshing_repair_non_manifold_vertices() of pymeshlab"),
    ("CGAL::Polygon_mesh_processing::split_connected_components(), or keep the largest, with "
     "keep_largest_connected_components()", "split() of trimesh, or keep the largest"),
    ("Split one of the edges, for example with CGAL::Euler::split_edge()", "Split one of the edges"),
    ("CGAL::alpha_wrap_3()", "generate_alpha_wrap() of pymeshlab"),
)


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
        for of_cpp, of_python in _IN_PYTHON:
            message = message.replace(of_cpp, of_python)
        # All of them, as a copy for another process is made of them.
        super().__init__(message, code, vertex, other_vertex, face)
        self.code = code
        self.vertex = vertex
        self.other_vertex = other_vertex
        self.face = face

    def __str__(self) -> str:
        return str(self.args[0])
