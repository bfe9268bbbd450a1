"""Which of the paper's models are in a folder, and what stands for those that are not."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from measuring.mesh_files import MeshFile, find_mesh_files
from measuring.meshes import Mesh, MeshError, why_not_a_sphere, write_off

AS_FOUND, SAME_COUNT = "as found", "same count"


@dataclass(frozen=True)
class Model:
    """A shape of the paper, and the names that files of it have: the first that a folder has is taken.

    `same_count` is a copy with as many vertices as the paper's. It is the fairer one for seconds. Where it was made by
    simplification, it has slivers that the paper's mesh need not have; the copy as found is the fairer one for maxima.
    """

    name: str
    title: str
    as_found: tuple[str, ...]
    same_count: tuple[str, ...] = ()


TABLE_1 = (
    Model("fandisk", "Fandisk", ("fandisk_6475", "fandisk"), ("fandisk_606",)),
    Model("skull", "Skull", ("skull",), ("skull_wrap_20002",)),
    Model("maxplanck", "Max Planck", ("maxplanck", "max_planck"), ("maxplanck_15000",)),
    Model("santa", "Santa", ("santa_10241", "santa"), ("santa_20000",)),
    Model("buddha", "Buddha", ("buddha_24992", "buddha"), ("buddha_44973",)),
    Model("bunny", "Bunny", ("bunny_3485", "bunny", "bunny00"), ("bunny_20002",)),
    Model("hand", "Hand", ("hand_10345", "hand"), ("hand_42068",)),
    Model("cow", "Cow", ("cow_2904", "cow"), ("cow_23023",)),
)
SIMPLE, COMPLEX = ("fandisk", "skull", "maxplanck", "santa"), ("buddha", "bunny", "hand", "cow")  # figures 8 and 9

# Beyond Table 1, in the order in which they are taken where the paper's own model is missing.
OTHERS = (
    Model("spot", "Spot", ("spot_2930", "spot")),
    Model("horse", "Horse", ("horse_19851", "horse")),
    Model("armadillo", "Armadillo", ("armadillo_26002", "armadillo")),
    Model("bull", "Bull", ("bull_6200", "bull")),
    Model("blub", "Blub", ("blub_7106", "blub")),
    Model("brain", "Brain", ("brain_fsaverage5_lh_pial",)),
    Model("spool", "Spool", ("spool_649", "spool")),
    Model("bimba", "Bimba", ("bimba_filled", "bimba"), ("bimba_45k",)),
    Model("vaselion", "Vase-Lion", ("vaselion_369650",)),
    Model("buste", "Buste", ("buste_522114",)),
)
MODELS = {model.name: model for model in TABLE_1 + OTHERS}

LEAST_VERTICES = 100  # of a mesh that stands for one of the paper


class Library:
    """The meshes of some folders, by the names of the paper's models."""

    def __init__(self, folders: list[Path], most_vertices: int | None, folder_for_derived: Path):
        self._most_vertices = most_vertices
        self._folder_for_derived = folder_for_derived
        self._files: dict[str, MeshFile] = {}
        self.notes: list[str] = []  # what a reader has to know about the choice of meshes
        for folder in folders:
            for file in find_mesh_files(folder, most_vertices):
                self._files.setdefault(file.name, file)

    @property
    def files(self) -> list[MeshFile]:
        """All meshes that may be used, small ones first."""
        return sorted(self._files.values(), key=lambda file: (file.number_of_vertices, file.name))

    @property
    def most_vertices(self) -> int | None:
        return self._most_vertices

    def copy(self, name: str, kind: str) -> MeshFile | None:
        model = MODELS[name]
        stems = model.as_found if kind == AS_FOUND else model.same_count
        for stem in stems:
            if stem in self._files:
                return self._files[stem]
        return self._like(model) if kind == AS_FOUND else None

    def copies(self, name: str) -> dict[str, MeshFile]:
        both = {kind: self.copy(name, kind) for kind in (AS_FOUND, SAME_COUNT)}
        found = {kind: file for kind, file in both.items() if file is not None}
        if len(found) == 2 and found[AS_FOUND] is found[SAME_COUNT]:
            del found[AS_FOUND]
        return found

    def best(self, name: str) -> MeshFile | None:
        """The copy of a model that is taken where one is enough."""
        return next(iter(self.copies(name).values()), None)

    def stand_ins(self, number: int, without: list[MeshFile]) -> list[MeshFile]:
        """Meshes for models that are missing: known ones first, then any closed one of genus 0, large ones first."""
        names = [model.name for model in (*reversed(TABLE_1), *OTHERS)]  # the more difficult ones first
        known = [file for file in map(self.best, names) if file is not None]
        others = [file for file in reversed(self.files) if file.number_of_vertices >= LEAST_VERTICES]
        chosen: list[MeshFile] = []
        for file in known + others:
            if len(chosen) == number:
                break
            if file not in chosen and file not in without and not self._objection(file):
                chosen.append(file)
        return chosen

    def one(self, name: str, figure: str, without: tuple[MeshFile, ...] = ()) -> MeshFile | None:
        """The mesh for a model, or another one, of which a note tells."""
        file = self.best(name)
        if file is not None and file not in without:
            return file
        others = self.stand_ins(1, list(without))
        if others:
            self.notes.append(
                f"{figure}: {MODELS[name].title} is not among the meshes; {others[0].name} stands for it."
            )
            return others[0]
        self.notes.append(f"{figure}: {MODELS[name].title} is not among the meshes, and nothing can stand for it.")
        return None

    def derive(self, name: str, origin: str, mesh: Mesh) -> MeshFile:
        """Stores a mesh that the driver made."""
        self._folder_for_derived.mkdir(parents=True, exist_ok=True)
        path = self._folder_for_derived / f"{name}.off"
        write_off(path, mesh)
        return MeshFile(path, len(mesh.vertices), len(mesh.faces), origin)

    def forget_meshes(self) -> None:
        for file in self._files.values():
            file.forget()

    def _like(self, model: Model) -> MeshFile | None:
        """A file with the model's name and a number, if none has a name that is known."""
        pattern = re.compile(rf"{re.escape(model.name)}[-_ ]?\d+", re.IGNORECASE)
        for file in self.files:
            is_alike = pattern.fullmatch(file.name) and file.name not in model.same_count
            if is_alike and file.number_of_vertices >= LEAST_VERTICES and not self._objection(file):
                return file
        return None

    def _objection(self, file: MeshFile) -> str:
        try:
            return why_not_a_sphere(file.mesh)
        except MeshError as error:
            return str(error)
        finally:
            file.forget()
