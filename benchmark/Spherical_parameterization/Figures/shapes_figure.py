#!/usr/bin/env python3
"""Usage: shapes_figure.py MESH.off RESULTS PICTURE.jpg

Draws what a surface is by its harmonics to the degrees 1, 5, 15, 30 and 60, and below it the first mode of the RESULTS of
python/examples/shape_modes.py, from -2 to 2 deviations. The Python module has to be found."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python/examples"))

import numpy as np
from shape_modes import draw, plt, sp

mesh, results, picture = map(Path, sys.argv[1:])
vertices, faces = sp.read_mesh(mesh)
sphere, _ = sp.parameterize(vertices, faces, prefer="sampling")
coefficients, _ = sp.expand(vertices, faces, sphere, 60)
degrees = (1, 5, 15, 30, 60)
shapes = [sp.reconstruct(coefficients[..., : n + 1, : n + 1], (faces, sphere)).vertices for n in degrees]
rows = [([f"degree {n}" for n in degrees], shapes, faces)]
(minus, faces), (plus, _) = (sp.read_mesh(results / f"mode1_{end}.off") for end in ("minus", "plus"))
scores = (-2, -1, 0, 1, 2)
names = [f"{s:+} deviations" if s else "mean" for s in scores]
rows.append((names, [(minus * (2 - s) + plus * (2 + s)) / 4 for s in scores], faces))

figure, axes = plt.subplots(2, figsize=(9, 5.4), layout="constrained")
grey = plt.cm.ScalarMappable(plt.Normalize(0, 1), "Greys")
for ax, (names, shapes, faces) in zip(axes, rows):
    depth, across, upright = np.argsort(np.ptp(shapes[-1], axis=0))
    view = np.eye(3)[[across, upright, depth]]
    view[2] *= np.linalg.det(view)  # no mirror
    shapes = [shape @ view.T for shape in shapes]
    low, high = np.min(shapes, axis=(0, 1)), np.max(shapes, axis=(0, 1))
    width = 1.1 * (high - low)[0]
    for k, (name, shape) in enumerate(zip(names, shapes)):
        draw(ax, shape, faces, np.full(len(shape), 0.25), grey, np.array([k * width, 0]))
        ax.text(k * width + (low[0] + high[0]) / 2, high[1], name, ha="center", va="bottom", fontsize=9)
    ax.set(xlim=(low[0], low[0] + len(shapes) * width), ylim=(low[1], high[1]), aspect="equal")
    ax.set_axis_off()
figure.savefig(picture, dpi=130)
