from __future__ import annotations

import operator
from typing import List, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import read_faces, read_points, refuse


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
        Those that were given, and those of the filler behind them.
    holes : list of Hole
        All holes.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    holes: List[Hole]


def fill_holes(vertices: ArrayLike, faces: ArrayLike, *, max_edges: Optional[int] = None) -> FilledSurface:
    """Fills the holes of a surface, so that it can be mapped to a sphere.

    Vertices and faces stay what they are, and new ones are added behind them: triangles between the vertices of the border,
    refined to the edge lengths around the hole, or an edge from each to a vertex in the middle. They may intersect others,
    which is of no consequence for a map.

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


def find_handles(vertices: ArrayLike, faces: ArrayLike, *, max_handles: Optional[int] = None) -> List[Handle]:
    """Finds the handles of a surface, tiny ones first as far as that is easily found.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    max_handles : int, optional
        The largest number of handles that are looked for, at least 1; by default any. Each takes 0.2 s on 100,000 vertices.

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
