from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import check_word, refuse, to_array
from ._sampling import Remesh

MAX_ALIGNMENTS = 100
MAX_MAGNITUDE = 1e300


@dataclass(frozen=True)
class ShapeModes:
    """Mean shape and shape modes (principal components), as computed by `shape_modes`.

    Attributes
    ----------
    mean : (...) ndarray of float64
        Mean shape.
    modes : (j, ...) ndarray of float64
        Orthonormal directions in which the shapes vary, in descending order of variance: at most k - 1 for k shapes.
    deviations : (j,) ndarray of float64
        Standard deviation along each mode, in the unit of the shapes, as the root of the sum of squares over all numbers.
        Divided by the square root of the number of vertices, it is the root mean square displacement of the vertices.
    scores : (k, j) ndarray of float64
        Coordinates of each shape along the modes, in standard deviations from the mean. Columns are uncorrelated.
    shares : (j,) ndarray of float64
        Fraction of the total variance in each mode. The sum is 1.
    """

    mean: NDArray[np.float64]
    modes: NDArray[np.float64]
    deviations: NDArray[np.float64]
    scores: NDArray[np.float64]
    shares: NDArray[np.float64]

    def shape(self, scores: ArrayLike) -> NDArray[np.float64]:
        """Return the shape with the given scores in the first modes and 0 in all others.

        Parameters
        ----------
        scores : (i,) array_like of float
            Standard deviations along the first i modes: ``[2]`` is the mean plus two deviations of the first mode.

        Returns
        -------
        (...) ndarray of float64
            The shape.

        Raises
        ------
        Error
            If there are more scores than modes, or if a score is not finite.
        """
        array = to_array("scores", scores)
        if array.dtype.kind not in "fiu":
            raise TypeError(f"scores has the type {array.dtype}; it has to hold real numbers")
        if array.ndim != 1 or len(array) > len(self.modes):
            refuse(f"scores has the shape {array.shape}; it has to hold at most {len(self.modes)} numbers, one for each mode")
        if not np.isfinite(array).all():
            refuse(f"scores is infinite or not a number at {np.flatnonzero(~np.isfinite(array))[0]}")
        n = len(array)
        return self.mean + np.tensordot(array * self.deviations[:n], self.modes[:n], axes=1)


def _align(shapes: NDArray[np.float64], scales: bool) -> NDArray[np.float64]:
    shapes = shapes - shapes.mean(axis=1, keepdims=True)
    if scales:
        sizes = np.linalg.norm(shapes, axis=(1, 2), keepdims=True)
        if not sizes.all():
            refuse(f"shapes[{np.flatnonzero(sizes.ravel() == 0)[0]}] is a single point, which has no size")
        shapes *= sizes.mean() / sizes
    mean = shapes[0]
    for _ in range(MAX_ALIGNMENTS):
        left, _, right = np.linalg.svd(np.swapaxes(shapes, 1, 2) @ mean)
        left[:, :, 2] *= np.sign(np.linalg.det(left @ right))[:, None]  # a rotation, never a reflection
        shapes = shapes @ (left @ right)
        previous, mean = mean, shapes.mean(axis=0)
        if np.linalg.norm(mean - previous) <= 1e-12 * np.linalg.norm(mean):
            break
    return shapes


def shape_modes(shapes: Sequence[ArrayLike], *, align: str = "rotation") -> ShapeModes:
    """Compute the mean and the shape modes (principal components) of corresponding shapes.

    Parameters
    ----------
    shapes : (k, n, 3) or (k, ...) array_like of float
        Two or more shapes: corresponding vertices of surfaces, such as `remesh` returns for the triangles of the first
        surface and the directions that `map_surface` returns; or other numbers, such as the coefficients that
        `standard_position` returns.
    align : {"rotation", "similarity", "none"}
        Alignment of the shapes. "rotation" translates and rotates each shape to minimize the sum of squared distances from
        the mean, so that no mode describes position or orientation in space. "similarity" also scales each shape to the
        mean size, the root of the sum of squared distances from the centroid, so that no mode describes size. Both take
        (k, n, 3), move the centroid of the vertices to 0, and keep the orientation of the first shape. "none" uses the
        shapes as they are: coefficients, or surfaces whose positions in space are meaningful.

    Returns
    -------
    ShapeModes
        The mean, the modes, and the scores of each shape.

    Raises
    ------
    Error
        If there are fewer than two shapes, if their array shapes differ, or if a number is not finite or beyond 1e300.

    Notes
    -----
    The alignment is generalized Procrustes analysis [1]_ without reflections. Modes are right singular vectors. Their signs
    make the number of largest magnitude in each mode positive. Modes whose deviation is at the level of rounding errors are
    omitted. Modes with similar deviations may be any mixture of each other. All numbers count the same: regions where the
    vertices of a template are dense count more. The time is O(k**2 n) for shapes of n numbers.

    References
    ----------
    .. [1] J. C. Gower: Generalized Procrustes analysis. Psychometrika 40(1), 1975.

    Examples
    --------
    Three ellipsoids that differ in one direction have a single mode:

    >>> shapes = [sphere * [1, 1, s] for s in (1, 2, 3)]
    >>> result = sp.shape_modes(shapes, align="none")
    >>> result.shares
    array([1.])
    >>> np.allclose(abs(result.scores[:, 0]), [1, 0, 1])
    True
    >>> stretched = result.shape([2])  # two standard deviations from the mean
    """
    check_word("align", align, ("rotation", "similarity", "none"))
    for i, shape in enumerate(shapes):
        if isinstance(shape, Remesh):
            raise TypeError(f"shapes[{i}] is a result of remesh or reconstruct: give its vertices")
    arrays = [to_array(f"shapes[{i}]", shape) for i, shape in enumerate(shapes)]
    if len(arrays) < 2:
        refuse(f"there are {len(arrays)} shapes; there have to be at least 2")
    for i, array in enumerate(arrays):
        if array.dtype.kind not in "bfiu":
            raise TypeError(f"shapes[{i}] has the type {array.dtype}; it has to hold real numbers")
        if array.shape != arrays[0].shape or array.size == 0:
            refuse(
                f"shapes[{i}] has the shape {array.shape}, and shapes[0] {arrays[0].shape}; all have to be the same, and not"
                " empty.\nmap_surface and remesh give surfaces the same faces."
            )
        if not np.isfinite(array).all():
            refuse(f"shapes[{i}] is infinite or not a number at {tuple(np.argwhere(~np.isfinite(array))[0].tolist())}")
    stack: NDArray[Any] = np.array(arrays, dtype=np.float64)
    magnitude = np.abs(stack).max()
    if magnitude > MAX_MAGNITUDE:
        refuse(f"shapes have numbers up to {magnitude:.3g}, but sums of squares overflow beyond {MAX_MAGNITUDE:g}: choose another unit")
    unit = np.ldexp(1.0, np.frexp(magnitude)[1])  # a power of 2: exact, and squares do not overflow
    stack /= unit
    if align != "none":
        if stack.ndim != 3 or stack.shape[2] != 3:
            refuse(f'shapes have the shape {stack.shape[1:]}; only (n, 3) can be aligned: set align="none"')
        stack = _align(stack, align == "similarity")

    mean = stack.mean(axis=0)
    differences = (stack - mean).reshape(len(stack), -1)
    left, singular, modes = np.linalg.svd(differences, full_matrices=False)
    rounding = np.finfo(float).eps * max(differences.shape) * np.abs(stack).max(initial=0) * np.sqrt(differences.shape[1])
    n = min(int((singular > rounding).sum()), len(stack) - 1)
    left, singular, modes = left[:, :n], singular[:n], modes[:n]
    rows = np.arange(n)
    signs = np.sign(modes[rows, np.abs(modes).argmax(axis=1)]) if n else np.ones(0)
    variances = singular**2
    return ShapeModes(
        mean * unit,
        (signs[:, None] * modes).reshape(n, *mean.shape),
        singular * unit / np.sqrt(len(stack) - 1),
        signs * left * np.sqrt(len(stack) - 1),
        variances / variances.sum() if n else variances,
    )
