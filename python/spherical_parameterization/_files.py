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
    """Read a triangle mesh from a file.

    The reader is that of the command line program.

    Parameters
    ----------
    path : str or path-like
        File whose name ends with .off (text; colors and normals are skipped), .obj, .ply, .stl, .ts, .gii or .gii.gz, in
        lower or upper case; or a FreeSurfer surface, such as lh.white.

    Returns
    -------
    vertices : (n, 3) ndarray of float64
        Points, in the order and the unit of the file.
    faces : (m, 3) ndarray of int64
        Vertices of each triangle.

    Raises
    ------
    OSError
        If the file does not exist.
    Error
        If the file is damaged or has another format; the message contains the line or byte. Also if a face is not a
        triangle.

    See Also
    --------
    find_defect : Check whether a mesh can be mapped.

    Notes
    -----
    The size of the file bounds the memory, whatever the file contains. `trimesh.load` and PyVista read further formats.

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
    """Write coefficients of spherical harmonics to a file, with all digits.

    An existing file is replaced.

    Parameters
    ----------
    path : str or path-like
        NAME.coef for a file of SPHARM-PDM, or NAME.csv for a table for R, pandas and spreadsheets. The table has a row for
        each degree and order, where sines have negative orders. Its columns are degree, order, one for each function (x, y
        and z if there are three), normalization and csphase.
    coefficients : (..., 2, L + 1, L + 1) array_like of float
        Coefficients of any number of functions, such as `expand` returns; for .coef, (3, 2, L + 1, L + 1).
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the coefficients, see `expand`. A table keeps and states it. .coef files have their own
        convention, to which the coefficients are converted.
    csphase : {1, -1}
        Phase of the coefficients, see `expand`.

    Raises
    ------
    OSError
        If the file cannot be written.
    Error
        If the name has another ending, or if the shape of the coefficients is not one of those above.

    See Also
    --------
    read_coefficients : Read such a file.

    Examples
    --------
    >>> coefficients, fit = sp.expand(vertices, faces, sphere, 8)
    >>> sp.write_coefficients("shape.csv", coefficients)
    >>> np.array_equal(sp.read_coefficients("shape.csv"), coefficients)
    True
    """
    is_table = _is_table(path)
    array, functions = read_table_of_coefficients(coefficients)
    convention = read_convention(normalization, csphase)
    if not is_table and functions != (3,):
        refuse(f"coefficients has the shape {np.shape(coefficients)}; a .coef file takes (3, 2, L + 1, L + 1), a surface")
    if len(array) == 0:
        refuse("coefficients has no function")
    content = _core.write_coefficients(array, is_table, *convention)
    with open(path, "wb") as file:
        file.write(content)


def read_coefficients(path: Path, *, normalization: str = "4pi", csphase: int = 1) -> NDArray[np.float64]:
    """Read coefficients of spherical harmonics from a file.

    Parameters
    ----------
    path : str or path-like
        NAME.coef, of SPHARM-PDM, or NAME.csv, a table as written by `write_coefficients`.
    normalization : {"4pi", "ortho", "schmidt"}
        Normalization of the returned coefficients, whatever the normalization in the file; see `expand`.
    csphase : {1, -1}
        Phase of the returned coefficients, whatever the phase in the file; see `expand`.

    Returns
    -------
    (k, 2, L + 1, L + 1) ndarray of float64
        Coefficients of k functions; k = 3 for a surface.

    Raises
    ------
    OSError
        If the file cannot be read.
    Error
        If the name has another ending; or if the file is damaged: the message contains the location.

    See Also
    --------
    write_coefficients : Write such a file.
    """
    is_table = _is_table(path)
    convention = read_convention(normalization, csphase)
    with open(path, "rb") as file:
        content = file.read()
    try:
        return _core.read_coefficients(content, is_table, *convention)
    except Error as error:
        raise Error(f"{os.fspath(path)}: {error}", error.code) from None
