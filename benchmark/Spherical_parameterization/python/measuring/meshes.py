"""Triangle meshes as numpy arrays: reading, writing, and changing the tessellation without changing the shape."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from pathlib import Path

import numpy as np

FORMATS = (".off", ".ply", ".obj")


class MeshError(Exception):
    """A file that is no triangle mesh, with the reason."""


@dataclass(frozen=True)
class Mesh:
    """Vertices (n x 3) and faces (m x 3, counterclockwise from outside)."""

    vertices: np.ndarray
    faces: np.ndarray

    def area(self) -> float:
        a, b, c = (self.vertices[self.faces[:, i]] for i in range(3))
        return 0.5 * float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())

    def objection(self) -> str:
        """Why this is no closed, oriented surface of Euler characteristic 2; empty if it is one."""
        starts, ends = self.faces, np.roll(self.faces, -1, axis=1)
        keys = np.sort((starts * len(self.vertices) + ends).ravel())
        if not len(keys) or np.any(keys[1:] == keys[:-1]):
            return "an edge is met twice in one direction"
        if not np.array_equal(keys, np.sort((ends * len(self.vertices) + starts).ravel())):
            return "there is a border"
        characteristic = len(np.unique(self.faces)) - len(keys) // 2 + len(self.faces)
        return "" if characteristic == 2 else f"the Euler characteristic is {characteristic}"


class MeshFile:
    """A mesh on disk, read when it is needed."""

    def __init__(self, path: Path, origin: str = ""):
        self.path, self.name, self.origin = path, path.stem, origin

    @cached_property
    def mesh(self) -> Mesh:
        return read_mesh(self.path)

    @cached_property
    def number_of_vertices(self) -> int:
        return read_number_of_vertices(self.path)

    @cached_property
    def checksum(self) -> str:
        return checksum(self.path)

    def forget(self) -> None:
        self.__dict__.pop("mesh", None)

    def objection(self) -> str:
        """Why the file is not worth a run: an objection to the mesh, or what is wrong with the file."""
        try:
            return self.mesh.objection()
        except MeshError as error:
            return str(error)
        finally:
            self.forget()


def checksum(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def find_mesh_files(inputs: list[Path], max_vertices: float = np.inf) -> list[MeshFile]:
    """The files among the inputs, and those directly in the folders among them that are meshes, by name."""
    files = [MeshFile(path) for path in inputs if not path.is_dir()]
    for folder in (path for path in inputs if path.is_dir()):
        files += [MeshFile(path) for path in sorted(folder.iterdir()) if path.suffix.lower() in FORMATS]
    return [file for file in files if max_vertices == np.inf or file.number_of_vertices <= max_vertices]


def read_mesh(path: Path) -> Mesh:
    """Reads a file; numbers keep all digits, vertices and faces their order.

    Raises MeshError if the file holds anything but triangles.
    """
    try:
        mesh = {".ply": _read_ply, ".obj": _read_obj}.get(path.suffix.lower(), _read_off)(path)
    except (OSError, ValueError, LookupError, StopIteration) as error:
        raise MeshError(f"{path.name} cannot be read: {error}") from error
    if mesh.faces.size and (mesh.faces.min() < 0 or mesh.faces.max() >= len(mesh.vertices)):
        raise MeshError(f"{path.name} has a face with a vertex that is not there")
    return mesh


def read_number_of_vertices(path: Path) -> int:
    """From the head of a file alone, where that suffices; -1 if the file cannot be read."""
    try:
        with path.open("rb") as file:
            if path.suffix.lower() == ".ply":
                return _read_ply_header(file)[1]["vertex"][0]
            if path.suffix.lower() == ".obj":
                return sum(line.startswith(b"v ") for line in file)
            return _read_off_counts(line.decode("ascii", "replace") for line in file)[0]
    except (OSError, ValueError, LookupError, StopIteration):
        return -1


def write_mesh(path: Path, mesh: Mesh) -> None:
    """Writes OFF, PLY (as text) or OBJ, by the ending of the name, with 17 digits."""
    n, m, faces = len(mesh.vertices), len(mesh.faces), np.insert(mesh.faces, 0, 3, axis=1)
    point_format, face_format, head = "%.17g", "%d", f"OFF\n{n} {m} 0\n"
    if path.suffix == ".ply":
        coordinates = "".join(f"property double {axis}\n" for axis in "xyz")
        head = f"ply\nformat ascii 1.0\nelement vertex {n}\n{coordinates}element face {m}\n"
        head += "property list uchar int vertex_indices\nend_header\n"
    elif path.suffix == ".obj":
        point_format, face_format, head, faces = "v %.17g %.17g %.17g", "f %d %d %d", "", mesh.faces + 1
    elif path.suffix != ".off":
        raise MeshError(f"{path.suffix} is none of the formats {', '.join(FORMATS)}")
    with path.open("w", encoding="ascii") as out:
        out.write(head)
        np.savetxt(out, mesh.vertices, fmt=point_format)
        np.savetxt(out, faces, fmt=face_format)


def refine_one_side(mesh: Mesh, rounds: int) -> Mesh:
    """Halves the edges on one side of the middle, `rounds` times: faces of very different size, the same shape."""
    axis, middle = _longest_axis(mesh)
    for _ in range(rounds):
        is_fine = mesh.vertices[mesh.faces].mean(axis=1)[:, axis] > middle
        mesh = _split_edges(mesh, np.repeat(is_fine[:, None], 3, axis=1))
    return mesh


def refine_along_one_axis(mesh: Mesh, rounds: int) -> Mesh:
    """Halves the edges along the longest axis only, `rounds` times: stretched faces, the same shape."""
    axis, _ = _longest_axis(mesh)
    for _ in range(rounds):
        step = mesh.vertices[np.roll(mesh.faces, -1, axis=1)] - mesh.vertices[mesh.faces]
        mesh = _split_edges(mesh, np.abs(step[..., axis]) > 0.75 * np.linalg.norm(step, axis=-1))
    return mesh


def refine_everywhere(mesh: Mesh) -> Mesh:
    """Splits each face into four, the same shape."""
    return _split_edges(mesh, np.ones(mesh.faces.shape, bool))


def subdivide_smoothly(mesh: Mesh) -> Mesh:
    """Loop's subdivision: splits each face into four and smooths the surface, so that no neighbours are coplanar."""
    points, n = mesh.vertices, len(mesh.vertices)
    starts, ends = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    opposite = np.roll(mesh.faces, -2, axis=1).ravel()
    edges, edge_of = np.unique(np.minimum(starts, ends) * n + np.maximum(starts, ends), return_inverse=True)
    low, high = np.divmod(edges, n)

    def summed(keys: np.ndarray, values: np.ndarray, size: int) -> np.ndarray:
        return np.stack([np.bincount(keys, values[:, axis], size) for axis in range(3)], axis=1)

    middles = 0.375 * (points[low] + points[high]) + 0.125 * summed(edge_of, points[opposite], len(edges))
    valence = np.maximum(np.bincount(starts, minlength=n), 1)[:, None]
    weight = (0.625 - (0.375 + 0.25 * np.cos(2.0 * np.pi / valence)) ** 2) / valence
    moved = (1.0 - valence * weight) * points + weight * summed(starts, points[ends], n)
    refined = refine_everywhere(mesh)  # numbers the new vertices by their edges in the same order
    return Mesh(np.concatenate([moved, middles]), refined.faces)


def _longest_axis(mesh: Mesh) -> tuple[int, float]:
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    axis = int(np.argmax(high - low))
    return axis, 0.5 * float(low[axis] + high[axis])


def _split_edges(mesh: Mesh, is_chosen: np.ndarray) -> Mesh:
    """Puts a vertex into the middle of every edge that is chosen in one of its faces, and splits the faces there."""
    vertices, faces = mesh.vertices, mesh.faces
    starts, ends = faces, np.roll(faces, -1, axis=1)
    keys = np.minimum(starts, ends) * len(vertices) + np.maximum(starts, ends)
    edges, edge_of = np.unique(keys, return_inverse=True)
    edge_of = edge_of.reshape(faces.shape)
    is_split = np.zeros(len(edges), bool)
    is_split[edge_of[is_chosen]] = True

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
    parts = {  # by the number of edges that are split
        0: [(a, b, c)],
        1: [(a, ab, c), (ab, b, c)],
        2: [(ab, b, bc), (a, ab, bc), (a, bc, c)],
        3: [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)],
    }
    count = marks.sum(axis=1)
    pieces = [np.stack(part, axis=1)[count == number] for number, of_number in parts.items() for part in of_number]
    return Mesh(vertices, np.concatenate(pieces))


def _read_off_counts(lines) -> tuple[int, int]:
    """The numbers of vertices and faces from an iterator over the lines of an OFF file, of which no more are read."""
    words: list[str] = []
    while len(words) < 4:
        words += next(lines).split("#")[0].split()
        if words and words[0] not in ("OFF", "COFF", "NOFF", "CNOFF"):
            raise ValueError("this is no OFF file")
    return int(words[1]), int(words[2])


def _read_off(path: Path) -> Mesh:
    with path.open(encoding="ascii", errors="replace") as file:
        n, m = _read_off_counts(file)
        lines = list(islice((line for line in (raw.split("#")[0] for raw in file) if line.strip()), n + m))
    if len(lines) < n + m or m <= 0:
        raise ValueError("it ends too early")
    vertices = np.loadtxt(lines[:n], usecols=(0, 1, 2), ndmin=2)
    faces = np.loadtxt(lines[n:], usecols=(0, 1, 2, 3), dtype=np.int64, ndmin=2)
    if np.any(faces[:, 0] != 3):
        raise ValueError("not all faces are triangles")
    return Mesh(vertices, np.ascontiguousarray(faces[:, 1:]))


def _read_obj(path: Path) -> Mesh:
    words = [line.split() for line in path.read_text("ascii", "replace").splitlines() if line[:2] in ("v ", "f ")]
    vertices = np.array([[float(x) for x in line[1:4]] for line in words if line[0] == "v"])
    faces = np.array([[int(corner.split("/")[0]) for corner in line[1:]] for line in words if line[0] == "f"])
    if vertices.ndim != 2 or faces.ndim != 2 or faces.shape[1] != 3:
        raise ValueError("not all faces are triangles")
    return Mesh(vertices, np.where(faces < 0, faces + len(vertices), faces - 1))


def _ply_type(name: str) -> str:
    """The type of a number in numpy's words, of which the others are aliases."""
    aliases = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4"}
    return aliases.get(name, "f8" if name == "double" else name)


def _read_ply_header(file) -> tuple[str, dict[str, tuple[int, list[list[str]]]]]:
    """The order of the bytes, empty for text; of each element the number and the words of its properties."""
    if file.readline().strip() != b"ply":
        raise ValueError("this is no PLY file")
    order, elements, properties = "", {}, []
    for line in file:
        words = line.decode("ascii", "replace").split() or [""]
        if words[0] == "format":
            order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
        elif words[0] == "element":
            properties = []
            elements[words[1]] = (int(words[2]), properties)
        elif words[0] == "property":
            properties.append(words[1:])
        elif words[0] == "end_header":
            return order, elements
    raise ValueError("it ends too early")


def _read_ply(path: Path) -> Mesh:
    with path.open("rb") as file:
        order, elements = _read_ply_header(file)
        if list(elements)[:2] != ["vertex", "face"]:
            raise ValueError("vertices and faces do not come first")
        (n, of_vertex), (m, of_face) = elements["vertex"], elements["face"]
        if any(p[0] == "list" for p in of_vertex) or [p[0] for p in of_face].count("list") != 1:
            raise ValueError("it has lists other than the corners of the faces")
        # A face's list is taken for three corners; its stored length shows whether that is right.
        fields: list = []
        for p in of_face:
            types = [np.dtype(_ply_type(word)).newbyteorder(order or "=") for word in p[:-1] if word != "list"]
            fields += [("length", types[0]), ("corners", types[1], 3)] if p[0] == "list" else [(p[-1], types[0])]
        vertex_type = np.dtype([(p[1], np.dtype(_ply_type(p[0])).newbyteorder(order or "=")) for p in of_vertex])
        if order:
            vertices, faces = np.fromfile(file, vertex_type, n), np.fromfile(file, np.dtype(fields), m)
        else:
            lines = file.read().decode("ascii").splitlines()
            vertices = np.loadtxt(lines[:n], dtype=vertex_type, ndmin=1)
            faces = np.loadtxt(lines[n : n + m], dtype=np.dtype(fields), ndmin=1)
    if len(vertices) < n or len(faces) < m or not m:
        raise ValueError("it ends too early")
    if np.any(faces["length"] != 3):
        raise ValueError("not all faces are triangles")
    return Mesh(np.stack([vertices[axis].astype(float) for axis in "xyz"], axis=1), faces["corners"].astype(np.int64))
