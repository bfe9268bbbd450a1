#!/usr/bin/env python3
"""Compares programs that map meshes to a sphere with the package, on one thread and on all.

A COMMAND is a shell command with {input} for the mesh file and {output} for the map, which the program must write in
OFF format. For other formats, write {input.obj}, {input.ply}, {output.obj} and the like: the mesh is converted
beforehand. The map is a mesh with the vertices in the order of the input, on a sphere around the origin, and the same
faces in any order. An example:

  --program 'stereographic=spherical_parameterization {input} -o {output.ply} --method stereographic'

The CPU seconds are those of all processes of a run, in user mode and for system calls; MB is the physical memory of the
largest of them. All maps are judged alike: a map is certified if it is bijective by exact arithmetic. D_iso is measured
at the radius of eq. 11, which not every program aims at, and at the best radius, where the largest D_iso of the map is
lowest; D_angle does not depend on the radius. The ratios are relative to the package on one thread: above 1, the package
is better. Their geometric means are over the meshes for which both maps are bijective. A program may fail; the status is
1 only if a map of the package is missing.
"""

from __future__ import annotations

import csv
import shlex
import sys
import tempfile
from pathlib import Path
from statistics import median

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.commands import MappingProgram
from measuring.drivers import PROGRAM, PROJECT, Driver, find_program
from measuring.meshes import MeshFile, find_mesh_files
from measuring.reports import geometric_mean, number, table

# The relative distance of images from the sphere that does not affect the printed distortions: other programs may write
# few digits.
MAX_DEVIATION = 1e-4

NAMES = {"mesh": "mesh", "program": "program", "judgement": "judgement"}
FIGURES = {"inverted": 0, "D_iso max": 3, "D_iso avg": 3, "best D_iso max": 3, "best D_iso avg": 3}  # with so many digits
FIGURES |= {"D_angle max": 3, "D_angle avg": 3}
COSTS = {"CPU seconds": 3, "seconds": 3, "MB": 0}
COMPARED = ["CPU seconds", *list(FIGURES)[1:]]
RATIOS = {f"{name} ratio": f"{name.removesuffix(' seconds')} ratio" for name in COMPARED}


def main() -> None:
    driver = Driver(__doc__)
    driver.add_limits()
    text = "a program to compare with; may be given several times"
    driver.add_argument("--program", action="append", default=[], metavar="NAME=COMMAND", help=text)
    text = "the program of the package, with options if needed"
    driver.add_argument("--package", default=find_program(PROJECT / "build", PROGRAM), metavar="COMMAND", help=text)
    text = "runs of each program on each mesh; times are medians (3)"
    driver.add_argument("--repeat", type=int, default=3, help=text)
    driver.add_argument("--csv", action="store_true", help="print comma-separated values instead of Markdown")
    driver.add_argument("inputs", type=Path, nargs="+", metavar="FILE_OR_FOLDER")
    options = driver.parse()
    if options.package is None:
        driver.error("--package must name the program of the package")
    package = str(options.package) if isinstance(options.package, str) else shlex.quote(str(options.package))
    commands = {"package, 1 thread": f"{package} {{input}} -o {{output}} --quiet --threads 1"}
    commands["package"] = f"{package} {{input}} -o {{output}} --quiet"
    for program in options.program:
        name, separator, command = program.partition("=")
        if not name or not separator or name in commands:
            driver.error(f"--program needs NAME=COMMAND with a unique name, not: {program}")
        commands[name] = command
    with tempfile.TemporaryDirectory() as folder:
        limits = (options.time_limit, 2**20 * options.memory_limit)
        programs = []
        for i, (name, command) in enumerate(commands.items()):
            own_folder = Path(folder) / str(i)
            own_folder.mkdir()
            programs.append(MappingProgram(name, command, own_folder, *limits))
        rows = [row for file in find_mesh_files(options.inputs) for row in run_all(programs, file, options.repeat)]
    print_table(NAMES | {name: name for name in FIGURES | COSTS} | RATIOS, rows, options.csv)
    counts = [summary(name, [row for row in rows if row["program"] == name]) for name in commands]
    print_table({"program": "geometric means"} | {name: name for name in list(counts[0])[1:6]} | RATIOS, counts, options.csv)
    for row in rows:
        if row["reason"]:
            print(f"{row['mesh']}: {row['program']}: {row['reason']}", file=sys.stderr if options.csv else sys.stdout)
    sys.exit(not all(row["judgement"] == "certified" for row in rows if row["program"] == programs[0].name))


def run_all(programs: list[MappingProgram], file: MeshFile, repetitions: int) -> list[dict]:
    """Every program in turn, as often as asked for unless it fails: so a drift of the machine is the same for all."""
    mappings = {program: [program.run(file, MAX_DEVIATION)] for program in programs}
    for _ in range(1, repetitions):
        for program, of_program in mappings.items():
            if of_program[0].verdict == "certified":
                of_program.append(program.run(file, MAX_DEVIATION))
    file.forget()
    rows = []
    for program, of_program in mappings.items():
        first = of_program[0]
        row = {"mesh": file.name, "program": program.name, "judgement": first.verdict, "reason": first.reason}
        if first.map is not None:
            distortion = first.map.distortion()
            row |= {"inverted": first.map.number_inverted}
            row |= {"D_iso max": distortion.isometric.maximum, "D_iso avg": distortion.isometric.average}
            best = first.map.distortion(first.map.best_radius).isometric
            row |= {"best D_iso max": best.maximum, "best D_iso avg": best.average}
            row |= {"D_angle max": distortion.angle.maximum, "D_angle avg": distortion.angle.average}
        outcomes = [mapping.outcome for mapping in of_program if mapping.outcome is not None]
        if outcomes:
            row |= {"CPU seconds": median(outcome.cpu_seconds for outcome in outcomes)}
            row |= {"seconds": median(outcome.process_seconds for outcome in outcomes)}
            row |= {"MB": max(outcome.peak_bytes for outcome in outcomes) / 2**20}
        rows.append(row)
        if row["judgement"] == rows[0]["judgement"] == "certified":
            row |= {f"{name} ratio": row[name] / rows[0][name] for name in COMPARED}
    return rows


def summary(name: str, rows: list[dict]) -> dict:
    """Counts, and the means over the meshes that this program and the first one map bijectively."""
    counts = {what: sum(row["judgement"] == what for row in rows) for what in ("certified", "not bijective")}
    common = [row for row in rows if "CPU seconds ratio" in row]
    ratios = {ratio: geometric_mean([row[ratio] for row in common]) for ratio in RATIOS if common}
    failed = {"failed": len(rows) - sum(counts.values()), "in common": len(common)}
    return {"program": name, "meshes": len(rows)} | counts | failed | ratios


def print_table(columns: dict[str, str], rows: list[dict], is_csv: bool) -> None:
    if is_csv:
        writer = csv.DictWriter(sys.stdout, list(columns), restval="", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
        return
    digits = FIGURES | COSTS | {ratio: 3 for ratio in RATIOS}

    def text(row: dict, key: str) -> str:
        return number(row[key], digits[key]) if digits[key] else f"{row[key]:,.0f}"

    shown = [row | {key: text(row, key) for key in digits if key in row} for row in rows]
    print(table(columns, shown, is_aligned=True) + "\n")


if __name__ == "__main__":
    main()
