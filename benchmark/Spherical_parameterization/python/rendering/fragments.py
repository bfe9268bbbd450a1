"""What is seen at each pixel: a depth buffer in numpy.

Points of the sphere are interpolated to every pixel, so that a pattern on the sphere is drawn on the surface as sharp
as the pixels are, however large the faces. This is what a renderer with colours at vertices cannot do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MOST_AT_ONCE = 500_000  # candidates of the pixels' faces; bounds the memory
TOLERANCE = 1e-6  # pixels; so that rounding leaves no pixel between two faces without either


@dataclass(frozen=True)
class Fragments:
    """The visible part of a mesh in a square of pixels: for each pixel where there is something, what it is."""

    pixel: np.ndarray  # row by row from the top left on
    face: np.ndarray
    weights: np.ndarray  # barycentric
    depth: np.ndarray  # towards the camera

    def interpolate(self, faces: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Values at vertices, at these pixels."""
        return self.interpolate_corners(values[faces])

    def interpolate_corners(self, values: np.ndarray) -> np.ndarray:
        """Values at the corners of faces (m x 3 x k), at these pixels."""
        return np.einsum("pi,pik->pk", self.weights, values[self.face])


def find_fragments(points: np.ndarray, faces: np.ndarray, size: int) -> Fragments:
    """Draws points that are given in pixels: x to the right, y downwards, z towards the camera."""
    corners = points[faces]
    depth = np.full(size * size, -np.inf)
    face = np.full(size * size, -1)
    for f, y, x in _Lines(corners[:, :, :2], size).pixels():
        z = np.einsum("pi,pi->p", _weights(corners[f], x, y), corners[f, :, 2])
        pixel = y * size + x
        nearer = np.flatnonzero(z > depth[pixel])
        nearer = nearer[np.argsort(z[nearer], kind="stable")]
        # Of several values for one pixel the last one remains, which is the nearest.
        depth[pixel[nearer]] = z[nearer]
        face[pixel[nearer]] = f[nearer]
    pixel = np.flatnonzero(face >= 0)
    face = face[pixel]
    return Fragments(pixel, face, _weights(corners[face], pixel % size, pixel // size), depth[pixel])


class _Lines:
    """The lines of pixels within each face: from the rows that it meets, to the pixels between two of its sides."""

    def __init__(self, corners: np.ndarray, size: int):
        self._corners = corners
        self._size = size
        self._top = np.clip(np.ceil(corners[:, :, 1].min(axis=1) - 0.5 - TOLERANCE), 0, size).astype(int)
        bottom = np.clip(np.floor(corners[:, :, 1].max(axis=1) - 0.5 + TOLERANCE), -1, size - 1).astype(int)
        # What is seen from its side has no place that a pixel could be in; its neighbours cover the pixel.
        is_flat = np.abs(doubled_areas(corners)) < TOLERANCE**2
        self._rows = np.where(is_flat, 0, np.maximum(bottom - self._top + 1, 0))

    def pixels(self):
        """Yields face, y and x of all pixels whose centres are in faces, some at a time."""
        for faces in _portions(self._rows):
            face, row = _expand(self._rows[faces])
            face += faces.start
            y = self._top[face] + row
            first, last = self._spans(face, y + 0.5)
            widths = np.maximum(last - first + 1, 0)
            for lines in _portions(widths):
                line, column = _expand(widths[lines])
                line += lines.start
                yield face[line], y[line], first[line] + column

    def _spans(self, face: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        a, b = self._corners[face], np.roll(self._corners[face], -1, axis=1)
        low, high = np.minimum(a[:, :, 1], b[:, :, 1]), np.maximum(a[:, :, 1], b[:, :, 1])
        meets = (low - TOLERANCE <= y[:, None]) & (y[:, None] <= high + TOLERANCE)
        rise = b[:, :, 1] - a[:, :, 1]
        share = np.clip((y[:, None] - a[:, :, 1]) / np.where(rise == 0.0, 1.0, rise), 0.0, 1.0)
        x = a[:, :, 0] + share * (b[:, :, 0] - a[:, :, 0])
        least = np.where(meets, x, np.inf).min(axis=1)
        largest = np.where(meets, x, -np.inf).max(axis=1)
        first = np.clip(np.ceil(least - 0.5 - TOLERANCE), 0, self._size)
        last = np.clip(np.floor(largest - 0.5 + TOLERANCE), -1, self._size - 1)
        return first.astype(int), last.astype(int)


def _portions(counts: np.ndarray):
    """Yields slices whose counts add up to about MOST_AT_ONCE."""
    sums = np.concatenate([[0], np.cumsum(counts)])
    start = 0
    while start < len(counts):
        stop = max(int(np.searchsorted(sums, sums[start] + MOST_AT_ONCE, side="right")) - 1, start + 1)
        yield slice(start, stop)
        start = stop


def _expand(counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(2, 0, 3) gives (0, 0, 2, 2, 2) and (0, 1, 0, 1, 2)."""
    index = np.repeat(np.arange(len(counts)), counts)
    return index, np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)


def _weights(corners: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Barycentric coordinates of the centres of pixels, cut off at the sides."""
    to_corners = corners[:, :, :2] - (np.stack([x, y], axis=1) + 0.5)[:, None, :]
    after, before = np.roll(to_corners, -1, axis=1), np.roll(to_corners, -2, axis=1)
    areas = after[:, :, 0] * before[:, :, 1] - after[:, :, 1] * before[:, :, 0]
    weights = np.clip(areas / doubled_areas(corners)[:, None], 0.0, 1.0)
    return weights / weights.sum(axis=1, keepdims=True)


def doubled_areas(corners: np.ndarray) -> np.ndarray:
    """Of the faces as they are seen, negative from behind."""
    first, second = corners[:, 1, :2] - corners[:, 0, :2], corners[:, 2, :2] - corners[:, 0, :2]
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
