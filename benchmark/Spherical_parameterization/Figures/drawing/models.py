"""The meshes of the figures, and how they are looked at."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from measuring.mesh_files import MeshFile
from measuring.meshes import FORMATS, read_counts
from rendering.views import View, view_of_surface


@dataclass(frozen=True)
class Model:
    """A surface; without a direction to the camera, it is looked at along its thinnest extent."""

    title: str
    file: str  # without the ending
    direction: tuple[float, float, float] | None = None
    up: tuple[float, float, float] | None = None


MODELS = {
    "armadillo": Model("armadillo", "armadillo_26002", (0.35, 0.2, -1.0)),
    "buddha": Model("buddha", "buddha_24992", (0.35, -0.9, 0.3), (0.0, 0.0, 1.0)),
    "bunny": Model("bunny", "bunny_20002", (0.2, 0.25, 0.95), (0.0, 1.0, 0.0)),
    "coarse bunny": Model("bunny", "bunny_3485", (0.2, 0.25, 0.95), (0.0, 1.0, 0.0)),
    "cow": Model("cow", "cow_2904"),
    "hand": Model("hand", "hand_10345"),
    "horse": Model("horse", "horse_19851", (0.9, 0.2, -0.5)),
    "max planck": Model("Max Planck", "maxplanck_15000", (0.75, 0.1, -0.75)),
    "octopus": Model("octopus", "octopus_16554", (0.0, 0.8, 0.6), (0.0, 1.0, 0.0)),
}


@dataclass(frozen=True, eq=False)
class Subject:
    """A model whose mesh is there."""

    model: Model
    file: MeshFile

    def view(self) -> View:
        return view_of_surface(self.file.mesh.vertices, self.model.direction, self.model.up)


class Cast:
    """The subjects of all figures: the models of a folder, or one mesh in the place of all."""

    def __init__(self, folder: Path | None, stand_in: Path | None):
        self._folder = folder
        self._subjects: dict[str, Subject] = {}
        if stand_in is not None:
            subject = Subject(Model(stand_in.stem, stand_in.stem), MeshFile(stand_in, *read_counts(stand_in)))
            self._subjects = {name: subject for name in MODELS}

    def missing(self, names: list[str]) -> list[str]:
        """The files of these models that are not there."""
        absent = [MODELS[name].file for name in names if name not in self._subjects and self._path(name) is None]
        return list(dict.fromkeys(absent))

    def subject(self, name: str) -> Subject:
        if name not in self._subjects:
            path = self._path(name)
            self._subjects[name] = Subject(MODELS[name], MeshFile(path, *read_counts(path)))
        return self._subjects[name]

    def _path(self, name: str) -> Path | None:
        paths = (self._folder / (MODELS[name].file + ending) for ending in FORMATS)
        return next((path for path in paths if path.is_file()), None)
