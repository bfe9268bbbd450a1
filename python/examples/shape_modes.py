#!/usr/bin/env python3
"""From a folder of surfaces to their mean and the modes in which they vary.

    shape_modes.py FOLDER RESULTS                        people, animals, organs: all are registered to the first one
    shape_modes.py FOLDER RESULTS --standard-position    cells and other blobs: by spherical harmonics
    shape_modes.py --demo RESULTS                        the same with 100 cells that are made, whose two modes are known

FOLDER has OFF files as text: closed surfaces of triangles, without handles. RESULTS gets scores.csv, a line for each surface;
modes.png; and mean.off, mode1_minus.off, mode1_plus.off and so on, the mean and two standard deviations to both sides, with the
same faces."""

import argparse
import csv
import sys
import time
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # needs no screen
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import spherical_parameterization as sp


def read_off(path):
    """Returns vertices and faces; trimesh.load(path) and PyVista have them of other formats."""
    lines = (line.split("#")[0] for line in path.read_text().splitlines())
    words = " ".join(lines).split()
    if not words or words[0] != "OFF":
        sys.exit(f"{path} is no OFF file as text")
    n, m = int(words[1]), int(words[2])
    end = 4 + 3 * n
    polygons = np.array(words[end : end + 4 * m], int).reshape(m, 4)
    if (polygons[:, 0] != 3).any():
        sys.exit(f"{path} has other faces than triangles")
    return np.array(words[4:end], float).reshape(n, 3), polygons[:, 1:]


def write_off(path, vertices, faces):
    rows = ["%.9g %.9g %.9g" % tuple(p) for p in vertices] + ["3 %d %d %d" % tuple(f) for f in faces]
    path.write_text(f"OFF\n{len(vertices)} {len(faces)} 0\n" + "\n".join(rows) + "\n")


def read_surface(path, **settings):
    """Returns a surface with its map to the sphere."""
    vertices, faces = read_off(path)
    try:
        return vertices, faces, sp.parameterize(vertices, faces, **settings)[0]
    except sp.Error as error:
        sys.exit(f"{path}: {error}")


def register(paths, template):
    """Returns the vertices of each surface with the faces of the template, and these faces."""
    first = read_surface(template)
    shapes = []
    for path in paths:
        if path == template:
            shapes.append(first[0])
            continue
        surface = read_surface(path)
        directions, report = sp.map_surface(first, surface)
        shapes.append(sp.remesh(*surface, (first[1], directions)).vertices)
        print(f"{path.name}: energy {report.energy:.2f}" + (", UNCERTAIN: look at it" if report.is_uncertain else ""))
    return shapes, first[1]


def expand(paths, degree):
    """Returns the surface of each one's harmonics in standard position, and the faces of all of them."""
    shapes = []
    for path in paths:
        surface = read_surface(path, prefer="sampling")
        coefficients, fit = sp.expand(*surface, degree)
        coefficients, position = sp.standard_position(coefficients)
        even = sp.reconstruct(coefficients, ("icosahedron", 24))
        shapes.append(even.vertices)
        is_sure = position.axes_are_determined and position.signs_are_determined
        print(f"{path.name}: error {fit.error_over_surface:.2g}" + ("" if is_sure else ", UNCERTAIN: nearly symmetric"))
    return shapes, even.faces


def draw(axes, vertices, faces, values):
    triangles = vertices[faces]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = 0.65 + 0.35 * (normals @ [0.6, -0.5, 0.6]) / np.where(lengths > 0, lengths, 1)
    colors = plt.get_cmap("YlOrRd")(0.8 * values[faces].mean(axis=1))
    colors[:, :3] *= light[:, None]
    axes.add_collection3d(Poly3DCollection(triangles, facecolors=colors, edgecolors=colors, linewidths=0.2))


def frame(axes, low, high, wide):
    """Shows what is between two corners from a side where x, or y if `wide` is 1, goes across."""
    for i, axis in enumerate("xyz"):
        getattr(axes, f"set_{axis}lim")(low[i], high[i])
    axes.view_init(10, 0 if wide else -90)
    axes.set_box_aspect(high - low, zoom=1.15)
    axes.set_axis_off()


def draw_modes(path, result, faces, n):
    """Draws a row for each mode, all of the same size: the redder, the more it moves the place."""
    up = np.ptp(result.mean, axis=0).argmax()
    scores = [[0] * i + [score] for i in range(n) for score in (-2, 0, 2)]
    shapes = [np.roll(result.shape(score), 2 - up, axis=1) for score in scores]  # the longest side upright
    low, high = np.min(shapes, axis=(0, 1)), np.max(shapes, axis=(0, 1))
    wide = int(np.ptp(shapes[1][:, :2], axis=0).argmax())
    figure, axes = plt.subplots(n, 3, figsize=(9, 3.2 * n), subplot_kw={"projection": "3d"}, squeeze=False)
    for k, (ax, shape) in enumerate(zip(axes.flat, shapes)):
        moves = np.linalg.norm(result.modes[k // 3], axis=1)
        draw(ax, shape, faces, moves / moves.max())
        frame(ax, low, high, wide)
        name = f"mode {k // 3 + 1} ({result.shares[k // 3]:.0%}): " if k % 3 == 0 else ""
        ax.set_title(name + ("-2 deviations", "mean", "+2 deviations")[k % 3], fontsize=9)
    figure.subplots_adjust(0, 0, 1, 0.95, 0, 0.1)
    figure.savefig(path, dpi=120)


def make_cells(folder, n=100, seed=1):
    """Writes cells as OFF files, and returns the scores of their two modes: how long they are, and how much they are bent.

    Each cell has a mesh of its own, and lies somewhere else. The scores are uncorrelated, with the mean 0 and the deviation 1."""
    random = np.random.default_rng(seed)
    truth = np.linalg.qr(np.column_stack([np.ones(n), random.normal(size=(n, 2))]))[0][:, 1:] * np.sqrt(n - 1)
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    solid = sp.remesh(corners, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], corners, ("icosahedron", 8))
    folder.mkdir(parents=True, exist_ok=True)
    for k, (length, bend) in enumerate(truth):
        turns = [np.linalg.qr(random.normal(size=(3, 3)))[0] for _ in range(2)]
        of_mesh, of_cell = (turn * np.linalg.det(turn) for turn in turns)
        directions = solid.sphere @ of_mesh
        points = directions * [3.5 + 0.3 * length, 2, 1.4]
        points[:, 1:] *= 1 + 0.3 * directions[:, :1]  # thicker at one end
        points[:, 1] += (0.9 + 0.2 * bend) * directions[:, 0] ** 2
        points += 0.005 * random.normal(size=points.shape)
        write_off(folder / f"cell{k:03}.off", points @ of_cell + random.normal(size=3), solid.faces)
    return truth


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("results", type=Path)
    parser.add_argument("--demo", action="store_true", help="make 100 cells, and compare the modes with what is known")
    parser.add_argument("--template", help="the file of FOLDER that all others are registered to; by default the first one")
    parser.add_argument("--standard-position", action="store_true", help="compare by harmonics instead of a template")
    parser.add_argument("--degree", type=int, default=15, help="of the harmonics (%(default)s)")
    parser.add_argument("--same-size", action="store_true", help="scale all to the same size")
    parser.add_argument("--modes", type=int, default=3, help="how many are drawn and written (%(default)s)")
    options = parser.parse_args()

    start = time.perf_counter()
    options.results.mkdir(parents=True, exist_ok=True)
    if options.demo:
        options.folder = options.results / "cells"
        options.standard_position = True
        truth = make_cells(options.folder)
    elif options.folder is None:
        parser.error("FOLDER and RESULTS are needed, or --demo RESULTS")
    paths = sorted(options.folder.glob("*.off"))
    if len(paths) < 2:
        sys.exit(f"{options.folder} has {len(paths)} files whose names end with .off; two are needed at least")
    if options.standard_position:
        shapes, faces = expand(paths, options.degree)
    else:
        template = options.folder / options.template if options.template else paths[0]
        shapes, faces = register(paths, template)
    result = sp.shape_modes(shapes, align="similarity" if options.same_size else "rotation")

    n = min(options.modes, len(result.modes))
    write_off(options.results / "mean.off", result.mean, faces)
    for i in range(n):
        for score, name in ((-2, "minus"), (2, "plus")):
            write_off(options.results / f"mode{i + 1}_{name}.off", result.shape([0] * i + [score]), faces)
    with open(options.results / "scores.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["file"] + [f"mode{i + 1}" for i in range(len(result.modes))])
        table.writerows([path.name, *scores] for path, scores in zip(paths, result.scores))
    draw_modes(options.results / "modes.png", result, faces, n)
    deviations = result.deviations / len(result.mean) ** 0.5  # root mean square of how far vertices move
    for i in range(n):
        print(f"mode {i + 1}: {result.shares[i]:.1%} of the variance, deviation {deviations[i]:.3g}")
    if options.demo:
        for i, what in enumerate(("length", "bend")):
            print(f"{what}: correlation of mode {i + 1} {np.corrcoef(truth[:, i], result.scores[:, i])[0, 1]:+.4f}")
    print(f"{len(paths)} surfaces, {time.perf_counter() - start:.1f} s")


if __name__ == "__main__":
    main()
