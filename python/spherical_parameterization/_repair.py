from __future__ import annotations

import operator
from typing import List, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import read_faces, read_points, read_vertices, refuse, to_array
from ._meshes import accepts_mesh


class Hole(NamedTuple):
    """A hole of a surface, and what `fill_holes` has filled it with.

    Attributes
    ----------
    vertex : int
        One of its border.
    number_of_edges : int
        Edges of its border.
    perimeter : float
        The length of its border.
    number_of_faces : int
        Faces that it has been filled with, 0 if it has been left open.
    share : float
        The share of these in the area of the closed surface, from 0 to 1.
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
        Those that were given, and new ones behind them.
    faces : (l, 3) ndarray of int64
        Those that were given, and those of the patches behind them.
    holes : list of Hole
        All holes.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    holes: List[Hole]


@accepts_mesh
def fill_holes(vertices: ArrayLike, faces: ArrayLike, *, max_edges: Optional[int] = None) -> FilledSurface:
    """Fills the holes of a surface, so that it can be mapped to a sphere.

    Vertices and faces stay what they are, and new ones are added behind them: triangles between the vertices of the border,
    refined to the lengths of the edges around the hole. They may intersect others, which does not matter to a map.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    max_edges : int, optional
        The largest number of edges of a hole that is filled, at least 3; by default any.

    Returns
    -------
    FilledSurface
        The closed surface, and what is known of its holes.

    Raises
    ------
    Error
        If the arrays are no mesh, a point is not finite, or a border touches itself or another one in a vertex.

    Examples
    --------
    >>> filled = sp.fill_holes(vertices, faces)
    >>> sphere, report = sp.parameterize(filled.vertices, filled.faces)
    >>> sphere[: len(vertices)]  # a one-to-one map of the surface with holes
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
    """A handle of a surface, which keeps it from being mapped to a sphere.

    Attributes
    ----------
    path : (k,) ndarray of int64
        The vertices of a short closed path around it, or through it: each is joined to the next one by an edge, and the last one
        to the first. Where the surface is cut along it, and both sides are filled, there is one handle less.
    length : float
        The length of the path.
    """

    path: NDArray[np.int64]
    length: float


@accepts_mesh
def find_handles(vertices: ArrayLike, faces: ArrayLike, *, max_handles: Optional[int] = None) -> List[Handle]:
    """Finds the handles of a surface, tiny ones first as far as that is easily found.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    max_handles : int, optional
        The largest number of handles that are looked for, at least 1; by default any.

    Returns
    -------
    list of Handle
        All handles, none if the surface has the topology of a sphere.

    Raises
    ------
    Error
        If anything else is wrong with the surface, see `find_defect`.
    """
    most = np.iinfo(np.uint32).max if max_handles is None else operator.index(max_handles)
    if most < 1:
        refuse(f"max_handles is {most}; it has to be at least 1")
    points, triangles = read_points("vertices", vertices), read_faces("faces", faces)
    return [Handle(*handle) for handle in _core.find_handles(points, triangles, min(most, np.iinfo(np.uint32).max))]


class RepairPatch(NamedTuple):
    """A part that was added to a surface, to close a hole or one side of a cut through a handle.

    Attributes
    ----------
    is_of_handle : bool
        Or of a hole.
    vertex : int
        One of its border, as a vertex of the input.
    number_of_edges : int
        Edges of its border.
    length : float
        The length of its border.
    share : float
        The share of its triangles in the area of the result, from 0 to 1.
    """

    is_of_handle: bool
    vertex: int
    number_of_edges: int
    length: float
    share: float


class RepairReport(NamedTuple):
    """What `repair_surface` found and did, in this order.

    Attributes
    ----------
    triangulated_polygons, degenerate_faces, repeated_faces : int
        Polygons with more than three corners; those with less than three different ones, and those with the corners of another
        one, which were removed.
    merged_vertices : int
        Vertices of borders at the same point as another one.
    reversed_faces : int
        Faces that were oriented against the others.
    non_manifold_edges, divided_vertices : int
        Edges with more than two faces, and vertices with more than one fan of faces.
    removed_faces : int
        Faces of all components but the largest.
    split_edges : int
        Edges of several that joined the same two vertices.
    number_of_components : int
        Of which the largest was kept.
    handle_cycles : list of (k,) ndarray of int64
        The cycles of edges that handles were cut along, as vertices of the input.
    patches : list of RepairPatch
        What was added.
    added_area : float
        The area of the patches over that of the result, from 0 to 1.
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
    """A surface that can be mapped, and where its parts come from.

    Attributes
    ----------
    vertices : (k, 3) ndarray of float64
        The vertices.
    faces : (l, 3) ndarray of int64
        The triangles.
    source_vertices : (k,) ndarray of int64
        Which vertex of the input each vertex is, or -1.
    source_faces : (l,) ndarray of int64
        Which polygon of the input each triangle is a part of, or -1.
    report : RepairReport
        What was found and done.
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
    """Makes a surface that can be mapped to a sphere of any polygons.

    Polygons are triangulated, repeated and degenerate ones removed, vertices of borders at the same point merged, faces
    oriented alike, edges and vertices that are no manifold divided, all components but the largest removed, holes filled,
    handles cut where that adds least area, and repeated edges divided; each only where it is needed. No point is moved.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points.
    faces : (m, k) array_like of integers, or sequence of sequences of integers
        The vertices of each polygon, in order around it.
    max_hole, max_handle : float, optional
        The length of the border of a hole that is filled, and of the cycle that a handle is cut along, in units of the square
        root of the area; by default any.
    max_added_area : float, optional
        All that is added over the area of the result, from 0 to 1.
    refine : bool, optional
        Whether the triangles of what is added are about as large as their neighbors; or as few as can be.

    Returns
    -------
    RepairedSurface
        The surface, where its parts come from, and what was done.

    Raises
    ------
    Error
        If the arrays are no polygons, a point is not finite, or a hole, a handle or all of them are beyond the limits.

    Examples
    --------
    >>> repaired = sp.repair_surface(vertices, faces)
    >>> sphere, report = sp.parameterize(repaired.vertices, repaired.faces)
    >>> values[repaired.source_vertices]  # where that is not -1
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
                raise TypeError("faces has to hold a row of integers for each polygon, its vertices")
        corners = np.concatenate([np.empty(0, np.int64), *rows]).astype(np.int64)
        first = np.cumsum([0, *(len(row) for row in rows)], dtype=np.int64)
    new_points, triangles, source_vertices, source_faces, counts, components, cycles, patches, added = _core.repair_surface(
        points, corners, first, float(max_hole), float(max_handle), float(max_added_area), bool(refine)
    )
    report = RepairReport(*counts, components, cycles, [RepairPatch(*patch) for patch in patches], added)
    return RepairedSurface(new_points, triangles, source_vertices, source_faces, report)
