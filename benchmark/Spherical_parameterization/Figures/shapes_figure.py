#!/usr/bin/env python3
"""Usage: shapes_figure.py MESH.off RESULTS PICTURE.jpg

Draws what a surface is by its harmonics to the degrees 1, 5, 15, 30 and 60, and below it the first mode of the RESULTS of
python/examples/shape_modes.py, from -2 to 2 deviations. The Python module has to be found."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python/examples"))

import numpy as np
import shape_modes as example
from shape_modes import plt, sp

mesh, results, picture = map(Path, sys.argv[1:])
surface = example.read_surface(mesh, prefer="sampling")
coefficients, _ = sp.expand(*surface, 60)
degrees = (1, 5, 15, 30, 60)
shapes = [sp.reconstruct(coefficients[..., : n + 1, : n + 1], (surface[1], surface[2])).vertices for n in degrees]
rows = [("degree {}", degrees, shapes, surface[1])]
minus, faces = example.read_off(results / "mode1_minus.off")
plus, _ = example.read_off(results / "mode1_plus.off")
scores = (-2, -1, 0, 1, 2)
rows.append(("{:+} deviations", scores, [(minus * (2 - s) + plus * (2 + s)) / 4 for s in scores], faces))

figure, axes = plt.subplots(2, 5, figsize=(9, 4), subplot_kw={"projection": "3d"})
for ax_row, (name, numbers, shapes, faces) in zip(axes, rows):
    up = np.ptp(shapes[-1], axis=0).argmax()
    shapes = [np.roll(shape, 2 - up, axis=1) for shape in shapes]
    low, high = np.min(shapes, axis=(0, 1)), np.max(shapes, axis=(0, 1))
    wide = int(np.ptp(shapes[-1][:, :2], axis=0).argmax())
    for ax, number, shape in zip(ax_row, numbers, shapes):
        example.draw(ax, shape, faces, np.full(len(shape), 0.25))
        example.frame(ax, low, high, wide)
        ax.set_title("mean" if number == 0 else name.format(number), fontsize=9)
figure.subplots_adjust(0, 0, 1, 0.94, 0, 0.08)
figure.savefig(picture, dpi=130)
