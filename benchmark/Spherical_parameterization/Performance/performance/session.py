"""What all sections share: the programs, the meshes, the report and the manual."""

from __future__ import annotations

import math
import statistics
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from measuring.mesh_files import MeshFile
from measuring.meshes import MeshError, subdivide_smoothly, write_off
from measuring.plots import Axes, draw
from measuring.program import Program
from measuring.report import Column, Report, table_text

from .benchmark_program import BenchmarkProgram, Job
from .manual import Manual

LEAST_VERTICES = 2500  # smaller meshes say little about speed
LEAST_VERTICES_OF_THREADS = 20_000
SIMPLIFIED_TO = (8, 4, 2)  # an eighth of the vertices and so on
LARGE = 300_000  # meshes that take seconds are measured less often

MESH = Column("Mesh", "mesh", is_number=False)
VERTICES = Column("Vertices", "vertices")


@dataclass
class Session:
    program: Program
    stages: BenchmarkProgram
    limits: BenchmarkProgram
    corpus: list[MeshFile]  # small ones first, at least one
    large: list[MeshFile]
    simplify: Path  # the program simplify_mesh
    folder_for_derived: Path
    report: Report
    manual: Manual
    threads: int
    repetitions: int
    paper_meshes: list[str]
    is_short: bool
    notes: list[str] = field(default_factory=list)
    objections: list[str] = field(default_factory=list)  # to what was measured
    _series: list[MeshFile] | None = None

    def one(self, name: str) -> MeshFile | None:
        return next((file for file in self.corpus + self.large if file.name == name), None)

    @property
    def series(self) -> list[MeshFile]:
        """One shape in several sizes: simplified, as it is, and subdivided."""
        if self._series is None:
            self._series = self._make_series()
        return self._series

    @property
    def measured_meshes(self) -> list[MeshFile]:
        """All that is measured stage by stage."""
        files = {file.path: file for file in self.corpus + self.large + self.series}
        return sorted(files.values(), key=lambda file: (file.number_of_vertices, file.name))

    @property
    def thread_counts(self) -> list[int]:
        return [1, self.threads] if self.threads > 1 and self.stages.has_threads else [1]

    def repetitions_of(self, mesh: MeshFile) -> int:
        return min(self.repetitions, 3) if mesh.number_of_vertices >= LARGE else self.repetitions

    def measure(self, jobs: list[Job]) -> None:
        """Measures all jobs once, then all again, so that a machine that gets slower is slower for all of them."""
        for repetition in range(max((job.repetitions for job in jobs), default=0)):
            for job in jobs if repetition % 2 == 0 else reversed(jobs):
                if repetition < job.repetitions:
                    job.program.measure(job, repetition)

    def rows(self, job: Job, row: int = 0) -> list[dict] | None:
        """A row of what each run of a job has given; None if any has failed."""
        tables = [job.program.measure(job, repetition).rows for repetition in range(job.repetitions)]
        return [table[row] for table in tables] if all(tables) else None

    def medians(self, job: Job, row: int = 0) -> dict | None:
        """The medians of a row of what a job has given; None if any of its runs has failed."""
        rows = self.rows(job, row)
        if rows is None:
            return None
        values = {}
        for key, first in rows[0].items():
            of_key = [of_run[key] for of_run in rows]
            if isinstance(first, float):
                values[key] = statistics.median(of_key)
            else:
                values[key] = first if len(set(of_key)) == 1 else "differs"
        return values

    def median_ratio(self, job: Job, other: Job, key: str) -> float:
        """The median of how many times as large a number is for a job as for another one in the same round.

        None of the runs may have failed.
        """
        pairs = zip(self.rows(job), self.rows(other), strict=False)  # the rounds that both have
        return statistics.median(row[key] / other_row[key] for row, other_row in pairs)

    def failures(self, jobs: list[Job]) -> list[str]:
        lines = []
        for job in jobs:
            for repetition in range(job.repetitions):
                measurement = job.program.measure(job, repetition)
                if measurement.message:
                    lines.append(f"{job.mesh.name}, `{measurement.words}`: {measurement.message}")
        return list(dict.fromkeys(lines))

    def draw(self, name: str, diagrams: list[Axes], caption: str) -> None:
        """Draws a figure for the report and the manual."""
        path = self.report.folder / name
        draw(path, diagrams)
        self.report.image(name, caption)
        self.manual.add_figure(path)

    def tell(self, section: str, text: str) -> None:
        """Adds a paragraph to the report and to the manual."""
        self.report.paragraph(text)
        self.manual.add(section, text)

    def tabulate(self, section: str, columns: list[Column], rows: list[dict]) -> None:
        """Adds a table to the report and to the manual."""
        if rows:
            self.tell(section, table_text(columns, rows))

    def _make_series(self) -> list[MeshFile]:
        first = self.corpus[0] if self.is_short else self.one("armadillo_26002") or self.corpus[-1]
        if not self.is_short and first.name != "armadillo_26002":
            self.notes.append(f"Growth: armadillo_26002 is not among the meshes; {first.name} is taken instead.")
        stem = first.name.rsplit("_", 1)[0]
        files = []
        for part in (2,) if self.is_short else SIMPLIFIED_TO:
            n = first.number_of_vertices // part
            if n < LEAST_VERTICES and not self.is_short:
                continue
            try:
                files.append(self._derived(f"{stem}_{n}", lambda path, n=n: self._write_simplified(first, n, path)))
            except MeshError as error:
                self.notes.append(f"Growth: {first.name} cannot be simplified to {n:,} vertices: {error}")
        files.append(first)
        try:
            mesh = first.mesh
            for _ in range(1 if self.is_short else 3):
                mesh = subdivide_smoothly(mesh)
                files.append(self._derived(f"{stem}_{len(mesh.vertices)}", lambda path, of=mesh: write_off(path, of)))
        except MeshError as error:
            self.notes.append(f"Growth: {first.name} cannot be subdivided: {error}")
        finally:
            first.forget()
        return files

    def _derived(self, name: str, write: Callable[[Path], None]) -> MeshFile:
        """The mesh of that name, which ends with the number of vertices; it is made if it is not there."""
        file = self.one(name)
        if file is not None:
            return file
        path = self.folder_for_derived / f"{name}.off"
        if not path.exists():
            self.folder_for_derived.mkdir(parents=True, exist_ok=True)
            part = path.with_name(f"{name}.part.off")
            write(part)
            part.replace(path)  # whole, or not there
        n_vertices = int(name.rsplit("_", 1)[1])
        return MeshFile(path, n_vertices, 2 * n_vertices - 4, "derived")

    def _write_simplified(self, file: MeshFile, n_vertices: int, path: Path) -> None:
        command = [str(self.simplify), str(file.path), str(n_vertices), str(path)]
        result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise MeshError(result.stderr.strip() or f"simplify_mesh ended with {result.returncode}")


def geometric_mean(values: list[float]) -> float:
    return math.exp(sum(math.log(value) for value in values) / len(values))


def span(values: list[float]) -> str:
    """From the lowest factor to the highest."""
    least, most = speed(min(values)), speed(max(values))
    return least if least == most else f"{least} to {most}"


def speed(x: float) -> str:
    """A factor, with as many digits as it is known to."""
    return f"{x:.0f}" if x >= 20 else f"{x:.1f}" if x >= 10 else f"{x:.2f}"
