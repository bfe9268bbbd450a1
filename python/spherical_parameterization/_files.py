from __future__ import annotations

import os
from typing import Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import refuse
from ._errors import Error
from ._harmonics import read_convention, read_table_of_coefficients

Path = Union[str, "os.PathLike[str]"]


def read_mesh(path: Path) -> Tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Reads a mesh of triangles from a file, with the reader of the command line program.

    Parameters
    ----------
    path : str or path-like
        A file whose name ends with .off (as text; colours and normals are skipped), .obj, .ply, .stl, .ts, .gii or .gii.gz, in
        small letters or capitals; or a surface of FreeSurfer, such as lh.white.

    Returns
    -------
    vertices : (n, 3) ndarray of float64
        The points, in the order and the unit of the file.
    faces : (m, 3) ndarray of int64
        The vertices of each triangle.

    Raises
    ------
    OSError
        If there is no such file.
    Error
        If the file is damaged or of another format, with the line or byte; or if a face is not a triangle.

    Notes
    -----
    Whether the mesh can be mapped is told by `find_defect`. The memory is bounded by the size of the file, whatever it holds.
    `trimesh.load` and PyVista read further formats.

    Examples
    --------
    >>> vertices, faces = sp.read_mesh("bunny.off")
    """
    os.stat(path)
    return _core.read_mesh(os.fsencode(path))


def _is_table(path: Path) -> bool:
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in (".coef", ".csv"):
        refuse(f"{os.fspath(path)}: the name has to end with .coef for SPHARM-PDM, or with .csv for a table")
    return ending == ".csv"


def write_coefficients(path: Path, coefficients: ArrayLike, *, normalization: str = "4pi", csphase: int = 1) -> None:
    """Writes coefficients of spherical harmonics to a file, with all digits.

    Parameters
    ----------
    path : str or path-like
        NAME.coef, a file of SPHARM-PDM, for the coefficients of a surface; or NAME.csv, a table for R, pandas and spreadsheets
        with a line for each degree and order, the sines with negative orders, and the columns degree, order, one for each
        function (x, y and z, if there are three), normalization and csphase. A file that is there is replaced.
    coefficients : (..., 2, L + 1, L + 1) array_like of numbers
        Those of any number of functions, such as `expand` returns; for .coef, (3, 2, L + 1, L + 1).
    normalization : {"4pi", "ortho", "schmidt"}
        That of the coefficients; see `expand`. A table has them like this, and says so; .coef files have a convention of their
        own, to which they are converted.
    csphase : {1, -1}
        That of the coefficients.

    Raises
    ------
    OSError
        If the file cannot be written.
    Error
        If the name ends otherwise, or coefficients are not of a shape that has been named.
    """
    is_table = _is_table(path)
    array, functions = read_table_of_coefficients(coefficients)
    convention = read_convention(normalization, csphase)
    if not is_table and functions != (3,):
        refuse(f"coefficients has the shape {np.shape(coefficients)}; a .coef file takes (3, 2, L + 1, L + 1), a surface")
    if len(array) == 0:
        refuse("coefficients are those of no function")
    content = _core.write_coefficients(array, is_table, *convention)
    with open(path, "wb") as file:
        file.write(content)


def read_coefficients(path: Path, *, normalization: str = "4pi", csphase: int = 1) -> NDArray[np.float64]:
    """Reads coefficients of spherical harmonics from a file that `write_coefficients` or another program has written.

    Parameters
    ----------
    path : str or path-like
        NAME.coef, of SPHARM-PDM, or NAME.csv, a table; see `write_coefficients`.
    normalization : {"4pi", "ortho", "schmidt"}
        That of the coefficients that are returned, whatever the file has; see `expand`.
    csphase : {1, -1}
        The same for the phase.

    Returns
    -------
    (k, 2, L + 1, L + 1) ndarray of float64
        The coefficients of k functions, 3 for a surface.

    Raises
    ------
    OSError
        If the file cannot be read.
    Error
        If the name ends otherwise, or the file is damaged, with the place.
    """
    is_table = _is_table(path)
    convention = read_convention(normalization, csphase)
    with open(path, "rb") as file:
        content = file.read()
    try:
        return _core.read_coefficients(content, is_table, *convention)
    except Error as error:
        raise Error(f"{os.fspath(path)}: {error}", error.code) from None
