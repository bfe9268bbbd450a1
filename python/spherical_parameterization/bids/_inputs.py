"""Finds the surfaces of subjects, and atlases, in the folders of FreeSurfer, smriprep, fMRIPrep and TemplateFlow."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Sequence

SURFACES = ("white", "pial", "midthickness")


class Failure(Exception):
    """An error in a subject, an atlas or an output, with a message for the user."""


@dataclass
class Hemisphere:
    """The files of a hemisphere. A hemisphere without a white surface is an error."""

    name: str  # L or R
    surfaces: Dict[str, Path] = field(default_factory=dict)
    metrics: Dict[str, Path] = field(default_factory=dict)
    cortex: Optional[Path] = None

    def files(self) -> Dict[str, Path]:
        """Returns all files by their kind."""
        return {**self.surfaces, **self.metrics, **({"cortex": self.cortex} if self.cortex else {})}


@dataclass
class Subject:
    """A session of a subject, or a subject without sessions."""

    label: str
    session: Optional[str]
    folder: Path
    hemispheres: Dict[str, Hemisphere]
    defects: List[str] = field(default_factory=list)  # reported as failures

    @property
    def stem(self) -> str:
        """The prefix of its file names."""
        return f"sub-{self.label}" + (f"_ses-{self.session}" if self.session else "")

    @property
    def anat(self) -> Path:
        """The folder of its files, relative to the dataset."""
        return Path(f"sub-{self.label}", *([f"ses-{self.session}"] if self.session else []), "anat")


@dataclass
class Atlas:
    """A sphere with sulcal depth, for each hemisphere."""

    name: str
    spheres: Dict[str, Path]
    depths: Dict[str, Path]


def _names(folder: Path) -> List[str]:
    """The names in a folder; none if the folder does not exist or cannot be read, as for a subject without files."""
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
                continue  # a broken link
            if kind in SURFACES or kind == "graymid":
                hemisphere.surfaces[kind if kind in SURFACES else "midthickness"] = path
            elif kind in ("sulc", "curv", "thickness", "area", "volume") or kind.endswith((".mgh", ".mgz")):
                hemisphere.metrics[kind.rsplit(".mg", 1)[0]] = path
        cortex = folder / "label" / f"{of_hemi}cortex.label"
        hemisphere.cortex = cortex if os.path.isfile(cortex) else None
    return Subject(label, session or None, folder, hemispheres)


def _of_derivatives(folder: Path, session: Optional[str]) -> Subject:
    anat = folder / (f"ses-{session}" if session else "") / "anat"
    hemispheres = {hemi: Hemisphere(hemi) for hemi in "LR"}
    subject = Subject(folder.name[4:], session, folder, hemispheres)
    # Other entities denote other spaces and versions.
    pattern = re.compile(
        r"sub-[^_]+(?:_(?:ses|acq|rec|run)-[^_]+)*_hemi-([LR])(_desc-cortex)?_([A-Za-z]+)\.(surf|shape|label)\.gii"
    )
    for name in _names(anat):
        match = pattern.fullmatch(name)
        if not match or not os.path.isfile(anat / name):
            continue
        hemi, cortex, kind, form = match.groups()
        hemisphere = hemispheres[hemi]
        into = hemisphere.surfaces if form == "surf" and kind in SURFACES else hemisphere.metrics if form == "shape" else {}
        if cortex:
            hemisphere.cortex = anat / name if kind == "mask" else hemisphere.cortex
            continue
        if kind in into:
            subject.defects.append(f"{anat} has several files of the same kind: {into[kind].name} and {name}")
        into[kind] = anat / name
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
            # fMRIPrep writes session folders without surfaces next to the surfaces of the subject.
            with_surfaces = [subject for subject in (own, *sessions) if _has_white(subject)]
            yield from with_surfaces or [subject for subject in sessions if (path / f"ses-{subject.session}/anat").is_dir()] or [own]


def _below(folder: Path) -> List[Subject]:
    """The subjects of a folder, or of the only folder below `derivatives` or `sourcedata` that has surfaces."""
    found = list(_subjects_in(folder))
    if any(map(_has_white, found)):
        return found
    inner = [folder / part / name for part in ("derivatives", "sourcedata") for name in _names(folder / part)]
    having = {path: subjects for path in inner for subjects in [list(_subjects_in(path))] if any(map(_has_white, subjects))}
    if len(having) > 1:
        raise Failure(f"{folder} has several folders with surfaces: give one of {', '.join(map(str, having))}")
    return next(iter(having.values()), found)


def find_subjects(
    folder: Path, labels: Optional[Sequence[str]], sessions: Optional[Sequence[str]], atlases: Sequence[Path]
) -> List[Subject]:
    """Finds the subjects of a subjects directory of FreeSurfer, of derivatives, or of a dataset that contains either.

    `labels` and `sessions` select subjects, with or without ``sub-`` and ``ses-``, or by folder. The folder of an atlas is not a
    subject.
    """
    if not folder.is_dir():
        raise Failure(f"{folder} is not a folder")
    folders_of_atlases = {os.path.realpath(path) for path in atlases}
    found = [subject for subject in _below(folder) if os.path.realpath(subject.folder) not in folders_of_atlases]
    if not found:
        raise Failure(f"{folder} has no subjects: neither folders of FreeSurfer nor sub-* with surfaces")
    if labels is not None:
        names = {label: label[4:] if label.startswith("sub-") else label for label in labels}
        unknown = []
        selected = []
        for label, name in names.items():
            of_label = [s for s in found if label == s.folder.name or name in (s.label, s.folder.name, s.stem[4:])]
            unknown += [] if of_label else [label]
            selected += [subject for subject in of_label if subject not in selected]
        if unknown:
            known = ", ".join(sorted({subject.label for subject in found})[:20])
            raise Failure(f"{folder} has no subject {' or '.join(map(repr, unknown))}; it has {known}")
        found = selected
    if sessions is not None:
        names_of_sessions = [session[4:] if session.startswith("ses-") else session for session in sessions]
        found = [subject for subject in found if subject.session in names_of_sessions]
        if not found:
            raise Failure(f"{folder} has no subject with the session {' or '.join(sessions)}")
    for subject in found:
        if any(not re.fullmatch("[0-9A-Za-z]+", part) for part in (subject.label, subject.session or "0")):
            raise Failure(f"{subject.folder}: in BIDS, labels of subjects and sessions consist of letters and digits")
        if sum(other.stem == subject.stem for other in found) > 1:
            raise Failure(f"{folder} has several subjects with the name {subject.stem}")
    return found


def _density(name: str) -> Optional[str]:
    match = re.search(r"(?:^|[._-])(\d+k)(?:[._-]|$)", name)
    return match.group(1) if match else None


def _is_file(path: Path) -> bool:
    return os.path.isfile(path) and os.path.getsize(path) > 0  # DataLad and TemplateFlow have empty files before a download


def find_atlas(name: str, density: Optional[str], folder: Path, hemispheres: Sequence[str]) -> Atlas:
    """Finds the spheres and sulcal depths of an atlas in a folder, by the file names of FreeSurfer, TemplateFlow or the HCP."""
    if not re.fullmatch(r"[A-Za-z0-9]+", name):
        raise Failure(f"the atlas name '{name}' must consist of letters and digits, as fsaverage and fsLR")
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
            candidates = [n for n in names if re.search(r"(sphere|spherical_std).*\.surf\.gii(\.gz)?$", n)]
            # The metrics of TemplateFlow belong to its sphere desc-std.
            candidates = [n for n in candidates if "desc-std" in n] or candidates
            pairs = [
                (sphere, depth)
                for sphere in candidates
                for depth in names
                if re.search(r"sulc.*\.(shape|func)\.gii(\.gz)?$", depth) and _density(sphere) == _density(depth)
            ]
            if not pairs:
                raise Failure(
                    f"{folder} is not an atlas: it has no sphere and sulcal depth of hemisphere {hemi}"
                    + (f" and density {density}" if density else "")
                    + f", such as surf/{h}.sphere and surf/{h}.sulc, or tpl-{name}_hemi-{hemi}_den-32k_sphere.surf.gii and"
                    " ..._sulc.shape.gii, as non-empty files"
                )
            if len(pairs) > 1:
                raise Failure(
                    f"{folder} has several spheres and sulcal depths of hemisphere {hemi}: give a density, as in"
                    f" {name}:{_density(pairs[0][0]) or '32k'}={folder}; {', '.join(sorted({part for pair in pairs for part in pair}))}"
                )
            atlas.spheres[hemi], atlas.depths[hemi] = (folder / part for part in pairs[0])
    return atlas
