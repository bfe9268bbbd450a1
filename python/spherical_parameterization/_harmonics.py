from __future__ import annotations

import operator
from typing import Any, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import check_word, read_faces, read_points, read_surface, read_threads, refuse, to_array
from ._core import ErrorCode
from ._errors import Error
from ._meshes import accepts_mesh
from ._sampling import MAX_SUBDIVISION, Remesh

MAX_DEGREE = 1000
NORMALIZATIONS = ("4pi", "ortho", "schmidt")


def read_convention(normalization: str, csphase: int) -> Tuple[str, bool]:
    check_word("normalization", normalization, NORMALIZATIONS)
    if csphase not in (1, -1):
        refuse(f"csphase is {csphase!r}; it has to be 1, or -1 with the Condon-Shortley phase")
    return normalization, csphase == -1


def read_table_of_coefficients(value: ArrayLike) -> Tuple[NDArray[np.float64], Tuple[int, ...]]:
    """Return the coefficients as an array (functions, 2, L + 1, L + 1), and the shape of the functions."""
    array = to_array("coefficients", value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"coefficients has the type {array.dtype}; it has to hold real numbers")
    n = array.shape[-1] if array.ndim >= 3 else 0
    if array.shape[-3:] != (2, n, n) or n == 0:
        refuse(f"coefficients has the shape {array.shape}; it has to end with 2, L + 1 and L + 1 for the degree L")
    if n - 1 > MAX_DEGREE:
        refuse(f"the degree of coefficients is {n - 1}; it may be at most {MAX_DEGREE}")
    if not np.isfinite(array).all():
        refuse(f"coefficients is infinite or not a number at {tuple(np.argwhere(~np.isfinite(array))[0].tolist())}")
    functions = array.shape[:-3]
    return np.ascontiguousarray(array.reshape(-1, 2, n, n), dtype=np.float64), functions


def _read_directions(name: str, value: ArrayLike) -> NDArray[np.float64]:
    directions = read_points(name, value)
    wrong = np.flatnonzero(~(np.isfinite(directions).all(axis=1) & directions.any(axis=1)))
    if wrong.size:
        row = int(wrong[0])
        message = f"{name}: row {row} is zero, infinite or not a number.\n(Rows are counted from 0.)"
        raise Error(message, ErrorCode.INVALID_DIRECTION, row)
    return directions


class HarmonicFit(NamedTuple):
    """Quality of an expansion into spherical harmonics.

    Errors are in the unit of the functions. For the points of a surface, they are distances.

    Attributes
    ----------
    error_over_surface : float
        Root mean square error over the whole surface, weighted by area.
    error_at_vertices : float
        Root mean square error at the vertices, weighted by the areas around them.
    aliasing : float
        Root mean square difference, over the sphere, from the expansion with half as many nodes in each direction; 0 for
        ``weights="vertices"``.
    number_of_iterations : int
        Iterations of conjugate gradients; 0 if none are needed.
    degree_of_vertices : int
        Maximum degree supported by the sampling: the largest degree that has no more coefficients than there are vertices.
        Higher degrees describe the flat faces, not the shape.
    """

    error_over_surface: float
    error_at_vertices: float
    aliasing: float
    number_of_iterations: int
    degree_of_vertices: int


@accepts_mesh
def expand(
    vertices: ArrayLike,
    faces: ArrayLike,
    sphere: ArrayLike,
    degree: int,
    *,
    values: Optional[ArrayLike] = None,
    weights: str = "surface",
    normalization: str = "4pi",
    csphase: int = 1,
    threads: Optional[int] = None,
) -> Tuple[NDArray[np.float64], HarmonicFit]:
    """Expand a surface, or values of its vertices, into real spherical harmonics.

    A map with ``prefer="sampling"`` gives the smallest errors. To compare surfaces, use the default map instead: it depends
    less on the triangulation, so that the coefficients of equal surfaces differ less.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle.
    sphere : (n, 3) array_like of float
        Images of the vertices, a bijective map.
    degree : int
        Maximum degree L, from 0 to 1000. Degrees above ``fit.degree_of_vertices``, the square root of n minus 1, describe
        the flat faces, not the shape.
    values : (n, ...) array_like of float, optional
        Values to expand instead of the points.
    weights : {"surface", "sphere", "vertices"}
        Weighting of the squared error, whose minimum is computed: by areas of the surface or of the sphere, both at nodes
        spread over the sphere; or by areas of the surface at the vertices only.
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the harmonics, as in pyshtools: the integral of the square of a harmonic of degree l is 4 pi, 1, or
        4 pi / (2 l + 1).
    csphase : {1, -1}
        -1 to include the Condon-Shortley phase, 1 to omit it.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    coefficients : (3, 2, L + 1, L + 1) or (..., 2, L + 1, L + 1) ndarray of float64
        Coefficients of each coordinate or value, in its unit: ``[..., 0, l, m]`` belongs to the cosine of order m,
        ``[..., 1, l, m]`` to the sine.
    fit : HarmonicFit
        Quality of the expansion.

    Raises
    ------
    Error
        If the mesh has a defect, see `find_defect`, or if the map is not bijective. With ``weights="vertices"``, also if
        there are fewer vertices than coefficients.

    See Also
    --------
    reconstruct : Evaluate an expansion.
    spectrum : Compute the power of each degree.
    standard_position : Make the coefficients of different surfaces comparable.

    Notes
    -----
    The harmonics are those of pyshtools, whose functions take ``coefficients[k]`` [1]_. Such expansions describe shapes in
    statistics since [2]_. The time grows with the third power of L: one second for L = 100, seven seconds for L = 200.

    References
    ----------
    .. [1] M. A. Wieczorek, M. Meschede: SHTools. Geochemistry, Geophysics, Geosystems 19, 2018.
    .. [2] Ch. Brechbuehler, G. Gerig, O. Kuebler: Parametrization of closed surfaces for 3-D shape description. Computer
       Vision and Image Understanding 61(2), 1995.

    Examples
    --------
    >>> coefficients, fit = sp.expand(vertices, faces, sphere, 8)
    >>> coefficients.shape
    (3, 2, 9, 9)
    >>> smooth = sp.reconstruct(coefficients, ("octahedron", 16))
    """
    surface = read_surface(vertices, faces, sphere)
    max_threads = read_threads(threads)
    convention = read_convention(normalization, csphase)
    check_word("weights", weights, ("surface", "sphere", "vertices"))
    n = operator.index(degree)
    if not 0 <= n <= MAX_DEGREE:
        refuse(f"degree is {degree}; it has to be from 0 to {MAX_DEGREE}")
    table, functions = None, (3,)
    if values is not None:
        array = to_array("values", values)
        if array.dtype.kind not in "bfiu":
            raise TypeError(f"values has the type {array.dtype}; it has to hold real numbers")
        if array.ndim == 0 or len(array) != len(surface[0]) or array.size == 0:
            refuse(f"values has the shape {array.shape}; it has to have {len(surface[0])} rows, one for each vertex")
        if not np.isfinite(array).all():
            refuse(f"values is infinite or not a number at vertex {np.argwhere(~np.isfinite(array))[0][0]}")
        table, functions = np.ascontiguousarray(array.reshape(len(array), -1), dtype=np.float64), array.shape[1:]
    coefficients, fit = _core.expand(*surface, table, n, weights, *convention, max_threads)
    return coefficients.reshape(*functions, 2, n + 1, n + 1), HarmonicFit(*fit)


def reconstruct(
    coefficients: ArrayLike,
    where: Union[ArrayLike, Tuple[str, int], Tuple[ArrayLike, ArrayLike]],
    *,
    normalization: str = "4pi",
    csphase: int = 1,
    threads: Optional[int] = None,
) -> Any:
    """Evaluate spherical harmonics at directions, or build a surface from them.

    Parameters
    ----------
    coefficients : (..., 2, L + 1, L + 1) array_like of float
        Coefficients of any number of functions. ``coefficients[..., :9, :9]`` omits all degrees above 8.
    where : (k, 3) array_like of float, (str, int) or (faces, sphere)
        Directions, which need not be normalized. If the functions are the coordinates of a surface, a tuple or list
        instead defines the sampling of the sphere: "octahedron", "cube" or "icosahedron" and the number of parts of each
        edge, from 1 to 5000; or any mesh of the sphere.
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the coefficients, see `expand`.
    csphase : {1, -1}
        Phase of the coefficients, see `expand`.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    (k, ...) ndarray of float64, or Remesh
        Values at each direction, such as (k,) or (k, 3); or the surface.

    Raises
    ------
    Error
        If a direction is zero or not finite, or if the shape of the coefficients is not one of those above.

    See Also
    --------
    expand : Compute the coefficients of a surface.

    Notes
    -----
    The time is O(k L**2) for k directions.

    Examples
    --------
    >>> coefficients, fit = sp.expand(vertices, faces, sphere, 8)
    >>> sp.reconstruct(coefficients, [[0, 0, 1], [1, 0, 0]]).shape
    (2, 3)
    """
    array, functions = read_table_of_coefficients(coefficients)
    convention = read_convention(normalization, csphase)
    max_threads = read_threads(threads)

    def at(directions: NDArray[np.float64]) -> NDArray[np.float64]:
        return _core.evaluate_harmonics(array, *convention, directions, max_threads)

    is_domain = isinstance(where, (tuple, list)) and len(where) == 2 and (isinstance(where[0], str) or np.ndim(where[0]) == 2)
    if not is_domain:
        return at(_read_directions("where", where)).reshape(-1, *functions)
    if functions != (3,):
        refuse(f"coefficients has the shape {np.shape(coefficients)}; that of a surface has to be (3, 2, L + 1, L + 1)")
    first, second = where  # type: ignore[misc]
    if isinstance(first, str):
        check_word("where[0]", first, ("octahedron", "cube", "icosahedron"))
        n = operator.index(second)  # type: ignore[arg-type]
        if not 1 <= n <= MAX_SUBDIVISION:
            refuse(f"where[1] is {n}; it has to be from 1 to {MAX_SUBDIVISION}")
        faces, sphere = _core.make_domain(first, n)
    else:
        faces, sphere = read_faces("where: faces", first).copy(), _read_directions("where: sphere", second)
        sphere = sphere / np.linalg.norm(sphere, axis=1, keepdims=True)
    return Remesh(at(sphere), faces, sphere)


def spectrum(coefficients: ArrayLike, *, normalization: str = "4pi") -> NDArray[np.float64]:
    """Compute the power of each degree.

    The power of a degree is the mean square, over the sphere, of the part of this degree, summed over all functions. It is
    independent of the normalization and invariant under rotations.

    Parameters
    ----------
    coefficients : (..., 2, L + 1, L + 1) array_like of float
        Coefficients of any number of functions, such as the coordinates of a surface.
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the coefficients, see `expand`.

    Returns
    -------
    (L + 1,) ndarray of float64
        Power of the degrees 0 to L, in the square of the unit of the functions.

    Raises
    ------
    Error
        If the shape of the coefficients is not the one above.

    Examples
    --------
    >>> coefficients = np.zeros((2, 3, 3))
    >>> coefficients[0, 2, 1] = 3
    >>> sp.spectrum(coefficients)
    array([0., 0., 9.])
    """
    array, _ = read_table_of_coefficients(coefficients)
    check_word("normalization", normalization, NORMALIZATIONS)
    degrees = np.arange(array.shape[-1])
    factors = {"4pi": 1.0, "ortho": 4 * np.pi, "schmidt": 2 * degrees + 1}[normalization]
    squares = np.tril(array**2)
    squares[:, 1, :, 0] = 0  # the sine of order 0
    return np.asarray(squares.sum(axis=(0, 1, 3)) / factors)


class StandardPosition(NamedTuple):
    """Standard position of a surface: the motion applied and its reliability.

    Attributes
    ----------
    rotation_of_surface, rotation_of_sphere : (3, 3) ndarray of float64
        A point p moves to ``rotation_of_surface @ (p - center)``, a direction q to ``rotation_of_sphere @ q``.
    center : (3,) ndarray of float64
        Mean of the surface over the sphere, in the unit of the surface.
    semi_axes : (3,) ndarray of float64
        Semi-axes of the ellipsoid of degree 1, in the unit of the surface, the largest one first. The last one is negative
        if the surface is inside out: then reverse its faces, ``faces[:, ::-1]``, and map it again.
    skewness : (3,) ndarray of float64
        Third moments along the axes over the powers 3/2 of the second moments. The first two are positive.
    axes_are_determined : bool
        Whether the lengths of any two axes differ by more than a hundredth. Otherwise, noise determines the rotation about
        the third axis.
    signs_are_determined : bool
        Whether the skewness along the first two axes is above a hundredth. Otherwise, noise determines whether the surface
        is rotated by a half-turn.
    """

    rotation_of_surface: NDArray[np.float64]
    rotation_of_sphere: NDArray[np.float64]
    center: NDArray[np.float64]
    semi_axes: NDArray[np.float64]
    skewness: NDArray[np.float64]
    axes_are_determined: bool
    signs_are_determined: bool


def standard_position(
    coefficients: ArrayLike, *, normalization: str = "4pi", csphase: int = 1, threads: Optional[int] = None
) -> Tuple[NDArray[np.float64], StandardPosition]:
    """Move a surface to standard position and rotate its sphere accordingly.

    The center of the ellipsoid of degree 1 moves to the origin. Its axes are aligned with the coordinate axes, in space and
    on the sphere. The coefficients of similar surfaces then become comparable, whatever their original pose. The scale does
    not change.

    Parameters
    ----------
    coefficients : (3, 2, L + 1, L + 1) array_like of float
        Coefficients of the surface, L > 0. They are not modified.
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the coefficients, see `expand`.
    csphase : {1, -1}
        Phase of the coefficients, see `expand`.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    coefficients : (3, 2, L + 1, L + 1) ndarray of float64
        Coefficients of the moved surface, with the same normalization.
    position : StandardPosition
        The motion, and whether noise determines it.

    Raises
    ------
    Error
        If the ellipsoid is a point or a line.

    Examples
    --------
    >>> coefficients, fit = sp.expand(vertices, faces, sphere, 8)
    >>> coefficients, position = sp.standard_position(coefficients)
    >>> position.axes_are_determined  # the tetrahedron has no longest axis
    False
    """
    array, functions = read_table_of_coefficients(coefficients)
    convention = read_convention(normalization, csphase)
    max_threads = read_threads(threads)
    if functions != (3,) or array.shape[-1] < 2:
        refuse(f"coefficients has the shape {np.shape(coefficients)}; it has to be (3, 2, L + 1, L + 1) for a degree L > 0")
    moved, *position = _core.standard_position(array, *convention, max_threads)
    return moved, StandardPosition(*position)
