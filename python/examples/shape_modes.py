#!/usr/bin/env python3
"""Computes the mean and the shape modes (principal components) of a folder of surfaces.

    shape_modes.py FOLDER RESULTS                        people, animals, organs: registers all to the first one
    shape_modes.py FOLDER RESULTS --standard-position    cells and other blobs: compares spherical harmonics
    shape_modes.py --demo RESULTS                        generates 100 cells with two known modes

FOLDER contains OFF, OBJ, PLY or STL files, or links to them: closed triangle meshes of genus 0. RESULTS, another folder, gets
scores.csv, with a line for each surface; modes.csv, with a line for each mode; modes.png; and mean.off, mode1_minus.off,
mode1_plus.off and so on: the mean, and the shapes two standard deviations to both sides of it, with the same faces."""

import argparse
import csv
import sys
import time
from pathlib import Path

try:
    import matplotlib

    matplotlib.use("Agg")  # needs no screen
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.collections import PolyCollection

    import spherical_parameterization as sp
except ImportError as error:
    sys.exit(
        f"{error}, in {sys.executable}.\ninstall numpy, matplotlib and spherical_parameterization for this"
        " Python, as in build/venv/bin/python of the page 'From a Folder of Shapes to Their Mean and Modes'."
    )


def write_off(path, vertices, faces):
    rows = ["%.9g %.9g %.9g" % tuple(p) for p in vertices] + ["3 %d %d %d" % tuple(f) for f in faces]
    path.write_text(f"OFF\n{len(vertices)} {len(faces)} 0\n" + "\n".join(rows) + "\n")


def read_surfaces(paths):
    """Return the vertices and faces of each file. Exit with a list of all defects if there is any."""
    surfaces, wrong = [], []
    for path in paths:
        try:
            vertices, faces = sp.read_mesh(path)
            defect = sp.find_defect(vertices, faces)
        except sp.Error as error:  # contains the name of the file
            wrong.append(str(error))
            continue
        if defect:
            wrong.append(f"{path}: {defect}")
        elif np.linalg.det(vertices[faces] - vertices[faces[0, 0]]).sum() < 0:  # six times the volume
            print(f"{path.name}: is inside out; its faces are reversed")
            faces = faces[:, ::-1]
        surfaces.append((vertices, faces))
    if wrong:
        sys.exit("\n\n".join(wrong) + f"\n\n{len(wrong)} of {len(paths)} files cannot be used: repair or remove them.")
    return surfaces


def register(surfaces, template):
    """Yield for each surface its vertices with the faces of the template, these faces, a note, and whether the map is reliable."""
    first = (*surfaces[template], sp.parameterize(*surfaces[template])[0])
    for k, surface in enumerate(surfaces):
        if k == template:
            yield first[0], first[1], "is the template", True
            continue
        surface = (*surface, sp.parameterize(*surface)[0])
        directions, report = sp.map_surface(first, surface)
        vertices = sp.remesh(*surface, (first[1], directions)).vertices
        yield vertices, first[1], f"energy {report.energy:.2f}", not report.is_uncertain


def expand(surfaces, degree):
    """Yield the same for the surface of the harmonics in standard position, with the faces of an icosahedron."""
    for vertices, faces in surfaces:
        sphere, _ = sp.parameterize(vertices, faces)
        coefficients, fit = sp.expand(vertices, faces, sphere, degree)
        coefficients, position = sp.standard_position(coefficients)
        even = sp.reconstruct(coefficients, ("icosahedron", max(24, degree // 2)))  # twice as many vertices as coefficients
        is_sure = position.axes_are_determined and position.signs_are_determined
        yield even.vertices, even.faces, f"error {fit.error_over_surface:.2g}", is_sure


def draw(axes, vertices, faces, moves, colors, offset):
    """Draw a surface as seen from the positive z-axis, translated by `offset` in x and y."""
    triangles = vertices[faces]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    order = np.argsort(triangles[:, :, 2].mean(axis=1))  # from back to front
    order = order[normals[order, 2] > 0]
    normals = normals[order] / np.linalg.norm(normals[order], axis=1)[:, None]
    rgba = colors.to_rgba(moves[faces[order]].mean(axis=1))
    rgba[:, :3] *= (0.65 + 0.35 * normals @ [0.5, 0.6, 0.6])[:, None]
    axes.add_collection(PolyCollection(triangles[order, :, :2] + offset, facecolors=rgba, edgecolors=rgba, linewidths=0.2))


def draw_modes(path, result, faces, n, up):
    """Draw a row for each mode at the same scale. Colors show the displacement of each point by one standard deviation."""
    upright = np.eye(3)["xyz".index(up)]
    across = max(np.eye(3)[upright == 0], key=lambda axis: np.ptp(result.mean @ axis))
    front = np.cross(across, upright)
    view = np.array([across, 0.97 * upright - 0.24 * front, 0.97 * front + 0.24 * upright])  # from slightly above
    shapes = [result.shape([0] * i + [score]) @ view.T for i in range(n) for score in (-2, 0, 2)]
    low, high = (f(shapes, axis=(0, 1))[:2] for f in (np.min, np.max))
    width, height = (high - low) * 1.1
    height += 0.1 * width  # for the title
    moves = np.linalg.norm(result.modes[:n], axis=2) * result.deviations[:n, None]
    colors = plt.cm.ScalarMappable(plt.Normalize(0, moves.max()), "YlOrRd")
    figure, axes = plt.subplots(figsize=(13, 0.3 + 3.8 * n * height / width), layout="constrained")
    for k, shape in enumerate(shapes):
        offset = np.array([k % 3 * width, -(k // 3) * height])
        draw(axes, shape, faces, moves[k // 3], colors, offset)
        name = f"mode {k // 3 + 1} ({result.shares[k // 3]:.0%}): " if k % 3 == 0 else ""
        title = name + ("-2 deviations", "mean", "+2 deviations")[k % 3]
        axes.text(*(offset + [(low[0] + high[0]) / 2, high[1] + 0.03 * width]), title, ha="center", fontsize=11)
    axes.set(xlim=(low[0], low[0] + 3 * width), ylim=(high[1] - n * height + 0.1 * width, high[1] + 0.1 * width), aspect="equal")
    axes.set_axis_off()
    figure.colorbar(colors, ax=axes, label="displacement by one standard deviation", fraction=0.02, shrink=min(0.9, 1.2 / n))
    figure.savefig(path, dpi=110)


def make_cells(folder, n=100, seed=1):
    """Write cells as OFF files. Return the files and the scores of the two modes, length and bend.

    Each cell has its own irregular mesh and its own pose. The scores are uncorrelated, with mean 0 and standard deviation 1.
    """
    random = np.random.default_rng(seed)
    truth = np.linalg.qr(np.column_stack([np.ones(n), random.normal(size=(n, 2))]))[0][:, 1:] * np.sqrt(n - 1)
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    folder.mkdir(parents=True, exist_ok=True)
    paths = [folder / f"cell{k:03}.off" for k in range(n)]
    for path, (length, bend) in zip(paths, truth):
        solid = (("octahedron", "cube", "icosahedron")[random.integers(3)], int(random.integers(10, 14)))
        mesh = sp.remesh(corners, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], corners, solid)
        of_mesh, of_cell = (q * np.linalg.det(q) for q in np.linalg.qr(random.normal(size=(2, 3, 3)))[0])
        directions = mesh.sphere @ of_mesh + 0.015 * random.normal(size=mesh.sphere.shape)
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        points = directions * [3.5 + 0.3 * length, 2, 1.4]
        points[:, 1:] *= 1 + 0.3 * directions[:, :1]  # thicker at one end
        points[:, 1] += (0.9 + 0.2 * bend) * directions[:, 0] ** 2
        points += 0.005 * random.normal(size=points.shape)
        write_off(path, points @ of_cell + random.normal(size=3), mesh.faces)
    return paths, truth


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, metavar="FOLDER", help="folder of the surfaces; not with --demo")
    parser.add_argument("results", type=Path, metavar="RESULTS", help="folder for the results, created if missing")
    parser.add_argument("--demo", action="store_true", help="generate 100 cells in RESULTS/cells and compare the modes with the known ones")
    parser.add_argument("--template", metavar="FILE", help="file of FOLDER to which all others are registered (the first one by name)")
    parser.add_argument("--standard-position", action="store_true", help="compare spherical harmonics instead of registering to a template")
    parser.add_argument("--degree", type=int, metavar="L", help="degree of the harmonics, 1 to 200, with --standard-position (15)")
    parser.add_argument("--same-size", action="store_true", help="scale all surfaces to the same size, so that no mode describes size")
    parser.add_argument("--modes", type=int, default=3, metavar="N", help="number of modes to draw and to write as surfaces (%(default)s)")
    parser.add_argument("--up", choices="xyz", default="y", help="vertical axis of the picture (%(default)s)")
    options = parser.parse_args()
    if (options.folder is None) != options.demo:
        parser.error("FOLDER and RESULTS are needed, or --demo RESULTS")
    options.standard_position |= options.demo
    if options.standard_position and options.template:
        parser.error("--template is for registration: remove it, or --standard-position or --demo")
    if options.degree is not None and not options.standard_position:
        parser.error("--degree needs --standard-position")
    options.degree = 15 if options.degree is None else options.degree
    if not 1 <= options.degree <= 200:
        parser.error(f"--degree is {options.degree}; it has to be from 1 to 200")
    if options.modes < 1:
        parser.error(f"--modes is {options.modes}; it has to be at least 1")
    if options.folder is not None and options.folder.resolve() == options.results.resolve():
        parser.error("RESULTS has to be another folder than FOLDER: otherwise, its surfaces would become shapes of the next run")
    if options.results.is_file():
        parser.error(f"RESULTS has to be a folder, but {options.results} is a file")
    return options


def find_files(options):
    """Return the mesh files of the folder, and the index of the template."""
    if not options.folder.is_dir():
        sys.exit(f"{options.folder} is not a folder")
    endings = (".off", ".obj", ".ply", ".stl")
    paths = sorted(path for path in options.folder.iterdir() if path.suffix.lower() in endings and path.is_file())
    if len(paths) < 2:
        sys.exit(f"{options.folder} has {len(paths)} {', '.join(endings)} files; modes need at least two")
    if not options.template:
        return paths, 0
    for k, path in enumerate(paths):
        if path.name == options.template or path.resolve() == Path(options.template).resolve():
            return paths, k
    sys.exit(f"--template {options.template} is not one of the {len(paths)} surfaces of {options.folder}")


def check_degree(degree, paths, surfaces):
    n, path = min((len(np.unique(faces)), path) for (_, faces), path in zip(surfaces, paths))
    highest = int(n**0.5) - 1
    if degree > highest:
        sys.exit(
            f"--degree {degree} has {(degree + 1) ** 2} coefficients, but {path} has only {n} vertices: degrees above {highest}"
            f" would describe its flat faces. Choose --degree {highest} or less, or finer meshes."
        )


def main():
    sys.stdout.reconfigure(line_buffering=True)  # also into a pipe
    options = read_options()
    start = time.perf_counter()
    options.results.mkdir(parents=True, exist_ok=True)
    if options.demo:
        paths, truth = make_cells(options.results / "cells")
    else:
        paths, template = find_files(options)
    surfaces = read_surfaces(paths)
    if options.standard_position:
        check_degree(options.degree, paths, surfaces)
        steps = expand(surfaces, options.degree)
    else:
        steps = register(surfaces, template)
    shapes, uncertain = [], []
    try:
        for path, (vertices, faces, text, is_sure) in zip(paths, steps):
            print(f"{path.name}: {text}" + ("" if is_sure else ", UNCERTAIN"))
            shapes.append(vertices)
            uncertain += [] if is_sure else [path]
    except sp.Error as error:
        sys.exit(f"{paths[len(shapes)]}: {error}")
    result = sp.shape_modes(shapes, align="similarity" if options.same_size else "rotation")
    if len(result.modes) == 0:
        sys.exit("All surfaces are the same: there is no mode.")

    n = min(options.modes, len(result.modes))
    write_off(options.results / "mean.off", result.mean, faces)
    for i in range(n):
        for score, name in ((-2, "minus"), (2, "plus")):
            write_off(options.results / f"mode{i + 1}_{name}.off", result.shape([0] * i + [score]), faces)
    for path in uncertain:
        write_off(options.results / f"uncertain_{path.stem}.off", result.shape(result.scores[paths.index(path)]), faces)
    with open(options.results / "scores.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["file"] + [f"mode{i + 1}" for i in range(len(result.modes))])
        table.writerows([path.name, *scores] for path, scores in zip(paths, result.scores))
    deviations = result.deviations / len(result.mean) ** 0.5  # root mean square displacement of the vertices
    with open(options.results / "modes.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["mode", "share", "deviation"])
        table.writerows((i + 1, *row) for i, row in enumerate(zip(result.shares, deviations)))
    draw_modes(options.results / "modes.png", result, faces, n, options.up)
    for i in range(n):
        print(f"mode {i + 1}: {result.shares[i]:.1%} of the variance, deviation {deviations[i]:.3g}")
    if options.demo:
        for i, what in enumerate(("length", "bend")[:n]):
            print(f"{what}: correlation of mode {i + 1} {np.corrcoef(truth[:, i], result.scores[:, i])[0, 1]:+.4f}")
    if uncertain:
        print(f"{len(uncertain)} UNCERTAIN: compare uncertain_*.off with mean.off and leave out surfaces in another pose")
    print(f"{len(paths)} surfaces, {time.perf_counter() - start:.1f} s")


if __name__ == "__main__":
    try:
        main()
    except OSError as error:
        sys.exit(str(error))
