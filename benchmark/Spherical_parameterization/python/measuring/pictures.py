"""Pictures of maps: a surface and its image on the sphere, drawn alike wherever they are drawn.

From the bottom up: what is seen at each pixel, by a depth buffer; cameras; the colors of distortions; and paint, which
puts these together under the one light. The same meshes give the same pixels.

Points of the sphere are interpolated to every pixel, so that a pattern on the sphere is drawn on the surface as sharp
as the pixels are, however large the faces. This is what a renderer with colors at vertices cannot do.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Union

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, LogNorm, to_rgb

MAX_AT_ONCE = 500_000  # candidates of the pixels' faces; bounds the memory
TOLERANCE = 1e-6  # pixels; so that rounding leaves no pixel between two faces without either
MARGIN = 1.04  # around what is looked at
SAMPLES = 3  # along both sides of a pixel
FEATURE_ANGLE = np.radians(60.0)  # sharper edges of the surface are not smoothed
FACES_AT_ONCE = 200_000  # bounds the memory

# In the camera's axes: right, up, and towards the camera.
AMBIENT = 0.56
LIGHTS = ((0.42, (-0.45, 0.65, 0.8)), (0.14, (0.8, -0.2, 0.6)))
EDGE_STRENGTH = 0.75  # of black

# Perceptually uniform. The darkest part is left out, in which the shape would not be seen.
COLORS = ListedColormap(matplotlib.colormaps["viridis"](np.linspace(0.12, 1.0, 256)))
INVERTED_COLOR = to_rgb("#e4006e")  # a hue that the scale does not have

# Colors of faces, or a function from points of the sphere to colors
Paint = Union[np.ndarray, Callable[[np.ndarray], np.ndarray]]


@dataclass(frozen=True)
class Fragments:
    """The visible part of a mesh in a square of pixels: for each pixel where there is something, what it is."""

    pixel: np.ndarray  # row by row from the top left on
    face: np.ndarray
    weights: np.ndarray  # barycentric
    depth: np.ndarray  # towards the camera

    def interpolate(self, values: np.ndarray) -> np.ndarray:
        """Values at the corners of faces (m x 3 x k), at these pixels."""
        return np.einsum("pi,pik->pk", self.weights, values[self.face])


def find_fragments(points: np.ndarray, faces: np.ndarray, size: int) -> Fragments:
    """Draws points that are given in pixels: x to the right, y downwards, z towards the camera."""
    corners = points[faces]
    depth = np.full(size * size, -np.inf)
    face = np.full(size * size, -1)
    for f, y, x in _covered_pixels(corners[:, :, :2], size):
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


def _covered_pixels(corners: np.ndarray, size: int):
    """Yields face, y and x of all pixels whose centers are in faces, some at a time."""
    top = np.clip(np.ceil(corners[:, :, 1].min(axis=1) - 0.5 - TOLERANCE), 0, size).astype(int)
    bottom = np.clip(np.floor(corners[:, :, 1].max(axis=1) - 0.5 + TOLERANCE), -1, size - 1).astype(int)
    # What is seen from its side has no place that a pixel could be in; its neighbours cover the pixel.
    is_flat = np.abs(_doubled_areas(corners)) < TOLERANCE**2
    rows = np.where(is_flat, 0, np.maximum(bottom - top + 1, 0))
    for faces in _portions(rows):
        face, row = _expand(rows[faces])
        face += faces.start
        y = top[face] + row
        first, last = _spans(corners[face], y + 0.5, size)
        widths = np.maximum(last - first + 1, 0)
        for lines in _portions(widths):
            line, column = _expand(widths[lines])
            line += lines.start
            yield face[line], y[line], first[line] + column


def _spans(a: np.ndarray, y: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """The first and the last pixel of a row between two sides of a face."""
    b = np.roll(a, -1, axis=1)
    low, high = np.minimum(a[:, :, 1], b[:, :, 1]), np.maximum(a[:, :, 1], b[:, :, 1])
    meets = (low - TOLERANCE <= y[:, None]) & (y[:, None] <= high + TOLERANCE)
    rise = b[:, :, 1] - a[:, :, 1]
    share = np.clip((y[:, None] - a[:, :, 1]) / np.where(rise == 0.0, 1.0, rise), 0.0, 1.0)
    x = a[:, :, 0] + share * (b[:, :, 0] - a[:, :, 0])
    first = np.clip(np.ceil(np.where(meets, x, np.inf).min(axis=1) - 0.5 - TOLERANCE), 0, size)
    last = np.clip(np.floor(np.where(meets, x, -np.inf).max(axis=1) - 0.5 + TOLERANCE), -1, size - 1)
    return first.astype(int), last.astype(int)


def _portions(counts: np.ndarray):
    """Yields slices whose counts add up to about MAX_AT_ONCE."""
    sums = np.concatenate([[0], np.cumsum(counts)])
    start = 0
    while start < len(counts):
        stop = max(int(np.searchsorted(sums, sums[start] + MAX_AT_ONCE, side="right")) - 1, start + 1)
        yield slice(start, stop)
        start = stop


def _expand(counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(2, 0, 3) gives (0, 0, 2, 2, 2) and (0, 1, 0, 1, 2)."""
    index = np.repeat(np.arange(len(counts)), counts)
    return index, np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)


def _weights(corners: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Barycentric coordinates of the centers of pixels, cut off at the sides."""
    to_corners = corners[:, :, :2] - (np.stack([x, y], axis=1) + 0.5)[:, None, :]
    after, before = np.roll(to_corners, -1, axis=1), np.roll(to_corners, -2, axis=1)
    areas = after[:, :, 0] * before[:, :, 1] - after[:, :, 1] * before[:, :, 0]
    weights = np.clip(areas / _doubled_areas(corners)[:, None], 0.0, 1.0)
    return weights / weights.sum(axis=1, keepdims=True)


def _doubled_areas(corners: np.ndarray) -> np.ndarray:
    """Of the faces as they are seen, negative from behind."""
    first, second = corners[:, 1, :2] - corners[:, 0, :2], corners[:, 2, :2] - corners[:, 0, :2]
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]


@dataclass(frozen=True)
class View:
    """A camera around the points that it looks at. The projection is parallel."""

    right: np.ndarray
    up: np.ndarray
    center: np.ndarray
    half_height: float  # of the picture, in the points' unit

    @property
    def axes(self) -> np.ndarray:
        """The camera's axes as rows: right, up, and towards the camera."""
        return np.stack([self.right, self.up, np.cross(self.right, self.up)])

    def pixels_of(self, points: np.ndarray, size: int) -> np.ndarray:
        """Points in pixels of a square picture: x to the right, y downwards, z towards the camera."""
        seen = (points - self.center) @ self.axes.T * (0.5 * size / self.half_height)
        return np.stack([0.5 * size + seen[:, 0], 0.5 * size - seen[:, 1], seen[:, 2]], axis=1)

    def of_sphere(self) -> "View":
        """Looks at the unit sphere from the same side."""
        return View(self.right, self.up, np.zeros(3), MARGIN)


def view_of_surface(points: np.ndarray, direction=None, up=None) -> View:
    """Fits a surface into the picture; without a direction, looks along the one in which it is thinnest."""
    center = 0.5 * (points.min(axis=0) + points.max(axis=0))
    if direction is None:
        _, axes = np.linalg.eigh((points - center).T @ (points - center))
        direction = axes[:, 0] * (1.0 if axes[np.argmax(np.abs(axes[:, 0])), 0] > 0 else -1.0)
    direction = np.asarray(direction, float) / np.linalg.norm(direction)
    if up is None:
        up = np.array([0.0, 1.0, 0.0]) if abs(direction[1]) < 0.8 else np.array([0.0, 0.0, 1.0])
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    seen = (points - center) @ np.stack([right, up], axis=1)
    low, high = seen.min(axis=0), seen.max(axis=0)
    center = center + 0.5 * (low + high) @ np.stack([right, up])
    return View(right, up, center, MARGIN * 0.5 * float((high - low).max()))


def turned_like(points: np.ndarray, images: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Turns a sphere so that it lies like the surface: how the program leaves it is arbitrary and differs by method."""
    used = np.unique(faces)
    centered = points[used] - 0.5 * (points[used].min(axis=0) + points[used].max(axis=0))
    u, _, v = np.linalg.svd(images[used].T @ centered)
    return images @ (u * [1.0, 1.0, np.sign(np.linalg.det(u @ v))]) @ v


@dataclass(frozen=True)
class Scale:
    """Colours for a distortion: equal ratios look alike, and the order is visible on a grey print."""

    low: float
    high: float  # what is above has the last color

    def of_faces(self, values: np.ndarray, is_inverted: np.ndarray) -> np.ndarray:
        """Red, green and blue in [0, 1]; what is not finite counts as large."""
        finite = np.nan_to_num(values, nan=self.high, posinf=self.high)
        colors = COLORS(LogNorm(self.low, self.high)(np.clip(finite, self.low, self.high)))[:, :3]
        colors[is_inverted] = INVERTED_COLOR
        return colors

    def add_bar(self, figure, **options):
        """A color bar with a tick at each doubling and at the end."""
        ticks = np.append(self.low * 2.0 ** np.arange(np.ceil(np.log2(self.high / self.low))), self.high)
        bar = figure.colorbar(ScalarMappable(LogNorm(self.low, self.high), COLORS), extend="max", **options)
        bar.set_ticks(ticks, labels=[f"{tick:g}" for tick in ticks])
        bar.minorticks_off()
        return bar


def paint(
    points: np.ndarray,
    faces: np.ndarray,
    view: View,
    size: int,
    colors_of: Paint,
    images: np.ndarray | None = None,
    edge_width: float = 0.0,
) -> np.ndarray:
    """A picture, size x size x 3 numbers in [0, 1], on white.

    `images` are the points of the sphere that belong to the vertices; colors that are a function need them. Edges of
    the mesh are `edge_width` pixels wide.
    """
    fine = SAMPLES * size
    pixels = view.pixels_of(points, fine)
    fragments = find_fragments(pixels, faces, fine)
    if callable(colors_of):
        colors = colors_of(fragments.interpolate(images[faces]))
    else:
        colors = colors_of[fragments.face]
    if edge_width > 0.0:
        share = _share_of_edges(fragments, pixels[faces][:, :, :2], edge_width * SAMPLES)
        colors = (1.0 - EDGE_STRENGTH * share[:, None]) * colors
    picture = np.ones((fine * fine, 3))
    picture[fragments.pixel] = np.clip(colors * _light(fragments, points, faces, view)[:, None], 0.0, 1.0)
    return picture.reshape(size, SAMPLES, size, SAMPLES, 3).mean(axis=(1, 3))


def _light(fragments: Fragments, points: np.ndarray, faces: np.ndarray, view: View) -> np.ndarray:
    normals = fragments.interpolate(_corner_normals(points, faces)) @ view.axes.T
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    normals *= np.where(normals[:, 2:] < 0.0, -1.0, 1.0)
    light = np.full(len(normals), AMBIENT)
    for strength, direction in LIGHTS:
        light += strength * np.maximum(normals @ (np.asarray(direction) / np.linalg.norm(direction)), 0.0)
    return light


def _corner_normals(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """For each corner, the mean of the normals around its vertex that differ little from that of its face."""
    a, b, c = (points[faces[:, i]] for i in range(3))
    weighted = np.cross(b - a, c - a)
    lengths = np.linalg.norm(weighted, axis=1, keepdims=True)
    units = weighted / np.where(lengths > 0.0, lengths, 1.0)
    vertex_of = faces.ravel()
    by_vertex = np.argsort(vertex_of, kind="stable") // 3  # the faces around the first vertex, around the second ...
    counts = np.bincount(vertex_of, minlength=len(points))
    starts = np.cumsum(counts) - counts
    normals = np.empty((len(faces), 3, 3))
    for first in range(0, len(faces), FACES_AT_ONCE):
        part = faces[first : first + FACES_AT_ONCE]
        corner, place = _expand(counts[part.ravel()])
        other = by_vertex[starts[part.ravel()][corner] + place]
        is_close = np.einsum("ij,ij->i", units[first + corner // 3], units[other]) > np.cos(FEATURE_ANGLE)
        sums = [np.bincount(corner, weighted[other, k] * is_close, part.size) for k in range(3)]
        normals[first : first + len(part)] = np.stack(sums, axis=1).reshape(-1, 3, 3)
    lengths = np.linalg.norm(normals, axis=2, keepdims=True)
    return normals / np.where(lengths > 0.0, lengths, 1.0)


def _share_of_edges(fragments: Fragments, corners: np.ndarray, width: float) -> np.ndarray:
    """How much of each pixel belongs to edges."""
    sides = np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1)  # opposite to the corners
    heights = np.abs(_doubled_areas(corners))[:, None] / np.maximum(np.linalg.norm(sides, axis=2), 1e-300)
    distances = (fragments.weights * heights[fragments.face]).min(axis=1)
    return np.clip(0.5 * width + 0.5 - distances, 0.0, 1.0)
