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
