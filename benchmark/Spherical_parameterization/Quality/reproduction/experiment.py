"""What all experiments share: runs, their tables, pictures and CSV files, and the words that they use alike."""

from __future__ import annotations

from dataclasses import dataclass, field

import matplotlib.pyplot as plt
import numpy as np
from measuring.meshes import MeshFile
from measuring.pictures import Scale, paint, turned_like, view_of_surface
from measuring.reports import DOTS_PER_INCH, Report, number, seconds, statistics, table
from measuring.runs import NOT_BIJECTIVE, Program, Run

from .models import Library

BLD, PACKAGE = "BLD, paper mode", "default of the package"
DEFAULT: list[str] = []
CONVERGED = ["--iterations", "10000"]  # enough for every run to converge; only then can results be compared
FULL_SWEEPS, SHORT_SWEEPS = 2000, 150  # of paper mode: 100 of eq. 6, and some of eq. 7

SIZE_OF_PICTURE, SIZE_OF_SHORT = 420, 40  # pixels of one surface or sphere
EDGE_WIDTH = 0.6  # pixels

METHOD, MESH, SIZE = {"method": "Method"}, {"mesh": "Mesh"}, {"size": "Vertices"}
ISOMETRIC = {"isometric": "D_iso max / avg / dev"}
ANGLE = {"angle": "D_angle max / avg / dev"}
ABOVE, INVERTED = {"above": "Faces above BLD's max"}, {"inverted": "Inverted"}
SWEEPS, SECONDS = {"sweeps": "Sweeps", "stop": "Ended"}, {"seconds": "Seconds"}


@dataclass
class Session:
    program: Program
    library: Library
    large: Library  # figure 10
    report: Report
    has_pictures: bool
    is_short: bool
    # The package's default and paper mode on the meshes of Table 1, by the kind of the copy.
    comparison: list[tuple[str, Run, Run]] = field(default_factory=list)

    @property
    def paper_sweeps(self) -> int:
        return SHORT_SWEEPS if self.is_short else FULL_SWEEPS

    def paper(self, *options: str) -> list[str]:
        """The options of paper mode. The short version ends it early, and the report says so."""
        return ["--paper", *options, *(["--iterations", str(SHORT_SWEEPS)] if self.is_short else [])]

    def forget_maps(self) -> None:
        """Frees what has been measured: the large meshes do not fit into memory all at once."""
        for run in self.program.runs:
            run.forget_map()
            run.mesh.forget()


class Experiment:
    """One section of the report. Rows are for its tables, records for its CSV file, cells for its picture."""

    def __init__(self, session: Session, name: str, title: str, text: str = ""):
        self.session, self.name, self.report, self.library = session, name, session.report, session.library
        self.rows: list[dict] = []
        self.records: list[dict] = []
        self.runs: list[Run] = []
        self._cells: list[list[tuple[Run, str]]] = []
        self._row_titles: list[str] = []
        self.report.begin_section(title, text)

    def run(self, file: MeshFile, options: list[str], **labels) -> Run:
        """Runs the program, and adds a row and a record with the labels."""
        run = self.session.program.run(file, options, self.name)
        self.runs.append(run)
        self.rows.append(shown(run) | labels)
        self.records.append(labels | run.row)
        return run

    def run_methods(self, file: MeshFile, methods: dict, bound="", measure="isometric", **labels) -> dict[str, Run]:
        """Runs several methods on a mesh, and adds a row of the picture.

        With a `bound`, one of the methods, those faces are counted that have more distortion than its worst one.
        """
        runs = {name: self.run(file, options, method=name, **labels) for name, options in methods.items()}
        cells = []
        for i, run in enumerate(runs.values(), -len(runs)):
            above = count_above(run, runs[bound], measure) if bound else None
            self.rows[i]["above"] = None if above is None else f"{above:,}"
            self.records[i] |= {} if above is None else {"faces_above_maximum_of_bound": above}
            cells.append((run, caption_of(run, measure, above)))
        self._cells.append(cells)
        self._row_titles.append(labels.get("what", file.name))
        return runs

    def add_text(self, text: str) -> None:
        if text:
            self.report.paragraph(text)

    def draw(self, caption: str, titles: list[str], high: float, measure: str = "isometric", has_edges=False) -> None:
        """Draws the maps of all calls of run_methods(): a row for each, a column for each method."""
        if not self.session.has_pictures or not self._cells:
            return
        size = SIZE_OF_SHORT if self.session.is_short else SIZE_OF_PICTURE
        shape = (len(self._cells), len(titles))
        figure, all_axes = plt.subplots(
            *shape, figsize=(2.8 * shape[1] + 1.1, 1.65 * shape[0] + 0.5), squeeze=False, layout="constrained"
        )
        scale = Scale(2.0 if measure == "angle" else 1.0, high)
        for axes, title in zip(all_axes[0], titles):
            axes.set_title(title, fontsize=9)
        for axes, title in zip(all_axes[:, 0], self._row_titles):
            axes.set_ylabel(title, fontsize=8)
        for axes, (run, text) in zip(all_axes.flat, (cell for row in self._cells for cell in row)):
            axes.set(xticks=[], yticks=[], frame_on=False)
            axes.set_xlabel(text, fontsize=8)
            axes.imshow(_surface_and_sphere(run, measure, scale, size, EDGE_WIDTH * has_edges))
        label = f"D_{'angle' if measure == 'angle' else 'iso'}; magenta: inverted"
        scale.add_bar(figure, ax=all_axes, aspect=25, label=label, pad=0.01)
        figure.savefig(self.report.folder / f"{self.name}.png", dpi=DOTS_PER_INCH)
        plt.close(figure)
        self.report.image(f"{self.name}.png", caption)

    def tabulate(self, columns: dict[str, str]) -> None:
        """Writes the rows since the last table."""
        if self.rows:
            self.report.paragraph(table(columns, self.rows))
        self.rows = []

    def finish(self, columns: dict[str, str], tells_inverted: bool = True) -> None:
        """Ends the section: the last table, the CSV file, and what failed, in the words of the program."""
        self.tabulate(columns)
        self.report.csv(f"{self.name}.csv", self.records)
        failures = []
        for run in self.runs:
            if not run.has_map:
                failures.append(f"{run.mesh.name}, `{run.command}`: no map. {run.message}")
            elif run.exit_status == NOT_BIJECTIVE and tells_inverted:
                failures.append(f"{run.mesh.name}, `{run.command}`: a map that is not one-to-one. {run.message}")
        self.report.items(failures)
        self.session.forget_maps()


def shown(run: Run) -> dict:
    """A row of a table in the report."""
    row = {"mesh": run.mesh.name, "size": f"{run.mesh.number_of_vertices:,}", "sweeps": run.sweeps}
    row |= {"seconds": seconds(run.seconds), "cpu_seconds": seconds(run.cpu_seconds), "stop": run.stop_reason}
    if not run.has_map:
        return row | {"isometric": "no map"}
    row |= {name: statistics(getattr(run.distortion, name)) for name in ("isometric", "area", "angle")}
    row |= {"own": statistics(run.own_distortion.isometric), "radius": number(run.map.own_radius, 5)}
    return row | {"inverted": f"{run.map.number_inverted:,}"}


def count_above(run: Run, bound: Run, measure: str) -> int | None:
    """Counts the faces of a map with more distortion than the largest of another map of the same mesh."""
    if not run.has_map or not bound.has_map:
        return None
    of_faces = getattr(run.distortion, f"{measure}_of_faces")
    return int((of_faces > getattr(bound.distortion, measure).maximum).sum())


def caption_of(run: Run, measure: str, above: int | None) -> str:
    """The paper's figures: maximum, average, faces above a bound, inverted ones."""
    if not run.has_map:
        return "no map"
    values = getattr(run.distortion, measure)
    counts = [f"{count:,}" for count in (above, run.map.number_inverted) if count is not None]
    return f"({', '.join([number(values.maximum, 2), number(values.average, 2), *counts])})"


def _surface_and_sphere(run: Run, measure: str, scale: Scale, size: int, edge_width: float) -> np.ndarray:
    if not run.has_map:
        return np.ones((size, 2 * size, 3))
    mesh = run.mesh.mesh
    colors = scale.of_faces(getattr(run.distortion, f"{measure}_of_faces"), run.map.is_inverted)
    view = view_of_surface(mesh.vertices)
    sphere = turned_like(mesh.vertices, run.map.unit_images, mesh.faces)
    parts = ((mesh.vertices, view), (sphere, view.of_sphere()))
    pictures = [paint(points, mesh.faces, camera, size, colors, edge_width=edge_width) for points, camera in parts]
    return np.concatenate(pictures, axis=1)
