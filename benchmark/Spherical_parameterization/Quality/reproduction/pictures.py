"""Pictures as in figures 8, 9 and 11: surface and sphere side by side, coloured by distortion, folded faces yellow."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib
import numpy as np

from measuring.plots import DOTS_PER_INCH, plt
from measuring.program import Run

COLORS = "coolwarm"  # has no yellow, which is for folded faces
FOLDED_COLOR = (255, 221, 0)
SIZE = 420  # pixels of one surface or sphere
MARGIN = 1.04
MOST_ATTEMPTS = 5  # to get a virtual display


@dataclass(frozen=True)
class Cell:
    """A map in a picture, with the lines of text below it."""

    run: Run
    caption: str


@dataclass(frozen=True)
class Picture:
    """A grid of maps: one row for each mesh, one column for each method. A cell that is None stays empty."""

    name: str
    column_titles: list[str]
    row_titles: list[str]
    cells: list[list[Cell | str | None]]  # a text says why there is no map
    measure: str  # D_iso or D_angle
    largest: float  # the colour bar ends here
    has_edges: bool = False


class Painter:
    """Draws pictures, or says once why it cannot."""

    def __init__(self, mode: str, folder: Path):
        """mode: auto, required or none."""
        self._mode = mode
        self._folder = folder
        self.objection = "they were not asked for" if mode == "none" else ""

    def draw(self, picture: Picture) -> bool:
        """Returns whether the picture is there now."""
        if self.objection:
            return False
        with tempfile.TemporaryDirectory() as scratch:
            jobs = self._jobs(picture, Path(scratch))
            self.objection = _render(list(jobs.values()), Path(scratch))
            if self.objection and self._mode == "required":
                raise SystemExit(f"Pictures are required, but {self.objection}")
            if not self.objection:
                self._compose(picture, jobs)
        return not self.objection

    def _jobs(self, picture: Picture, scratch: Path) -> dict:
        jobs = {}
        for i, row in enumerate(picture.cells):
            for j, cell in enumerate(row):
                if not isinstance(cell, Cell):
                    continue
                colors = _colors(cell.run, picture.measure, picture.largest)
                mesh = cell.run.mesh.mesh
                surface = _placed(mesh.vertices)
                sphere = _turned_like(surface.points, cell.run.map.unit_images, mesh.faces)
                views = (("surface", surface), ("sphere", replace(surface, points=sphere, half_height=MARGIN)))
                for part, view in views:
                    stem = scratch / f"{i}_{j}_{part}"
                    np.savez(f"{stem}.npz", faces=mesh.faces, colors=colors, **vars(view))
                    names = {"input": f"{stem}.npz", "output": f"{stem}.png"}
                    jobs[i, j, part] = {**names, "size": SIZE, "has_edges": picture.has_edges}
        return jobs

    def _compose(self, picture: Picture, jobs: dict) -> None:
        rows, columns = len(picture.cells), len(picture.column_titles)
        size = (2.8 * columns + 1.1, 1.65 * rows + 0.5)
        figure, all_axes = plt.subplots(rows, columns, figsize=size, squeeze=False, layout="constrained")
        for i, row in enumerate(picture.cells):
            for j, cell in enumerate(row):
                axes = all_axes[i, j]
                axes.set(xticks=[], yticks=[], frame_on=False)
                if i == 0:
                    axes.set_title(picture.column_titles[j], fontsize=9)
                if j == 0:
                    axes.set_ylabel(picture.row_titles[i], fontsize=8)
                if isinstance(cell, Cell):
                    parts = [plt.imread(jobs[i, j, part]["output"]) for part in ("surface", "sphere")]
                    axes.imshow(np.concatenate(parts, axis=1))
                    axes.set_xlabel(cell.caption, fontsize=8)
                elif cell is not None:
                    axes.imshow(np.ones((SIZE, 2 * SIZE, 3)))
                    axes.text(0.5, 0.5, cell, ha="center", va="center", fontsize=8, transform=axes.transAxes)
        least = 2.0 if picture.measure == "D_angle" else 1.0
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(least, picture.largest), COLORS)
        label = f"{picture.measure}; yellow: folded"
        figure.colorbar(scale, ax=all_axes, aspect=25, label=label, extend="max", pad=0.01)
        figure.savefig(self._folder / picture.name, dpi=DOTS_PER_INCH)
        plt.close(figure)


@dataclass(frozen=True)
class View:
    """Points and how they are looked at."""

    points: np.ndarray
    direction: np.ndarray  # from the centre to the camera
    up: np.ndarray
    half_height: float  # of the picture, in the points' unit


def _colors(run: Run, measure: str, largest: float) -> np.ndarray:
    least = 2.0 if measure == "D_angle" else 1.0
    values = run.distortion.angle_of_faces if measure == "D_angle" else run.distortion.isometric_of_faces
    scaled = np.nan_to_num((values - least) / (largest - least), nan=1.0, posinf=1.0)
    colors = (255 * matplotlib.colormaps[COLORS](np.clip(scaled, 0.0, 1.0))[:, :3]).astype(np.uint8)
    colors[run.map.is_folded] = FOLDED_COLOR
    return colors


def _placed(vertices: np.ndarray) -> View:
    """Centres a surface, and looks at it along the direction in which it is thinnest."""
    points = vertices - 0.5 * (vertices.min(axis=0) + vertices.max(axis=0))
    _, axes = np.linalg.eigh(points.T @ points)
    direction = axes[:, 0] * (1.0 if axes[np.argmax(np.abs(axes[:, 0])), 0] > 0 else -1.0)
    up = np.array([0.0, 1.0, 0.0]) if abs(direction[1]) < 0.8 else np.array([0.0, 0.0, 1.0])
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    seen = points @ np.stack([right, np.cross(direction, right)], axis=1)
    points = points - 0.5 * (seen.min(axis=0) + seen.max(axis=0)) @ np.stack([right, np.cross(direction, right)])
    return View(points, direction, up, MARGIN * 0.5 * float((seen.max(axis=0) - seen.min(axis=0)).max()))


def _turned_like(points: np.ndarray, images: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Turns a sphere so that it lies like the surface: how the program leaves it is arbitrary and differs by method."""
    used = np.unique(faces)
    u, _, v = np.linalg.svd(images[used].T @ points[used])
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    return images @ (u * signs) @ v


def _render(jobs: list[dict], scratch: Path) -> str:
    """Returns why it failed, or nothing."""
    if not jobs:
        return ""
    job_file = scratch / "jobs.json"
    job_file.write_text(json.dumps(jobs))
    command = [sys.executable, str(Path(__file__).with_name("render.py")), str(job_file)]
    if not os.environ.get("DISPLAY"):
        if shutil.which("xvfb-run") is None:
            return "there is no display, and no xvfb-run (packages xvfb and xauth)"
        command = ["xvfb-run", "-a", *command]
    # Now and then a virtual display is started on the place of one that is just ending, and takes no connection.
    for _ in range(MOST_ATTEMPTS):
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
        if "bad X server connection" not in answer.stderr:
            break
    if answer.returncode == 0 and all(Path(job["output"]).exists() for job in jobs):
        return ""
    if "No module named 'vtk" in answer.stderr:
        return "VTK for Python is not installed (package python3-vtk9)"
    if "bad X server connection" in answer.stderr:
        return "the display takes no connection"
    lines = [line for line in answer.stderr.splitlines() if line.strip()]
    return "rendering with VTK failed: " + (lines[-1] if lines else f"exit status {answer.returncode}")
