#!/usr/bin/env python3
"""Measures the time of each stage: the table of stages of the manual's page on performance.

Samples the whole program, from file to file in one thread, by `perf record`, on cow_2904 and on the original and subdivided armadillo, and
assigns the sampled functions to stages. Needs perf (linux-perf) and a program with symbols. Takes two minutes; leave the machine idle
meanwhile.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.drivers import MANUAL, Driver
from measuring.meshes import MeshFile, find_mesh_files, subdivide_smoothly, write_mesh
from measuring.reports import fill_in, table

SMALL, GROWING, ROUNDS = "cow_2904", "armadillo_26002", (0, 2, 3)

# A function belongs to the first stage of which its name contains one of the words.
STAGES = {
    "certificate": ("certify", "count_triangles", "are_safely_positive<", "Orientation_about_origin"),
    "sweeps": ("move_all",),
    "smooth steps": ("Strain_sums", "Smooth_step", "Sphere_cells", "cube_location", "array<double, 24"),
    "face measurement": ("Measured_faces::for_each_", "Measured_faces::summar", "Measured_faces::measure", "Measured_faces::radius"),
    "star layout": ("Star_packets", "Rest_triangle", "Independent_sets", "Measured_faces", "Block_coordinate_descent"),
    "choice of removals": ("Vertex_removal", "Mesh_hierarchy::select", "Mesh_hierarchy::coarsen", "_Iter_equals_val", "spreadsort"),
    "coarser meshes": ("Mesh_hierarchy", "Edge_set"),
    "vertex insertion": ("Star_kernel", "Level_descent", "Hierarchical_embedding"),
    "surface reading, connectivity": ("link_triangles", "build_rings", "Surface::", "read_mesh", "Mesh_arrays", "Vertex_rings", "vertex_"),
    "distortion of the report": ("measure_distortion", "Distortion", "distortion"),
    "mesh of the caller": ("Surface_mesh", "Properties::", "Euler::", "add_triangles"),
    "files": ("Program::", "Text_scanner", "parse_number", "Ply", "from_chars", "to_chars", "printf", "ryu", "basic_string", "stream"),
}


def profile(program: Path, mesh: Path, folder: Path) -> tuple[float, Counter]:
    """Seconds from file to file, of a run without sampling overhead, and the percentage of each stage."""
    data, report = folder / "samples", folder / "report.json"
    command = [program, mesh, "-o", folder / "sphere.off", "--threads", "1", "--quiet", "--json", report]
    subprocess.run(command, check=True, capture_output=True)
    seconds = json.loads(report.read_text(encoding="utf-8"))["seconds"]["total"]
    subprocess.run(["perf", "record", "--quiet", "--output", data, *command], check=True, capture_output=True)
    options = ["--stdio", "--no-children", "--fields", "overhead,symbol", "--input", data]
    lines = subprocess.run(["perf", "report", *options], check=True, capture_output=True, text=True).stdout.splitlines()
    shares: Counter = Counter()
    for line in lines:
        if match := re.match(r"\s*([0-9.]+)% +\[(.)\] (.*)", line):
            share, where, symbol = float(match[1]), match[2], match[3]
            names = (stage for stage, words in STAGES.items() if any(word in symbol for word in words))
            shares["operating system" if where == "k" else next(names, "other")] += share
    return seconds, shares


def main() -> None:
    driver = Driver(__doc__, folders=("meshes",))
    driver.add_program()
    driver.add_meshes()
    driver.add_argument("--manual", type=Path, default=MANUAL / "Performance.txt", help="the page whose table is filled in")
    options = driver.parse()
    if not shutil.which("perf"):
        driver.error("perf is not installed (Debian package linux-perf)")
    files = {file.name: file for file in find_mesh_files([options.meshes])}
    with tempfile.TemporaryDirectory() as name:
        folder, columns, seconds = Path(name), [], {}
        meshes = [files[SMALL]]
        mesh, rounds = files[GROWING].mesh, 0
        for wanted in ROUNDS:
            while rounds < wanted:
                mesh, rounds = subdivide_smoothly(mesh), rounds + 1
            path = folder / f"armadillo_{len(mesh.vertices)}.off"
            write_mesh(path, mesh)
            meshes.append(MeshFile(path))
        for file in meshes:
            total, shares = profile(options.program, file.path, folder)
            columns.append(file.name)
            seconds[file.name] = total, shares
            print(f"{file.name}: {total:.2f} s", flush=True)
    rows = [{"stage": stage, **{name: f"{seconds[name][1][stage]:.1f}" for name in columns}}
            for stage in [*STAGES, "operating system", "other"]]
    rows.append({"stage": "microseconds per vertex, file to file",
                 **{name: f"{1e6 * seconds[name][0] / int(name.rsplit('_', 1)[1]):.1f}" for name in columns}})
    text = table({"stage": "percent of the samples", **{name: name for name in columns}}, rows) + "\n"
    print(text)
    options.manual.write_text(fill_in(options.manual.read_text(encoding="utf-8"), "stages", text), encoding="utf-8")


if __name__ == "__main__":
    main()
