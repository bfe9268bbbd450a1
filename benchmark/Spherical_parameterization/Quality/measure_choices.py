#!/usr/bin/env python3
"""Measures the choices that the user manual describes, and fills in its tables.

Takes about ten minutes, half of them for prescribed areas; leave the machine idle meanwhile. The tables are those of
README.md (`results`) and of the pages Quality and Choosing (`needs`) between `<!-- begin NAME -->` and
`<!-- end NAME -->`. They are made from the templates below, in which `@MESH OPTIONS FIGURE@` stands for a figure of a
run of the program, and `@rows of areas@` for the rows of some meshes and the largest values over all meshes. Figures
outside of these tables are updated by hand.
"""

from __future__ import annotations

import json
import re
import statistics
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import numpy as np
from measuring.commands import run_command
from measuring.drivers import MANUAL, PROJECT, Driver
from measuring.meshes import MeshFile, find_mesh_files
from measuring.reports import fill_in
from measuring.runs import Program, Run

MESHES = {
    "fandisk": "fandisk_6475",
    "bunny": "bunny_3485",
    "hand": "hand_10345",
    "cow": "cow_2904",
    "camel": "camel_9770",
    "maxplanck": "maxplanck_15000",
    "horse": "horse_19851",
    "octopus": "octopus_16554",
    "spot": "spot_2930",
    "brain": "brain_fsaverage5_lh_pial",
    "armadillo": "armadillo_26002",
}

# The meshes that have a row in the table of prescribed areas; the last row is about all meshes of the folder.
MESHES_OF_AREAS = (
    "cow_2904",
    "spot_2930",
    "bunny_3485",
    "fandisk_6475",
    "camel_9770",
    "brain_fsaverage5_lh_pial",
    "hand_10345",
    "maxplanck_15000",
    "octopus_16554",
    "horse_19851",
    "armadillo_26002",
    "bimba_45k",
)

OPTIONS = {
    "default": [],
    "average": ["--prefer", "average"],
    "worst": ["--prefer", "worst"],
    **{f"beta_{beta}": ["--sharpness", beta] for beta in ("3", "6", "12", "100")},
    "isometric": ["--energy", "isometric"],
    "isometric_0": ["--energy", "isometric", "--prefer", "average"],
    "conformal": ["--energy", "conformal"],
    **{f"only_{m}": ["--method", m] for m in ("hierarchical", "harmonic", "stereographic", "schnyder", "conformal", "arap")},
    **{f"radius_{rule}": ["--radius", rule] for rule in ("two-phase", "balanced", "optimal", "area", "fixed=1")},
    **{f"sweeps_{n}": ["--iterations", n] for n in ("0", "25", "2000")},
    "to_the_end": ["--iterations", "2000", "--tolerance", "0"],
    "sampling": ["--prefer", "sampling"],
    "paper": ["--paper"],
    "from_harmonic": ["--initial", "harmonic"],
    "from_harmonic_2000": ["--initial", "harmonic", "--iterations", "2000"],
    "from_stereographic": ["--initial", "stereographic"],
}

TABLES = {
    "results": r"""
| Mesh | Vertices | D_iso maximum / average | conformal: D_angle maximum / average | seconds, one thread |
| :--- | ---: | ---: | ---: | ---: |
| spot | @spot default size@ | @spot default D_iso@ | @spot conformal D_angle@ | @spot default seconds@ |
| bunny | @bunny default size@ | @bunny default D_iso@ | @bunny conformal D_angle@ | @bunny default seconds@ |
| fandisk | @fandisk default size@ | @fandisk default D_iso@ | @fandisk conformal D_angle@ | @fandisk default seconds@ |
| camel | @camel default size@ | @camel default D_iso@ | @camel conformal D_angle@ | @camel default seconds@ |
| brain, fsaverage5 | @brain default size@ | @brain default D_iso@ | @brain conformal D_angle@ | @brain default seconds@ |
| hand | @hand default size@ | @hand default D_iso@ | @hand conformal D_angle@ | @hand default seconds@ |
| Max Planck | @maxplanck default size@ | @maxplanck default D_iso@ | @maxplanck conformal D_angle@ | @maxplanck default seconds@ |
| octopus | @octopus default size@ | @octopus default D_iso@ | @octopus conformal D_angle@ | @octopus default seconds@ |
| horse | @horse default size@ | @horse default D_iso@ | @horse conformal D_angle@ | @horse default seconds@ |
| armadillo | @armadillo default size@ | @armadillo default D_iso@ | @armadillo conformal D_angle@ | @armadillo default seconds@ |
""",
    "needs": r"""
| Need | Choice | Guarantee | Time | D_iso maximum / average, hand |
| :--- | :----- | :-------- | ---: | ----------------------------: |
| low worst and low average distortion: **the default** | `Bijective_low_distortion_parameterizer_3` | bijective | 1 | @hand default D_iso@ |
| a lower worst distortion | the same with `Sharpness::lowest_worst()` | bijective | @hand worst time@ | @hand worst D_iso@ |
| a lower average distortion | the same with `Sharpness::lowest_average()` | bijective | @hand average time@ | @hand average D_iso@ |
| angles, certified | the same with `Conformal_energy_3` and `Fixed_radius_3` | bijective | @hand conformal time@ | D_angle @hand conformal D_angle@ |
| angles, fast, for shapes without long extremities | `Conformal_parameterizer_3` | none; an error code if not injective | @hand only_conformal time@ | D_angle @hand only_conformal D_angle@ |
| approximately angles, bijective | `Harmonic_parameterizer_3` | bijective or an error code | @hand only_harmonic time@ | D_angle @hand only_harmonic D_angle@ |
| prescribed areas: equal, or by a density | `Target_area_parameterizer_3`: \ref SphericalParameterizationAreas | bijective | | |
| even samples, for a remesh or a geometry image | the default with `Stretch_energy_3`, `Area_preserving_radius_3` and a sharpness of 3: \ref SphericalParameterizationStretch | bijective | | |
| any bijective map, in a short time | the default with `number_of_iterations(0)` | bijective | @hand sweeps_0 time@ | @hand sweeps_0 D_iso@ |
| low average of angle plus area distortion, by a hierarchy | `Hierarchical_parameterizer_3` | bijective | @hand only_hierarchical time@ | @hand only_hierarchical D_iso@ |
| Tutte's planar map, projected to the sphere | `Stereographic_parameterizer_3` | bijective or an error code | @hand only_stereographic time@ | @hand only_stereographic D_iso@ |
| a map from the connectivity alone, with a proof | `Schnyder_parameterizer_3` | bijective | @hand only_schnyder time@ | @hand only_schnyder D_iso@ |
| as-rigid-as-possible, for comparison | `ARAP_parameterizer_3` | none; an error code if not injective | @hand only_arap time@ | @hand only_arap D_iso@ |
| the published method, for comparison | `Published_low_distortion_parameterizer_3` | bijective or an error code | @hand paper time@ | @hand paper D_iso@ |
| a given map | `Precomputed_parameterizer_3` | refused unless bijective | | |
""",
    "methods": r"""
| Method | fandisk_6475 | bunny_3485 | hand_10345 | horse_19851 | octopus_16554 |
| :----- | -----------: | ---------: | ---------: | ----------: | ------------: |
| default | @fandisk default D_iso@ | @bunny default D_iso@ | @hand default D_iso@ | @horse default D_iso@ | @octopus default D_iso@ |
| hierarchical | @fandisk only_hierarchical D_iso@ | @bunny only_hierarchical D_iso@ | @hand only_hierarchical D_iso@ | @horse only_hierarchical D_iso@ | @octopus only_hierarchical D_iso@ |
| harmonic | @fandisk only_harmonic D_iso@ | @bunny only_harmonic D_iso@ | @hand only_harmonic D_iso@ | @horse only_harmonic D_iso@ | refused |
| as-rigid-as-possible | @fandisk only_arap D_iso@ | @bunny only_arap D_iso@ | @hand only_arap D_iso@ | @horse only_arap D_iso@ | @octopus only_arap D_iso@ |
| published | @fandisk paper D_iso@ | @bunny paper D_iso@ | @hand paper D_iso@ | | |
| default with the conformal energy, D_angle | @fandisk conformal D_angle@ | @bunny conformal D_angle@ | @hand conformal D_angle@ | @horse conformal D_angle@ | @octopus conformal D_angle@ |
| harmonic, D_angle | @fandisk only_harmonic D_angle@ | @bunny only_harmonic D_angle@ | @hand only_harmonic D_angle@ | @horse only_harmonic D_angle@ | |
| conformal, D_angle | @fandisk only_conformal D_angle@ | @bunny only_conformal D_angle@ | @hand only_conformal D_angle@ | @horse only_conformal D_angle@ | @octopus only_conformal D_iso@ |
""",
    "energies": r"""
| Energy | Sharpness | D_iso | D_area | D_angle |
| :----- | --------: | ----: | -----: | ------: |
| `Symmetric_Dirichlet_energy_3`, the default: lengths | 20 | @hand default D_iso@ | @hand default D_area@ | @hand default D_angle@ |
| `Isometric_energy_3`, as in the BLD paper: angles and areas, half each | 20 | @hand isometric D_iso@ | @hand isometric D_area@ | @hand isometric D_angle@ |
| `Conformal_energy_3`: angles only | 20 | | | @hand conformal D_angle@ |
| `Symmetric_Dirichlet_energy_3` | 0 | @hand average D_iso@ | @hand average D_area@ | @hand average D_angle@ |
| `Isometric_energy_3` | 0 | @hand isometric_0 D_iso@ | @hand isometric_0 D_area@ | @hand isometric_0 D_angle@ |
""",
    "samples": r"""
| Mesh | SphereParam | default | `--prefer sampling` | its time, default = 1 |
| :--- | ----------: | ----------: | ------------------: | --------------------------: |
| bunny_3485 | 60.0 / 69.4 / 78.5 | @bunny default psnr@ | @bunny sampling psnr@ | @bunny sampling time@ |
| fandisk_6475 | 62.0 / 70.8 / 80.2 | @fandisk default psnr@ | @fandisk sampling psnr@ | @fandisk sampling time@ |
| cow_2904 | 56.1 / 64.8 / 74.5 | @cow default psnr@ | @cow sampling psnr@ | @cow sampling time@ |
| hand_10345 | 62.1 / 72.3 / 81.9 | @hand default psnr@ | @hand sampling psnr@ | @hand sampling time@ |
| camel_9770 | 53.1 / 61.9 / 72.2 | @camel default psnr@ | @camel sampling psnr@ | @camel sampling time@ |
| maxplanck_15000 | 64.7 / 75.0 / 84.9 | @maxplanck default psnr@ | @maxplanck sampling psnr@ | @maxplanck sampling time@ |
| horse_19851 | 57.0 / 67.7 / 76.9 | @horse default psnr@ | @horse sampling psnr@ | @horse sampling time@ |
""",
    "areas": r"""
| Mesh | equal areas: deviation&nbsp;/&nbsp;largest | D_angle | steps | seconds | contrast 10: deviation&nbsp;/&nbsp;largest | D_angle | steps | seconds |
| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
@rows of areas@
""",
    "sharpness": r"""
| Mesh | \f$ \beta = 0 \f$ | 3 | 6 | 12 | 20 | 40 | 100 |
| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| fandisk_6475 | @fandisk average D_iso@ | @fandisk beta_3 D_iso@ | @fandisk beta_6 D_iso@ | @fandisk beta_12 D_iso@ | @fandisk default D_iso@ | @fandisk worst D_iso@ | @fandisk beta_100 D_iso@ |
| bunny_3485 | @bunny average D_iso@ | @bunny beta_3 D_iso@ | @bunny beta_6 D_iso@ | @bunny beta_12 D_iso@ | @bunny default D_iso@ | @bunny worst D_iso@ | @bunny beta_100 D_iso@ |
| hand_10345 | @hand average D_iso@ | @hand beta_3 D_iso@ | @hand beta_6 D_iso@ | @hand beta_12 D_iso@ | @hand default D_iso@ | @hand worst D_iso@ | @hand beta_100 D_iso@ |
| horse_19851 | @horse average D_iso@ | @horse beta_3 D_iso@ | @horse beta_6 D_iso@ | @horse beta_12 D_iso@ | @horse default D_iso@ | @horse worst D_iso@ | @horse beta_100 D_iso@ |
| octopus_16554 | @octopus average D_iso@ | @octopus beta_3 D_iso@ | @octopus beta_6 D_iso@ | @octopus beta_12 D_iso@ | @octopus default D_iso@ | @octopus worst D_iso@ | @octopus beta_100 D_iso@ |
""",
    "radii": r"""
| Policy | Rule | Radius | D_iso | D_area |
| :----- | :--- | -----: | ----: | -----: |
| none, the default | minimizes the objective of the vertices | @horse default radius@ | @horse default D_iso@ | @horse default D_area@ |
| `Two_phase_radius_3` | preserves the total area at first, then as the next one | @horse radius_two-phase radius@ | @horse radius_two-phase D_iso@ | @horse radius_two-phase D_area@ |
| `Area_balancing_radius_3` | balances the area distortion of grown and of shrunk faces (eq. 11 of the paper) | @horse radius_balanced radius@ | @horse radius_balanced D_iso@ | @horse radius_balanced D_area@ |
| `Optimal_radius_3` | minimizes the sum of the energies in use | @horse radius_optimal radius@ | @horse radius_optimal D_iso@ | @horse radius_optimal D_area@ |
| `Area_preserving_radius_3` | gives the flat images of the faces the total area of the surface (eq. 9) | @horse radius_area radius@ | @horse radius_area D_iso@ | @horse radius_area D_area@ |
| `Fixed_radius_3` of 1 | is prescribed, in the unit of the mesh | 1 | @horse radius_fixed=1 D_iso@ | @horse radius_fixed=1 D_area@ |
""",
    "starts": r"""
| Maximum number of sweeps | fandisk_6475: 250 | 2000 | bunny_3485: 250 | 2000 | horse_19851: 0 | 25 | 250 | 2000 | 2000, tolerance 0 |
| :----------------------- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| hierarchical | @fandisk default D_iso@ | @fandisk sweeps_2000 D_iso@ (@fandisk sweeps_2000 sweeps@) | @bunny default D_iso@ | @bunny sweeps_2000 D_iso@ (@bunny sweeps_2000 sweeps@) | @horse sweeps_0 D_iso@ | @horse sweeps_25 D_iso@ | @horse default D_iso@ | @horse sweeps_2000 D_iso@ (@horse sweeps_2000 sweeps@) | @horse to_the_end D_iso@ |
| harmonic | @fandisk from_harmonic D_iso@ | @fandisk from_harmonic_2000 D_iso@ (@fandisk from_harmonic_2000 sweeps@) | @bunny from_harmonic D_iso@ | @bunny from_harmonic_2000 D_iso@ (@bunny from_harmonic_2000 sweeps@) | | | @horse from_harmonic D_iso@ | @horse from_harmonic_2000 D_iso@ (@horse from_harmonic_2000 sweeps@) | |
| stereographic | @fandisk from_stereographic D_iso@ | | @bunny from_stereographic D_iso@ | | | | @horse from_stereographic D_iso@ | | |
""",
}

PAGES = {
    PROJECT / "README.md": ("results",),
    MANUAL / "Choosing.txt": ("needs",),
    MANUAL / "Quality.txt": tuple(name for name in TABLES if name not in ("needs", "results")),
}

DIVISIONS = (32, 64, 128)  # of the edges of the octahedron, for the remeshes whose PSNR is measured

TIMED_RUNS = 5  # of which only one is made where it takes long
LONG = 5.0  # seconds

SLASH = "&nbsp;/&nbsp;"


class Figures:
    """The figures of the templates; times are those of one thread."""

    def __init__(self, program: Program, alone: Program, folder: Path, scratch: Path):
        self._program, self._alone, self._scratch = program, alone, scratch
        self._files = {file.name: file for file in find_mesh_files([folder])}

    def text(self, mesh: str, options: str, figure: str) -> str:
        if figure == "areas":
            files = sorted(self._files.values(), key=lambda file: (file.number_of_vertices, file.name))
            return rows_of_areas({file.name: self._areas(file, "equal") + self._areas(file, "10") for file in files})
        if figure == "size":
            return f"{self._file(mesh).number_of_vertices:,}"
        if figure == "seconds":
            return f"{self._seconds(mesh, options):.2f}"
        if figure == "time":
            ratio = self._seconds(mesh, options) / self._seconds(mesh, "default")
            return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.1f}" if ratio >= 0.1 else f"{ratio:.2f}"
        run = self._program.run(self._file(mesh), OPTIONS[options])
        if not run.has_map:
            return "refused"
        if figure == "psnr":
            return " / ".join(f"{self._psnr(run, n):.1f}" for n in DIVISIONS)
        if figure == "sweeps":
            return f"{run.sweeps:,}"
        if figure == "radius":
            return f"{run.report['radius']:.4f}"
        if not run.report["one_to_one"]:
            return f"{run.map.number_inverted:,} inverted"
        # Maps to the unit sphere are compared at the radius of eq. 11.
        distortion = run.distortion if "balanced" in run.report else run.own_distortion
        values = getattr(distortion, {"D_iso": "isometric", "D_area": "area", "D_angle": "angle"}[figure])
        return f"{_number(values.maximum)}{SLASH}{_number(values.average)}"

    def _areas(self, file: MeshFile, density: str) -> list[str]:
        """The deviations of the areas from a density: `equal`, or a factor by which it grows along the longest side."""
        if density != "equal":
            points = file.mesh.vertices
            file.forget()
            x = points[:, np.argmax(np.ptp(points, axis=0))]
            values = float(density) ** ((x - x.min()) / np.ptp(x))
            density = str(self._scratch / f"{file.name}.ply")
            properties = "".join(f"property double {name}\n" for name in ("x", "y", "z", "density"))
            head = f"ply\nformat ascii 1.0\nelement vertex {len(x)}\n{properties}end_header"
            np.savetxt(density, np.column_stack([points, values]), fmt="%.17g", header=head, comments="")
        run = self._alone.run(file, ["--density", density])
        if not run.has_map:
            return ["refused", "", "", ""]
        areas, d_angle = run.report["areas"], run.report["distortion"]["D_angle"]["average"]
        deviations = f"{1000 * areas['deviation']:.2f}{SLASH}{100 * areas['largest_deviation']:.1f}"
        return [deviations, f"{d_angle:.2f}", str(areas["steps"]), f"{run.mapping_seconds:.1f}"]

    def _psnr(self, run: Run, n: int) -> float:
        """The PSNR of a remesh through the map of a run."""
        arguments = [f"octahedron={n}", "--initial", run.sphere, "--iterations", 0, "--json", "-"]
        outcome = run_command([self._program.path, "remesh", run.mesh.path, *arguments])
        if outcome.status != 0:
            sys.exit(outcome.message)
        return json.loads(outcome.output)["remesh"]["psnr"]

    def _seconds(self, mesh: str, options: str) -> float:
        times: list[float] = []
        while len(times) < TIMED_RUNS and (not times or times[0] < LONG):
            run = self._alone.run(self._file(mesh), OPTIONS[options], repetition=len(times))
            times.append(run.mapping_seconds)
        return statistics.median(times)

    def _file(self, mesh: str):
        if MESHES[mesh] not in self._files:
            sys.exit(f"There is no mesh {MESHES[mesh]} in the folder.")
        return self._files[MESHES[mesh]]


def rows_of_areas(cells: dict[str, list[str]]) -> str:
    """The rows of some meshes, and a row with the largest value of each column over all meshes."""
    rows = [(name, *row) for name, row in cells.items() if name in MESHES_OF_AREAS]
    columns = [[cell.split(SLASH) for cell in column if cell and cell != "refused"] for column in zip(*cells.values())]
    largest = [SLASH.join(max(values, key=float) for values in zip(*column)) for column in columns]
    rows.append((f"largest of all {len(cells)} meshes", *largest))
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def _number(value: float) -> str:
    if value == float("inf"):
        return "infinite"
    return f"{value:,.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.3f}"


def main() -> None:
    driver = Driver(__doc__, tuple(TABLES), folders=("meshes",))
    driver.add_program()
    driver.add_meshes()
    driver.add_threads()
    driver.add_argument("--output", type=Path, help="the folder for copies of the pages (by default, fills them in)")
    options = driver.parse()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.program, options.threads, Path(folder) / "runs")
        figures = Figures(program, Program(options.program, 1, Path(folder) / "alone"), options.meshes, Path(folder))
        for page, names in PAGES.items():
            text = page.read_text(encoding="utf-8")
            selected = [name for name in options.only if name in names]
            for name in selected:
                table = re.sub(r"@(\w+) (\S+) (\w+)@", lambda m: figures.text(*m.groups()), TABLES[name].lstrip("\n"))
                text = fill_in(text, name, table)
            if selected:
                (options.output / page.name if options.output else page).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
