"""Runs the command line program, one run after the other, and keeps what each run gave."""

from __future__ import annotations

import hashlib
import json
import re
import resource
import subprocess
import sys
import time
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from .distortion import Distortion, SphericalMap
from .meshes import MeshError, read_mesh
from .mesh_files import MeshFile

CERTIFIED, FAILED, FOLDS = 0, 1, 2  # exit status of the program


@dataclass(eq=False)
class Run:
    """One run of the program on one mesh."""

    mesh: MeshFile
    arguments: tuple[str, ...]
    exit_status: int
    message: str  # why there is no map, or why it is not to be used; empty otherwise
    seconds: float  # by the program's own report; of the process if there is none
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
    def mapping_seconds(self) -> float:
        """Without reading, measuring and writing: from the mesh in memory to the certified map."""
        told = self.report.get("seconds")
        if told is None:
            return self.seconds
        return sum(told[stage] for stage in ("copy", "hierarchy", "initial_map", "sweeps", "certificate"))

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
        sphere = read_mesh(self.sphere)
        if not np.array_equal(sphere.faces, self.mesh.mesh.faces):
            raise MeshError(f"{self.sphere.name} has other faces than {self.mesh.name}")
        return SphericalMap(self.mesh.mesh, sphere.vertices)

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
        told = self.report.get("distortion")
        if not told:
            return 0.0
        own = self.own_distortion
        pairs = [
            (getattr(statistics, key), told[name][key])
            for name, statistics in (("D_iso", own.isometric), ("D_area", own.area), ("D_angle", own.angle))
            for key in ("maximum", "average", "deviation")
            if told[name][key] is not None
        ]
        return max((abs(a - b) / max(1.0, abs(b)) for a, b in pairs), default=0.0)

    @cached_property
    def row(self) -> dict:
        """All figures of this run, for a CSV file."""
        row = {
            "mesh": self.mesh.name,
            "vertices": self.mesh.number_of_vertices,
            "faces": self.mesh.number_of_faces,
            "options": self.command,
            "exit_status": self.exit_status,
            "message": self.message,
            "seconds": self.seconds,
            "process_seconds": self.process_seconds,
            "cpu_seconds": self.cpu_seconds,
            "sweeps": self.sweeps,
            "stop_reason": self.stop_reason,
        }
        if self.has_map:
            row |= {"radius_eq11": self.distortion.radius, "own_radius": self.map.own_radius}
            row |= {"folded_faces": self.map.number_folded, "faces_left_out": self.map.number_left_out}
            row |= {"difference_to_program": self.disagreement}
            for prefix, distortion in (("", self.distortion), ("own_radius_", self.own_distortion)):
                for name in ("isometric", "area", "angle"):
                    for key, value in asdict(getattr(distortion, name)).items():
                        row[f"{prefix}{name}_{key}"] = value
        return row

    def forget_map(self) -> None:
        """Frees what was computed from the files; it is computed again when it is asked for."""
        for name in ("map", "distortion", "own_distortion"):
            self.__dict__.pop(name, None)


class Program:
    """The program with the settings that all runs have in common.

    Within one session, a command that several tables need is run once. Results of an earlier session are used only if
    that was asked for, and only if the program, the mesh, the options and the number of threads are the same.
    """

    def __init__(self, path: Path, threads: int, folder: Path, may_resume: bool, most_seconds: float):
        self.path = path
        self.threads = threads
        self._folder = folder
        self._may_resume = may_resume
        self._most_seconds = most_seconds
        self._checksum = checksum(path)
        self._runs: dict[tuple[Path, tuple[str, ...], int], Run] = {}
        folder.mkdir(parents=True, exist_ok=True)
        answer = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
        if answer.returncode != 0:
            raise SystemExit(f"{path} --version fails: {answer.stderr.strip()}")
        self.version = answer.stdout.strip()

    @property
    def runs(self) -> list[Run]:
        return list(self._runs.values())

    def run(self, mesh: MeshFile, arguments: list[str], used_for: str, repetition: int = 0) -> Run:
        """Runs the program, or returns the run that has been made with the same arguments of this method."""
        key = (mesh.path, tuple(arguments), repetition)
        run = self._runs.get(key)
        if run is None:
            stem = self._stem(*key)
            run = self._stored(mesh, key[1], stem) if self._may_resume else None
            run = run or self._run(mesh, key[1], stem)
            try:
                run.row  # measures the map
            except (MeshError, ValueError) as error:
                run.sphere, run.message = (
                    None,
                    f"exit status {run.exit_status}, but the map cannot be measured: {error}",
                )
            self._runs[key] = run
            self._log(run)
        if used_for not in run.used_for:
            run.used_for.append(used_for)
        return run

    def map_all(self, meshes: list[MeshFile], folder: Path) -> str:
        """Maps meshes to a folder by one command, which is not kept, and returns what went wrong, if anything."""
        command = [str(self.path), *(str(mesh.path) for mesh in meshes), "--output-folder", str(folder), "--quiet"]
        status, message, _ = self._call([*command, "--threads", str(self.threads)])
        return "" if status == CERTIFIED else message or f"exit status {status}"

    def _call(self, command: list[str]) -> tuple[int, str, float | None]:
        """The exit status of a command, its first message, and the limit in seconds that has ended it, if any has."""
        try:
            answer = subprocess.run(
                command,
                capture_output=True,
                text=True,
                check=False,
                timeout=self._most_seconds,
                stdin=subprocess.DEVNULL,
            )
        except subprocess.TimeoutExpired:
            return FAILED, f"stopped by this driver after {self._most_seconds:.0f} seconds", self._most_seconds
        status, message = answer.returncode, _first_message(answer.stderr)
        if status < 0:
            message = f"ended by signal {-status}"
        elif status not in (CERTIFIED, FOLDS):
            message = message or f"exit status {status}"
        return status, message, None

    def _run(self, mesh: MeshFile, arguments: tuple[str, ...], stem: str) -> Run:
        sphere, report = (self._folder / (stem + ending) for ending in (".off", ".json"))
        record = self._folder / (stem + ".run.json")
        for file in (sphere, report, record):
            file.unlink(missing_ok=True)
        command = [str(self.path), str(mesh.path), "-o", str(sphere), "--json", str(report), "--quiet"]
        command += ["--threads", str(self.threads), *arguments]

        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        status, message, stopped_after = self._call(command)
        message = message.replace(str(mesh.path), mesh.path.name)
        process_seconds = time.monotonic() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpu_seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        told = json.loads(report.read_text()) if report.exists() and status in (CERTIFIED, FOLDS) else {}
        has_map = sphere.exists() and status in (CERTIFIED, FOLDS)
        if status in (CERTIFIED, FOLDS) and not has_map:
            status, message = FAILED, f"exit status {status}, but there is no map"
        seconds = told.get("seconds", {}).get("total", process_seconds)
        values = {
            "exit_status": status,
            "message": message,
            "seconds": seconds,
            "process_seconds": process_seconds,
            "cpu_seconds": cpu_seconds,
        }
        settings = self._settings(mesh, arguments)
        record.write_text(json.dumps({**settings, **values, "stopped_after": stopped_after}, indent=2) + "\n")
        return Run(mesh, arguments, report=told, sphere=sphere if has_map else None, **values)

    def _stored(self, mesh: MeshFile, arguments: tuple[str, ...], stem: str) -> Run | None:
        record = self._folder / (stem + ".run.json")
        if not record.exists():
            return None
        values = json.loads(record.read_text())
        for name, value in self._settings(mesh, arguments).items():
            if values.pop(name, None) != value:
                return None
        if values.pop("stopped_after") not in (None, self._most_seconds):
            return None  # it may come further now
        sphere, report = (self._folder / (stem + ending) for ending in (".off", ".json"))
        told = {}
        if values["exit_status"] in (CERTIFIED, FOLDS):
            if not sphere.exists() or not report.exists():
                return None
            told = json.loads(report.read_text())
        return Run(mesh, arguments, report=told, sphere=sphere if told else None, is_reused=True, **values)

    def _settings(self, mesh: MeshFile, arguments: tuple[str, ...]) -> dict:
        """All that a result depends on."""
        return {
            "program": self._checksum,
            "mesh": mesh.checksum,
            "arguments": list(arguments),
            "threads": self.threads,
        }

    @staticmethod
    def _stem(path: Path, arguments: tuple[str, ...], repetition: int) -> str:
        words = re.sub(r"[^A-Za-z0-9.=]+", "-", " ".join(arguments)).strip("-")[:80]
        key = hashlib.sha256("\n".join((str(path), *arguments)).encode()).hexdigest()[:8]
        return "_".join(word for word in (path.stem, words, key, str(repetition or "")) if word)

    def _log(self, run: Run) -> None:
        row = run.row
        if run.has_map:
            result = f"D_iso {row['isometric_maximum']:.4g} / {row['isometric_average']:.4g}"
            result += f", {row['folded_faces']} folded" if row["folded_faces"] else ""
        else:
            result = run.message
        origin = ", of an earlier session" if run.is_reused else ""
        print(f"  {run.mesh.name} {run.command}: {result} ({run.seconds:.2f} s{origin})", file=sys.stderr, flush=True)


def checksum(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _first_message(stderr: str) -> str:
    """The first line that is a message, without the name of the program before it."""
    for line in stderr.replace("\r", "\n").splitlines():
        if line.strip():
            return line.strip().removeprefix("spherical_parameterization:").strip()
    return ""
