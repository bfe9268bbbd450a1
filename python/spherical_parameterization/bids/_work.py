"""Computes the files of a subject."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import threading
import uuid
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence, Set, Tuple

from .._files import read_mesh
from ._inputs import Atlas, Failure, Hemisphere, Subject
from ._report import make_page, make_table

NAME = "spherical_parameterization_bids"
SIGNALS = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)

class Programs:
    """The running programs. A signal ends them, and no others start after that."""

    def __init__(self) -> None:
        self._running: Set[subprocess.Popen[bytes]] = set()
        self._lock = threading.Lock()
        self._is_ended = False

    def run(self, command: Sequence[str]) -> Tuple[int, str]:
        """Returns the exit status and the standard error stream of the program."""
        with self._lock:
            if self._is_ended:
                raise Failure("interrupted")
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True
            )
            self._running.add(process)
        messages = process.communicate()[1].decode(errors="replace")
        with self._lock:
            self._running.discard(process)
            if self._is_ended:
                raise Failure("interrupted")
        return process.returncode, messages

    def end(self) -> None:
        """May be called by a signal handler, as the main thread starts no programs."""
        with self._lock:
            self._is_ended = True
            for process in self._running:
                process.kill()


programs = Programs()


@dataclass
class Run:
    """The settings for all subjects."""

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
        """Runs the program; its error message becomes a Failure."""
        command = [self.program, *map(str, arguments), "--quiet"]
        try:
            status, messages = programs.run(command)
        except OSError as error:
            raise Failure(f"{self.program} cannot be run: {error.strerror}") from error
        if status < 0:
            raise Failure(f"{self.program} was ended by signal {-status}; signal 9 often means insufficient memory")
        if status:
            raise Failure(" ".join(messages.split()) or f"{self.program} ended with the exit status {status}")

    def density_of(self, sphere: Path) -> str:
        """The density of an atlas in file names, such as 164k."""
        if sphere not in self.densities:
            self.densities[sphere] = f"{round(len(read_mesh(sphere)[0]) / 1000)}k"
        return self.densities[sphere]


@dataclass
class Result:
    """The results for a subject: files by their paths in the dataset, rows of the table, links, and failures."""

    files: Dict[str, Path] = field(default_factory=dict)
    rows: List[Dict[str, Any]] = field(default_factory=list)
    pages: Dict[str, str] = field(default_factory=dict)
    failures: List[str] = field(default_factory=list)


def stamp_of(path: Path) -> List[int]:
    status = path.stat()
    return [status.st_size, status.st_mtime_ns]


def read_report(path: Path) -> Dict[str, Any]:
    """Returns a report of the program. After a signal, the program writes an incomplete result, which is a Failure."""
    report: Dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    if "interrupted" in (report["stop_reason"], report.get("match", {}).get("stop_reason")):
        raise Failure("the program was interrupted by a signal")
    return report


def digest_of(path: Path) -> str:
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()


def write_text(path: Path, text: str) -> None:
    """Writes a file, which appears under its name when it is complete."""
    path.parent.mkdir(parents=True, exist_ok=True)
    # Process numbers are not unique among containers.
    temporary = path.parent / f".{path.name}.{uuid.uuid4().hex}"
    try:
        temporary.write_text(text, encoding="utf-8", errors="backslashreplace")
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Locks a subject against other processes; the system releases the lock when this process ends."""
    path.parent.mkdir(parents=True, exist_ok=True)
    while True:
        with open(path, "w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError as error:
                raise Failure("another process is working on it") from error
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
    """Everything that the results depend on, and nothing else."""
    inputs: Dict[str, Dict[str, Any]] = {}

    def add(role: str, path: Path) -> None:
        inputs[role] = {"path": os.path.realpath(path), "stamp": stamp_of(path)}

    for hemi in run.hemispheres:
        for role, path in subject.hemispheres[hemi].files().items():
            add(f"{hemi} {role}", path)
        for atlas in run.atlases:
            add(f"{hemi} sphere of {atlas.name}", atlas.spheres[hemi])
            add(f"{hemi} depth of {atlas.name}", atlas.depths[hemi])
    return {
        "version": run.version,
        "hemispheres": list(run.hemispheres),
        "metrics": list(run.metrics),
        "fslr_description": run.fslr_description,
        "inputs": inputs,
    }


def _is_gifti(path: Path) -> bool:
    return path.name.endswith((".gii", ".gii.gz"))


def _register(
    run: Run, hemisphere: Hemisphere, sphere: Path, atlas: Atlas, output: Path, threads: int
) -> Dict[str, Any]:
    """Registers a sphere to an atlas, and returns the report.

    The sulcal depths are those of the subject, if they have the same kind of file as those of the atlas; otherwise the program
    computes them. FreeSurfer has positive depths in sulci, smriprep and the HCP negative ones in GIFTI files; other GIFTI files do
    not state the sign. With the wrong sign, the correlation is too low for a certain map, and the next candidate is tried.
    """
    depth_of_atlas = atlas.depths[hemisphere.name]
    features: List[Any] = ["height", "depth"] if _is_gifti(depth_of_atlas) else ["depth", "height"]
    own = hemisphere.metrics.get("sulc")
    if own is not None and _is_gifti(own) == _is_gifti(depth_of_atlas):
        features.insert(0, own)
    reports: List[Tuple[Dict[str, Any], Path]] = []
    for k, feature in enumerate(features):
        path = output.with_name(f"{k}_{output.name}")
        report_path = output.with_name(f"{k}_{output.name}.json")
        run.call(
            *("register", hemisphere.surfaces["white"], atlas.spheres[hemisphere.name]),
            *("--features", feature, depth_of_atlas, "--initial", sphere, "--iterations", 0),
            *("-o", path, "--json", report_path, "--threads", threads),
        )
        reports.append((read_report(report_path), path))
        if not reports[-1][0]["match"]["is_uncertain"]:
            break
    report, path = max(reports, key=lambda pair: (not pair[0]["match"]["is_uncertain"], pair[0]["match"]["agreement"]))
    os.replace(path, output)
    return report


def sorted_surfaces(hemisphere: Hemisphere) -> List[Tuple[str, Path]]:
    """The surfaces, the white one first, as others need its areas."""
    return sorted(hemisphere.surfaces.items(), key=lambda pair: (pair[0] != "white", pair[0]))


def _process_hemisphere(subject: Subject, hemisphere: Hemisphere, run: Run, folder: Path, threads: int) -> Result:
    hemi, result = hemisphere.name, Result()
    stem = f"{subject.stem}_hemi-{hemi}"
    white = hemisphere.surfaces["white"]

    def add(name: str) -> Path:
        result.files[str(subject.anat / name)] = folder / name
        return folder / name

    def add_report(of: Path, report: Dict[str, Any]) -> None:
        """Writes the report without references to the temporary folder."""
        for name in ("files", "crc32", "input_stamp", "start_stamp"):
            report.pop(name, None)
        report["method"] = re.sub(r"start from .*(?=, [a-z-]+ energy)", f"start from {sphere.name}", report["method"], flags=re.DOTALL)
        add(of.name.replace(".surf.gii", ".json")).write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")

    try:
        sphere = folder / f"{stem}_sphere.surf.gii"
        page = f"{stem}_desc-distortion_sphere.html"
        report_path = folder / f"{stem}.json"
        run.call("map", white, "-o", sphere, "--json", report_path, "--page", folder / page, "--threads", threads)
        report = read_report(report_path)
        add(sphere.name)
        add_report(sphere, report)
        result.files[f"sub-{subject.label}/figures/{page}"] = folder / page
        result.pages[f"Hemisphere {hemi}"] = f"sub-{subject.label}/figures/{page}"
        distortion = report["distortion"]
        result.rows.append(
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
            registered = folder / f"{stem}_space-{atlas.name}_desc-{description}_sphere.surf.gii"
            report = _register(run, hemisphere, sphere, atlas, registered, threads)
            add(registered.name)
            add_report(registered, report)
            match = report["match"]
            result.rows.append(
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
            resampled = f"{stem}_space-{atlas.name}_den-{run.density_of(atlas.spheres[hemi])}"
            spheres = (registered, atlas.spheres[hemi])
            areas = ("--areas", white, folder / f"{resampled}_white.surf.gii")
            mask = ("--mask", hemisphere.cortex) if hemisphere.cortex else ()
            files: List[Tuple[str, Path, Sequence[Any]]] = [(f"{resampled}_{kind}.surf.gii", path, ()) for kind, path in sorted_surfaces(hemisphere)]
            files += [
                (f"{resampled}_{metric}.shape.gii", hemisphere.metrics[metric], (*areas, *mask))
                for metric in run.metrics
                if metric in hemisphere.metrics
            ]
            for name, path, options in files:
                try:
                    run.call("resample", path, *spheres, "-o", folder / name, *options, "--threads", threads)
                    add(name)
                except Failure as failure:
                    result.failures.append(f"hemisphere {hemi}: {failure}")
    except Failure as failure:
        # If a registration fails, results that do not depend on it are kept.
        result.failures.append(f"hemisphere {hemi}: {failure}")
    return result


def _process_hemispheres(subject: Subject, run: Run, folder: Path) -> Result:
    result = Result(failures=list(subject.defects))
    present: List[Hemisphere] = []
    for hemi in run.hemispheres:
        hemisphere = subject.hemispheres[hemi]
        if "white" not in hemisphere.surfaces:
            result.failures.append(f"hemisphere {hemi}: {subject.folder} has no white surface")
        else:
            present.append(hemisphere)
    n_parallel = max(1, min(len(present), run.threads))
    with ThreadPoolExecutor(n_parallel) as pool:
        for part in pool.map(lambda h: _process_hemisphere(subject, h, run, folder, run.threads // n_parallel), present):
            result.files.update(part.files)
            result.rows += part.rows
            result.pages.update(part.pages)
            result.failures += part.failures
    return result


def _read_state(path: Path) -> Dict[str, Any]:
    """Returns the record of earlier runs, with the possible checksums of each file."""
    if not os.path.lexists(path):
        return {"files": {}}
    try:
        state = json.loads(path.read_text(encoding="utf-8"))
        if state["program"] == NAME and all(isinstance(d, list) for d in state["files"].values()):
            return dict(state)
    except (ValueError, KeyError, TypeError, AttributeError):
        pass
    raise Failure(f"{path} was not written by this program, or is damaged: move it and the other files of the subject to another folder")


def _is_as_written(path: Path, digests: Sequence[str]) -> bool:
    try:
        return path.is_file() and digest_of(path) in digests
    except OSError:
        return False


@contextmanager
def _without_signals() -> Iterator[None]:
    """Blocks signals, which are delivered afterwards."""
    held = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, held)


def _publish(result: Result, of_run: Sequence[str], state_path: Path, provenance: Dict[str, Any], old: Dict[str, Any], output: Path) -> None:
    """Moves files into the dataset, and refuses to replace files that this program has not written.

    The old and new files are recorded first, so that the next run recognizes them whenever this one ends. Files of earlier runs that
    are no longer produced, for the hemispheres of this run, could be mistaken for its results, and are removed.
    """
    known = old["files"]
    for name in result.files:
        target = output / name
        if os.path.lexists(target) and not _is_as_written(target, known.get(name, ())):
            raise Failure(f"{target} exists and was not written by this program: move it, or choose another output folder")
    digests = {name: [digest_of(path)] for name, path in result.files.items()}
    outdated = [
        name
        for name in known
        if name not in digests and any(f"_hemi-{hemi}_" in name for hemi in of_run) and _is_as_written(output / name, known[name])
    ]
    left = {name: d for name, d in known.items() if name not in digests and name not in outdated}
    both = {name: [*digests.get(name, ()), *known.get(name, ())] for name in {**known, **digests}}
    base = {"program": NAME, "provenance": provenance}
    with _without_signals():
        write_text(state_path, json.dumps({**base, "complete": False, "files": both}))
        for name in outdated:
            (output / name).unlink()
        for name, path in result.files.items():
            (output / name).parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, output / name)
        state = {**base, "complete": not result.failures, "made": sorted(digests), "files": {**left, **digests}}
        write_text(state_path, json.dumps(state, indent=1) + "\n")


def process(subject: Subject, run: Run, resumes: bool) -> Tuple[bool, Result]:
    """Computes all files of a subject; returns whether it was not up to date, and the results with all failures."""
    state_path = run.output / subject.anat / f"{subject.stem}_desc-provenance_surfaces.json"
    work = run.output / f".{subject.stem}.work"
    page_name = f"{subject.stem}.html"
    try:
        provenance = provenance_of(subject, run)
        if resumes:
            old = _read_state(state_path)
            is_done = old.get("complete") and old.get("provenance") == provenance
            if is_done and all(_is_as_written(run.output / name, old["files"].get(name, ())) for name in old.get("made", ())):
                return False, Result()
        with locked(run.output / f".{subject.stem}.lock"):
            old = _read_state(state_path)
            shutil.rmtree(work, ignore_errors=True)  # from a killed run
            work.mkdir()
            try:
                result = _process_hemispheres(subject, run, work)
                write_text(work / "table.tsv", make_table(result.rows))
                page = make_page(subject.stem, run.version, result.rows, result.failures, result.pages)
                write_text(work / page_name, page)
                if result.rows:
                    result.files[str(subject.anat / f"{subject.stem}_desc-quality_surfaces.tsv")] = work / "table.tsv"
                result.files[page_name] = work / page_name
                _publish(result, run.hemispheres, state_path, provenance, old, run.output)
                return True, result
            finally:
                shutil.rmtree(work, ignore_errors=True)
    except Failure as failure:
        return True, Result(failures=[str(failure)])
    except OSError as error:
        return True, Result(failures=[f"{error.filename or run.output}: {error.strerror or error}"])
