"""Distortion of a spherical map by eq. 12 to 14 of the paper, computed without the package that is measured.

A face is measured as the flat triangle between the images of its vertices. The sign of its orientation is left out of
the distortion and counted apart, as folded: the paper's tables do the same, or their maxima could not be finite.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from .meshes import Mesh

# A face with less than this share of its longest edge squared has no shape to compare with, and is left out.
LEAST_RELATIVE_AREA = 1e-12


@dataclass(frozen=True)
class Statistics:
    """Over the faces, without weights, as in the paper's tables."""

    maximum: float
    average: float
    deviation: float

    @staticmethod
    def of(values: np.ndarray) -> "Statistics":
        if len(values) == 0:
            return Statistics(np.nan, np.nan, np.nan)
        return Statistics(float(values.max()), float(values.mean()), float(values.std()))


@dataclass(frozen=True)
class Distortion:
    """The three measures of one map at one radius, for each face that is measured (the others hold NaN)."""

    radius: float
    isometric_of_faces: np.ndarray
    area_of_faces: np.ndarray
    angle_of_faces: np.ndarray

    @property
    def isometric(self) -> Statistics:
        return _statistics(self.isometric_of_faces)

    @property
    def area(self) -> Statistics:
        return _statistics(self.area_of_faces)

    @property
    def angle(self) -> Statistics:
        return _statistics(self.angle_of_faces)


class SphericalMap:
    """A map of a mesh to a sphere, with all that is measured of it."""

    def __init__(self, mesh: Mesh, images: np.ndarray):
        self._mesh = mesh
        used = np.unique(mesh.faces)
        lengths = np.linalg.norm(images, axis=1)
        if not np.all(np.isfinite(images[used])) or np.any(lengths[used] == 0.0):
            raise ValueError("an image is not finite, or is the centre of the sphere")
        self.own_radius = float(lengths[used].mean())
        self.unit_images = images / np.where(lengths > 0.0, lengths, 1.0)[:, None]
        self.is_folded = _is_folded(images, mesh.faces)
        self._least, self._largest, self._is_measured = self._stretch()
        self.number_left_out = int(np.count_nonzero(~self._is_measured))

    @property
    def number_folded(self) -> int:
        return int(np.count_nonzero(self.is_folded))

    @property
    def optimal_radius(self) -> float:
        """The radius of eq. 11, which balances the area distortion whatever radius the map came with."""
        areas = (self._least * self._largest)[self._is_measured]
        return float(((1.0 / areas).sum() / areas.sum()) ** 0.25)

    def distortion(self, radius: float | None = None) -> Distortion:
        """Measures at a radius, by default that of eq. 11."""
        radius = self.optimal_radius if radius is None else radius
        least, largest = radius * self._least, radius * self._largest
        with np.errstate(divide="ignore", invalid="ignore"):
            isometric = np.maximum(largest, 1.0 / least)
            area = least * largest + 1.0 / (least * largest)
            angle = largest / least + least / largest
        return Distortion(radius, *(np.where(self._is_measured, x, np.nan) for x in (isometric, area, angle)))

    def area_weighted_average(self) -> float:
        """D_iso averaged over the surface, at the radius of eq. 11: does not depend on where the faces are small."""
        values, areas = self.distortion().isometric_of_faces, self._mesh.doubled_areas()
        return float(np.average(values[self._is_measured], weights=areas[self._is_measured]))

    def number_across(self, share: float = 0.1) -> int:
        """Counts faces whose plane comes closer to the centre than `share` of the radius.

        Such a face is not large but lies across a great circle: the trap that the flat area leaves open.
        """
        u, v, w = (self.unit_images[self._mesh.faces[:, i]] for i in range(3))
        normals = np.cross(v - u, w - u)
        doubled_areas = np.linalg.norm(normals, axis=1)
        return int(np.count_nonzero(np.einsum("ij,ij->i", u, normals) < share * doubled_areas))

    def _stretch(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the singular values on the unit sphere, and which faces have both triangles."""
        points = self._mesh.vertices[self._mesh.faces]
        images = self.unit_images[self._mesh.faces]
        # The longest edge of the face is the first axis: of all choices the one that loses the fewest digits.
        edges = np.linalg.norm(np.roll(points, -1, axis=1) - points, axis=2)
        turn = (np.argmax(edges, axis=1)[:, None] + np.arange(3)) % 3
        points = np.take_along_axis(points, turn[:, :, None], axis=1)
        images = np.take_along_axis(images, turn[:, :, None], axis=1)
        length, x, doubled_area = _in_plane(points)
        image_length, image_x, image_doubled_area = _in_plane(images)
        is_measured = (doubled_area > LEAST_RELATIVE_AREA * length**2) & (image_doubled_area > 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            height, image_height = doubled_area / length, image_doubled_area / image_length
            a = image_length / length
            b = (image_x - x * a) / height
            d = image_height / height
            largest = 0.5 * (np.hypot(a + d, b) + np.hypot(a - d, b))
            least = a * d / largest
        return np.where(is_measured, least, np.nan), np.where(is_measured, largest, np.nan), is_measured


def _statistics(values: np.ndarray) -> Statistics:
    return Statistics.of(values[~np.isnan(values)])


def _in_plane(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the length of the first edge, the third corner's coordinate along it, and twice the area."""
    first, second = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    length = np.linalg.norm(first, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        along = np.einsum("ij,ij->i", first, second) / length
    return length, along, np.linalg.norm(np.cross(first, second), axis=1)


def _is_folded(images: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Tells for each face whether det(u0, u1, u2) <= 0, exactly: fractions settle the few that doubles leave open."""
    u, v, w = (images[faces[:, i]] for i in range(3))
    v, w = v - u, w - u
    terms = np.stack([u[:, i] * v[:, (i + j) % 3] * w[:, (i - j) % 3] * j for i in range(3) for j in (1, -1)])
    determinants = terms.sum(axis=0)
    # The differences, two products and five sums are each right to one rounding; 32 of them are more than enough.
    is_open = np.abs(determinants) <= 32.0 * np.finfo(float).eps * np.abs(terms).sum(axis=0)
    result = determinants <= 0.0
    for face in np.flatnonzero(is_open):
        a, b, c = ([Fraction(float(x)) for x in images[i]] for i in faces[face])
        result[face] = (
            sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3)) <= 0
        )
    return result
