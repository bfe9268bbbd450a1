#!/usr/bin/env python3
"""Usage: distortion_picture.py MESH PICTURE.png

Draws a surface and its map to the sphere side by side, colored by the distortion of each face. Meshes of trimesh or PyVista can
replace the arrays vertices and faces."""

import sys

import matplotlib

matplotlib.use("Agg")  # needs no screen
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import spherical_parameterization as sp


def draw(axes, vertices, faces, values, norm):
    triangles = vertices[faces]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = 0.6 + 0.4 * (normals @ [0.5, -0.6, 0.6]) / np.where(lengths > 0, lengths, 1)
    colors = plt.get_cmap("viridis")(norm(values))
    colors[:, :3] *= np.clip(light, 0.2, 1)[:, None]
    axes.add_collection3d(Poly3DCollection(triangles, facecolors=colors, edgecolors=colors, linewidths=0.2))
    middle, size = (vertices.max(0) + vertices.min(0)) / 2, np.ptp(vertices, 0).max() / 2
    for i, axis in enumerate("xyz"):
        getattr(axes, f"set_{axis}lim")(middle[i] - size, middle[i] + size)
    axes.set_box_aspect((1, 1, 1), zoom=1.4)
    axes.set_axis_off()


def main():
    vertices, faces = sp.read_mesh(sys.argv[1])
    sphere, report = sp.parameterize(vertices, faces)
    distortion = sp.measure_distortion(vertices, faces, sphere).isometric

    figure, axes = plt.subplots(1, 2, figsize=(10, 4.5), subplot_kw={"projection": "3d"})
    norm = LogNorm(1, max(2, distortion.maximum))
    draw(axes[0], vertices, faces, distortion.values, norm)
    draw(axes[1], sphere, faces, distortion.values, norm)
    scale = figure.colorbar(plt.cm.ScalarMappable(norm, "viridis"), ax=axes, label="isometric distortion", shrink=0.8)
    scale.set_ticks([t for t in (1, 1.5, 2, 3, 5, 8, 12, 20) if t <= norm.vmax], minor=False)
    scale.ax.yaxis.set_major_formatter("{x:g}")
    scale.minorticks_off()
    figure.suptitle(f"{len(faces)} faces, {report.seconds:.2f} s; {distortion.average:.3f} on average")
    figure.savefig(sys.argv[2], dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main()
    except (OSError, sp.Error) as error:
        sys.exit(str(error))
