#!/usr/bin/env python3
"""Measures the effect of each heuristic of the descent and of the hierarchy, and prints the table of the manual's page Experiments.

For each row, the script removes one of them from a copy of the headers, or replaces it by something simpler, and maps all meshes of at
least 2,800 vertices by the default method, in one thread. The table contains time and isometric distortion relative to the version
with all heuristics, as geometric means; and the number of meshes that are worse by half a percent in both maximum and average. Takes
half an hour on 31 meshes; leave the machine idle meanwhile.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.drivers import PROJECT, Driver
from measuring.meshes import find_mesh_files
from measuring.reports import geometric_mean, table

MIN_VERTICES = 2800
WORSE = 1.005
INTERNAL = Path("include/CGAL/Spherical_parameterization/internal")


@dataclass(frozen=True)
class Change:
    """A replacement of text in a header."""

    file: str
    old: str
    new: str


SMOOTH = "descent/Smooth_step.h"
LOOP, LEVELS, SETTINGS = "descent/Descent_loop.h", "descent/Hierarchical_embedding.h", "descent/Descent_settings.h"
STEP, REMOVAL, KERNEL = "descent/Vertex_step.h", "hierarchy/Vertex_removal.h", "hierarchy/Star_kernel.h"

HEURISTICS = {
    "smooth steps": {
        "none": [Change(SMOOTH, "return sweep >= m_next;", "return false;"),
                 Change(SMOOTH, "m_last >= begin || m_interval > max_useful_interval;", "true;")],
    },
    "focus sweeps": {
        "none": [Change(LOOP, "m_descent.sweep_with_focus(positions, scaled_radius(), m_objective.of_faces(),\n"
                        "                                   m_state.summary.maximum_energy());",
                        "m_descent.sweep(positions, scaled_radius(), m_objective.of_faces());")],
    },
    "over-relaxation 1.7": {
        "1": [Change(STEP, "m_over_relaxation = 1.7;", "m_over_relaxation = 1.;")],
    },
    "over-relaxation 1.5 on levels": {
        "1.7": [Change(LEVELS, "over_relaxation = 1.5;", "over_relaxation = 1.7;")],
    },
    "radius steps only without a smooth step": {
        "always": [Change(LOOP, "else if(!makes_smooth_step(i))", "else")],
    },
    "descents on levels": {
        "none": [Change(LEVELS, "if(!m_settings.sharpness ||", "if(true ||")],
    },
    "small levels until convergence": {
        "5 sweeps": [Change(LEVELS, "level.vertices.size() < size_of_small_meshes && !m_limits.is_uniform", "false")],
    },
    "5 sweeps on the other levels": {
        "3": [Change(SETTINGS, "default_sweeps_per_level = 5;", "default_sweeps_per_level = 3;")],
    },
    "a quarter of the vertices removed per level": {
        "a third": [Change("hierarchy/Mesh_hierarchy.h", "max_fraction = 0.25;", "max_fraction = 1. / 3.;")],
    },
    "areas passed on by removed vertices": {
        "none": [Change("descent/Level_descent.h", "if(!m_limits.is_uniform)", "if(false)")],
    },
    "triangle quality in the removal cost": {
        "none": [Change(REMOVAL, "min_squared_quality = 1e-12;", "min_squared_quality = 1.;")],
    },
    "target degree in the removal cost": {
        "none": [Change(REMOVAL, "good_degree = 9;", "good_degree = 1000000000;")],
    },
    "best of several kernel points": {
        "the centroid, if representable": [Change(KERNEL, "    consider({middle[0]", "    if(!(min_roughness < largest))\n      consider({middle[0]")],
    },
    "area correction on coarse meshes": {
        "none": [Change("descent/Objective.h", "has_radius ? 1. / 9. : 0.;", "0.;")],
    },
    "radius and level in the smooth step": {
        "fixed": [Change(SMOOTH, "const bool moves_level = rr > 0., moves_radius = m_has_radius && tt > 0.;",
                        "const bool moves_level = false, moves_radius = false;")],
    },
}


def apply_changes(changes: Sequence[Change], folder: Path) -> None:
    """Changes a copy of the project's headers."""
    for change in changes:
        path = folder / INTERNAL / change.file
        text = path.read_text(encoding="utf-8")
        if text.count(change.old) != 1:
            sys.exit(f"{change.file} does not contain this exactly once: {change.old}")
        path.write_text(text.replace(change.old, change.new), encoding="utf-8")


def build(headers: Path, driver: Path, program: Path) -> None:
    command = ["g++", "-std=c++17", "-O2", "-w", "-DCGAL_EIGEN3_ENABLED", "-I/usr/include/eigen3", f"-I{headers}"]
    result = subprocess.run([*command, driver, "-o", program, "-lmpfr", "-lgmp"], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(result.stderr)


def measure(program: Path, file: Path) -> tuple[float, float, float]:
    """Seconds, maximum and average distortion of a mesh."""
    result = subprocess.run([program, file], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(result.stderr)
    time, _, maximum, average = result.stdout.rsplit(maxsplit=4)[1:]
    return float(time), float(maximum), float(average)


def measure_pair(program: Path, reference: Path, file: Path) -> list[float]:
    """Ratios of the shorter of two times, of the maximum and of the average distortion; the programs alternate."""
    pairs = [(measure(program, file), measure(reference, file)) for _ in range(2)]
    return [min(new[k] for new, _ in pairs) / min(old[k] for _, old in pairs) for k in range(3)]


def main() -> None:
    driver = Driver(__doc__, tuple(HEURISTICS), folders=("meshes",))
    driver.add_meshes()
    options = driver.parse()
    files = [file.path for file in find_mesh_files([options.meshes]) if file.number_of_vertices >= MIN_VERTICES]
    source = Path(__file__).with_name("default_maps.cpp")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        headers, program, reference = Path(folder) / "include", Path(folder) / "maps", Path(folder) / "reference"
        build(PROJECT / "include", source, reference)
        for heuristic in options.only:
            for alternative, changes in HEURISTICS[heuristic].items():
                shutil.rmtree(headers, ignore_errors=True)
                shutil.copytree(PROJECT / "include", headers)
                apply_changes(changes, Path(folder))
                build(headers, source, program)
                ratios = [measure_pair(program, reference, file) for file in files]
                means = [geometric_mean(values) for values in zip(*ratios)]
                n_worse = sum(maximum > WORSE and average > WORSE for _, maximum, average in ratios)
                rows.append({"heuristic": heuristic, "instead": alternative, "time": f"{means[0]:.2f}",
                             "maximum": f"{means[1]:.4f}", "average": f"{means[2]:.4f}", "worse": n_worse})
                print(*rows[-1].values(), sep=", ", flush=True)
    columns = {"heuristic": "heuristic", "instead": "replaced by", "time": "time", "maximum": "maximum D_iso",
               "average": "average D_iso", "worse": "meshes worse in both"}
    print(table(columns, rows))


if __name__ == "__main__":
    main()
