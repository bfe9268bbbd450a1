from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import read_points, refuse, to_array
from ._meshes import accepts_mesh
from ._parameterization import parameterize


@accepts_mesh
def compute_angles(
    vertices: ArrayLike, faces: ArrayLike, *, sphere: Optional[ArrayLike] = None, threads: Optional[int] = None
) -> NDArray[np.float64]:
    """Compute the spherical coordinates of the vertices of a surface.

    Other libraries of spherical harmonics, such as ktch, start from these angles.

    Parameters
    ----------
    vertices : (n, 3) array_like of float
        Points of the surface, or a mesh object instead of `vertices` and `faces`.
    faces : (m, 3) array_like of int
        Vertices of each triangle, counterclockwise as seen from outside.
    sphere : (n, 3) array_like of float, optional
        Images of the vertices, which need not be normalized. By default, `parameterize` computes them.
    threads : int, optional
        Maximum number of threads. By default, all cores.

    Returns
    -------
    (n, 2) ndarray of float64
        For each vertex, in radians, the angle theta from the z-axis, from 0 to pi, and the azimuth phi around the z-axis,
        from 0 to 2 pi, starting at the x-axis.

    Raises
    ------
    Error
        If the mesh has a defect, see `find_defect`; or if an image is the origin or not finite, such as the image of a
        vertex without a face.

    See Also
    --------
    angles_to_directions : Compute directions from these angles.

    Examples
    --------
    >>> theta_phi = sp.compute_angles(vertices, faces)
    >>> theta_phi.shape
    (258, 2)

    ktch takes the angles as they are:

    >>> analysis = ktch.harmonic.SphericalHarmonicAnalysis(n_harmonics=20)  # doctest: +SKIP
    >>> analysis.fit_transform([vertices], theta_phi=[theta_phi])  # doctest: +SKIP
    """
    images = parameterize(vertices, faces, threads=threads)[0] if sphere is None else read_points("sphere", sphere)
    lengths = np.linalg.norm(images, axis=1)
    wrong = ~(np.isfinite(lengths) & (lengths > 0))
    if wrong.any():
        refuse(f"sphere: the image of vertex {np.flatnonzero(wrong)[0]} is the origin or not finite, so that it has no angles")
    x, y, z = np.ascontiguousarray(images.T)  # of strides, the last bit of numpy's arctan2 depends on the addresses
    return np.column_stack((np.arctan2(np.hypot(x, y), z), np.arctan2(y, x) % (2 * np.pi)))


def angles_to_directions(theta_phi: ArrayLike) -> NDArray[np.float64]:
    """Compute directions from spherical coordinates.

    `Locator.locate`, `reconstruct` and ``parameterize(initial=...)`` take such directions.

    Parameters
    ----------
    theta_phi : (n, 2) array_like of float
        In radians, the angle theta from the z-axis and the azimuth phi around the z-axis, starting at the x-axis.

    Returns
    -------
    (n, 3) ndarray of float64
        Points of the unit sphere.

    Raises
    ------
    Error
        If the array does not have two columns.

    See Also
    --------
    compute_angles : Compute the angles of the vertices of a surface.

    Examples
    --------
    >>> sp.angles_to_directions([[0, 1]])
    array([[0., 0., 1.]])
    """
    angles = to_array("theta_phi", theta_phi, 2)
    if angles.dtype.kind not in "fiu":
        raise TypeError(f"theta_phi has the type {angles.dtype}; it has to hold real numbers")
    if angles.ndim != 2 or angles.shape[1] != 2:
        refuse(f"theta_phi has the shape {angles.shape}; it has to be (n, 2): theta and phi in each row")
    theta, phi = np.ascontiguousarray(np.asarray(angles, float).T)
    return np.column_stack((np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)))
