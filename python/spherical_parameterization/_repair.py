from __future__ import annotations

import operator
from typing import List, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import read_faces, read_points, read_vertices, refuse, to_array
from ._meshes import accepts_mesh


class Hole(NamedTuple):
    """A hole of a surface and the patch that `fill_holes` added.

    Attributes
    ----------
    vertex : int
        A vertex of its border.
    number_of_edges : int
        Edges of its border.
    perimeter : float
        Length of its border.
    number_of_faces : int
        Patch faces; 0 if the hole was left open.
    share : float
        Fraction of the patch faces in the area of the closed surface, from 0 to 1.
    """

    vertex: int
    number_of_edges: int
    perimeter: float
    number_of_faces: int
    share: float


class FilledSurface(NamedTuple):
    """A surface whose holes have been filled.

    Attributes
    ----------
    vertices : (k, 3) ndarray of float64
        Input vertices, followed by the new ones.
    faces : (l, 3) ndarray of int64
        Input faces, followed by the patch faces.
    holes : list of Hole
        All holes.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    holes: List[Hole]


@accepts_mesh
def fill_holes(vertices: ArrayLike, faces: ArrayLike, *, max_edges: Optional[int] = None) -> FilledSurface:
    """Fill the holes of a surface, so that it can be mapped to a sphere.

    Input vertices and faces are kept, and new ones are appended: triangles between the vertices of the border, refined to
    the lengths of the edges around the hole. Patch faces may intersect other faces, which does not affect a map.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    max_edges : int, optional
        Maximum number of edges of a hole that is filled, at least 3. By default, all holes are filled.

    Returns
    -------
    FilledSurface
        The closed surface and a list of its holes.

    Raises
    ------
    Error
        If the arrays are not a mesh, if a point is not finite, or if a border touches itself or another one in a vertex.

    See Also
    --------
    repair_surface : Repair holes and all other defects.

    Examples
    --------
    The images of the input vertices are a bijective map of the surface with holes:

    >>> filled = sp.fill_holes(vertices, faces[9:])
    >>> sphere, report = sp.parameterize(filled.vertices, filled.faces)
    >>> sphere[: len(vertices)].shape
    (258, 3)
    """
    points, triangles = read_points("vertices", vertices), read_faces("faces", faces)
    most = np.iinfo(np.uint32).max if max_edges is None else operator.index(max_edges)
    if most < 3:
        refuse(f"max_edges is {most}; it has to be at least 3")
    new_points, new_triangles, holes = _core.fill_holes(points, triangles, min(most, np.iinfo(np.uint32).max))
    return FilledSurface(
        np.concatenate([points, new_points]), np.concatenate([triangles, new_triangles]), [Hole(*hole) for hole in holes]
    )


class Handle(NamedTuple):
    """A handle of a surface, which prevents a map to the sphere.

    Attributes
    ----------
    path : (k,) ndarray of int64
        Vertices of a handle cycle, a short non-separating cycle of edges: an edge joins each vertex to the next one, and
        the last one to the first. Cutting the surface along it and filling both sides removes the handle.
    length : float
        Length of the cycle.
    """

    path: NDArray[np.int64]
    length: float


@accepts_mesh
def find_handles(vertices: ArrayLike, faces: ArrayLike, *, max_handles: Optional[int] = None) -> List[Handle]:
    """Find the handles of a surface, approximately in ascending order of size.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    max_handles : int, optional
        Maximum number of handles to find, at least 1. By default, all handles are found.

    Returns
    -------
    list of Handle
        The handles; empty if the surface has genus 0.

    Raises
    ------
    Error
        If the surface has another defect, see `find_defect`.

    See Also
    --------
    repair_surface : Cut the handles.

    Notes
    -----
    The time is O(n log n) for each handle.

    Examples
    --------
    >>> sp.find_handles(vertices, faces)
    []
    """
    most = np.iinfo(np.uint32).max if max_handles is None else operator.index(max_handles)
    if most < 1:
        refuse(f"max_handles is {most}; it has to be at least 1")
    points, triangles = read_points("vertices", vertices), read_faces("faces", faces)
    return [Handle(*handle) for handle in _core.find_handles(points, triangles, min(most, np.iinfo(np.uint32).max))]


class RepairPatch(NamedTuple):
    """A hole patch or a patch on one side of a cut through a handle.

    Attributes
    ----------
    is_of_handle : bool
        Whether the patch closes a side of a cut through a handle, not a hole.
    vertex : int
        A vertex of its border, as a vertex of the input.
    number_of_edges : int
        Edges of its border.
    length : float
        Length of its border.
    share : float
        Fraction of its triangles in the area of the result, from 0 to 1.
    """

    is_of_handle: bool
    vertex: int
    number_of_edges: int
    length: float
    share: float


class RepairReport(NamedTuple):
    """Defects that `repair_surface` found and repaired, in this order.

    Attributes
    ----------
    triangulated_polygons, degenerate_faces, repeated_faces : int
        Polygons with more than three corners; polygons with fewer than three different corners, and polygons with the
        corners of another one, both of which were removed.
    merged_vertices : int
        Border vertices at the same point as another one.
    reversed_faces : int
        Faces that were oriented against the others.
    non_manifold_edges, divided_vertices : int
        Edges with more than two faces, and vertices with more than one fan of faces.
    removed_faces : int
        Faces of all components but the largest.
    split_edges : int
        Edges that joined the same two vertices as another edge.
    number_of_components : int
        Connected components, of which the largest was kept.
    handle_cycles : list of (k,) ndarray of int64
        Cycles of edges along which handles were cut, as vertices of the input.
    patches : list of RepairPatch
        Added patches.
    added_area : float
        Area of the patches over that of the result, from 0 to 1.
    """

    triangulated_polygons: int
    degenerate_faces: int
    repeated_faces: int
    merged_vertices: int
    reversed_faces: int
    non_manifold_edges: int
    divided_vertices: int
    removed_faces: int
    split_edges: int
    number_of_components: int
    handle_cycles: List[NDArray[np.int64]]
    patches: List[RepairPatch]
    added_area: float


class RepairedSurface(NamedTuple):
    """A surface that can be mapped, and the origin of its vertices and faces.

    Attributes
    ----------
    vertices : (k, 3) ndarray of float64
        Vertices.
    faces : (l, 3) ndarray of int64
        Triangles.
    source_vertices : (k,) ndarray of int64
        Vertex of the input that each vertex is, or -1.
    source_faces : (l,) ndarray of int64
        Polygon of the input that contains each triangle, or -1.
    report : RepairReport
        Defects found and repaired.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    source_vertices: NDArray[np.int64]
    source_faces: NDArray[np.int64]
    report: RepairReport


@accepts_mesh
def repair_surface(
    vertices: ArrayLike,
    faces: Union[ArrayLike, Sequence[Sequence[int]]],
    *,
    max_hole: float = np.inf,
    max_handle: float = np.inf,
    max_added_area: float = 0.05,
    refine: bool = True,
) -> RepairedSurface:
    """Make a surface that can be mapped to a sphere from any polygons.

    The function takes the following steps, each only where it is needed. It triangulates polygons, removes repeated and
    degenerate ones, merges border vertices at the same point, orients faces consistently, splits non-manifold edges and
    vertices, keeps the largest component, fills holes, cuts handles where that adds the least area, and splits repeated
    edges. No point moves.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points, or a mesh object instead of `vertices` and `faces`.
    faces : (m, k) array_like of int, or sequence of sequences of int
        Vertices of each polygon, in order around it.
    max_hole, max_handle : float, optional
        Maximum length of the border of a hole to fill, and of the cycle along which a handle is cut, in units of the square
        root of the area. By default, there is no limit.
    max_added_area : float, optional
        Maximum area of all patches over the area of the result, from 0 to 1.
    refine : bool, optional
        Whether the patch faces are about as large as their neighbors. Otherwise, they are as few as possible.

    Returns
    -------
    RepairedSurface
        The surface, the origin of its vertices and faces, and a report.

    Raises
    ------
    Error
        If the arrays are not polygons, if a point is not finite, or if a hole, a handle or the total area of patches
        exceeds its limit.

    See Also
    --------
    find_defect : Check whether a surface needs a repair.

    Notes
    -----
    Vertices and faces that are kept are in the order of the input, followed by the new ones. The time is quasi-linear in the size of
    input and result.

    Examples
    --------
    >>> repaired = sp.repair_surface(vertices, faces[9:])
    >>> sphere, report = sp.parameterize(repaired.vertices, repaired.faces)

    Values of the input vertices apply to all vertices of the result whose source is not -1:

    >>> is_old = repaired.source_vertices >= 0
    >>> np.array_equal(vertices[repaired.source_vertices[is_old]], repaired.vertices[is_old])
    True
    """
    points = read_points("vertices", vertices)
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        k = faces.shape[1]
        corners = read_vertices("faces", faces, k, "(m, k): the vertices of a polygon in each row").ravel()
        first = np.arange(len(faces) + 1, dtype=np.int64) * k
    else:
        rows = [to_array("faces", row, None) for row in faces]  # type: ignore[union-attr, arg-type]
        for row in rows:
            if row.ndim != 1 or (row.size > 0 and row.dtype.kind not in "iu"):
                raise TypeError("faces has to hold a row of integers for each polygon: its vertices")
        corners = np.concatenate([np.empty(0, np.int64), *rows]).astype(np.int64)
        first = np.cumsum([0, *(len(row) for row in rows)], dtype=np.int64)
    new_points, triangles, source_vertices, source_faces, counts, components, cycles, patches, added = _core.repair_surface(
        points, corners, first, float(max_hole), float(max_handle), float(max_added_area), bool(refine)
    )
    report = RepairReport(*counts, components, cycles, [RepairPatch(*patch) for patch in patches], added)
    return RepairedSurface(new_points, triangles, source_vertices, source_faces, report)
