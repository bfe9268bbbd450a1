"""One picture of a mesh: its visible faces, a paint, and the light."""

from __future__ import annotations

from typing import Callable, Union

import numpy as np

from .fragments import Fragments, doubled_areas, find_fragments
from .views import View

SAMPLES = 3  # along both sides of a pixel
FEATURE_ANGLE = np.radians(60.0)  # sharper edges of the surface are not smoothed
FACES_AT_ONCE = 200_000  # bounds the memory

# In the camera's axes: right, up, and towards the camera.
AMBIENT = 0.56
LIGHTS = ((0.42, (-0.45, 0.65, 0.8)), (0.14, (0.8, -0.2, 0.6)))
EDGE_STRENGTH = 0.75  # of black

# Colours of faces, or a function from points of the sphere to colours
Paint = Union[np.ndarray, Callable[[np.ndarray], np.ndarray]]


def paint(
    points: np.ndarray,
    faces: np.ndarray,
    view: View,
    size: int,
    colors_of: Paint,
    images: np.ndarray | None = None,
    edge_width: float = 0.0,
) -> np.ndarray:
    """Returns size x size x 3 numbers in [0, 1], on white.

    `images` are the points of the sphere that belong to the vertices; colours that are a function need them. Edges of
    the mesh are `edge_width` pixels wide.
    """
    fine = SAMPLES * size
    pixels = view.pixels_of(points, fine)
    fragments = find_fragments(pixels, faces, fine)
    if callable(colors_of):
        colors = colors_of(fragments.interpolate(faces, images))
    else:
        colors = colors_of[fragments.face]
    if edge_width > 0.0:
        share = _share_of_edges(fragments, pixels, faces, edge_width * SAMPLES)
        colors = (1.0 - EDGE_STRENGTH * share[:, None]) * colors
    picture = np.ones((fine * fine, 3))
    picture[fragments.pixel] = np.clip(colors * _light(fragments, points, faces, view)[:, None], 0.0, 1.0)
    return picture.reshape(size, SAMPLES, size, SAMPLES, 3).mean(axis=(1, 3))


def _light(fragments: Fragments, points: np.ndarray, faces: np.ndarray, view: View) -> np.ndarray:
    normals = fragments.interpolate_corners(_corner_normals(points, faces)) @ view.axes.T
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
        around = counts[part.ravel()]
        corner = np.repeat(np.arange(part.size), around)
        place = np.arange(len(corner)) - np.repeat(np.cumsum(around) - around, around)
        other = by_vertex[starts[part.ravel()][corner] + place]
        is_close = np.einsum("ij,ij->i", units[first + corner // 3], units[other]) > np.cos(FEATURE_ANGLE)
        sums = [np.bincount(corner, weighted[other, k] * is_close, part.size) for k in range(3)]
        normals[first : first + len(part)] = np.stack(sums, axis=1).reshape(-1, 3, 3)
    lengths = np.linalg.norm(normals, axis=2, keepdims=True)
    return normals / np.where(lengths > 0.0, lengths, 1.0)


def _share_of_edges(fragments: Fragments, pixels: np.ndarray, faces: np.ndarray, width: float) -> np.ndarray:
    """How much of each pixel belongs to edges."""
    corners = pixels[faces][:, :, :2]
    sides = np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1)  # opposite to the corners
    heights = np.abs(doubled_areas(corners))[:, None] / np.maximum(np.linalg.norm(sides, axis=2), 1e-300)
    distances = (fragments.weights * heights[fragments.face]).min(axis=1)
    return np.clip(0.5 * width + 0.5 - distances, 0.0, 1.0)
