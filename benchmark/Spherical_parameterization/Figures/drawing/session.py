"""What all figures share: maps, pictures of surfaces and spheres, and the scale of their colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from measuring.distortion import Statistics
from measuring.program import Program, Run
from rendering.colors import Scale
from rendering.painting import Paint, paint
from rendering.views import turned_like, view_of_sphere

from .models import Cast, Subject
from .sheet import Sheet

ISOMETRIC = Scale(1.0, 8.0)  # of all figures, so that equal colours mean the same in each
ISOMETRIC_LABEL, ANGLE_LABEL = "$D_{\\mathrm{iso}}$", "$D_{\\mathrm{angle}}$"
EDGE_WIDTH = 1.0  # pixels


@dataclass(frozen=True, eq=False)
class Mapped:
    """A subject and one of its maps. The sphere is turned like the surface, and both are looked at from one side."""

    subject: Subject
    run: Run

    @property
    def images(self) -> np.ndarray:
        mesh = self.subject.file.mesh
        return turned_like(mesh.vertices, self.run.map.unit_images, mesh.faces)

    @property
    def distortion_colors(self) -> np.ndarray:
        """The colours of the faces by their isometric distortion, at the radius that makes maps comparable."""
        return ISOMETRIC.of_faces(self.run.distortion.isometric_of_faces, self.run.map.is_folded)

    def surface(self, colors_of: Paint, size: int, edge_width: float = 0.0) -> np.ndarray:
        mesh = self.subject.file.mesh
        return paint(mesh.vertices, mesh.faces, self.subject.view(), size, colors_of, self.images, edge_width)

    def sphere(self, colors_of: Paint, size: int, edge_width: float = 0.0) -> np.ndarray:
        images, view = self.images, view_of_sphere(self.subject.view())
        return paint(images, self.subject.file.mesh.faces, view, size, colors_of, images, edge_width)


@dataclass
class Session:
    program: Program
    cast: Cast
    scale: float

    def sheet(self, width: float, height: float) -> Sheet:
        return Sheet(width, height, self.scale)

    def map(self, name: str, *options: str) -> Mapped:
        """Maps a model with the program; no figure can be drawn if that fails."""
        subject = self.cast.subject(name)
        run = self.program.run(subject.file, list(options), "figures")
        if not run.has_map:
            raise SystemExit(f"{subject.file.path}: there is no map to draw. {run.message}")
        return Mapped(subject, run)


def extremes(statistics: Statistics, separator: str = ", ") -> str:
    return f"max {_number(statistics.maximum)}{separator}avg {_number(statistics.average)}"


def _number(x: float) -> str:
    return f"{x:.2f}" if x < 100 else f"{x:.0f}" if x < 10000 else f"{x:.1e}"
