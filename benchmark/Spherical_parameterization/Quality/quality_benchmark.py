#!/usr/bin/env python3
"""Prints the distortion of the map of each mesh, at the radius of the map and at that of eq. 11.

With --bounds FILE, it is compared with the bounds of the meshes and settings in that file, and other meshes are left
out. Fails if a map is not one-to-one, or above one of its bounds.
"""

from __future__ import annotations

import math
import sys
import tempfile
from fnmatch import fnmatch
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.drivers import Driver
from measuring.meshes import find_mesh_files
from measuring.reports import number, table
from measuring.runs import Program, Run

MEASURES = {"D_iso": "own_radius_isometric", "D_iso_eq11": "isometric", "D_angle": "angle"}  # by their names in a run
ENERGIES, PREFERENCES = ("symmetric-dirichlet", "isometric", "conformal"), ("average", "balance", "worst")

Bounds = dict[tuple[str, str], list[tuple[str, float, float]]]  # of a mesh and settings: measure, maximum, average


def main() -> None:
    driver = Driver(__doc__)
    driver.add_program()
    driver.add_threads()
    driver.add_argument("--energy", choices=ENERGIES, help="that of the maps (symmetric-dirichlet; with --bounds all)")
    driver.add_argument("--prefer", choices=PREFERENCES, help="what they prefer (balance; with --bounds all)")
    driver.add_argument("--iterations", metavar="N", help="sweeps at the finest level, at most")
    driver.add_argument("--max-vertices", type=int, default=math.inf, help="skip the meshes with more vertices")
    driver.add_argument("--bounds", type=Path, help="bounds that the distortions are compared with")
    driver.add_argument("inputs", type=Path, nargs="+", metavar="FILE_OR_FOLDER")
    options = driver.parse()
    files = find_mesh_files(options.inputs, options.max_vertices)
    if options.bounds is None:
        settings = f"{options.energy or ENERGIES[0]}/{options.prefer or PREFERENCES[1]}"
        bounds = {(file.name, settings): [] for file in files}
    else:
        chosen = f"{options.energy or '*'}/{options.prefer or '*'}"
        bounds = {key: x for key, x in read_bounds(options.bounds).items() if fnmatch(key[1], chosen)}
    rows, failures, count = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.program, options.threads, Path(folder))
        for file in files:
            for (mesh, settings), of_mesh in bounds.items():
                if mesh != file.name:
                    continue
                energy, preference = settings.split("/")
                arguments = ["--energy", energy, "--prefer", preference]
                arguments += ["--iterations", options.iterations] if options.iterations else []
                run = program.run(file, arguments)
                rows.append(shown(run, settings))
                objection = run.map.objection() if run.has_map else run.message
                failures += [f"{mesh}, {settings}: {objection}"] if objection else []
                for measure, *limits in of_mesh if run.has_map else ():
                    for name, limit in zip(("maximum", "average"), limits):
                        value = run.row[f"{MEASURES[measure]}_{name}"]
                        count += math.isfinite(limit)
                        if not value <= limit:
                            failures.append(f"{mesh}, {settings}: {measure} {name} is {value:.4f}, above {limit:.4f}")
            file.forget()
    columns = {"mesh": "mesh", "settings": "settings", "vertices": "vertices"}
    for measure, prefix in MEASURES.items():
        columns |= {f"{prefix}_maximum": f"{measure} max", f"{prefix}_average": f"{measure} avg"}
    print(table(columns | {"sweeps": "sweeps", "stop_reason": "stop reason"}, rows, is_aligned=True))
    if options.bounds:
        print(f"{count} bounds compared", file=sys.stderr)
        failures += [] if count else ["There are none for these meshes and settings."]
    sys.exit("\n".join(failures) or 0)


def shown(run: Run, settings: str) -> dict:
    return {key: number(x) if isinstance(x, float) else x for key, x in run.row.items()} | {"settings": settings}


def read_bounds(path: Path) -> Bounds:
    """Lines of a mesh, settings, a measure, its maximum and its average, in which '-' stands for no bound."""
    bounds: Bounds = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            try:
                mesh, settings, measure, *limits = line.split()
                maximum, average = (math.inf if limit == "-" else float(limit) for limit in limits)
                MEASURES[measure]
            except (ValueError, KeyError):
                sys.exit(f"{path}: not a mesh, settings, one of {', '.join(MEASURES)}, and two numbers: {line}")
            bounds.setdefault((mesh, settings), []).append((measure, maximum, average))
    return bounds


if __name__ == "__main__":
    main()
