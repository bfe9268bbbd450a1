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
    """The mean of shapes, and the modes by which they differ from it, the largest one first: what `shape_modes` has found.

    Attributes
    ----------
    mean : (...) ndarray of float64
        The mean shape.
    modes : (j, ...) ndarray of float64
        The directions in which shapes vary, of length 1 and at right angles to each other: at most k - 1 for k shapes.
    deviations : (j,) ndarray of float64
        The standard deviation along each mode, in the unit of the shapes, as the root of the sum of squares over all numbers: of
        n vertices, divided by the root of n, it is the root mean square of how far they move.
    scores : (k, j) ndarray of float64
        Where each shape lies along each mode, in standard deviations from the mean. Columns are uncorrelated.
    shares : (j,) ndarray of float64
        The share of each mode in the variance of all numbers; together 1.
    """

    mean: NDArray[np.float64]
    modes: NDArray[np.float64]
    deviations: NDArray[np.float64]
    scores: NDArray[np.float64]
    shares: NDArray[np.float64]

    def shape(self, scores: ArrayLike) -> NDArray[np.float64]:
        """Returns the shape with these scores in the first modes, and 0 in all others.

        Parameters
        ----------
        scores : (i,) array_like of numbers
            Standard deviations along the first i modes: ``[2]`` is the mean and two deviations of the first mode.

        Returns
        -------
        (...) ndarray of float64
            The shape.

        Raises
        ------
        Error
            If there are more scores than modes, or one is not finite.
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
        left[:, :, 2] *= np.sign(np.linalg.det(left @ right))[:, None]  # turns it, and never mirrors it
        shapes = shapes @ (left @ right)
        previous, mean = mean, shapes.mean(axis=0)
        if np.linalg.norm(mean - previous) <= 1e-12 * np.linalg.norm(mean):
            break
    return shapes


def shape_modes(shapes: Sequence[ArrayLike], *, align: str = "rotation") -> ShapeModes:
    """Finds the mean of shapes that correspond number by number, and the modes in which they vary: their principal components.

    Parameters
    ----------
    shapes : (k, n, 3) or (k, ...) array_like of numbers
        Two shapes or more: the vertices of surfaces in the same order, as `remesh` makes them with the triangles and the images
        that `map_surface` returns; or any other numbers, such as the coefficients of `standard_position`.
    align : {"rotation", "similarity", "none"}
        How shapes are brought together before. "rotation" moves and turns each to where the sum of squares between it and the
        mean is least, so that place and pose of the whole are no modes; "similarity" scales each to the mean size as well, the
        root of the sum of squared distances from the middle, so that size is no mode either. Both take (k, n, 3), and leave
        the middle of all vertices at 0, turned as the first shape. "none" takes all as it is: coefficients, or surfaces whose
        places in space mean something.

    Returns
    -------
    ShapeModes
        The mean, the modes, and the scores of each shape.

    Raises
    ------
    Error
        If there are fewer than two shapes, they are not of one shape, or a number is not finite, or beyond 1e300.

    Notes
    -----
    The alignment is the generalized Procrustes analysis [1]_, without mirror images. Modes are right singular vectors, with signs
    such that the number of the largest magnitude of each is positive; those whose deviation is rounding are left out. Modes whose
    deviations are alike may be any mixture of each other. All numbers count alike: where the vertices of a template are dense,
    a surface counts more. For n numbers, the time is O(k**2 n).

    References
    ----------
    .. [1] J. C. Gower: Generalized Procrustes analysis. Psychometrika 40(1), 1975.

    Examples
    --------
    Other surfaces with the faces of the first one, their mean and the first mode:

    >>> maps = [sp.map_surface(first, surface)[0] for surface in surfaces]
    >>> result = sp.shape_modes([sp.remesh(*s, (first[1], d)).vertices for s, d in zip(surfaces, maps)])
    >>> result.mean, result.shape([-2]), result.shape([2]), result.scores[:, 0]
    """
    check_word("align", align, ("rotation", "similarity", "none"))
    for i, shape in enumerate(shapes):
        if isinstance(shape, Remesh):
            raise TypeError(f"shapes[{i}] is what remesh or reconstruct returns: give its vertices")
    arrays = [to_array(f"shapes[{i}]", shape) for i, shape in enumerate(shapes)]
    if len(arrays) < 2:
        refuse(f"shapes has {len(arrays)} of them; there have to be at least 2")
    for i, array in enumerate(arrays):
        if array.dtype.kind not in "bfiu":
            raise TypeError(f"shapes[{i}] has the type {array.dtype}; it has to hold real numbers")
        if array.shape != arrays[0].shape or array.size == 0:
            refuse(
                f"shapes[{i}] has the shape {array.shape}, and shapes[0] {arrays[0].shape}; all have to be the same, and not"
                " empty.\nSurfaces with other faces are registered by map_surface and remesh."
            )
        if not np.isfinite(array).all():
            refuse(f"shapes[{i}] is infinite or not a number at {tuple(np.argwhere(~np.isfinite(array))[0].tolist())}")
    stack: NDArray[Any] = np.array(arrays, dtype=np.float64)
    magnitude = np.abs(stack).max()
    if magnitude > MAX_MAGNITUDE:
        refuse(f"shapes have numbers up to {magnitude:.3g}, but sums of squares hold none beyond {MAX_MAGNITUDE:g}: choose another unit")
    unit = np.ldexp(1.0, np.frexp(magnitude)[1])  # a power of 2, which changes no digits, but squares overflow without it
    stack /= unit
    if align != "none":
        if stack.ndim != 3 or stack.shape[2] != 3:
            refuse(f'shapes have the shape {stack.shape[1:]}; only (n, 3) can be aligned, others take align="none"')
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
