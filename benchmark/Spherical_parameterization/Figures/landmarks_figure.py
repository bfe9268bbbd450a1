#!/usr/bin/env python3
"""Usage: landmarks_figure.py PROGRAM FIRST.off SECOND.off LANDMARKS1 LANDMARKS2 PICTURE.jpg

Draws the second surface with a pattern, and the first one with what it gets of that when the program maps it there, without and with
these landmarks. Of the figure in the manual, they are the vertices 2350, 3365, 4126, 4975 and 1185 of 8_gorilla_03 and 6, 4146, 4268,
3843 and 3023 of 8_man_07, as the pairs of measure_pairs.py are numbered. The third axis is up."""

import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import numpy as np
from measuring.commands import run_command
from measuring.meshes import read_mesh
from measuring.pictures import find_fragments, paint, view_of_surface
from patterns import Globe
from sheet import Sheet

SIZE = 420

program, first, second, *landmarks, picture = (Path(name).resolve() for name in sys.argv[1:])
marks = [np.loadtxt(path, int) for path in landmarks]
with tempfile.TemporaryDirectory() as folder:
    directions = Path(folder) / "directions.off"

    def images(*options):
        """returns where the vertices of the first surface are on the sphere of the second one"""
        outcome = run_command([program, "match", first, second, "--sphere", directions, "--quiet", *options])
        if outcome.status != 0:
            raise SystemExit(outcome.message)
        return read_mesh(directions).vertices

    parts = [
        (first, images(), (), "without landmarks"),
        (first, images("--landmarks", *landmarks), marks[0], f"with {len(marks[0])} landmarks"),
    ]
    parts.insert(0, (second, read_mesh(directions.with_stem("directions_target")).vertices, marks[1], "the target"))

sheet, globe = Sheet(1400, 500, 1.0), Globe(step=15.0, width=1.2)
for k, (path, places, dots, text) in enumerate(parts):
    mesh, x = read_mesh(path), 20 + 465 * k
    view = view_of_surface(mesh.vertices, up=(0.0, 0.0, 1.0))
    sheet.place(paint(mesh.vertices, mesh.faces, view, SIZE, globe, places), x, 5)
    sheet.text(x + SIZE / 2, 475, text)
    axes = sheet.axes(x, 5, SIZE, SIZE)
    axes.set(xlim=(0, SIZE), ylim=(SIZE, 0), zorder=1)
    axes.set_axis_off()
    pixels = view.pixels_of(mesh.vertices, SIZE)
    seen = find_fragments(pixels, mesh.faces, SIZE)
    depth = dict(zip(seen.pixel, seen.depth))
    for px, py, pz in pixels[list(dots)]:
        around = (int(py + i) * SIZE + int(px + j) for i in (-1, 0, 1) for j in (-1, 0, 1))
        if min(depth.get(pixel, pz) for pixel in around) <= pz + 3.0:
            axes.plot(px, py, "o", markersize=13, color="white", markeredgecolor="black", markeredgewidth=3)
sheet.save(picture)
