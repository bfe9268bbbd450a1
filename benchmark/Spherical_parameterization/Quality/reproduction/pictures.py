"""Pictures as in figures 8, 9 and 11: surface and sphere side by side, coloured by distortion, folded faces magenta."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from measuring.plots import DOTS_PER_INCH, plt
from measuring.program import Run
from rendering.colors import Scale
from rendering.painting import paint
from rendering.views import turned_like, view_of_sphere, view_of_surface

SIZE, SIZE_OF_SHORT = 420, 100  # pixels of one surface or sphere
EDGE_WIDTH = 0.6  # pixels


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

    @property
    def scale(self) -> Scale:
        return Scale(2.0 if self.measure == "D_angle" else 1.0, self.largest)


class Painter:
    """Draws pictures into a folder, or nothing if there is none; small ones if nobody is to look at them."""

    def __init__(self, folder: Path | None, is_short: bool):
        self._folder = folder
        self._size = SIZE_OF_SHORT if is_short else SIZE

    @property
    def is_idle(self) -> bool:
        return self._folder is None

    def draw(self, picture: Picture) -> bool:
        """Returns whether the picture is there now."""
        if self.is_idle:
            return False
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
                    axes.imshow(_surface_and_sphere(cell.run, picture, self._size))
                    axes.set_xlabel(cell.caption, fontsize=8)
                elif cell is not None:
                    axes.imshow(np.ones((self._size, 2 * self._size, 3)))
                    axes.text(0.5, 0.5, cell, ha="center", va="center", fontsize=8, transform=axes.transAxes)
        scale = picture.scale
        label = f"{picture.measure}; magenta: folded"
        bar = figure.colorbar(scale.mappable, ax=all_axes, aspect=25, label=label, extend="max", pad=0.01)
        bar.set_ticks(scale.ticks, labels=[f"{tick:g}" for tick in scale.ticks])
        bar.minorticks_off()
        figure.savefig(self._folder / picture.name, dpi=DOTS_PER_INCH)
        plt.close(figure)
        return True


def _surface_and_sphere(run: Run, picture: Picture, size: int) -> np.ndarray:
    distortion = run.distortion
    values = distortion.angle_of_faces if picture.measure == "D_angle" else distortion.isometric_of_faces
    colors = picture.scale.of_faces(values, run.map.is_folded)
    mesh, edge_width = run.mesh.mesh, EDGE_WIDTH if picture.has_edges else 0.0
    view = view_of_surface(mesh.vertices)
    sphere = turned_like(mesh.vertices, run.map.unit_images, mesh.faces)
    parts = ((mesh.vertices, view), (sphere, view_of_sphere(view)))
    return np.concatenate(
        [paint(points, mesh.faces, camera, size, colors, edge_width=edge_width) for points, camera in parts], axis=1
    )
