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
    """Returns the spherical coordinates of the vertices of a surface, which scikit-learn-like libraries of harmonics start from.

    Parameters
    ----------
    vertices : (n, 3) array_like of numbers
        The points of the surface.
    faces : (m, 3) array_like of integers
        The vertices of each triangle, counterclockwise as seen from outside.
    sphere : (n, 3) array_like of numbers, optional
        The images of the vertices, at any distance from the origin. By default, `parameterize` finds them.
    threads : int, optional
        The largest number of threads; by default all cores.

    Returns
    -------
    theta_phi : (n, 2) ndarray of float64
        For each vertex, the angle theta from the z axis, from 0 to pi, and phi around it from the x axis, from 0 to 2 pi.

    Raises
    ------
    Error
        If the mesh has no map, see `find_defect`, or an image is the origin or not finite.

    See Also
    --------
    angles_to_directions : the way back.

    Examples
    --------
    ktch takes them as they are:

    >>> theta_phi = sp.compute_angles(vertices, faces)
    >>> ktch.harmonic.SphericalHarmonicAnalysis(n_harmonics=20).fit_transform([vertices], theta_phi=[theta_phi])
    """
    images = parameterize(vertices, faces, threads=threads)[0] if sphere is None else read_points("sphere", sphere)
    lengths = np.linalg.norm(images, axis=1)
    wrong = ~(np.isfinite(lengths) & (lengths > 0))
    if wrong.any():
        refuse(f"sphere: the image of vertex {np.flatnonzero(wrong)[0]} is the origin or not finite, and has no angles")
    x, y, z = images.T
    return np.column_stack((np.arctan2(np.hypot(x, y), z), np.arctan2(y, x) % (2 * np.pi)))


def angles_to_directions(theta_phi: ArrayLike) -> NDArray[np.float64]:
    """Returns the directions that have these spherical coordinates.

    Parameters
    ----------
    theta_phi : (n, 2) array_like of numbers
        The angle theta from the z axis, and phi around it from the x axis.

    Returns
    -------
    directions : (n, 3) ndarray of float64
        Points of the unit sphere, such as `Locator`, `reconstruct` and ``parameterize(initial=...)`` take.

    Examples
    --------
    >>> triangles, coordinates = sp.Locator(faces, sphere).locate(sp.angles_to_directions(theta_phi))
    """
    angles = to_array("theta_phi", theta_phi, 2)
    if angles.dtype.kind not in "fiu":
        raise TypeError(f"theta_phi has the type {angles.dtype}; it has to hold real numbers")
    if angles.ndim != 2 or angles.shape[1] != 2:
        refuse(f"theta_phi has the shape {angles.shape}; it has to be (n, 2): theta and phi in each row")
    theta, phi = np.asarray(angles, float).T
    return np.column_stack((np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)))
