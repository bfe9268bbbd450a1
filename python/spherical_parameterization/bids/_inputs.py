"""Finds the surfaces of subjects, and atlases, in the folders of FreeSurfer, smriprep, fMRIPrep and TemplateFlow."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Sequence, Set

SURFACES = ("white", "pial", "midthickness")


class Failure(Exception):
    """What is wrong with a subject or an atlas, for its user to read."""


@dataclass
class Hemisphere:
    """The files of a hemisphere. Without a white surface, there is nothing to work on."""

    name: str  # L or R
    surfaces: Dict[str, Path] = field(default_factory=dict)
    metrics: Dict[str, Path] = field(default_factory=dict)
    cortex: Optional[Path] = None

    def files(self) -> List[Path]:
        return [*self.surfaces.values(), *self.metrics.values(), *([self.cortex] if self.cortex else [])]


@dataclass
class Subject:
    """A session of a subject, or a subject without sessions."""

    label: str
    session: Optional[str]
    folder: Path
    hemispheres: Dict[str, Hemisphere]

    @property
    def stem(self) -> str:
        """What the names of its files begin with."""
        return f"sub-{self.label}" + (f"_ses-{self.session}" if self.session else "")

    @property
    def place(self) -> Path:
        """The folder of its files, below that of a dataset."""
        return Path(f"sub-{self.label}", *([f"ses-{self.session}"] if self.session else []), "anat")


@dataclass
class Atlas:
    """A sphere with the depth of its folds, for each hemisphere."""

    name: str
    spheres: Dict[str, Path]
    depths: Dict[str, Path]


def _names(folder: Path) -> List[str]:
    try:
        return sorted(path.name for path in folder.iterdir())
    except OSError:  # no folder, or one that cannot be read: a subject without files
        return []


def _is_freesurfer(folder: Path) -> bool:
    return any((folder / part).is_dir() for part in ("surf", "mri"))


def _of_freesurfer(folder: Path) -> Subject:
    name = folder.name
    parts = re.fullmatch(r"(?:sub-)?(.+?)(?:_ses-(.+))?", name)
    assert parts
    label, session = (re.sub(r"[^A-Za-z0-9]", "", part) if part else None for part in parts.groups())
    hemispheres = {}
    for hemi in "LR":
        of_hemi = f"{hemi.lower()}h."
        hemisphere = hemispheres[hemi] = Hemisphere(hemi)
        for found in _names(folder / "surf"):
            if not found.startswith(of_hemi):
                continue
            kind, path = found[len(of_hemi) :], folder / "surf" / found
            if kind in SURFACES or kind == "graymid":
                hemisphere.surfaces[kind if kind in SURFACES else "midthickness"] = path
            elif kind in ("sulc", "curv", "thickness", "area", "volume") or kind.endswith((".mgh", ".mgz")):
                hemisphere.metrics[kind.rsplit(".mg", 1)[0]] = path
        cortex = folder / "label" / f"{of_hemi}cortex.label"
        hemisphere.cortex = cortex if cortex.is_file() else None
    return Subject(label or "", session, folder, hemispheres)


def _of_derivatives(folder: Path, session: Optional[str]) -> Subject:
    place = folder / (f"ses-{session}" if session else "") / "anat"
    hemispheres = {hemi: Hemisphere(hemi) for hemi in "LR"}
    # Entities other than these are of other spaces and versions.
    pattern = re.compile(
        r"sub-[^_]+(?:_(?:ses|acq|rec|run)-[^_]+)*_hemi-([LR])(_desc-cortex)?_([A-Za-z]+)\.(surf|shape|label)\.gii"
    )
    for name in _names(place):
        match = pattern.fullmatch(name)
        if not match:
            continue
        hemi, cortex, kind, form = match.groups()
        hemisphere = hemispheres[hemi]
        into = hemisphere.surfaces if form == "surf" and kind in SURFACES else hemisphere.metrics if form == "shape" else {}
        if cortex:
            hemisphere.cortex = place / name if kind == "mask" else hemisphere.cortex
            continue
        if kind in into:
            raise Failure(f"{place} has several surfaces of a kind: {into[kind].name} and {name}")
        into[kind] = place / name
    return Subject(folder.name[4:], session, folder, hemispheres)


def _has_white(subject: Subject) -> bool:
    return any("white" in hemisphere.surfaces for hemisphere in subject.hemispheres.values())


def _subjects_in(folder: Path) -> Iterator[Subject]:
    for name in _names(folder):
        path = folder / name
        if not path.is_dir() or name.startswith("."):
            continue
        if _is_freesurfer(path):
            if not name.startswith("fsaverage"):
                yield _of_freesurfer(path)
        elif name.startswith("sub-"):
            sessions = [inner[4:] for inner in _names(path) if inner.startswith("ses-") and (path / inner).is_dir()]
            for session in [None] if not sessions or (path / "anat").is_dir() else []:
                yield _of_derivatives(path, session)
            for session in sessions:
                yield _of_derivatives(path, session)


def find_subjects(folder: Path, labels: Optional[Sequence[str]]) -> List[Subject]:
    """Finds the subjects of a subjects folder of FreeSurfer, of derivatives, or of a dataset that has either below it.

    Those named by `labels`, with or without ``sub-``, come first of all as they are named; one that is not there is among them
    without files.
    """
    if not folder.is_dir():
        raise Failure(f"{folder} is no folder")
    found = list(_subjects_in(folder))
    if not any(map(_has_white, found)):
        # A dataset of images: its derivatives have the surfaces.
        inner = [path for part in ("derivatives", "sourcedata") if (folder / part).is_dir() for path in sorted((folder / part).iterdir())]
        having = {path: subjects for path in inner if any(map(_has_white, subjects := list(_subjects_in(path))))}
        if len(having) > 1:
            raise Failure(f"{folder} has several folders with surfaces: name one of {', '.join(map(str, having))}")
        found = next(iter(having.values()), found)
    seen: Set[str] = set()
    for subject in found:
        if subject.stem in seen:
            raise Failure(f"{folder} has several subjects that would be called {subject.stem}")
        seen.add(subject.stem)
    if labels is None:
        if not found:
            raise Failure(f"{folder} has no subjects: neither folders of FreeSurfer nor sub-* with surfaces")
        return found
    result = []
    for label in dict.fromkeys(label[4:] if label.startswith("sub-") else label for label in labels):
        of_label = [subject for subject in found if label in (subject.label, subject.folder.name)]
        result += of_label or [Subject(label, None, folder / f"sub-{label}", {})]
    return result


def _density(name: str) -> Optional[str]:
    match = re.search(r"(?:^|[._-])(\d+k)(?:[._-]|$)", name)
    return match.group(1) if match else None


def find_atlas(name: str, folder: Path, hemispheres: Sequence[str]) -> Atlas:
    """Finds the spheres and the depths of an atlas in a folder, as FreeSurfer, TemplateFlow or the HCP name them."""
    if not re.fullmatch(r"[A-Za-z0-9]+", name):
        raise Failure(f"the atlas name '{name}' has to be of letters and digits, such as fsaverage or fsLR")
    atlas = Atlas(name, {}, {})
    for hemi in hemispheres:
        h = hemi.lower() + "h"
        for inner in (folder / "surf", folder):
            spheres = [inner / f"{h}.{kind}" for kind in ("sphere.reg", "sphere") if (inner / f"{h}.{kind}").is_file()]
            if spheres and (inner / f"{h}.sulc").is_file():
                atlas.spheres[hemi], atlas.depths[hemi] = spheres[0], inner / f"{h}.sulc"
                break
        else:
            of_hemi = re.compile(rf"(^|[._-])(hemi-{hemi}|{hemi}|{h})(?=[._-])")
            names = [found for found in _names(folder) if of_hemi.search(found) and "_space-" not in found]
            pairs = [
                (sphere, depth)
                for sphere in names
                for depth in names
                if re.search(r"sphere.*\.surf\.gii(\.gz)?$", sphere)
                and re.search(r"sulc.*\.(shape|func)\.gii(\.gz)?$", depth)
                and (_density(sphere) == _density(depth))
            ]
            if not pairs:
                raise Failure(
                    f"{folder} is no atlas: it has no sphere and sulcal depth of hemisphere {hemi}, such as surf/{h}.sphere and"
                    f" surf/{h}.sulc, or tpl-{name}_hemi-{hemi}_den-32k_sphere.surf.gii and ..._sulc.shape.gii"
                )
            if len(pairs) > 1:
                raise Failure(
                    f"{folder} has several spheres and depths of hemisphere {hemi}: put one of each into a folder;"
                    f" {', '.join(sorted({part for pair in pairs for part in pair}))}"
                )
            atlas.spheres[hemi], atlas.depths[hemi] = (folder / part for part in pairs[0])
    return atlas
