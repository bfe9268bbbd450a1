"""Which of the paper's models are in a folder, and what stands for those that are not."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from measuring.meshes import Mesh, MeshFile, find_mesh_files, write_mesh

AS_FOUND, SAME_COUNT = "as found", "same count"
MIN_VERTICES = 100  # of a mesh that stands for one of the paper


@dataclass(frozen=True)
class Model:
    """A shape of the paper, and the names of its files.

    `same_count` is a copy with as many vertices as the paper's. It is the fairer one for seconds. Where it was made by
    simplification, it has slivers that the paper's mesh need not have; the copy as found is the fairer one for maxima.
    """

    title: str
    as_found: str
    same_count: str = ""


TABLE_1 = {
    "fandisk": Model("Fandisk", "fandisk_6475", "fandisk_606"),
    "skull": Model("Skull", "skull", "skull_wrap_20002"),
    "maxplanck": Model("Max Planck", "max_planck", "maxplanck_15000"),
    "santa": Model("Santa", "santa_10241", "santa_20000"),
    "buddha": Model("Buddha", "buddha_24992", "buddha_44973"),
    "bunny": Model("Bunny", "bunny_3485", "bunny_20002"),
    "hand": Model("Hand", "hand_10345", "hand_42068"),
    "cow": Model("Cow", "cow_2904", "cow_23023"),
}
MODELS = TABLE_1 | {
    "spot": Model("Spot", "spot_2930"),
    "horse": Model("Horse", "horse_19851"),
    "armadillo": Model("Armadillo", "armadillo_26002"),
    "blub": Model("Blub", "blub_7106"),
    "brain": Model("Brain", "brain_fsaverage5_lh_pial"),
    "bimba": Model("Bimba", "bimba_filled", "bimba_45k"),
    "vaselion": Model("Vase-Lion", "vaselion_369650"),
    "buste": Model("Buste", "buste_522114"),
}


class Library:
    """The meshes of a folder, by the names of the paper's models."""

    def __init__(self, folders: list[Path], max_vertices: float, folder_for_derived: Path):
        found = find_mesh_files(folders, max_vertices)
        self._files = {file.name: file for file in reversed(found)}
        self._folder_for_derived = folder_for_derived
        self.notes: list[str] = []  # what a reader has to know about the choice of meshes

    @property
    def files(self) -> list[MeshFile]:
        """All meshes, small ones first."""
        return sorted(self._files.values(), key=lambda file: (file.number_of_vertices, file.name))

    def copies(self, name: str) -> dict[str, MeshFile]:
        """A model as it was found, and with as many vertices as the paper's mesh, as far as they are there."""
        model = MODELS[name]
        same_count = self._files.get(model.same_count)
        as_found = self._files.get(model.as_found) or self._files.get(name) or self._like(name, model.same_count)
        both = {AS_FOUND: as_found, SAME_COUNT: same_count}
        return {kind: file for kind, file in both.items() if file is not None}

    def best(self, name: str) -> MeshFile | None:
        """The copy of a model that is taken where one is enough."""
        return next(iter(self.copies(name).values()), None)

    def stand_ins(self, number: int) -> list[MeshFile]:
        """Meshes for models that are missing: any closed one of genus 0, large ones first."""
        chosen: list[MeshFile] = []
        for file in reversed(self.files):
            if len(chosen) == number or file.number_of_vertices < MIN_VERTICES:
                break
            if not file.objection():
                chosen.append(file)
        return chosen

    def some(self, names: tuple[str, ...], figure: str) -> list[MeshFile]:
        """The meshes of some models; if there is none, another mesh. A note lists the missing ones."""
        files = [file for file in map(self.best, names) if file is not None]
        missing = [MODELS[name].title for name in names if self.best(name) is None]
        others = [] if files else self.stand_ins(1)
        if missing:
            instead = f"; in their place: {', '.join(file.name for file in others) or 'nothing'}" if not files else ""
            self.notes.append(f"{figure}: not among the meshes: {', '.join(missing)}{instead}.")
        return files + others

    def derive(self, name: str, origin: str, mesh: Mesh) -> MeshFile:
        """Stores a mesh that the driver made."""
        self._folder_for_derived.mkdir(parents=True, exist_ok=True)
        path = self._folder_for_derived / f"{name}.off"
        write_mesh(path, mesh)
        return MeshFile(path, origin)

    def _like(self, name: str, same_count: str) -> MeshFile | None:
        """A file with the model's name and a number, if none has a name that is known."""
        alike = (file for file in self.files if re.fullmatch(rf"{name}[-_ ]?\d+", file.name, re.IGNORECASE))
        return next((file for file in alike if file.name != same_count), None)
