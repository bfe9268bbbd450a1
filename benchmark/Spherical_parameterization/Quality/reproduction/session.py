"""What all experiments share: the program, the meshes, the report, and the words that they use alike."""

from __future__ import annotations

from dataclasses import dataclass, field

from measuring.mesh_files import MeshFile
from measuring.program import FOLDS, Program, Run
from measuring.report import Column, Report, number, seconds, statistics

from .models import Library
from .pictures import Cell, Painter, Picture

HARMONIC, HIERARCHICAL, ARAP = ["--method", "harmonic"], ["--method", "hierarchical"], ["--method", "arap"]
DEFAULT: list[str] = []
PAPER_ENERGY = ["--energy", "isometric", "--s-first", "0.1", "--s-last", "10"]
# Enough for every run to converge; only then can the results be compared.
CONVERGED = ["--iterations", "10000"]

SHORT_SWEEPS = 150  # of paper mode: 100 of eq. 6, and some of eq. 7
FULL_SWEEPS = 2000

MESH = Column("Mesh", "mesh", is_number=False)
SIZE = Column("Vertices / faces", "size")
ISOMETRIC = Column("D_iso max / avg / dev", "isometric")
AREA = Column("D_area max / avg / dev", "area")
ANGLE = Column("D_angle max / avg / dev", "angle")
FOLDED = Column("Folded", "folded")
SECONDS = Column("Seconds", "seconds")
CPU_SECONDS = Column("CPU seconds", "cpu_seconds")
SWEEPS = Column("Sweeps", "sweeps")
STOP = Column("Ended", "stop", is_number=False)
OWN_RADIUS = Column("D_iso max / avg at the map's own radius", "own")


@dataclass(frozen=True)
class Comparison:
    """The package's default and paper mode on the same mesh of Table 1."""

    kind: str  # of the copy
    default: Run
    paper: Run

    @property
    def mesh(self) -> MeshFile:
        return self.default.mesh


@dataclass
class Session:
    program: Program
    library: Library
    large: Library  # figure 10
    report: Report
    painter: Painter
    is_short: bool
    comparison: list[Comparison] = field(default_factory=list)

    @property
    def paper_sweeps(self) -> int:
        return SHORT_SWEEPS if self.is_short else FULL_SWEEPS

    def paper(self, *options: str) -> list[str]:
        """The options of paper mode. The short version ends it early, and the report says so."""
        return ["--paper", *options] + (["--iterations", str(SHORT_SWEEPS)] if self.is_short else [])

    def notes(self) -> list[str]:
        return list(dict.fromkeys(self.library.notes + self.large.notes))

    def draw(self, picture: Picture, caption: str) -> None:
        if self.painter.draw(picture):
            self.report.image(picture.name, caption)

    def forget_maps(self) -> None:
        """Frees what a section has measured: the large meshes do not fit into memory all at once."""
        for run in self.program.runs:
            run.forget_map()
        self.library.forget_meshes()
        self.large.forget_meshes()


def size_of(mesh: MeshFile) -> str:
    return f"{mesh.number_of_vertices:,} / {mesh.number_of_faces:,}"


def shown(run: Run, **labels: str) -> dict:
    """A row of a table in the report."""
    row = {"mesh": run.mesh.name, "size": size_of(run.mesh), **labels}
    row |= {"seconds": seconds(run.seconds), "cpu_seconds": seconds(run.cpu_seconds)}
    row |= {"sweeps": run.sweeps, "stop": run.stop_reason}
    if not run.has_map:
        return row | {"isometric": "no map"}
    row |= {name: statistics(getattr(run.distortion, name)) for name in ("isometric", "area", "angle")}
    own = run.own_distortion.isometric
    row["own"] = f"{number(own.maximum)} / {number(own.average)}"
    row["radius"] = number(run.map.own_radius, 5)
    row["folded"] = f"{run.map.number_folded:,}"
    return row


def record(run: Run, **labels) -> dict:
    """The same for the CSV file."""
    return {**labels, **run.row}


def failures(runs: list[Run]) -> list[str]:
    """Why there is no map, or a map with folds: in the words of the program."""
    lines = []
    for run in runs:
        if not run.has_map:
            lines.append(f"{run.mesh.name}, `{run.command}`: no map. {run.message}")
        elif run.exit_status == FOLDS:
            lines.append(
                f"{run.mesh.name}, `{run.command}`: a map that is not one-to-one (exit status 2). {run.message}"
            )
    return list(dict.fromkeys(line.strip() for line in lines))


def count_above(run: Run, bound: Run, measure: str = "D_iso") -> int | None:
    """Counts the faces of a map with more distortion than the largest of another map of the same mesh."""
    if not run.has_map or not bound.has_map:
        return None
    if measure == "D_angle":
        return int((run.distortion.angle_of_faces > bound.distortion.angle.maximum).sum())
    return int((run.distortion.isometric_of_faces > bound.distortion.isometric.maximum).sum())


def cell(run: Run, bound: Run | None = None, measure: str = "D_iso") -> Cell | str:
    """A map of a picture, with the paper's figures: max, avg, faces above the maximum of `bound`, folded ones."""
    if not run.has_map:
        return "no map"
    values = run.distortion.angle if measure == "D_angle" else run.distortion.isometric
    caption = f"{number(values.maximum, 2)}, {number(values.average, 2)}"
    if bound is not None:
        above = count_above(run, bound, measure)
        caption += "" if above is None else f", {above:,}"
    return Cell(run, f"({caption}, {run.map.number_folded:,})")
