"""The figures: what is carried over from the sphere to the surface, where the distortion is, what options change."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from matplotlib.ticker import NullLocator
from measuring.commands import run_command
from measuring.maps import Statistics
from measuring.meshes import FORMATS, Mesh, MeshFile, read_mesh, write_mesh
from measuring.pictures import SAMPLES, Paint, Scale, paint, turned_like, view_of_surface
from measuring.runs import Program, Run
from PIL import Image
from patterns import Globe, planet, squares
from sheet import SMALL_TEXT, TEXT_COLOR, Sheet

SCALE = Scale(1.0, 8.0)  # of all figures, so that equal colors mean the same in each
ISOMETRIC_LABEL, ANGLE_LABEL = "$D_{\\mathrm{iso}}$", "$D_{\\mathrm{angle}}$"
EDGE_WIDTH = 1.0  # pixels
DIVISION = 32  # of the edges of the octahedron that is sampled

PREFERENCES = ("average", "balance", "worst")
# The hues of the scale of the distortion, and ways to draw a line that differ without colors.
LINES = (("#3b528b", "-"), ("#1f9e89", "--"), ("#c2560a", "-."))
RULES = (("two-phase", "o"), ("optimal", "s"), ("area", "^"), ("balanced", "D"))
FIXED_RADII = np.linspace(0.7, 1.6, 10)  # in radii of the sphere with the area of the surface


@dataclass(frozen=True)
class Model:
    """A surface; without a direction to the camera, it is looked at along its thinnest extent."""

    title: str
    file: str  # without the ending
    direction: tuple[float, float, float] | None = None
    up: tuple[float, float, float] | None = None


MODELS = {
    "armadillo": Model("armadillo", "armadillo_26002", (0.35, 0.2, -1.0)),
    "buddha": Model("buddha", "buddha_24992", (0.35, -0.9, 0.3), (0.0, 0.0, 1.0)),
    "bunny": Model("bunny", "bunny_20002", (0.2, 0.25, 0.95), (0.0, 1.0, 0.0)),
    "coarse bunny": Model("bunny", "bunny_3485", (0.2, 0.25, 0.95), (0.0, 1.0, 0.0)),
    "cow": Model("cow", "cow_2904"),
    "hand": Model("hand", "hand_10345"),
    "horse": Model("horse", "horse_19851", (0.9, 0.2, -0.5)),
    "max planck": Model("Max Planck", "maxplanck_15000", (0.75, 0.1, -0.75)),
    "steer": Model("steer", "shrec391_steer_4315"),
    "octopus": Model("octopus", "octopus_16554", (0.0, 0.8, 0.6), (0.0, 1.0, 0.0)),
}


class Mapped:
    """A model and one of its maps. The sphere is turned like the surface, and both are looked at from one side."""

    def __init__(self, model: Model, run: Run):
        self.title, self.run = model.title, run
        mesh = run.mesh.mesh
        self._vertices, self._faces = mesh.vertices, mesh.faces
        self._images = turned_like(mesh.vertices, run.map.unit_images, mesh.faces)
        self._view = view_of_surface(mesh.vertices, model.direction, model.up)
        # At the radius of eq. 11, which makes maps comparable.
        self.colors = SCALE.of_faces(run.distortion.isometric_of_faces, run.map.is_inverted)

    def surface(self, colors_of: Paint, size: int) -> np.ndarray:
        return paint(self._vertices, self._faces, self._view, size, colors_of, self._images)

    def sphere(self, colors_of: Paint, size: int, edge_width: float = 0.0) -> np.ndarray:
        view = self._view.of_sphere()
        return paint(self._images, self._faces, view, size, colors_of, self._images, edge_width)


@dataclass(frozen=True)
class Sampled:
    """A model, and what it is sampled to."""

    model: Model
    mesh: Mesh
    values: np.ndarray  # a measurement at each vertex: the distance from the middle
    remesh: Mesh
    carried_values: np.ndarray
    points: Image.Image
    normals: Image.Image


@dataclass(frozen=True)
class Repaired:
    """A model with holes and a handle, what the program has made of it, and the sphere."""

    model: Model
    damaged: tuple[np.ndarray, np.ndarray]  # vertices and faces
    mesh: Mesh
    is_patch: np.ndarray  # of each face
    images: np.ndarray


@dataclass(frozen=True)
class Matched:
    """Two models, and the map from one to the other."""

    models: tuple[Model, Model]
    first: Mesh
    second: Mesh
    places: np.ndarray  # of the vertices of the first one, on the second one
    directions: np.ndarray  # the same on its sphere
    images: np.ndarray  # of the vertices of the second one


class Session:
    """The program, and the meshes of a folder, or one `mesh` instead of all."""

    def __init__(self, program: Program, folder: Path | None, mesh: Path | None, scale: float):
        self._program, self._folder, self._scale = program, folder, scale
        self._stand_in = MeshFile(mesh) if mesh is not None else None

    def file_of(self, name: str) -> MeshFile | None:
        if self._stand_in is not None:
            return self._stand_in
        paths = (self._folder / (MODELS[name].file + ending) for ending in FORMATS)
        return next((MeshFile(path) for path in paths if path.is_file()), None)

    def sheet(self, width: float, height: float) -> Sheet:
        return Sheet(width, height, self._scale)

    def map(self, name: str, *options: str) -> Mapped:
        """Maps a model with the program; no figure can be drawn if that fails."""
        run = self._program.run(self.file_of(name), list(options), "figures")
        if not run.has_map:
            raise SystemExit(f"{run.mesh.path}: there is no map to draw. {run.message}")
        return Mapped(MODELS[name], run)

    def sample(self, name: str) -> Sampled:
        """Remeshes a model over an octahedron, and makes a geometry image of it."""
        file = self.file_of(name)
        points = file.mesh.vertices
        values = np.linalg.norm(points - points.mean(axis=0), axis=1)
        with tempfile.TemporaryDirectory() as folder:
            measured, remesh, image = (Path(folder) / name for name in ("values.ply", "remesh.ply", "image.png"))
            _write_values(measured, file.mesh, values)
            options = ["-o", remesh, "--transfer", measured, "--geometry-image", image, "--quiet"]
            outcome = run_command([self._program.path, "remesh", file.path, f"octahedron={DIVISION}", *options])
            if outcome.status != 0:
                raise SystemExit(outcome.message)
            images = [Image.open(path).convert("RGB") for path in (image, image.with_stem("image_normals"))]
            return Sampled(MODELS[name], file.mesh, values, read_mesh(remesh), _read_values(remesh), *images)


    def repair(self, name: str) -> Repaired:
        """Damages a model, and repairs and maps it."""
        vertices, faces = _damaged(self.file_of(name).mesh, np.asarray(MODELS[name].direction))
        with tempfile.TemporaryDirectory() as folder:
            damaged, repaired, sphere = (Path(folder) / name for name in ("damaged.off", "repaired.off", "sphere.off"))
            write_mesh(damaged, Mesh(vertices, faces))
            options = ["--repair", "--max-added-area", "1", "-o", sphere, "--repaired", repaired, "--quiet"]
            outcome = run_command([self._program.path, "map", damaged, *options])
            if outcome.status != 0:
                raise SystemExit(outcome.message)
            mesh = read_mesh(repaired)
            old = {tuple(corners) for corners in np.sort(vertices[faces].reshape(len(faces), -1)).tolist()}
            corners = np.sort(mesh.vertices[mesh.faces].reshape(len(mesh.faces), -1)).tolist()
            is_patch = np.array([tuple(one) not in old for one in corners])
            return Repaired(MODELS[name], (vertices, faces), mesh, is_patch, read_mesh(sphere).vertices)

    def match(self, first: str, second: str) -> Matched:
        """Maps a model onto another one."""
        files = [self.file_of(first), self.file_of(second)]
        with tempfile.TemporaryDirectory() as folder:
            result, directions = Path(folder) / "result.off", Path(folder) / "directions.off"
            names = [file.path for file in files]
            options = ["-o", result, "--sphere", directions, "--quiet"]
            outcome = run_command([self._program.path, "match", *names, *options])
            if outcome.status != 0:
                raise SystemExit(outcome.message)
            target = read_mesh(directions.with_stem("directions_target"))
            places = (read_mesh(result).vertices, read_mesh(directions).vertices)
            return Matched((MODELS[first], MODELS[second]), files[0].mesh, files[1].mesh, *places, target.vertices)


def _damaged(mesh: Mesh, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Cuts two holes into the side that is seen, and joins two faces at the top by a thin tube."""
    vertices, faces = mesh.vertices, mesh.faces
    middles = vertices[faces].mean(axis=1)
    extent = np.ptp(vertices, axis=0).max()
    seen = middles @ direction
    side = middles @ np.cross(direction, (0.0, 1.0, 0.0))
    nearest = [np.argmax(seen), np.argmax(seen + side)]
    high = np.flatnonzero(middles[:, 1] > np.quantile(middles[:, 1], 0.9))
    top = high[np.argmax(middles[high, 1])]
    other = high[np.argmax(np.linalg.norm(middles[high] - middles[top], axis=1))]
    a, b = faces[top], faces[other]
    tube = []
    for i in range(3):
        corners = a[i], a[(i + 1) % 3], b[(-i - 1) % 3], b[-i % 3]
        tube += [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]
    is_kept = np.ones(len(faces), bool)
    is_kept[[top, other]] = False
    for face in nearest:
        is_kept &= np.linalg.norm(middles - middles[face], axis=1) > 0.08 * extent
    return vertices, np.concatenate([faces[is_kept], tube])


def _write_values(path: Path, mesh: Mesh, values: np.ndarray) -> None:
    write_mesh(path, mesh)
    head, _, body = path.read_text(encoding="ascii").partition("element face")
    faces, _, numbers = body.partition("end_header\n")
    lines = numbers.splitlines()
    for v, value in enumerate(values):
        lines[v] += f" {value:.17g}"
    path.write_text(f"{head}property double value\nelement face{faces}end_header\n" + "\n".join(lines) + "\n")


def _read_values(path: Path) -> np.ndarray:
    """The last property of the vertices of a file of the program, all of whose properties are doubles."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    vertices = head.partition(b"element vertex ")[2].partition(b"element face")[0].split(b"\n")
    count, width = int(vertices[0]), sum(line.startswith(b"property double") for line in vertices)
    return np.frombuffer(body, "<f8", count * width).reshape(count, width)[:, -1]


def opening(session: Session, name: str) -> Sheet:
    """A surface and its sphere; corresponding points have equal colors, and the lines are meridians and parallels."""
    mapped = session.map(name)
    sheet, globe = session.sheet(1400, 700), Globe(step=15.0, width=0.5)
    sheet.place(mapped.surface(globe, sheet.pixels(690)), 5, 5)
    sheet.place(mapped.sphere(globe, sheet.pixels(600)), 770, 50)
    return sheet


def package_picture(session: Session, name: str) -> Sheet:
    """The same, small, for the overview of packages."""
    mapped = session.map(name)
    sheet, globe = session.sheet(260, 140), Globe(step=30.0, width=2.0)
    sheet.place(mapped.surface(globe, sheet.pixels(132)), 4, 4)
    sheet.place(mapped.sphere(globe, sheet.pixels(112)), 143, 14)
    return sheet


def texture(session: Session, name: str) -> Sheet:
    """A drawing in longitude and latitude, the sphere that it covers, and the surface that the sphere was made from."""
    mapped = session.map(name)
    sheet = session.sheet(1400, 500)
    sheet.place(_unrolled(planet, sheet.pixels(250)), 12, 105)
    sheet.place(mapped.sphere(planet, sheet.pixels(400)), 535, 30)
    sheet.place(mapped.surface(planet, sheet.pixels(440)), 950, 5)
    for x, text in ((262, "the texture"), (735, "on the sphere"), (1170, "on the surface")):
        sheet.text(x, 470, text)
    return sheet


def conformal(session: Session, name: str) -> Sheet:
    """The same squares of the sphere on a surface, by the default map and by the conformal one."""
    sheet = session.sheet(1400, 820)
    for i, (title, options) in enumerate((("isometric (default)", []), ("conformal", ["--energy", "conformal"]))):
        mapped = session.map(name, *options)
        distortion, x = mapped.run.distortion, 350 + 700 * i
        sheet.place(mapped.surface(squares, sheet.pixels(660)), 20 + 700 * i, 5)
        sheet.text(x, 700, title)
        sheet.text(x, 745, f"{ISOMETRIC_LABEL}: {_extremes(distortion.isometric)}")
        sheet.text(x, 790, f"{ANGLE_LABEL}: {_extremes(distortion.angle)}")
    return sheet


def distortion(session: Session, *names: str) -> Sheet:
    """Surface and sphere of several models, default settings."""
    width = 350
    sheet = session.sheet(width * len(names), 840)
    for i, name in enumerate(names):
        mapped, x = session.map(name), width * i
        sheet.place(mapped.surface(mapped.colors, sheet.pixels(336)), x + 7, 5)
        sheet.place(mapped.sphere(mapped.colors, sheet.pixels(290)), x + 30, 350)
        sheet.text(x + 0.5 * width, 668, mapped.title)
        sheet.text(x + 0.5 * width, 710, _extremes(mapped.run.distortion.isometric))
    sheet.color_bar(400, 758, 600, SCALE, ISOMETRIC_LABEL)
    return sheet


def remesh(session: Session, name: str) -> Sheet:
    """A surface with a measurement, a remesh over an octahedron that has it, too, and the geometry image."""
    sampled, sheet = session.sample(name), session.sheet(1400, 420)
    scale = Scale(sampled.values.min(), sampled.values.max())
    parts = (
        (5, sampled.mesh, sampled.values, "a measurement"),
        (355, sampled.remesh, sampled.carried_values, "on the remesh"),
    )
    for x, mesh, values, text in parts:
        view = view_of_surface(sampled.mesh.vertices, sampled.model.direction, sampled.model.up)
        colors = scale.of_faces(values[mesh.faces].mean(axis=1), np.zeros(len(mesh.faces), bool))
        sheet.place(paint(mesh.vertices, mesh.faces, view, sheet.pixels(340), colors, edge_width=EDGE_WIDTH), x, 5)
        sheet.text(x + 170, 385, text)
    for x, image, text in ((720, sampled.points, "its geometry image"), (1070, sampled.normals, "the normals")):
        size = (sheet.pixels(310), sheet.pixels(310))
        sheet.place(np.asarray(image.resize(size, Image.Resampling.BICUBIC)) / 255.0, x, 20)
        sheet.text(x + 155, 385, text)
    return sheet


def repair(session: Session, name: str) -> Sheet:
    """A surface with holes and a handle, what the program has made of it, and its sphere; what was added is orange.

    The inside of the surface is dark.
    """
    repaired, sheet = session.repair(name), session.sheet(1400, 490)
    grey, orange, dark = np.array([0.72, 0.72, 0.74]), np.array([0.92, 0.45, 0.05]), np.array([0.3, 0.18, 0.2])
    colors = np.where(repaired.is_patch[:, None], orange, grey)
    vertices, faces = repaired.damaged
    view = view_of_surface(vertices, repaired.model.direction, repaired.model.up)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    is_inside = np.cross(b - a, c - a) @ np.asarray(repaired.model.direction) < 0.0
    units = repaired.images / np.linalg.norm(repaired.images, axis=1, keepdims=True)
    images = turned_like(repaired.mesh.vertices, units, repaired.mesh.faces)
    parts = (
        (vertices, faces, view, np.where(is_inside[:, None], dark, grey), "the file"),
        (repaired.mesh.vertices, repaired.mesh.faces, view, colors, "repaired"),
        (images, repaired.mesh.faces, view.of_sphere(), colors, "its sphere"),
    )
    for k, (points, of_faces, camera, paints, text) in enumerate(parts):
        sheet.place(paint(points, of_faces, camera, sheet.pixels(430), paints, edge_width=EDGE_WIDTH), 20 + 465 * k, 5)
        sheet.text(235 + 465 * k, 470, text)
    return sheet


def surfaces(session: Session, first: str, second: str) -> Sheet:
    """A surface, what is half way to another one, and that one, with a pattern that is carried along."""
    matched, sheet, globe = session.match(first, second), session.sheet(1400, 400), Globe(step=15.0, width=1.2)
    start = _placed(matched.first.vertices, matched.places)
    parts = (
        (matched.first, start, matched.directions, matched.models[0].title),
        (matched.first, 0.5 * (start + matched.places), matched.directions, "half way"),
        (matched.second, matched.second.vertices, matched.images, matched.models[1].title),
    )
    for k, (mesh, vertices, images, text) in enumerate(parts):
        view = view_of_surface(vertices, matched.models[1].direction, matched.models[1].up)
        sheet.place(paint(vertices, mesh.faces, view, sheet.pixels(350), globe, images), 40 + 465 * k, 5)
        sheet.text(215 + 465 * k, 385, text)
    return sheet


def _placed(points: np.ndarray, others: np.ndarray) -> np.ndarray:
    """The points moved, turned and scaled to where others are, by least squares."""
    centered, target = points - points.mean(axis=0), others - others.mean(axis=0)
    u, s, v = np.linalg.svd(centered.T @ target)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    return others.mean(axis=0) + (s @ signs / np.sum(centered**2)) * centered @ (u * signs) @ v


def methods(session: Session, *names: str) -> Sheet:
    """The methods side by side. Inverted faces have a color that is not in the scale."""
    width, height = 280, 350
    columns = (
        ("harmonic", ["--method", "harmonic"]),
        ("hierarchical", ["--method", "hierarchical"]),
        ("as rigid\nas possible", ["--method", "arap"]),
        ("BLD as\npublished", ["--paper"]),
        ("BLD by\ndefault", []),
    )
    sheet = session.sheet(width * len(columns), 90 + height * len(names) + 82)
    for i, (title, options) in enumerate(columns):
        x = width * i
        sheet.text(x + 0.5 * width, 42, title)
        for j, name in enumerate(names):
            mapped, y = session.map(name, *options), 90 + height * j
            sheet.place(mapped.surface(mapped.colors, sheet.pixels(220)), x + 30, y)
            inverted = mapped.run.map.number_inverted
            lines = _extremes(mapped.run.distortion.isometric, "\n") + (f"\n{inverted:,} inverted" if inverted else "\n")
            sheet.text(x + 0.5 * width, y + 280, lines)
    sheet.color_bar(400, 90 + height * len(names), 600, SCALE, ISOMETRIC_LABEL)
    return sheet


def sharpness(session: Session, name: str) -> Sheet:
    """Three preferences: where the distortion is, and how many faces have more than so much."""
    sheet = session.sheet(1400, 940)
    axes = sheet.axes(165, 520, 1205, 320)
    for i, (preference, (color, dashes)) in enumerate(zip(PREFERENCES, LINES)):
        mapped = session.map(name, "--prefer", preference)
        of_faces = mapped.run.distortion.isometric_of_faces
        x = 20 + 460 * i
        sheet.place(mapped.surface(mapped.colors, sheet.pixels(310)), x + 65, 5)
        sheet.text(x + 220, 340, f"--prefer {preference}", family="monospace")
        sheet.text(x + 220, 382, _extremes(mapped.run.distortion.isometric))
        values = np.sort(of_faces[~np.isnan(of_faces)])
        shares = 1.0 - np.arange(len(values)) / len(values)
        axes.plot(values, shares, dashes, color=color, linewidth=sheet.length(4), label=f"--prefer {preference}")
        axes.plot(values[-1:], shares[-1:], "o", color=color, markersize=sheet.length(13), clip_on=False)
    sheet.color_bar(400, 425, 600, SCALE, ISOMETRIC_LABEL)
    axes.set(xscale="log", yscale="log", xlim=(1.0, None), ylim=(shares[-1] * 0.8, 1.2))
    axes.yaxis.set_major_formatter(lambda share, _: f"{100.0 * share:g} %")
    low, high = axes.xaxis.get_view_interval()
    ticks = [x for x in (1, 1.5, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100) if low <= x <= high]
    axes.xaxis.set_ticks(ticks, labels=[f"{x:g}" for x in ticks])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel(ISOMETRIC_LABEL)
    axes.set_ylabel("share of faces above", labelpad=sheet.length(8))
    _add_grid_and_legend(sheet, axes, "lower left", "monospace")
    return sheet


def radius_rules(session: Session, name: str) -> Sheet:
    """The distortion of maps to spheres of fixed radii, and of those whose radius the rules have chosen."""
    sheet = session.sheet(1400, 740)
    axes = sheet.axes(150, 20, 1220, 620)
    unit = np.sqrt(session.file_of(name).mesh.area() / (4.0 * np.pi))
    fixed = [session.map(name, "--radius", f"fixed={radius * unit:.6g}").run for radius in FIXED_RADII]
    by_rule = [(rule, marker, session.map(name, "--radius", rule).run) for rule, marker in RULES]
    for key, (color, dashes) in zip(("maximum", "average"), LINES):
        values = [getattr(run.own_distortion.isometric, key) for run in fixed]
        axes.plot(FIXED_RADII, values, dashes, color=color, linewidth=sheet.length(4), label=f"fixed=R: {key}")
    style = {"color": "none", "markeredgecolor": TEXT_COLOR, "markeredgewidth": sheet.length(3)}
    for rule, marker, run in by_rule:
        values = run.own_distortion.isometric
        x = run.map.own_radius / unit
        axes.plot(x, values.maximum, marker, markersize=sheet.length(20), label=rule, **style)
        axes.plot(x, values.average, marker, markersize=sheet.length(20), **style)
    axes.set_xlabel("radius, in radii of the sphere with the area of the surface")
    axes.set_ylabel(ISOMETRIC_LABEL)
    _add_grid_and_legend(sheet, axes, "upper center")
    return sheet


def _add_grid_and_legend(sheet: Sheet, axes, place: str, family: str = "sans-serif") -> None:
    axes.grid(True, linewidth=sheet.length(1), color="#cccccc")
    axes.set_axisbelow(True)
    font = {"family": family, "size": sheet.length(SMALL_TEXT)}
    axes.legend(loc=place, prop=font, framealpha=1.0, edgecolor="none")


def _unrolled(pattern: Callable[[np.ndarray], np.ndarray], height: int) -> np.ndarray:
    """A pattern in longitude and latitude, twice as wide as high."""
    fine = SAMPLES * height
    longitudes, latitudes = np.meshgrid(
        np.pi * ((np.arange(2 * fine) + 0.5) / fine - 1.0), np.pi * (0.5 - (np.arange(fine) + 0.5) / fine)
    )
    directions = [np.cos(latitudes) * np.sin(longitudes), np.sin(latitudes), np.cos(latitudes) * np.cos(longitudes)]
    picture = pattern(np.stack(directions, axis=-1))
    return picture.reshape(height, SAMPLES, 2 * height, SAMPLES, 3).mean(axis=(1, 3))


def _extremes(statistics: Statistics, separator: str = ", ") -> str:
    def text(x: float) -> str:
        return f"{x:.2f}" if x < 100 else f"{x:.0f}" if x < 10000 else f"{x:.1e}"

    return f"max {text(statistics.maximum)}{separator}avg {text(statistics.average)}"
