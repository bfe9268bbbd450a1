"""Runs the programs that measure, performance_benchmark and machine_limits, and keeps what they tell."""

from __future__ import annotations

import csv
import hashlib
import json
import re
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from measuring.mesh_files import MeshFile
from measuring.program import checksum

FINGERPRINT = "fingerprint"  # of a map, in hexadecimal digits, which may look like a number


@dataclass(eq=False)
class Measurement:
    """One call of a program for one mesh, or several that were made at the same time."""

    mesh: MeshFile
    arguments: tuple[str, ...]
    rows: list[dict]  # of the table that the program prints: numbers, where a cell is one
    message: str  # why there is no row; empty otherwise
    is_reused: bool = False
    copies: int = 1  # that ran at the same time

    @property
    def words(self) -> str:
        """What was asked for."""
        return " ".join(self.arguments) + (f", {self.copies} at once" if self.copies > 1 else "")


@dataclass(frozen=True)
class Job:
    """What is to be measured, several times."""

    program: "BenchmarkProgram"
    mesh: MeshFile
    arguments: tuple[str, ...]
    repetitions: int
    purpose: str = ""  # jobs with another purpose are measured anew, next to what they are compared with
    copies: int = 1  # that run at the same time, each in a process of its own; the result is their mean


class BenchmarkProgram:
    """A program with the settings that all of its calls have in common.

    Results of an earlier session are used only if that was asked for, and only if the program, the mesh and the options
    are the same.
    """

    def __init__(self, path: Path, folder: Path, may_resume: bool, most_seconds: float):
        self.path = path
        self._folder = folder
        self._may_resume = may_resume
        self._most_seconds = most_seconds
        self._checksum = checksum(path)
        self._measurements: dict[tuple[Job, int], Measurement] = {}
        folder.mkdir(parents=True, exist_ok=True)
        answer = subprocess.run([path, "--help"], capture_output=True, text=True, check=False)
        if answer.returncode != 0:
            raise SystemExit(f"{path} --help fails: {answer.stderr.strip()}")
        self.has_threads = "--threads" in answer.stdout

    @property
    def measurements(self) -> list[Measurement]:
        return list(self._measurements.values())

    def threads(self, number: int) -> tuple[str, ...]:
        """The arguments for a number of threads."""
        return ("--threads", str(number)) if self.has_threads else ()

    def measure(self, job: Job, repetition: int) -> Measurement:
        key = (job, repetition)
        measurement = self._measurements.get(key)
        if measurement is None:
            file = self._folder / self._name(job, repetition)
            settings = {"program": self._checksum, "mesh": job.mesh.checksum, "arguments": list(job.arguments)}
            if job.copies > 1:
                settings["copies"] = job.copies
            measurement = self._stored(job, file, settings) if self._may_resume else None
            if measurement is None:
                measurement = self._measure(job)
                content = settings | {"rows": measurement.rows, "message": measurement.message}
                file.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")
            self._measurements[key] = measurement
            _log(measurement)
        return measurement

    def _measure(self, job: Job) -> Measurement:
        if job.copies == 1:
            return self._run(job)
        with ThreadPoolExecutor(job.copies) as executor:
            copies = list(executor.map(self._run, [job] * job.copies))
        for copy in copies:
            if copy.message:
                return replace(copy, copies=job.copies)
        rows = [_mean(rows) for rows in zip(*(copy.rows for copy in copies), strict=True)]
        return Measurement(job.mesh, job.arguments, rows, "", copies=job.copies)

    def _run(self, job: Job) -> Measurement:
        command = [str(self.path), "--csv", *job.arguments, str(job.mesh.path)]
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
            return Measurement(
                job.mesh, job.arguments, [], f"stopped by this driver after {self._most_seconds:.0f} seconds"
            )
        rows = [
            {key: text if key == FINGERPRINT else _value(text) for key, text in row.items()}
            for row in csv.DictReader(answer.stdout.splitlines())
        ]
        if answer.returncode == 0 and rows:
            return Measurement(job.mesh, job.arguments, rows, "")
        lines = answer.stderr.replace(str(job.mesh.path), job.mesh.path.name).strip().splitlines()
        return Measurement(job.mesh, job.arguments, [], lines[0] if lines else f"exit status {answer.returncode}")

    def _stored(self, job: Job, file: Path, settings: dict) -> Measurement | None:
        if not file.exists():
            return None
        content = json.loads(file.read_text(encoding="utf-8"))
        if any(content.get(name) != value for name, value in settings.items()) or content["message"]:
            return None
        return Measurement(job.mesh, job.arguments, content["rows"], "", is_reused=True, copies=job.copies)

    def _name(self, job: Job, repetition: int) -> str:
        words = re.sub(r"[^A-Za-z0-9]+", "-", " ".join(job.arguments)).strip("-")
        key = hashlib.sha256(str(job.mesh.path).encode()).hexdigest()[:8]
        at_once = f"{job.copies}-at-once" if job.copies > 1 else ""
        parts = (self.path.name, job.purpose, job.mesh.name, words, at_once, key, str(repetition))
        return "_".join(part for part in parts if part) + ".json"


def _mean(rows: tuple[dict, ...]) -> dict:
    """The means of the numbers of several rows; of other cells, what all say."""
    mean = {}
    for key, first in rows[0].items():
        cells = [row[key] for row in rows]
        if all(isinstance(cell, float) for cell in cells):
            mean[key] = statistics.fmean(cells)
        else:
            mean[key] = first if len(set(cells)) == 1 else "differs"
    return mean


def _value(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _log(measurement: Measurement) -> None:
    row = measurement.rows[-1] if measurement.rows else {}
    if "mesh to map" in row:
        result = f"{row['mesh to map']:.3f} s, D_iso {row['D_iso max']:.4g} / {row['D_iso avg']:.4g}"
    elif row:
        result = f"{row['sweep ns/vertex']:.0f} ns a vertex"
    else:
        result = measurement.message
    origin = " (of an earlier session)" if measurement.is_reused else ""
    print(f"  {measurement.mesh.name} {measurement.words}: {result}{origin}", file=sys.stderr, flush=True)
