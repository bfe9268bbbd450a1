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
        refuse(f"csphase is {csphase!r}; it has to be 1, or -1 with the phase of Condon and Shortley")
    return normalization, csphase == -1


def read_table_of_coefficients(value: ArrayLike) -> Tuple[NDArray[np.float64], Tuple[int, ...]]:
    """Returns them as an array (functions, 2, L + 1, L + 1), and the shape of the functions."""
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
        message = f"{name}: row {row} is zero, infinite or not a number, so that it leads nowhere.\n(Rows are counted from 0.)"
        raise Error(message, ErrorCode.INVALID_DIRECTION, row)
    return directions


class HarmonicFit(NamedTuple):
    """How well an expansion fits. The errors are in the unit of the functions; for points of a surface, they are distances.

    Attributes
    ----------
    error_over_surface : float
        Root mean square error over all of the surface, by its area.
    error_at_vertices : float
        The same at the vertices, by the areas around them.
    aliasing : float
        Root mean square difference, over the sphere, to the expansion with half as many nodes each way; 0 at the vertices.
    number_of_iterations : int
        Of conjugate gradients; 0 where none are needed.
    degree_of_vertices : int
        The largest degree with no more coefficients than vertices: what is above it tells of flat faces.
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
    """Expands a surface, or values of its vertices, into real spherical harmonics by its map to the sphere.

    Maps with ``prefer="sampling"`` leave the smallest errors. Where surfaces are compared with each other, take the default map:
    it depends less on how a surface is meshed, so that the coefficients of equal surfaces differ less.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle.
    sphere : (n, 3) array_like of numbers
        The images of the vertices, a one-to-one map.
    degree : int
        The largest degree L, from 0 to 1000. What is above ``fit.degree_of_vertices``, the square root of n less 1, tells of flat
        faces and not of a shape. The time grows with the third power of L: a second for 100, seven for 200.
    values : (n, ...) array_like of numbers, optional
        What is expanded in the place of the points.
    weights : {"surface", "sphere", "vertices"}
        What the squared error that is least is weighed with: areas of the surface, or of the sphere, at nodes all over; or areas
        of the surface at the vertices alone.
    normalization : {"4pi", "ortho", "schmidt"}
        Of the harmonics, as in pyshtools: the integrals of their squares are 4 pi, 1, or 4 pi / (2 l + 1) for the degree l.
    csphase : {1, -1}
        -1 with the phase of Condon and Shortley.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    coefficients : (3, 2, L + 1, L + 1) or (..., 2, L + 1, L + 1) ndarray of float64
        Those of each coordinate, or number, in its unit: ``[..., 0, l, m]`` belongs to the cosine of the order m,
        ``[..., 1, l, m]`` to the sine.
    fit : HarmonicFit
        How well they fit.

    Raises
    ------
    Error
        If the mesh has no map to the sphere, or the map is not one-to-one; or if there are fewer vertices than coefficients, and
        only they are weighted.

    Notes
    -----
    The harmonics are those of pyshtools, whose functions take ``coefficients[k]`` [1]_. Surfaces have been expanded like this for
    the statistics of shapes since [2]_.

    References
    ----------
    .. [1] M. A. Wieczorek, M. Meschede: SHTools. Geochemistry, Geophysics, Geosystems 19, 2018.
    .. [2] Ch. Brechbuehler, G. Gerig, O. Kuebler: Parametrization of closed surfaces for 3-D shape description. Computer
       Vision and Image Understanding 61(2), 1995.

    Examples
    --------
    >>> coefficients, fit = sp.expand(vertices, faces, sphere, 30)
    >>> smooth = sp.reconstruct(coefficients, ("octahedron", 64))
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
    """Evaluates sums of spherical harmonics at directions, or makes a surface of them.

    Parameters
    ----------
    coefficients : (..., 2, L + 1, L + 1) array_like of numbers
        Those of any number of functions. ``coefficients[..., :9, :9]`` leaves out what is above the degree 8.
    where : (k, 3) array_like of numbers, (str, int) or (faces, sphere)
        Directions, at any distance from the origin. Or, as a tuple or list, if the functions are the three coordinates of a
        surface, what the sphere is sampled with: "octahedron", "cube" or "icosahedron" and the number, from 1 to 5000, that its
        edges are divided into, or any mesh of the sphere.
    normalization : {"4pi", "ortho", "schmidt"}
        That of the coefficients; see `expand`.
    csphase : {1, -1}
        That of the coefficients.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    (k, ...) ndarray of float64, or Remesh
        The values at each direction, such as (k,) or (k, 3); or the surface.

    Raises
    ------
    Error
        If a direction is zero or not finite, or coefficients are not of a shape that has been named.
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
    """Returns the power of each degree: the mean square, over the sphere, of what the functions have of it together.

    It depends neither on the normalization nor on any rotation.

    Parameters
    ----------
    coefficients : (..., 2, L + 1, L + 1) array_like of numbers
        Those of any number of functions, such as the coordinates of a surface.
    normalization : {"4pi", "ortho", "schmidt"}
        That of the coefficients; see `expand`.

    Returns
    -------
    (L + 1,) ndarray of float64
        The power of the degrees 0 to L, in the square of the unit of the functions.

    Raises
    ------
    Error
        If coefficients are not of a shape that has been named.
    """
    array, _ = read_table_of_coefficients(coefficients)
    check_word("normalization", normalization, NORMALIZATIONS)
    degrees = np.arange(array.shape[-1])
    factors = {"4pi": 1.0, "ortho": 4 * np.pi, "schmidt": 2 * degrees + 1}[normalization]
    squares = np.tril(array**2)
    squares[:, 1, :, 0] = 0  # no sine
    return np.asarray(squares.sum(axis=(0, 1, 3)) / factors)


class StandardPosition(NamedTuple):
    """How a surface has come into standard position, and how sure that is.

    Attributes
    ----------
    rotation_of_surface, rotation_of_sphere : (3, 3) ndarray of float64
        A point p has come to ``rotation_of_surface @ (p - center)``, a direction q to ``rotation_of_sphere @ q``.
    center : (3,) ndarray of float64
        The mean of the surface over the sphere, in its unit.
    semi_axes : (3,) ndarray of float64
        Half the lengths of the axes of the ellipsoid of degree 1, in the unit of the surface, the largest one first; the last one
        is negative if the surface is inside out: then turn its faces, ``faces[:, ::-1]``, and map it again.
    skewness : (3,) ndarray of float64
        Third moments along the axes over the powers 3/2 of the second ones: positive for the first two.
    axes_are_determined : bool
        Whether no two axes are of the same length, up to a hundredth: otherwise noise turns the surface about the third one.
    signs_are_determined : bool
        Whether the skewness along the first two axes is above a hundredth: otherwise noise turns the surface by half a turn.
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
    """Moves a surface, and turns its sphere, such that the ellipsoid of degree 1 lies along the axes of both.

    So surfaces of the same kind can be compared by their coefficients, wherever they were. Nothing is scaled.

    Parameters
    ----------
    coefficients : (3, 2, L + 1, L + 1) array_like of numbers
        Those of the surface, of the degree 1 or more; they are not changed.
    normalization : {"4pi", "ortho", "schmidt"}
        That of the coefficients; see `expand`.
    csphase : {1, -1}
        That of the coefficients.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    coefficients : (3, 2, L + 1, L + 1) ndarray of float64
        Those of the surface that has been moved, with the same normalization.
    position : StandardPosition
        What has been done, and whether noise has decided it.

    Raises
    ------
    Error
        If the ellipsoid is a point or a line.
    """
    array, functions = read_table_of_coefficients(coefficients)
    convention = read_convention(normalization, csphase)
    max_threads = read_threads(threads)
    if functions != (3,) or array.shape[-1] < 2:
        refuse(f"coefficients has the shape {np.shape(coefficients)}; it has to be (3, 2, L + 1, L + 1) for a degree L > 0")
    moved, *position = _core.standard_position(array, *convention, max_threads)
    return moved, StandardPosition(*position)
