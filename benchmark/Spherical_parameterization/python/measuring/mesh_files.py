"""Meshes on disk, which are read only when they are needed."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from .meshes import FORMATS, Mesh, MeshError, read_counts, read_mesh


@dataclass(eq=False)  # a file is the same as itself only, and a key
class MeshFile:
    """A mesh on disk, read when it is needed."""

    path: Path
    number_of_vertices: int
    number_of_faces: int
    origin: str = ""  # how it was made, if by this driver
    name: str = field(init=False)

    def __post_init__(self) -> None:
        self.name = self.path.stem

    @cached_property
    def mesh(self) -> Mesh:
        return read_mesh(self.path)

    @cached_property
    def checksum(self) -> str:
        return hashlib.sha256(self.path.read_bytes()).hexdigest()

    def forget(self) -> None:
        self.__dict__.pop("mesh", None)


def find_mesh_files(folder: Path, most_vertices: int | None = None) -> list[MeshFile]:
    """The meshes directly in a folder, by name; it may hold anything else besides."""
    files = []
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() not in FORMATS:
            continue
        try:
            vertices, faces = read_counts(path)
        except MeshError:
            continue
        if most_vertices is None or vertices <= most_vertices:
            files.append(MeshFile(path, vertices, faces))
    return files
