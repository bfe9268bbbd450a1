"""Judges a map of a mesh to a sphere: whether it is one-to-one, and its distortion by eq. 12 to 14 of the paper.

Nothing of the package is used here, because the package is what is judged. A face is measured as the flat triangle
between the images of its vertices. The sign of its orientation is left out of the distortion and counted apart, as
inverted: the paper's tables do the same, or their maxima could not be finite.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from .meshes import Mesh, MeshError

# A face with less than this share of its longest edge squared has no shape to compare with, and is left out.
MIN_RELATIVE_AREA = 1e-12


@dataclass(frozen=True)
class Statistics:
    """Over the faces, without weights, as in the paper's tables."""

    maximum: float
    average: float
    deviation: float

    @staticmethod
    def of(values: np.ndarray) -> "Statistics":
        values = values[~np.isnan(values)]
        if len(values) == 0:
            return Statistics(np.nan, np.nan, np.nan)
        return Statistics(float(values.max()), float(values.mean()), float(values.std()))


class Distortion:
    """The three measures of one map at one radius: of each face that is measured (the others hold NaN), and of all."""

    def __init__(self, radius: float, isometric: np.ndarray, area: np.ndarray, angle: np.ndarray):
        self.radius = radius
        self.isometric_of_faces, self.angle_of_faces = isometric, angle
        self.isometric, self.area, self.angle = (Statistics.of(values) for values in (isometric, area, angle))


class SphericalMap:
    """A map, with all that is measured of it.

    A map may be mirrored as a whole if `may_be_mirrored`; else a face is inverted if det(u0, u1, u2) <= 0.
    """

    def __init__(self, mesh: Mesh, images: np.ndarray, may_be_mirrored: bool = False):
        self._mesh = mesh
        self._points, self._unit = _scaled(mesh.vertices)
        scaled_images, unit_of_images = _scaled(images)
        used = np.unique(mesh.faces)
        lengths = np.linalg.norm(scaled_images, axis=1)
        if not np.all(np.isfinite(images[used])) or np.any(lengths[used] == 0.0):
            raise MeshError("an image is not finite, or is the center of the sphere")
        self._lengths = lengths[used]
        self.own_radius = unit_of_images * float(self._lengths.mean())
        self.unit_images = scaled_images / np.where(lengths > 0.0, lengths, 1.0)[:, None]
        signs = _orientations(images, scaled_images, mesh.faces)
        is_mirrored = may_be_mirrored and np.count_nonzero(signs < 0) > np.count_nonzero(signs > 0)
        self.is_inverted = signs >= 0 if is_mirrored else signs <= 0
        self._smallest, self._largest, self._is_measured = self._stretch()
        self.number_left_out = int(np.count_nonzero(~self._is_measured))

    @property
    def number_inverted(self) -> int:
        return int(np.count_nonzero(self.is_inverted))

    def objection(self, max_deviation: float = 1e-6) -> str:
        """Why this is no one-to-one map onto a sphere around the origin; empty if it is one.

        Decides by a theorem: if the faces of a closed surface are mapped to spherical triangles that all have the same
        orientation, then two faces that share an edge lie on different sides of it, so that each point of the sphere
        that is on no edge is covered by the same number of faces. This number is the sum of the areas over that of the
        sphere; and if it is 1, the map is one-to-one. Radii may differ by `max_deviation`, relatively: files may have
        few digits.
        """
        if self._mesh.objection():
            return f"the mesh is no closed surface: {self._mesh.objection()}"
        if not self._lengths.min() > (1.0 - max_deviation) * self._lengths.max():
            return "the images are on no sphere around the origin"
        if self.number_inverted > 0:
            return f"{self.number_inverted} of {len(self.is_inverted)} faces are inverted or have no area"
        degree = self._solid_angle() / (4.0 * np.pi)
        return "" if abs(degree - 1.0) < 0.01 else f"the faces cover the sphere {round(degree)} times"

    @property
    def optimal_radius(self) -> float:
        """The radius of eq. 11, which balances the area distortion whatever radius the map came with."""
        areas = (self._smallest * self._largest)[self._is_measured]
        return self._unit * float(((1.0 / areas).sum() / areas.sum()) ** 0.25) if len(areas) else np.nan

    @property
    def best_radius(self) -> float:
        """The radius at which the largest D_iso is lowest: the one most favourable to whoever made the map."""
        smallest, largest = self._smallest[self._is_measured].min(), self._largest[self._is_measured].max()
        return self._unit / float(np.sqrt(smallest * largest))

    def distortion(self, radius: float | None = None) -> Distortion:
        """Measures at a radius, by default that of eq. 11."""
        radius = self.optimal_radius if radius is None else radius
        smallest, largest = radius / self._unit * self._smallest, radius / self._unit * self._largest
        with np.errstate(divide="ignore", invalid="ignore"):
            isometric = np.maximum(largest, 1.0 / smallest)
            area = smallest * largest + 1.0 / (smallest * largest)
            angle = largest / smallest + smallest / largest
        return Distortion(radius, *(np.where(self._is_measured, x, np.nan) for x in (isometric, area, angle)))

    def area_weighted_average(self) -> float:
        """D_iso averaged over the surface, at the radius of eq. 11: does not depend on where the faces are small."""
        a, b, c = (self._points[self._mesh.faces[:, i]] for i in range(3))
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)[self._is_measured]
        return float(np.average(self.distortion().isometric_of_faces[self._is_measured], weights=areas))

    def number_across(self, share: float = 0.1) -> int:
        """Counts faces whose plane comes closer to the center than `share` of the radius.

        Such a face is not large but lies across a great circle: the trap that the flat area leaves open.
        """
        u, v, w = (self.unit_images[self._mesh.faces[:, i]] for i in range(3))
        normals = np.cross(v - u, w - u)
        return int(np.count_nonzero(np.einsum("ij,ij->i", u, normals) < share * np.linalg.norm(normals, axis=1)))

    def _solid_angle(self) -> float:
        """The sum of the areas of the spherical triangles on the unit sphere, by Van Oosterom and Strackee."""
        u, v, w = (self.unit_images[self._mesh.faces[:, i]] for i in range(3))
        cosines = [np.einsum("ij,ij->i", a, b) for a, b in ((u, v), (v, w), (w, u))]
        determinants = np.abs(np.einsum("ij,ij->i", u, np.cross(v, w)))  # rounding may have changed the sign of one
        return float((2.0 * np.arctan2(determinants, 1.0 + sum(cosines))).sum())

    def _stretch(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The singular values on the unit sphere, smallest and largest, and which faces have both triangles."""
        points = self._points[self._mesh.faces]
        images = self.unit_images[self._mesh.faces]
        # The longest edge of the face is the first axis: of all choices the one that loses the fewest digits.
        edges = np.linalg.norm(np.roll(points, -1, axis=1) - points, axis=2)
        turn = (np.argmax(edges, axis=1)[:, None] + np.arange(3)) % 3
        points = np.take_along_axis(points, turn[:, :, None], axis=1)
        images = np.take_along_axis(images, turn[:, :, None], axis=1)
        length, x, doubled_area = _in_plane(points)
        image_length, image_x, image_doubled_area = _in_plane(images)
        is_measured = (doubled_area > MIN_RELATIVE_AREA * length**2) & (image_doubled_area > 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            height, image_height = doubled_area / length, image_doubled_area / image_length
            a = image_length / length
            b = (image_x - x * a) / height
            d = image_height / height
            largest = 0.5 * (np.hypot(a + d, b) + np.hypot(a - d, b))
            smallest = a * d / largest
        return np.where(is_measured, smallest, np.nan), np.where(is_measured, largest, np.nan), is_measured


def map_between(mesh: Mesh, sphere: Mesh, may_be_mirrored: bool = False) -> SphericalMap:
    """The map from a mesh to one with the same vertices and, in whatever order, the same faces."""
    if len(sphere.vertices) != len(mesh.vertices) or len(sphere.faces) != len(mesh.faces):
        raise MeshError("the map has other numbers of vertices and faces than the mesh")
    if not np.array_equal(_sorted_faces(sphere.faces), _sorted_faces(mesh.faces)):
        raise MeshError("the map has other faces than the mesh")
    return SphericalMap(mesh, sphere.vertices, may_be_mirrored)


def _sorted_faces(faces: np.ndarray) -> np.ndarray:
    """Each from its smallest corner on."""
    turned = np.take_along_axis(faces, (np.argmin(faces, axis=1)[:, None] + np.arange(3)) % 3, axis=1)
    return turned[np.lexsort(turned.T)]


def _scaled(points: np.ndarray) -> tuple[np.ndarray, float]:
    """The points in a unit, a power of two, in which no product of coordinates overflows."""
    finite = np.abs(points[np.isfinite(points)])
    unit = 2.0 ** int(np.frexp(finite.max(initial=0.0))[1] - 1)
    return points / unit, unit


def _in_plane(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The length of the first edge, the third corner's coordinate along it, and twice the area."""
    first, second = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    length = np.linalg.norm(first, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        along = np.einsum("ij,ij->i", first, second) / length
    return length, along, np.linalg.norm(np.cross(first, second), axis=1)


def _orientations(images: np.ndarray, scaled_images: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The sign of det(u0, u1, u2) of each face, exactly: fractions settle the few that doubles leave open."""
    u, v, w = (scaled_images[faces[:, i]] for i in range(3))
    v, w = v - u, w - u
    terms = np.stack([u[:, i] * v[:, (i + j) % 3] * w[:, (i - j) % 3] * j for i in range(3) for j in (1, -1)])
    determinants = terms.sum(axis=0)
    # The differences, two products and five sums are each right to one rounding; 32 of them are more than enough, and
    # so is the second term for what underflows.
    is_open = np.abs(determinants) <= 32.0 * np.finfo(float).eps * np.abs(terms).sum(axis=0) + 1e-300
    signs = np.sign(determinants).astype(int)
    for face in np.flatnonzero(is_open):
        a, b, c = ([Fraction(float(x)) for x in images[i]] for i in faces[face])
        minors = [b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3] for i in range(3)]
        determinant = sum(x * minor for x, minor in zip(a, minors))
        signs[face] = (determinant > 0) - (determinant < 0)
    return signs
