"""Runs the command line program, and keeps what each run gave."""

from __future__ import annotations

import json
import re
import sys
from dataclasses import asdict, dataclass, field
from functools import cached_property
from hashlib import sha256
from pathlib import Path

from .commands import run_command
from .maps import Distortion, SphericalMap, map_between
from .meshes import MeshError, MeshFile, checksum, read_mesh

CERTIFIED, FAILED, NOT_BIJECTIVE = 0, 1, 2  # exit status of the program
STAGES = {  # from the mesh in memory to the certified map, by their names in the program's report
    "reading": "copy",
    "hierarchy": "hierarchy",
    "embedding": "initial_map",
    "optimization": "sweeps",
    "certificate": "certificate",
}


@dataclass(eq=False)
class Run:
    """One run of the command line program on one mesh."""

    mesh: MeshFile
    arguments: tuple[str, ...]
    exit_status: int
    message: str  # why there is no map, or why it is not to be used; empty otherwise
    process_seconds: float
    cpu_seconds: float
    report: dict
    sphere: Path | None
    is_reused: bool = False
    used_for: list[str] = field(default_factory=list)

    @property
    def command(self) -> str:
        return " ".join(self.arguments) or "(no options)"

    @property
    def has_map(self) -> bool:
        return self.sphere is not None

    @property
    def seconds(self) -> float:
        """By the program's own report; of the process if there is none."""
        return self.report.get("seconds", {}).get("total", self.process_seconds)

    @property
    def mapping_seconds(self) -> float:
        """Without reading, measuring and writing: from the mesh in memory to the certified map."""
        reported = self.report.get("seconds")
        return self.seconds if reported is None else sum(reported[stage] for stage in STAGES.values())

    @property
    def sweeps(self) -> int | None:
        sweeps = self.report.get("sweeps")
        return None if sweeps is None else sweeps.get("average", 0) + sweeps.get("sharp", 0)

    @property
    def stop_reason(self) -> str:
        return self.report.get("stop_reason", "")

    @cached_property
    def map(self) -> SphericalMap:
        """The map that was written, measured by this driver."""
        return map_between(self.mesh.mesh, read_mesh(self.sphere))

    @cached_property
    def distortion(self) -> Distortion:
        """At the radius of eq. 11."""
        return self.map.distortion()

    @cached_property
    def own_distortion(self) -> Distortion:
        """At the radius that the map was written with."""
        return self.map.distortion(self.map.own_radius)

    @cached_property
    def disagreement(self) -> float:
        """The largest relative difference between the driver's and the program's own figures of this map."""
        reported, own = self.report.get("distortion"), self.own_distortion
        pairs = [
            (value, reported[name][key])
            for name, statistics in (("D_iso", own.isometric), ("D_area", own.area), ("D_angle", own.angle))
            for key, value in asdict(statistics).items()
            if reported and reported[name][key] is not None
        ]
        return max((abs(a - b) / max(1.0, abs(b)) for a, b in pairs), default=0.0)

    @cached_property
    def row(self) -> dict:
        """All figures of this run, for a CSV file."""
        row = {"mesh": self.mesh.name, "vertices": self.mesh.number_of_vertices, "options": self.command}
        names = "exit_status message seconds mapping_seconds process_seconds cpu_seconds sweeps stop_reason is_reused"
        row |= {name: getattr(self, name) for name in names.split()}
        if self.has_map:
            row |= {"radius_eq11": self.distortion.radius, "own_radius": self.map.own_radius}
            row |= {"inverted_faces": self.map.number_inverted, "faces_left_out": self.map.number_left_out}
            row |= {"difference_to_program": self.disagreement}
            for prefix, distortion in (("", self.distortion), ("own_radius_", self.own_distortion)):
                for name in ("isometric", "area", "angle"):
                    values = asdict(getattr(distortion, name))
                    row |= {f"{prefix}{name}_{key}": value for key, value in values.items()}
        return row

    def forget_map(self) -> None:
        """Frees what was computed from the files; it is computed again when it is asked for."""
        for name in ("map", "distortion", "own_distortion"):
            self.__dict__.pop(name, None)


class Program:
    """The command line program with the settings that all runs have in common.

    Within one session, a command that several tables need is run once. Results of an earlier session are used only if
    that was asked for, and only if the program, the mesh, the options and the number of threads are the same.
    """

    def __init__(self, path: Path, threads: int, folder: Path, may_resume: bool = False, max_seconds: float = 7200.0):
        self.path, self.threads = path.resolve(), threads
        self._folder, self._may_resume, self._max_seconds = folder, may_resume, max_seconds
        self._runs: dict[tuple, Run] = {}
        folder.mkdir(parents=True, exist_ok=True)
        answer = run_command([self.path, "--version"])
        if answer.status != 0:
            raise SystemExit(f"{path} --version fails: {answer.message}")
        self.version, self._checksum = answer.output.strip(), checksum(self.path)

    @property
    def runs(self) -> list[Run]:
        return list(self._runs.values())

    def run(self, mesh: MeshFile, arguments: list[str], used_for: str = "", repetition: object = 0) -> Run:
        """Runs the program, or returns the run that has been made with the same arguments of this method."""
        key = (mesh.path, tuple(arguments), repetition)
        run = self._runs.get(key)
        if run is None:
            stem = self._folder / self._stem(*key)
            run = self._stored(mesh, key[1], stem) or self.execute(mesh, key[1], stem)
            try:
                run.row  # measures the map
            except MeshError as error:
                run.sphere = None
                run.message = f"exit status {run.exit_status}, but the map cannot be measured: {error}"
            self._runs[key] = run
            self._log(run)
        if used_for not in run.used_for:
            run.used_for.append(used_for)
        return run

    def contradictions(self) -> list[str]:
        """Runs in which the program said one thing and its map another."""
        lines = []
        for run in self.runs:
            name, inverted = f"{run.mesh.name}, `{run.command}`", run.row.get("inverted_faces")
            if run.exit_status == CERTIFIED and inverted:
                lines.append(f"{name}: exit status 0, but {inverted} faces are inverted")
            if run.exit_status != FAILED and not run.has_map:
                lines.append(f"{name}: {run.message}")
            if run.report.get("one_to_one", run.exit_status == CERTIFIED) != (run.exit_status == CERTIFIED):
                lines.append(f"{name}: exit status {run.exit_status}, but the report says otherwise")
        return lines

    def execute(self, mesh: MeshFile, arguments: tuple[str, ...], stem: Path) -> Run:
        """Runs the program, whose files begin with `stem`. The map is not looked at."""
        sphere, report, record = (Path(f"{stem}{ending}") for ending in (".off", ".json", ".run.json"))
        for file in (sphere, report, record):
            file.unlink(missing_ok=True)
        command = [self.path, mesh.path, "-o", sphere, "--json", report, "--quiet", "--threads", self.threads]
        outcome = run_command([*command, *arguments], self._max_seconds)
        is_done = outcome.status in (CERTIFIED, NOT_BIJECTIVE)
        status, has_map = outcome.status, is_done and sphere.exists() and report.exists()
        message = outcome.message.replace(str(mesh.path), mesh.path.name).removeprefix("spherical_parameterization: ")
        if is_done and not has_map:
            status, message = FAILED, f"exit status {status}, but there is no map"
        seconds = {"process_seconds": outcome.process_seconds, "cpu_seconds": outcome.cpu_seconds}
        values = {"exit_status": status, "message": message, **seconds}
        limit = {"stopped_after": self._max_seconds if outcome.is_timed_out else None}
        record.write_text(json.dumps(self._settings(mesh, arguments) | limit | {"values": values}, indent=2) + "\n")
        reported = json.loads(report.read_text()) if has_map else {}
        return Run(mesh, arguments, report=reported, sphere=sphere if has_map else None, **values)

    def _stored(self, mesh: MeshFile, arguments: tuple[str, ...], stem: Path) -> Run | None:
        sphere, report, record = (Path(f"{stem}{ending}") for ending in (".off", ".json", ".run.json"))
        if not self._may_resume or not record.exists():
            return None
        stored = json.loads(record.read_text())
        values = stored.pop("values", {})
        if stored.pop("stopped_after", None) not in (None, self._max_seconds):
            return None  # it may come further now
        if stored != self._settings(mesh, arguments):
            return None
        has_map = values["exit_status"] in (CERTIFIED, NOT_BIJECTIVE)
        if has_map and not (sphere.exists() and report.exists()):
            return None
        reported = json.loads(report.read_text()) if has_map else {}
        return Run(mesh, arguments, report=reported, sphere=sphere if has_map else None, is_reused=True, **values)

    def _settings(self, mesh: MeshFile, arguments: tuple[str, ...]) -> dict:
        """All that a result depends on."""
        of_run = {"mesh": mesh.checksum, "arguments": list(arguments)}
        return {"program": self._checksum, "threads": self.threads, **of_run}

    @staticmethod
    def _stem(path: Path, arguments: tuple[str, ...], repetition: object) -> str:
        words = re.sub(r"[^A-Za-z0-9.=]+", "-", " ".join(arguments)).strip("-")[:80]
        key = sha256("\n".join((str(path), *arguments)).encode()).hexdigest()[:8]
        return "_".join(word for word in (path.stem, words, key, str(repetition or "")) if word)

    @staticmethod
    def _log(run: Run) -> None:
        result = run.message
        if run.has_map:
            result = f"D_iso {run.row['isometric_maximum']:.4g} / {run.row['isometric_average']:.4g}"
            result += f", {run.row['inverted_faces']} inverted" if run.row["inverted_faces"] else ""
        origin = ", of an earlier session" if run.is_reused else ""
        print(f"  {run.mesh.name} {run.command}: {result} ({run.seconds:.2f} s{origin})", file=sys.stderr, flush=True)
