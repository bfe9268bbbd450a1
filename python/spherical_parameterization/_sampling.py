from __future__ import annotations

import operator
from typing import Any, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (
    Surface,
    carry_rows,
    check_word,
    read_faces,
    read_named_surface,
    read_points,
    read_surface,
    read_threads,
    read_tuple,
    refuse,
    to_array,
)
from ._meshes import accepts_mesh

MAX_SUBDIVISION = 5000


class Locator:
    """The inverse of a map to the sphere: finds the place of the surface that has a direction.

    Parameters
    ----------
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    sphere : (n, 3) array_like of numbers
        The images of the vertices, a one-to-one map, at any distance from the origin.
    threads : int, optional
        The largest number of threads, of `locate` as well; by default all cores.

    Raises
    ------
    Error
        If the faces are no closed surface without handles, or the map is not one-to-one.

    Notes
    -----
    A locator is made in linear time, unless long and narrow faces are crossed by many cells of its grid, and keeps some 42
    bytes a face. It may be used by several threads of Python at once. `pickle` keeps faces and images, from which a
    copy, such as for another process, is made anew.
    """

    def __init__(self, faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> None:
        self._core = _core.Locator(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))

    def locate(self, directions: ArrayLike) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Finds the face and the barycentric coordinates of each direction.

        The face is exact. Of the faces that share the edge or vertex that a direction meets, it is the first one.

        Parameters
        ----------
        directions : (k, 3) array_like of numbers
            Points at any distance from the origin but 0.

        Returns
        -------
        face : (k,) ndarray of int64
            The rows of `faces`.
        coordinates : (k, 3) ndarray of float64
            From 0 to 1, in the order of the face's vertices.

        Raises
        ------
        Error
            If a direction is zero or not finite.

        Examples
        --------
        The points of the surface: ``np.einsum("kc,kcx->kx", coordinates, vertices[faces[face]])``
        """
        return self._core.locate(read_points("directions", directions))


class Remesh(NamedTuple):
    """A surface that has been sampled at the directions of a mesh of the sphere.

    Attributes
    ----------
    vertices : (k, 3) ndarray of float64
        The points of the surface.
    faces : (l, 3) ndarray of int64
        The triangles of the mesh of the sphere.
    sphere : (k, 3) ndarray of float64
        The directions: the map of the new mesh to the sphere.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    sphere: NDArray[np.float64]


@accepts_mesh
def remesh(
    vertices: ArrayLike,
    faces: ArrayLike,
    sphere: ArrayLike,
    domain: Union[Tuple[str, int], Tuple[ArrayLike, ArrayLike]],
    *,
    threads: Optional[int] = None,
) -> Remesh:
    """Samples a surface at the vertices of a mesh of the sphere. Maps with ``prefer="sampling"`` suit it best.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    sphere : (n, 3) array_like of numbers
        The images of the vertices, a one-to-one map.
    domain : (str, int) or (faces, sphere)
        "octahedron", "cube" or "icosahedron" and the number, from 1 to 5000, that its edges are divided into. Or any mesh of
        the sphere: its triangles, (l, 3) integers, and the directions of its vertices, (k, 3) numbers. Their rows are kept;
        vertices without a face get NaN.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    Remesh
        The new mesh and its map to the sphere.

    Raises
    ------
    Error
        If the mesh has no map to the sphere, or one of the maps is not one-to-one.

    Notes
    -----
    The remesh corresponds to the surface one-to-one, by the sphere [1]_. `measure_distance` tells how close it is; where it is
    too coarse, it may intersect itself. The time is linear in the size of the mesh and the domain, but for what `Locator` says.

    References
    ----------
    .. [1] E. Praun, H. Hoppe: Spherical parametrization and remeshing. ACM Transactions on Graphics 22(3), 2003.
    """
    surface = read_surface(vertices, faces, sphere)
    max_threads = read_threads(threads)
    if not isinstance(domain, (tuple, list)) or len(domain) != 2:
        raise TypeError('domain has to be a tuple: ("octahedron", 64), or (faces, sphere) of a mesh of the sphere')
    first, second = domain
    if isinstance(first, str):
        check_word("domain[0]", first, ("octahedron", "cube", "icosahedron"))
        n = operator.index(second)  # type: ignore[arg-type]
        if not 1 <= n <= MAX_SUBDIVISION:
            refuse(f"domain[1] is {n}; it has to be from 1 to {MAX_SUBDIVISION}")
        return Remesh(*_core.remesh(*surface, first, n, max_threads))
    domain_faces, directions = read_faces("domain: faces", first), read_points("domain: sphere", second)
    points, images = _core.remesh_with(*surface, domain_faces, directions, max_threads)
    has_face = np.zeros(len(directions), dtype=bool)
    has_face[domain_faces] = True
    result = Remesh(np.full(directions.shape, np.nan), domain_faces.copy(), np.full(directions.shape, np.nan))
    result.vertices[has_face] = points
    result.sphere[has_face] = images
    return result


def transfer(
    source: Surface,
    target: Tuple[ArrayLike, ArrayLike],
    values: ArrayLike,
    *,
    of: str = "vertices",
    threads: Optional[int] = None,
) -> NDArray[Any]:
    """Carries values from the vertices or faces of a surface to those of another one that has a map to the same sphere.

    Values of floating-point types are interpolated, or averaged where the target is coarser, weighted with areas. Rows
    of integers, bools or strings are labels, of which the one with the largest weight is carried over.

    Parameters
    ----------
    source : (vertices, faces, sphere)
        The surface that has the values: its points, (n, 3) numbers; its triangles, (m, 3) integers; and the images of its
        vertices, (n, 3) numbers, a one-to-one map.
    target : (faces, sphere)
        The surface that gets them, of which no points are needed: its triangles, (l, 3) integers, and the images of its
        vertices, (k, 3) numbers, a one-to-one map.
    values : (n, ...) or (m, ...) array_like
        The values of each vertex or face of the source, such as (n,) or (n, 3).
    of : {"vertices", "faces"}
        What the values belong to.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    (k, ...) or (l, ...) ndarray
        The values of the target, of the same type. Vertices without a face get NaN, and labels the zero of their type.

    Raises
    ------
    Error
        If a mesh has no map to the sphere, or a map is not one-to-one.

    Notes
    -----
    As the adaptive barycentric resampling of cortical surfaces [1]_, but with other weights. A surface gets from itself what it
    has, to the bit. The time is linear in the size of the meshes, but for what `Locator` says, and for labels, which are
    sorted.

    References
    ----------
    .. [1] M. F. Glasser et al.: The minimal preprocessing pipelines for the Human Connectome Project. NeuroImage 80, 2013.

    Examples
    --------
    What is known of a surface, for its remesh:

    >>> even = sp.remesh(vertices, faces, sphere, ("octahedron", 64))
    >>> sp.transfer((vertices, faces, sphere), (even.faces, even.sphere), thickness)
    """
    check_word("of", of, ("vertices", "faces"))
    max_threads = read_threads(threads)
    surface = read_named_surface("source", source)
    target_faces, target_sphere = read_tuple("target", target, "faces", "sphere")
    sphere_mesh = read_faces("target: faces", target_faces), read_points("target: sphere", target_sphere)
    array = to_array("values", values)
    n = len(surface[of == "faces"])
    if array.ndim == 0 or len(array) != n:
        refuse(f"values has the shape {array.shape}; it has to have {n} rows, one for each of the {of}")
    shape = (len(sphere_mesh[of == "vertices"]), *array.shape[1:])

    def carry(table: NDArray[Any]) -> NDArray[Any]:
        return _core.transfer(table, of == "faces", *surface, *sphere_mesh, max_threads)

    return carry_rows(array, shape, carry)
