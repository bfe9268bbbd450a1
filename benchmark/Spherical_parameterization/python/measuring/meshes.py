"""Triangle meshes as numpy arrays: reading OFF and PLY, and changing the tessellation without changing the shape."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

FORMATS = (".off", ".ply")


class MeshError(Exception):
    """A file that is no triangle mesh, with the reason."""


@dataclass(frozen=True)
class Mesh:
    """Vertices (n x 3) and faces (m x 3, counterclockwise from outside)."""

    vertices: np.ndarray
    faces: np.ndarray

    def doubled_areas(self) -> np.ndarray:
        a, b, c = (self.vertices[self.faces[:, i]] for i in range(3))
        return np.linalg.norm(np.cross(b - a, c - a), axis=1)

    def area(self) -> float:
        return 0.5 * float(self.doubled_areas().sum())


def read_mesh(path: Path) -> Mesh:
    """Reads a file; numbers keep all digits, vertices and faces their order.

    Raises MeshError if the file holds anything but triangles.
    """
    try:
        mesh = _read_ply(path) if path.suffix.lower() == ".ply" else _read_off(path)
    except (OSError, ValueError, IndexError, KeyError, StopIteration) as error:
        raise MeshError(f"{path.name} cannot be read: {error}") from error
    if mesh.faces.size and (mesh.faces.min() < 0 or mesh.faces.max() >= len(mesh.vertices)):
        raise MeshError(f"{path.name} has a face with a vertex that is not there")
    return mesh


def read_counts(path: Path) -> tuple[int, int]:
    """Reads the numbers of vertices and faces from the head of a file, for choosing among many files quickly."""
    try:
        with path.open("rb") as file:
            if path.suffix.lower() == ".ply":
                header = _read_ply_header(file)
                return header.elements["vertex"].count, header.elements["face"].count
            return _off_counts(line.decode("ascii", "replace") for line in file)
    except (OSError, ValueError, IndexError, KeyError, StopIteration) as error:
        raise MeshError(f"{path.name} cannot be read: {error}") from error


def write_off(path: Path, mesh: Mesh) -> None:
    with path.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{len(mesh.vertices)} {len(mesh.faces)} 0\n")
        np.savetxt(out, mesh.vertices, fmt="%.17g")
        np.savetxt(out, np.insert(mesh.faces, 0, 3, axis=1), fmt="%d")


def why_not_a_sphere(mesh: Mesh) -> str:
    """Says why a mesh is not closed, oriented and of Euler characteristic two; empty if it is.

    The program checks more. This is only to choose meshes from a folder of unknown ones.
    """
    n = len(mesh.vertices)
    directed = np.concatenate([mesh.faces[:, (i, (i + 1) % 3)] for i in range(3)])
    keys = directed[:, 0] * n + directed[:, 1]
    if len(np.unique(keys)) != len(keys):
        return "an edge is met twice in one direction"
    if not np.array_equal(np.sort(keys), np.sort(directed[:, 1] * n + directed[:, 0])):
        return "there is a border"
    characteristic = len(np.unique(mesh.faces)) - len(keys) // 2 + len(mesh.faces)
    return "" if characteristic == 2 else f"the Euler characteristic is {characteristic}"


def refine_one_side(mesh: Mesh, rounds: int) -> Mesh:
    """Halves the edges on one side of the middle, `rounds` times: faces of very different size, the same shape."""
    axis, middle = _longest_axis(mesh)
    for _ in range(rounds):
        is_fine = mesh.vertices[mesh.faces].mean(axis=1)[:, axis] > middle
        mesh = _split_edges(mesh, lambda a, b, faces: np.repeat(is_fine[:, None], 3, axis=1))
    return mesh


def refine_along_one_axis(mesh: Mesh, rounds: int) -> Mesh:
    """Halves the edges along the longest axis only, `rounds` times: stretched faces, the same shape."""
    axis, _ = _longest_axis(mesh)

    def is_along(a: np.ndarray, b: np.ndarray, _: np.ndarray) -> np.ndarray:
        step = b - a
        return np.abs(step[..., axis]) > 0.75 * np.linalg.norm(step, axis=-1)

    for _ in range(rounds):
        mesh = _split_edges(mesh, is_along)
    return mesh


def refine_everywhere(mesh: Mesh) -> Mesh:
    """Splits each face into four, the same shape."""
    return _split_edges(mesh, lambda a, b, faces: np.ones(faces.shape, bool))


def subdivide_smoothly(mesh: Mesh) -> Mesh:
    """Loop's subdivision: splits each face into four and smooths the surface, so that no neighbours are coplanar."""
    n = len(mesh.vertices)
    starts, ends = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    opposite = np.roll(mesh.faces, -2, axis=1).ravel()
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    edges, edge_of = np.unique(low * n + high, return_inverse=True)
    low, high = np.divmod(edges, n)

    def summed(keys: np.ndarray, values: np.ndarray, size: int) -> np.ndarray:
        return np.stack([np.bincount(keys, values[:, axis], size) for axis in range(3)], axis=1)

    points = mesh.vertices
    middles = 0.375 * (points[low] + points[high]) + 0.125 * summed(edge_of, points[opposite], len(edges))
    valence = np.bincount(starts, minlength=n)[:, None]
    weight = (0.625 - (0.375 + 0.25 * np.cos(2.0 * np.pi / np.maximum(valence, 1))) ** 2) / np.maximum(valence, 1)
    moved = (1.0 - valence * weight) * points + weight * summed(starts, points[ends], n)
    refined = refine_everywhere(mesh)  # numbers the new vertices by their edges in the same order
    return Mesh(np.concatenate([moved, middles]), refined.faces)


def _longest_axis(mesh: Mesh) -> tuple[int, float]:
    least, largest = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    axis = int(np.argmax(largest - least))
    return axis, 0.5 * float(least[axis] + largest[axis])


def _split_edges(mesh: Mesh, choose) -> Mesh:
    """Puts a vertex into the middle of every edge that `choose` names in one of its faces; splits the faces there."""
    vertices, faces = mesh.vertices, mesh.faces
    starts, ends = faces, np.roll(faces, -1, axis=1)
    keys = np.minimum(starts, ends) * len(vertices) + np.maximum(starts, ends)
    edges, edge_of = np.unique(keys, return_inverse=True)
    edge_of = edge_of.reshape(faces.shape)
    is_split = np.zeros(len(edges), bool)
    is_split[edge_of[choose(vertices[starts], vertices[ends], faces)]] = True

    middle_of = np.full(len(edges), -1)
    middle_of[is_split] = len(vertices) + np.arange(int(is_split.sum()))
    low, high = np.divmod(edges[is_split], len(vertices))
    vertices = np.concatenate([vertices, 0.5 * (vertices[low] + vertices[high])])

    # Each face is turned so that its first edge is split and its last is not, where there are both.
    marks = is_split[edge_of]
    first = np.argmax(marks & ~np.roll(marks, 1, axis=1), axis=1)
    turn = (first[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(faces, turn, axis=1).T
    ab, bc, ca = np.take_along_axis(middle_of[edge_of], turn, axis=1).T
    count = marks.sum(axis=1)

    def parts(number: int, *corners) -> list[np.ndarray]:
        chosen = count == number
        return [np.stack([x[chosen] for x in triple], axis=1) for triple in corners]

    pieces = parts(0, (a, b, c))
    pieces += parts(1, (a, ab, c), (ab, b, c))
    pieces += parts(2, (ab, b, bc), (a, ab, bc), (a, bc, c))
    pieces += parts(3, (a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
    return Mesh(vertices, np.concatenate(pieces))


def _off_counts(lines) -> tuple[int, int]:
    """Reads the numbers of vertices and faces from an iterator over the lines of an OFF file, and no line more."""
    words: list[str] = []
    while len(words) < 4:
        words += next(lines).split("#")[0].split()
        if words and words[0] not in ("OFF", "COFF", "NOFF", "CNOFF"):
            raise ValueError("this is no OFF file")
    return int(words[1]), int(words[2])


def _read_off(path: Path) -> Mesh:
    with path.open(encoding="ascii", errors="replace") as file:
        number_of_vertices, number_of_faces = _off_counts(file)
        lines = [line for line in (raw.split("#")[0] for raw in file) if line and not line.isspace()]
    lines = lines[: number_of_vertices + number_of_faces]
    if len(lines) < number_of_vertices + number_of_faces or number_of_faces == 0:
        raise ValueError("it ends too early")
    vertices = np.loadtxt(lines[:number_of_vertices], usecols=(0, 1, 2), ndmin=2)
    faces = np.loadtxt(lines[number_of_vertices:], usecols=(0, 1, 2, 3), dtype=np.int64, ndmin=2)
    if np.any(faces[:, 0] != 3):
        raise ValueError("not all faces are triangles")
    return Mesh(vertices, np.ascontiguousarray(faces[:, 1:]))


@dataclass
class _PlyElement:
    count: int
    properties: list[tuple[str, ...]]


@dataclass
class _PlyHeader:
    byte_order: str  # '<', '>' or, for text, ''
    elements: dict[str, _PlyElement]


_PLY_TYPES = {
    "char": "i1",
    "uchar": "u1",
    "short": "i2",
    "ushort": "u2",
    "int": "i4",
    "uint": "u4",
    "float": "f4",
    "double": "f8",
    "int8": "i1",
    "uint8": "u1",
    "int16": "i2",
    "uint16": "u2",
    "int32": "i4",
    "uint32": "u4",
    "float32": "f4",
    "float64": "f8",
}


def _read_ply_header(file) -> _PlyHeader:
    orders = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
    if file.readline().strip() != b"ply":
        raise ValueError("this is no PLY file")
    header = _PlyHeader("", {})
    element = None
    for line in file:
        words = line.decode("ascii", "replace").split()
        if not words:
            continue
        if words[0] == "format":
            header.byte_order = orders[words[1]]
        elif words[0] == "element":
            element = header.elements[words[1]] = _PlyElement(int(words[2]), [])
        elif words[0] == "property" and element is not None:
            element.properties.append(tuple(words[1:]))
        elif words[0] == "end_header":
            return header
    raise ValueError("it ends too early")


def _read_ply(path: Path) -> Mesh:
    with path.open("rb") as file:
        header = _read_ply_header(file)
        if list(header.elements)[:2] != ["vertex", "face"]:
            raise ValueError("vertices and faces do not come first")
        vertex, face = header.elements["vertex"], header.elements["face"]
        if any(p[0] == "list" for p in vertex.properties) or [p[0] for p in face.properties].count("list") != 1:
            raise ValueError("it has lists other than the corners of the faces")
        order = header.byte_order
        # A face's list is taken for three corners; its stored length shows whether that is right.
        vertex_type = np.dtype([(p[1], order + _PLY_TYPES[p[0]]) for p in vertex.properties])
        face_fields: list = []
        for p in face.properties:
            if p[0] == "list":
                face_fields += [("length", order + _PLY_TYPES[p[1]]), ("corners", order + _PLY_TYPES[p[2]], 3)]
            else:
                face_fields.append((p[1], order + _PLY_TYPES[p[0]]))
        face_type = np.dtype(face_fields)
        if order:
            vertices = np.fromfile(file, vertex_type, vertex.count)
            faces = np.fromfile(file, face_type, face.count)
        else:
            lines = file.read().decode("ascii").splitlines()
            vertices = np.loadtxt(lines[: vertex.count], dtype=vertex_type, ndmin=1)
            faces = np.loadtxt(lines[vertex.count : vertex.count + face.count], dtype=face_type, ndmin=1)
    if len(vertices) < vertex.count or len(faces) < face.count or not len(faces):
        raise ValueError("it ends too early")
    if np.any(faces["length"] != 3):
        raise ValueError("not all faces are triangles")
    points = np.stack([vertices[axis].astype(float) for axis in "xyz"], axis=1)
    return Mesh(points, faces["corners"].astype(np.int64))
