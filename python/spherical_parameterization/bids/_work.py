"""Makes the files of a subject."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence, Set, Tuple

from .._files import read_mesh
from ._inputs import Atlas, Failure, Hemisphere, Subject
from ._report import make_page, make_table


# Those at work
programs: Set[subprocess.Popen[bytes]] = set()


@dataclass
class Run:
    """What is the same for all subjects."""

    program: str
    version: str
    output: Path
    hemispheres: Sequence[str]
    atlases: Sequence[Atlas]
    metrics: Sequence[str]
    fslr_description: str
    threads: int
    densities: Dict[Path, str] = field(default_factory=dict)

    def call(self, *arguments: Any) -> None:
        """Runs the program; what it says of an error is a Failure."""
        command = [self.program, *map(str, arguments), "--quiet"]
        pipe = subprocess.PIPE
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=pipe)
        except OSError as error:
            raise Failure(f"{self.program} cannot be run: {error.strerror}") from error
        programs.add(process)
        said = process.communicate()[1].decode(errors="replace")
        programs.discard(process)
        if process.returncode:
            raise Failure(" ".join(said.split()) or f"{self.program} has ended with the status {process.returncode}")

    def density_of(self, sphere: Path) -> str:
        """How the names of files call the density of an atlas, such as 164k."""
        if sphere not in self.densities:
            self.densities[sphere] = f"{round(len(read_mesh(sphere)[0]) / 1000)}k"
        return self.densities[sphere]


@dataclass
class Made:
    """What has been made of a subject: files by their paths in the dataset, rows of the table, and what has failed."""

    files: Dict[str, Path] = field(default_factory=dict)
    rows: List[Dict[str, Any]] = field(default_factory=list)
    pages: Dict[str, str] = field(default_factory=dict)
    failures: List[str] = field(default_factory=list)


def stamp_of(path: Path) -> List[int]:
    status = path.stat()
    return [status.st_size, status.st_mtime_ns]


def digest_of(path: Path) -> str:
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()


def write_text(path: Path, text: str) -> None:
    """Writes a file that appears under its name when it is complete."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.parent / f".{path.name}.{os.getpid()}"
    try:
        temporary.write_text(text, encoding="utf-8")
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Keeps other processes from the same subject; the system gives the lock back, however this one ends."""
    path.parent.mkdir(parents=True, exist_ok=True)
    while True:
        with open(path, "w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError as error:
                raise Failure("another process works on it") from error
            try:
                if os.fstat(file.fileno()).st_ino != path.stat().st_ino:
                    continue  # the file of a process that has just ended
            except FileNotFoundError:
                continue
            try:
                yield
            finally:
                path.unlink(missing_ok=True)
            return


def provenance_of(subject: Subject, run: Run) -> Dict[str, Any]:
    """What the results depend on, and nothing else."""
    files = [file for hemi in run.hemispheres if hemi in subject.hemispheres for file in subject.hemispheres[hemi].files()]
    files += [part[hemi] for atlas in run.atlases for part in (atlas.spheres, atlas.depths) for hemi in run.hemispheres]
    return {
        "version": run.version,
        "hemispheres": list(run.hemispheres),
        "atlases": [atlas.name for atlas in run.atlases],
        "metrics": list(run.metrics),
        "fslr_description": run.fslr_description,
        "inputs": {str(file): stamp_of(file) for file in files},
    }


def _is_gifti(path: Path) -> bool:
    return path.name.endswith((".gii", ".gii.gz"))


def _register(
    run: Run, hemisphere: Hemisphere, sphere: Path, atlas: Atlas, output: Path, threads: int
) -> Dict[str, Any]:
    """Registers a sphere to an atlas, and returns the report.

    The depths are those that the subject has, if they are of the same kind of file as those of the atlas; otherwise the program
    measures them. FreeSurfer has a positive depth in furrows, smriprep and the HCP a negative one in GIFTI files, and other GIFTI
    files do not say. With the wrong sign, the depths agree too little for a certain map: then the others are tried.
    """
    depth_of_atlas = atlas.depths[hemisphere.name]
    features: List[Any] = ["height", "depth"] if _is_gifti(depth_of_atlas) else ["depth", "height"]
    own = hemisphere.metrics.get("sulc")
    if own is not None and _is_gifti(own) == _is_gifti(depth_of_atlas):
        features.insert(0, own)
    reports: List[Tuple[Dict[str, Any], Path]] = []
    for k, feature in enumerate(features):
        path = output.with_name(f"{k}_{output.name}")
        told = output.with_name(f"{k}_{output.name}.json")
        run.call(
            *("register", hemisphere.surfaces["white"], atlas.spheres[hemisphere.name]),
            *("--features", feature, depth_of_atlas, "--initial", sphere, "--iterations", 0),
            *("-o", path, "--json", told, "--threads", threads),
        )
        reports.append((json.loads(told.read_text(encoding="utf-8")), path))
        if not reports[-1][0]["match"]["is_uncertain"]:
            break
    report, path = max(reports, key=lambda pair: (not pair[0]["match"]["is_uncertain"], pair[0]["match"]["agreement"]))
    os.replace(path, output)
    return report


def _make_hemisphere(subject: Subject, hemisphere: Hemisphere, run: Run, folder: Path, threads: int) -> Made:
    hemi, made = hemisphere.name, Made()
    stem = f"{subject.stem}_hemi-{hemi}"
    white = hemisphere.surfaces["white"]

    def add(name: str) -> Path:
        made.files[str(subject.place / name)] = folder / name
        return folder / name

    def add_report(of: Path, report: Dict[str, Any]) -> None:
        for name in ("files", "crc32", "input_stamp"):  # of this folder, which is moved
            report.pop(name, None)
        add(of.name.replace(".surf.gii", ".json")).write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")

    try:
        sphere = add(f"{stem}_sphere.surf.gii")
        page = f"{stem}_desc-distortion_sphere.html"
        made.files[f"sub-{subject.label}/figures/{page}"] = folder / page
        told = folder / f"{stem}.json"
        run.call("map", white, "-o", sphere, "--json", told, "--page", folder / page, "--threads", threads)
        report = json.loads(told.read_text())
        add_report(sphere, report)
        made.pages[f"Hemisphere {hemi}"] = f"sub-{subject.label}/figures/{page}"
        distortion = report["distortion"]
        made.rows.append(
            {
                "hemisphere": hemi,
                "map": "sphere",
                "vertices": report["vertices"],
                "one_to_one": report["one_to_one"],
                "D_iso_average": distortion["D_iso"]["average"],
                "D_iso_maximum": distortion["D_iso"]["maximum"],
                "D_area_average": distortion["D_area"]["average"],
                "D_angle_average": distortion["D_angle"]["average"],
                "seconds": report["seconds"]["total"],
            }
        )
        for atlas in run.atlases:
            description = run.fslr_description if atlas.name == "fsLR" else "reg"
            registered = add(f"{stem}_space-{atlas.name}_desc-{description}_sphere.surf.gii")
            report = _register(run, hemisphere, sphere, atlas, registered, threads)
            add_report(registered, report)
            match = report["match"]
            made.rows.append(
                {
                    "hemisphere": hemi,
                    "map": atlas.name,
                    "vertices": report["vertices"],
                    "one_to_one": report["one_to_one"],
                    "D_iso_average": match["D_iso"]["average"],
                    "D_iso_maximum": match["D_iso"]["maximum"],
                    "agreement": match["agreement"],
                    "certain": not match["is_uncertain"],
                    "seconds": report["seconds"]["total"],
                }
            )
            place = f"{stem}_space-{atlas.name}_den-{run.density_of(atlas.spheres[hemi])}"
            spheres = (registered, atlas.spheres[hemi])
            for kind, surface in hemisphere.surfaces.items():
                run.call("resample", surface, *spheres, "-o", add(f"{place}_{kind}.surf.gii"), "--threads", threads)
            areas = (white, folder / f"{place}_white.surf.gii")
            mask = ("--mask", hemisphere.cortex) if hemisphere.cortex else ()
            for metric in run.metrics:
                if metric in hemisphere.metrics:
                    result = add(f"{place}_{metric}.shape.gii")
                    values = hemisphere.metrics[metric]
                    run.call("resample", values, *spheres, "-o", result, "--areas", *areas, *mask, "--threads", threads)
    except Failure as failure:
        return Made(failures=[f"hemisphere {hemi}: {failure}"])
    return made


def _make(subject: Subject, run: Run, folder: Path) -> Made:
    result = Made()
    present: List[Hemisphere] = []
    for hemi in run.hemispheres:
        hemisphere = subject.hemispheres.get(hemi)
        if hemisphere is None or "white" not in hemisphere.surfaces:
            result.failures.append(f"hemisphere {hemi}: there is no white surface in {subject.folder}")
        else:
            present.append(hemisphere)
    n_parallel = max(1, min(len(present), run.threads))
    with ThreadPoolExecutor(n_parallel) as pool:
        for made in pool.map(lambda h: _make_hemisphere(subject, h, run, folder, run.threads // n_parallel), present):
            result.files.update(made.files)
            result.rows += made.rows
            result.pages.update(made.pages)
            result.failures += made.failures
    return result


def _read_state(path: Path) -> Dict[str, Any]:
    try:
        state = json.loads(path.read_text(encoding="utf-8"))
        return state if isinstance(state, dict) and isinstance(state.get("files"), dict) else {"files": {}}
    except (OSError, ValueError):
        return {"files": {}}


def _is_as_written(path: Path, digests: Sequence[str]) -> bool:
    try:
        return path.is_file() and digest_of(path) in digests
    except OSError:
        return False


def _publish(files: Dict[str, Path], state_path: Path, state: Dict[str, Any], old: Dict[str, Any], output: Path) -> None:
    """Moves files to their places, of which none may be taken by a file that this program has not written.

    What has been and will be written is noted first: so whenever this ends, the next run knows its own files.
    """
    for name in files:
        target = output / name
        if os.path.lexists(target) and not _is_as_written(target, old["files"].get(name, ())):
            raise Failure(f"{target} is there and was not written by this program: move it, or choose another output folder")
    digests = {name: [digest_of(path)] for name, path in files.items()}
    both = {name: [*digests.get(name, ()), *old["files"].get(name, ())] for name in {**old["files"], **digests}}
    write_text(state_path, json.dumps({"complete": False, "files": both}))
    for name, path in files.items():
        (output / name).parent.mkdir(parents=True, exist_ok=True)
        os.replace(path, output / name)
    # What an earlier run has written under other names stays, and stays known.
    left = {name: known for name, known in old["files"].items() if name not in digests}
    write_text(state_path, json.dumps({**state, "files": {**left, **digests}}, indent=1) + "\n")


def process(subject: Subject, run: Run, resumes: bool) -> Tuple[bool, List[str]]:
    """Makes all files of a subject; returns whether there was something to do, and what has failed."""
    state_path = run.output / subject.place / f"{subject.stem}_desc-provenance_surfaces.json"
    work = run.output / f".{subject.stem}.work"
    page_path, page_name = run.output / f"{subject.stem}.html", f"{subject.stem}.html"
    try:
        with locked(run.output / f".{subject.stem}.lock"):
            old = _read_state(state_path)
            provenance = provenance_of(subject, run)
            is_done = old.get("complete") and old.get("provenance") == provenance
            if resumes and is_done and all(_is_as_written(run.output / n, d) for n, d in old["files"].items()):
                return False, []
            shutil.rmtree(work, ignore_errors=True)  # of a run that was killed
            work.mkdir()
            try:
                made = _make(subject, run, work)
                (work / "table.tsv").write_text(make_table(made.rows), encoding="utf-8")
                page = make_page(subject.stem, run.version, made.rows, made.failures, made.pages)
                (work / page_name).write_text(page, encoding="utf-8")
                if made.rows:
                    made.files[str(subject.place / f"{subject.stem}_desc-quality_surfaces.tsv")] = work / "table.tsv"
                made.files[page_name] = work / page_name
                state = {"complete": not made.failures, "provenance": provenance}
                _publish(made.files, state_path, state, old, run.output)
                return True, made.failures
            finally:
                shutil.rmtree(work, ignore_errors=True)
    except Failure as failure:
        return True, [str(failure)]
    except OSError as error:
        return True, [f"{error.filename or run.output}: {error.strerror or error}"]
