"""Cameras: how surfaces and spheres are looked at. The projection is parallel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MARGIN = 1.04


@dataclass(frozen=True)
class View:
    """A camera around the points that it looks at."""

    right: np.ndarray
    up: np.ndarray
    center: np.ndarray
    half_height: float  # of the picture, in the points' unit

    @property
    def direction(self) -> np.ndarray:
        """From the centre to the camera."""
        return np.cross(self.right, self.up)

    @property
    def axes(self) -> np.ndarray:
        """The camera's axes as rows: right, up, and towards the camera."""
        return np.stack([self.right, self.up, self.direction])

    def pixels_of(self, points: np.ndarray, size: int) -> np.ndarray:
        """Points in pixels of a square picture: x to the right, y downwards, z towards the camera."""
        seen = (points - self.center) @ self.axes.T * (0.5 * size / self.half_height)
        return np.stack([0.5 * size + seen[:, 0], 0.5 * size - seen[:, 1], seen[:, 2]], axis=1)


def view_of_surface(
    points: np.ndarray, direction: np.ndarray | None = None, up: np.ndarray | None = None, margin: float = MARGIN
) -> View:
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
    least, largest = seen.min(axis=0), seen.max(axis=0)
    center = center + 0.5 * (least + largest) @ np.stack([right, up])
    return View(right, up, center, margin * 0.5 * float((largest - least).max()))


def view_of_sphere(view: View, margin: float = MARGIN) -> View:
    """Looks at the unit sphere from where the surface is looked at."""
    return View(view.right, view.up, np.zeros(3), margin)


def turned_like(points: np.ndarray, images: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Turns a sphere so that it lies like the surface: how the program leaves it is arbitrary and differs by method."""
    used = np.unique(faces)
    centered = points[used] - 0.5 * (points[used].min(axis=0) + points[used].max(axis=0))
    u, _, v = np.linalg.svd(images[used].T @ centered)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    return images @ (u * signs) @ v
