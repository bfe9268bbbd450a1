"""Finds the surfaces of subjects, and atlases, in the folders of FreeSurfer, smriprep, fMRIPrep and TemplateFlow."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Sequence

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

    def files(self) -> Dict[str, Path]:
        """All of them by what they are."""
        return {**self.surfaces, **self.metrics, **({"cortex": self.cortex} if self.cortex else {})}


@dataclass
class Subject:
    """A session of a subject, or a subject without sessions."""

    label: str
    session: Optional[str]
    folder: Path
    hemispheres: Dict[str, Hemisphere]
    faults: List[str] = field(default_factory=list)  # that keep it from being mapped

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
    """The names of what is in a folder; none if it is not there or cannot be read, as of a subject without files."""
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def _is_freesurfer(folder: Path) -> bool:
    return not {"surf", "mri"}.isdisjoint(_names(folder))


def _of_freesurfer(folder: Path) -> Subject:
    name = folder.name
    label, _, session = (name[4:] if name.startswith("sub-") else name).partition("_ses-")
    label, session = (re.sub(r"[^A-Za-z0-9]", "", part) for part in (label, session))
    hemispheres = {}
    for hemi in "LR":
        of_hemi = f"{hemi.lower()}h."
        hemisphere = hemispheres[hemi] = Hemisphere(hemi)
        for found in _names(folder / "surf"):
            if not found.startswith(of_hemi):
                continue
            kind, path = found[len(of_hemi) :], folder / "surf" / found
            if not os.path.isfile(path):
                continue  # a link that leads nowhere
            if kind in SURFACES or kind == "graymid":
                hemisphere.surfaces[kind if kind in SURFACES else "midthickness"] = path
            elif kind in ("sulc", "curv", "thickness", "area", "volume") or kind.endswith((".mgh", ".mgz")):
                hemisphere.metrics[kind.rsplit(".mg", 1)[0]] = path
        cortex = folder / "label" / f"{of_hemi}cortex.label"
        hemisphere.cortex = cortex if os.path.isfile(cortex) else None
    return Subject(label, session or None, folder, hemispheres)


def _of_derivatives(folder: Path, session: Optional[str]) -> Subject:
    place = folder / (f"ses-{session}" if session else "") / "anat"
    hemispheres = {hemi: Hemisphere(hemi) for hemi in "LR"}
    subject = Subject(folder.name[4:], session, folder, hemispheres)
    # Entities other than these are of other spaces and versions.
    pattern = re.compile(
        r"sub-[^_]+(?:_(?:ses|acq|rec|run)-[^_]+)*_hemi-([LR])(_desc-cortex)?_([A-Za-z]+)\.(surf|shape|label)\.gii"
    )
    for name in _names(place):
        match = pattern.fullmatch(name)
        if not match or not os.path.isfile(place / name):
            continue
        hemi, cortex, kind, form = match.groups()
        hemisphere = hemispheres[hemi]
        into = hemisphere.surfaces if form == "surf" and kind in SURFACES else hemisphere.metrics if form == "shape" else {}
        if cortex:
            hemisphere.cortex = place / name if kind == "mask" else hemisphere.cortex
            continue
        if kind in into:
            subject.faults.append(f"{place} has several files of a kind: {into[kind].name} and {name}")
        into[kind] = place / name
    return subject


def _has_white(subject: Subject) -> bool:
    return any("white" in hemisphere.surfaces for hemisphere in subject.hemispheres.values())


def _subjects_in(folder: Path) -> Iterator[Subject]:
    for name in _names(folder):
        path = folder / name
        if name.startswith(".") or not os.path.isdir(path):
            continue
        if _is_freesurfer(path):
            if not name.startswith("fsaverage"):
                yield _of_freesurfer(path)
        elif name.startswith("sub-"):
            own = _of_derivatives(path, None)
            sessions = [_of_derivatives(path, inner[4:]) for inner in _names(path) if inner.startswith("ses-")]
            # fMRIPrep has folders of sessions without surfaces beside the surfaces of the subject.
            with_surfaces = [subject for subject in (own, *sessions) if _has_white(subject)]
            yield from with_surfaces or [subject for subject in sessions if (path / f"ses-{subject.session}/anat").is_dir()] or [own]


def _below(folder: Path) -> List[Subject]:
    """The subjects of a folder, or of the one below `derivatives` or `sourcedata` that has surfaces."""
    found = list(_subjects_in(folder))
    if any(map(_has_white, found)):
        return found
    inner = [folder / part / name for part in ("derivatives", "sourcedata") for name in _names(folder / part)]
    having = {path: subjects for path in inner for subjects in [list(_subjects_in(path))] if any(map(_has_white, subjects))}
    if len(having) > 1:
        raise Failure(f"{folder} has several folders with surfaces: name one of {', '.join(map(str, having))}")
    return next(iter(having.values()), found)


def find_subjects(
    folder: Path, labels: Optional[Sequence[str]], sessions: Optional[Sequence[str]], atlases: Sequence[Path]
) -> List[Subject]:
    """Finds the subjects of a subjects folder of FreeSurfer, of derivatives, or of a dataset that has either below it.

    `labels` and `sessions` name those that are wanted, with or without ``sub-`` and ``ses-``, or by their folders. A folder that is
    an atlas is no subject.
    """
    if not folder.is_dir():
        raise Failure(f"{folder} is no folder")
    folders_of_atlases = {os.path.realpath(path) for path in atlases}
    found = [subject for subject in _below(folder) if os.path.realpath(subject.folder) not in folders_of_atlases]
    if not found:
        raise Failure(f"{folder} has no subjects: neither folders of FreeSurfer nor sub-* with surfaces")
    if labels is not None:
        names = {label: label[4:] if label.startswith("sub-") else label for label in labels}
        unknown = []
        wanted = []
        for label, name in names.items():
            of_label = [s for s in found if label == s.folder.name or name in (s.label, s.folder.name, s.stem[4:])]
            unknown += [] if of_label else [label]
            wanted += [subject for subject in of_label if subject not in wanted]
        if unknown:
            known = ", ".join(sorted({subject.label for subject in found})[:20])
            raise Failure(f"{folder} has no subject {' or '.join(map(repr, unknown))}; there are {known}")
        found = wanted
    if sessions is not None:
        names_of_sessions = [session[4:] if session.startswith("ses-") else session for session in sessions]
        found = [subject for subject in found if subject.session in names_of_sessions]
        if not found:
            raise Failure(f"{folder} has no subject with the session {' or '.join(sessions)}")
    for subject in found:
        if any(not re.fullmatch("[0-9A-Za-z]+", part) for part in (subject.label, subject.session or "0")):
            raise Failure(f"{subject.folder}: labels of subjects and sessions are of letters and digits in BIDS")
        if sum(other.stem == subject.stem for other in found) > 1:
            raise Failure(f"{folder} has several subjects that would be called {subject.stem}")
    return found


def _density(name: str) -> Optional[str]:
    match = re.search(r"(?:^|[._-])(\d+k)(?:[._-]|$)", name)
    return match.group(1) if match else None


def _is_file(path: Path) -> bool:
    return os.path.isfile(path) and os.path.getsize(path) > 0  # DataLad and TemplateFlow have empty ones until they are fetched


def find_atlas(name: str, density: Optional[str], folder: Path, hemispheres: Sequence[str]) -> Atlas:
    """Finds the spheres and the depths of an atlas in a folder, as FreeSurfer, TemplateFlow or the HCP name them."""
    if not re.fullmatch(r"[A-Za-z0-9]+", name):
        raise Failure(f"the atlas name '{name}' has to be of letters and digits, such as fsaverage or fsLR")
    atlas = Atlas(name, {}, {})
    for hemi in hemispheres:
        h = hemi.lower() + "h"
        for inner in (folder / "surf", folder):
            spheres = [inner / f"{h}.{kind}" for kind in ("sphere.reg", "sphere") if _is_file(inner / f"{h}.{kind}")]
            if spheres and _is_file(inner / f"{h}.sulc"):
                atlas.spheres[hemi], atlas.depths[hemi] = spheres[0], inner / f"{h}.sulc"
                break
        else:
            of_hemi = re.compile(rf"(^|[._-])(hemi-{hemi}|{hemi}|{hemi}_LR|{h})(?=[._-])")
            names = [n for n in _names(folder) if of_hemi.search(n) and "_space-" not in n and _is_file(folder / n)]
            if density:
                names = [found for found in names if _density(found) == density]
            spheres_there = [n for n in names if re.search(r"(sphere|spherical_std).*\.surf\.gii(\.gz)?$", n)]
            # TemplateFlow's desc-std is what its metrics belong to.
            spheres_there = [n for n in spheres_there if "desc-std" in n] or spheres_there
            pairs = [
                (sphere, depth)
                for sphere in spheres_there
                for depth in names
                if re.search(r"sulc.*\.(shape|func)\.gii(\.gz)?$", depth) and _density(sphere) == _density(depth)
            ]
            if not pairs:
                raise Failure(
                    f"{folder} is no atlas: it has no sphere and sulcal depth of hemisphere {hemi}"
                    + (f" and density {density}" if density else "")
                    + f", such as surf/{h}.sphere and surf/{h}.sulc, or tpl-{name}_hemi-{hemi}_den-32k_sphere.surf.gii and"
                    " ..._sulc.shape.gii, that are no empty files"
                )
            if len(pairs) > 1:
                raise Failure(
                    f"{folder} has several spheres and depths of hemisphere {hemi}: name a density, as in"
                    f" {name}:{_density(pairs[0][0]) or '32k'}={folder}; {', '.join(sorted({part for pair in pairs for part in pair}))}"
                )
            atlas.spheres[hemi], atlas.depths[hemi] = (folder / part for part in pairs[0])
    return atlas
