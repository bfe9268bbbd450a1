#!/usr/bin/env python3
"""Runs a program on meshes (OFF, PLY, OBJ), judges what it writes, and counts the results.

A map is certified if the exit status is 0 and the file holds a one-to-one map of the same faces onto a sphere around
the origin, by exact arithmetic. A mesh is refused if the exit status is another one. All else is wrong: a map that is
not bijective, no map, a crash, a limit reached. Fails if anything is wrong. D_iso is at the radius of eq. 11.
"""

from __future__ import annotations

import shlex
import sys
import tempfile
from math import nan
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.commands import MappingProgram
from measuring.drivers import PROGRAM, PROJECT, Driver, find_program
from measuring.meshes import MeshFile, find_mesh_files
from measuring.reports import number, table

COLUMNS = {"seconds": "seconds", "maximum": "D_iso max", "average": "D_iso avg"}


def main() -> None:
    driver = Driver(__doc__)
    driver.add_limits()
    driver.add_argument("--program", metavar="COMMAND", help="what the shell runs, with {input} and {output} for files")
    driver.add_argument("--list", action="store_true", help="print a line for each mesh first")
    driver.add_argument("inputs", type=Path, nargs="+", metavar="FILE_OR_FOLDER")
    options = driver.parse()
    program = find_program(PROJECT / "build", PROGRAM)
    if options.program is None and program is None:
        driver.error("--program has to say what to run: the project's build folder has no program")
    command = options.program or f"{shlex.quote(str(program))} {{input}} -o {{output}} --quiet"
    with tempfile.TemporaryDirectory() as folder:
        mapping = MappingProgram("", command, Path(folder), options.time_limit, 2**20 * options.memory_limit)
        rows = [judge(mapping, file) for file in find_mesh_files(options.inputs)]
    verdicts = ("certified", "refused", "wrong")
    if options.list:
        print(table({"file": "mesh", "verdict": "verdict"} | COLUMNS, list(map(shown, rows)), is_aligned=True) + "\n")
    by_class = {name: [row for row in rows if row["class"] == name] for name in sorted({row["class"] for row in rows})}
    counts = []
    for name, members in (by_class | {"all": rows}).items():
        count = {verdict: sum(row["verdict"] == verdict for row in members) for verdict in verdicts}
        largest = {key: max((row[key] for row in members if row[key] == row[key]), default=nan) for key in COLUMNS}
        counts.append(shown({"class": name, "files": len(members)} | count | largest))
    headings = {"class": "meshes", "files": "files"} | {verdict: verdict for verdict in verdicts} | COLUMNS
    print(table(headings, counts, is_aligned=True))
    for row in rows:
        if row["verdict"] != "certified":
            print(f"{row['verdict']}: {row['file']}: {row['reason']}")
    sys.exit(any(row["verdict"] == "wrong" for row in rows))


def judge(program: MappingProgram, file: MeshFile) -> dict:
    mapping = program.run(file)
    distortion = mapping.map.distortion().isometric if mapping.verdict == "certified" else None
    file.forget()
    return {
        "file": str(file.path),
        "class": class_of(file.path),
        "verdict": mapping.verdict if mapping.verdict in ("certified", "refused") else "wrong",
        "reason": mapping.reason,
        "seconds": mapping.outcome.process_seconds if mapping.outcome else nan,
        "maximum": distortion.maximum if distortion else nan,
        "average": distortion.average if distortion else nan,
    }


def class_of(path: Path) -> str:
    """The files that are counted together: those of a folder, and among them the hard and the invalid ones, by name."""
    prefix = next((prefix for prefix in ("hard_", "invalid_") if path.name.startswith(prefix)), "")
    return f"{path.parent}/{prefix}*"


def shown(row: dict) -> dict:
    return row | {key: number(row[key]) for key in COLUMNS}


if __name__ == "__main__":
    main()
