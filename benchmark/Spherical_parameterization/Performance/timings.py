"""Times the program on meshes, many times and in turns, and runs the kernels."""

from __future__ import annotations

import json
import statistics
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from measuring.commands import run_command
from measuring.meshes import MeshFile, checksum, write_mesh
from measuring.runs import STAGES, Program, Run

TOTAL = "mesh to map"
MIN_TIME = 0.05  # seconds of each repetition of a kernel


@dataclass(frozen=True)
class Job:
    """The program on one mesh, which is to be timed several times."""

    mesh: MeshFile
    threads: int
    arguments: tuple[str, ...] = ()
    repetitions: int = 1
    purpose: str = ""  # jobs with another purpose are measured anew, next to what they are compared with
    copies: int = 1  # that run at the same time; the result is their mean

    def __str__(self) -> str:
        at_once = f", {self.copies} at once" if self.copies > 1 else ""
        return f"{self.mesh.name}, `{' '.join(('--threads', str(self.threads), *self.arguments))}`{at_once}"


class Timings:
    """The figures of each run: seconds, distortions, and a fingerprint that equal maps have in common."""

    def __init__(self, program: Path, folder: Path, max_seconds: float):
        self._path, self._folder, self._max_seconds = program, folder, max_seconds
        self._programs: dict[int, Program] = {}
        self.rows: dict[Job, list[dict]] = {}
        self.failures: dict[Job, str] = {}

    def measure(self, jobs: list[Job]) -> None:
        """Measures all jobs once, then all again, so that a machine that gets slower is slower for all of them."""
        new = [job for job in jobs if job not in self.rows]
        for job in new:
            self.rows[job] = []
        for repetition in range(max((job.repetitions for job in new), default=0)):
            for job in new if repetition % 2 == 0 else reversed(new):
                if repetition < job.repetitions and job not in self.failures:
                    self._measure_once(job)

    def medians(self, job: Job) -> dict | None:
        """The medians of the figures of a job; None if any of its runs has failed."""
        self.measure([job])
        return None if job in self.failures else _summary(self.rows[job], statistics.median)

    def median_ratio(self, job: Job, other: Job, key: str) -> float:
        """The median of how many times as large a figure is for a job as for another one in the same round."""
        pairs = zip(self.rows[job], self.rows[other])
        return statistics.median(row[key] / other_row[key] for row, other_row in pairs)

    def different_maps(self) -> list[str]:
        """What must not be: maps of one mesh that differ between runs, whatever the number of threads."""
        fingerprints: dict[tuple, set[str]] = {}
        for job, rows in self.rows.items():
            found = fingerprints.setdefault((job.mesh.name, *job.arguments), set())
            found.update(row["fingerprint"] for row in rows)
        different = [" ".join(key) for key, found in fingerprints.items() if len(found) > 1]
        return [f"{key}: the map differs between runs" for key in different]

    def program(self, threads: int) -> Program:
        if threads not in self._programs:
            self._programs[threads] = Program(self._path, threads, self._folder, max_seconds=self._max_seconds)
        return self._programs[threads]

    def _measure_once(self, job: Job) -> None:
        program = self.program(job.threads)
        with ThreadPoolExecutor(job.copies) as executor:
            stems = [self._folder / f"copy_{i}" for i in range(job.copies)]
            runs = list(executor.map(lambda stem: program.execute(job.mesh, job.arguments, stem), stems))
        failed = next((run for run in runs if run.exit_status != 0), None)
        if failed is not None:
            self.failures[job] = failed.message or f"exit status {failed.exit_status}"
            text = self.failures[job]
        else:
            row = _summary([_figures(run) for run in runs], statistics.fmean)
            self.rows[job].append(row)
            text = f"{row[TOTAL]:.3f} s, D_iso {row['D_iso max']:.4g} / {row['D_iso avg']:.4g}"
        print(f"  {job}: {text}", file=sys.stderr, flush=True)


def _figures(run: Run) -> dict:
    reported, distortion = run.report["seconds"], run.report["distortion"]["D_iso"]
    figures = {name: reported[stage] for name, stage in STAGES.items()}
    figures |= {TOTAL: run.mapping_seconds, "parsing": reported["input"]}
    figures |= {"D_iso max": distortion["maximum"], "D_iso avg": distortion["average"], "sweeps": float(run.sweeps)}
    return figures | {"fingerprint": checksum(run.sphere), "stop": run.stop_reason}


def _summary(rows: list[dict], mean) -> dict:
    """The mean of some kind of numbers; of other cells, what all say."""
    summary = {}
    for key, first in rows[0].items():
        of_key = [row[key] for row in rows]
        summary[key] = mean(of_key) if isinstance(first, float) else first if len(set(of_key)) == 1 else "differs"
    return summary


class Kernels:
    """The program kernel_benchmark, which reads OFF files only; others are converted into a folder."""

    def __init__(self, path: Path, folder: Path, max_seconds: float):
        self._path, self._folder, self._max_seconds = path, folder, max_seconds

    def run(self, mesh: MeshFile, kernels: str, threads: int, repetitions: int = 1) -> dict[str, list[dict]] | str:
        """For each kernel that matches, the results and counters of its repetitions; or why there are none. Kernels of
        several threads have an ending in their names.
        """
        path = mesh.path
        if path.suffix != ".off":
            path = self._folder / f"{mesh.name}.off"
            if not path.exists():
                write_mesh(path, mesh.mesh)
                mesh.forget()
        settings = {"format": "json", "filter": kernels, "repetitions": repetitions, "min_time": MIN_TIME}
        settings = [f"--benchmark_{name}={value}" for name, value in settings.items()]
        outcome = run_command([self._path, *settings, f"--threads={threads}", path], self._max_seconds)
        if outcome.status != 0:
            return outcome.message
        print(f"  {mesh.name}, {kernels}, {threads} threads", file=sys.stderr, flush=True)
        results: dict[str, list[dict]] = {}
        for entry in json.loads(outcome.output)["benchmarks"]:
            if entry["run_type"] == "iteration":
                results.setdefault(entry["name"], []).append(entry)
        return results
