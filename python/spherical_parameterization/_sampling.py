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
    """Inverse of a map to the sphere: finds the surface point in each direction.

    Parameters
    ----------
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    sphere : (n, 3) array_like of float
        Images of the vertices, a bijective map, which need not be normalized.
    threads : int, optional
        Maximum number of threads, also for `locate`. By default, all cores.

    Raises
    ------
    Error
        If the faces are not a closed surface of genus 0, or if the map is not bijective.

    Notes
    -----
    Each direction corresponds to exactly one surface point. Construction takes linear time, unless long and narrow faces
    cross many cells of the grid. A locator uses about 42 bytes per face. Several Python threads may use it at once. `pickle`
    stores faces and images; the copy, for example in another process, is constructed from them.

    Examples
    --------
    >>> locator = sp.Locator(faces, sphere)
    >>> face, coordinates = locator.locate(sphere)
    >>> points = np.einsum("kc,kcx->kx", coordinates, vertices[faces[face]])
    >>> np.allclose(points, vertices)
    True
    """

    def __init__(self, faces: ArrayLike, sphere: ArrayLike, *, threads: Optional[int] = None) -> None:
        self._core = _core.Locator(read_faces("faces", faces), read_points("sphere", sphere), read_threads(threads))

    def locate(self, directions: ArrayLike) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Find the face and the barycentric coordinates in each direction.

        The face is exact. If a direction meets an edge or a vertex, the face is the first one that contains it.

        Parameters
        ----------
        directions : (k, 3) array_like of float
            Points other than the origin, which need not be normalized.

        Returns
        -------
        face : (k,) ndarray of int64
            Rows of `faces`.
        coordinates : (k, 3) ndarray of float64
            Barycentric coordinates, from 0 to 1, in the order of the vertices of the face.

        Raises
        ------
        Error
            If a direction is zero or not finite.
        """
        return self._core.locate(read_points("directions", directions))


class Remesh(NamedTuple):
    """A surface sampled at the vertices of a mesh of the sphere.

    Attributes
    ----------
    vertices : (k, 3) ndarray of float64
        Points of the surface.
    faces : (l, 3) ndarray of int64
        Triangles of the mesh of the sphere.
    sphere : (k, 3) ndarray of float64
        Directions: the map of the new mesh to the sphere.
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
    """Sample a surface at the vertices of a mesh of the sphere.

    Maps with ``prefer="sampling"`` give the most even samples.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    sphere : (n, 3) array_like of float
        Images of the vertices, a bijective map.
    domain : (str, int) or (faces, sphere)
        "octahedron", "cube" or "icosahedron" and the number of parts of each edge, from 1 to 5000. Or any mesh of the
        sphere: its triangles, (l, 3) int, and the directions of its vertices, (k, 3) float. Their rows are kept; vertices
        without a face get NaN.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    Remesh
        The new mesh and its map to the sphere.

    Raises
    ------
    Error
        If the mesh has a defect, see `find_defect`, or if one of the maps is not bijective.

    See Also
    --------
    transfer : Transfer values to the new mesh.
    measure_distance : Measure how close the new mesh is.

    Notes
    -----
    The sphere defines a bijection between the surface and the new mesh [1]_. The new mesh may intersect itself where it is
    too coarse. The time is linear in the size of the mesh and the domain, except as stated for `Locator`.

    References
    ----------
    .. [1] E. Praun, H. Hoppe: Spherical parametrization and remeshing. ACM Transactions on Graphics 22(3), 2003.

    Examples
    --------
    >>> even = sp.remesh(vertices, faces, sphere, ("icosahedron", 10))
    >>> even.vertices.shape, even.faces.shape
    ((1002, 3), (2000, 3))
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
    """Transfer values from a surface to another one that has a map to the same sphere.

    Values of floating-point types are interpolated, or averaged, weighted by areas, where the target is coarser. Rows of
    integers, bools or strings are labels: each target vertex or face gets the label with the largest weight.

    Parameters
    ----------
    source : (vertices, faces, sphere)
        Surface that has the values: points, (n, 3) float; triangles, (m, 3) int; and images of the vertices, (n, 3) float,
        a bijective map. A mesh object may replace the points and triangles.
    target : (faces, sphere)
        Surface that gets the values; its points are not needed: triangles, (l, 3) int, and images of the vertices, (k, 3)
        float, a bijective map.
    values : (n, ...) or (m, ...) array_like
        Values of each vertex or face of the source, such as (n,) or (n, 3).
    of : {"vertices", "faces"}
        Whether the values belong to vertices or faces.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    (k, ...) or (l, ...) ndarray
        Values of the target, of the same type. Vertices without a face get NaN, or the zero of the type of labels.

    Raises
    ------
    Error
        If a mesh has a defect, see `find_defect`, or if a map is not bijective.

    See Also
    --------
    resample : Resample values between cortical spheres, with the definitions of Connectome Workbench.

    Notes
    -----
    The method is adaptive barycentric resampling as for cortical surfaces [1]_, with other weights. A surface gets its own
    values back, with the same bits. The time is linear in the size of the meshes, except as stated for `Locator`, and for
    labels, which are sorted.

    References
    ----------
    .. [1] M. F. Glasser et al.: The minimal preprocessing pipelines for the Human Connectome Project. NeuroImage 80, 2013.

    Examples
    --------
    >>> even = sp.remesh(vertices, faces, sphere, ("octahedron", 16))
    >>> height = vertices[:, 2]
    >>> sp.transfer((vertices, faces, sphere), (even.faces, even.sphere), height).shape
    (1026,)
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
