"""Makes the files of a subject."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
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
    """The programs at work, which a signal ends; none is started after that."""

    def __init__(self) -> None:
        self._running: Set[subprocess.Popen[bytes]] = set()
        self._lock = threading.Lock()
        self._is_ended = False

    def run(self, command: Sequence[str]) -> Tuple[int, str]:
        """Returns the exit status, and what the program says on the standard error stream."""
        with self._lock:
            if self._is_ended:
                raise Failure("interrupted")
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True
            )
            self._running.add(process)
        said = process.communicate()[1].decode(errors="replace")
        with self._lock:
            self._running.discard(process)
            if self._is_ended:
                raise Failure("interrupted")
        return process.returncode, said

    def end(self) -> None:
        """May be called by a signal, as the main thread starts no programs itself."""
        with self._lock:
            self._is_ended = True
            for process in self._running:
                process.kill()


programs = Programs()


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
        try:
            status, said = programs.run(command)
        except OSError as error:
            raise Failure(f"{self.program} cannot be run: {error.strerror}") from error
        if status < 0:
            raise Failure(f"{self.program} was ended by signal {-status}; signal 9 often means that memory was short")
        if status:
            raise Failure(" ".join(said.split()) or f"{self.program} has ended with the status {status}")

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


def read_report(path: Path) -> Dict[str, Any]:
    """Returns a report of the program, which has come to its end: one that was sent a signal writes what it has."""
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
    """Writes a file that appears under its name when it is complete."""
    path.parent.mkdir(parents=True, exist_ok=True)
    # Processes of containers have the same numbers.
    temporary = path.parent / f".{path.name}.{uuid.uuid4().hex}"
    try:
        temporary.write_text(text, encoding="utf-8", errors="backslashreplace")
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

    The depths are those that the subject has, if they are of the same kind of file as those of the atlas; otherwise the program
    measures them. FreeSurfer has a positive depth in sulci, smriprep and the HCP a negative one in GIFTI files, and other GIFTI
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
    """The surfaces, the white one first, whose areas others need."""
    return sorted(hemisphere.surfaces.items(), key=lambda pair: (pair[0] != "white", pair[0]))


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
        sphere = folder / f"{stem}_sphere.surf.gii"
        page = f"{stem}_desc-distortion_sphere.html"
        report_path = folder / f"{stem}.json"
        run.call("map", white, "-o", sphere, "--json", report_path, "--page", folder / page, "--threads", threads)
        report = read_report(report_path)
        add(sphere.name)
        add_report(sphere, report)
        made.files[f"sub-{subject.label}/figures/{page}"] = folder / page
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
            registered = folder / f"{stem}_space-{atlas.name}_desc-{description}_sphere.surf.gii"
            report = _register(run, hemisphere, sphere, atlas, registered, threads)
            add(registered.name)
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
            areas = ("--areas", white, folder / f"{place}_white.surf.gii")
            mask = ("--mask", hemisphere.cortex) if hemisphere.cortex else ()
            files: List[Tuple[str, Path, Sequence[Any]]] = [(f"{place}_{kind}.surf.gii", path, ()) for kind, path in sorted_surfaces(hemisphere)]
            files += [
                (f"{place}_{metric}.shape.gii", hemisphere.metrics[metric], (*areas, *mask))
                for metric in run.metrics
                if metric in hemisphere.metrics
            ]
            for name, path, options in files:
                try:
                    run.call("resample", path, *spheres, "-o", folder / name, *options, "--threads", threads)
                    add(name)
                except Failure as failure:
                    made.failures.append(f"hemisphere {hemi}: {failure}")
    except Failure as failure:
        # A registration that fails leaves what does not depend on it.
        made.failures.append(f"hemisphere {hemi}: {failure}")
    return made


def _make(subject: Subject, run: Run, folder: Path) -> Made:
    result = Made(failures=list(subject.faults))
    present: List[Hemisphere] = []
    for hemi in run.hemispheres:
        hemisphere = subject.hemispheres[hemi]
        if "white" not in hemisphere.surfaces:
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
    """Returns what has been noted of earlier runs, with the checksums that each file may have."""
    if not os.path.lexists(path):
        return {"files": {}}
    try:
        state = json.loads(path.read_text(encoding="utf-8"))
        if state["program"] == NAME and all(isinstance(d, list) for d in state["files"].values()):
            return dict(state)
    except (ValueError, KeyError, TypeError, AttributeError):
        pass
    raise Failure(f"{path} was not written by this program, or is damaged: move it away, with the other files of the subject")


def _is_as_written(path: Path, digests: Sequence[str]) -> bool:
    try:
        return path.is_file() and digest_of(path) in digests
    except OSError:
        return False


@contextmanager
def _without_signals() -> Iterator[None]:
    """Holds back signals, which come when this has ended."""
    held = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, held)


def _publish(made: Made, of_run: Sequence[str], state_path: Path, provenance: Dict[str, Any], old: Dict[str, Any], output: Path) -> None:
    """Moves files into the dataset, where none of a name may be there that this program has not written.

    What has been and will be written is noted first: so whenever this ends, the next run knows its own files. Those of earlier runs
    that are not made any more, of the hemispheres of this run, would be taken for its results, and are removed.
    """
    known = old["files"]
    for name in made.files:
        target = output / name
        if os.path.lexists(target) and not _is_as_written(target, known.get(name, ())):
            raise Failure(f"{target} is there and was not written by this program: move it, or choose another output folder")
    digests = {name: [digest_of(path)] for name, path in made.files.items()}
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
        for name, path in made.files.items():
            (output / name).parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, output / name)
        state = {**base, "complete": not made.failures, "made": sorted(digests), "files": {**left, **digests}}
        write_text(state_path, json.dumps(state, indent=1) + "\n")


def process(subject: Subject, run: Run, resumes: bool) -> Tuple[bool, Made]:
    """Makes all files of a subject; returns whether there was something to do, and what has been made and has failed."""
    state_path = run.output / subject.place / f"{subject.stem}_desc-provenance_surfaces.json"
    work = run.output / f".{subject.stem}.work"
    page_name = f"{subject.stem}.html"
    try:
        provenance = provenance_of(subject, run)
        if resumes:
            old = _read_state(state_path)
            is_done = old.get("complete") and old.get("provenance") == provenance
            if is_done and all(_is_as_written(run.output / name, old["files"].get(name, ())) for name in old.get("made", ())):
                return False, Made()
        with locked(run.output / f".{subject.stem}.lock"):
            old = _read_state(state_path)
            shutil.rmtree(work, ignore_errors=True)  # of a run that was killed
            work.mkdir()
            try:
                made = _make(subject, run, work)
                write_text(work / "table.tsv", make_table(made.rows))
                page = make_page(subject.stem, run.version, made.rows, made.failures, made.pages)
                write_text(work / page_name, page)
                if made.rows:
                    made.files[str(subject.place / f"{subject.stem}_desc-quality_surfaces.tsv")] = work / "table.tsv"
                made.files[page_name] = work / page_name
                _publish(made, run.hemispheres, state_path, provenance, old, run.output)
                return True, made
            finally:
                shutil.rmtree(work, ignore_errors=True)
    except Failure as failure:
        return True, Made(failures=[str(failure)])
    except OSError as error:
        return True, Made(failures=[f"{error.filename or run.output}: {error.strerror or error}"])
