#!/usr/bin/env python3
"""Reproduces the tables and figures of the paper with the command line program, on a folder of meshes.

Writes report.md, one CSV file for each table and figure, plots and pictures. Runs are made one after the other, so that
their seconds can be compared: leave the machine alone meanwhile.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.drivers import Driver, describe_machine
from measuring.reports import Report, duration
from measuring.runs import Program
from reproduction import experiments
from reproduction.experiment import Session
from reproduction.models import Library

MAX_VERTICES_OF_SHORT = 700
SECTIONS = {
    "table1": experiments.table_1,
    **{f"fig{i}": getattr(experiments, f"figure_{i}") for i in range(1, 12)},
    "yardstick": experiments.yardstick,
    "certificates": experiments.certificates,
}


def main() -> None:
    options = read_options()
    start = time.monotonic()
    program = Program(options.program, options.threads, options.output / "runs", options.resume, options.run_limit)
    folders = [options.large, options.meshes] if options.large else [options.meshes]
    derived = options.output / "derived"
    session = Session(
        program=program,
        library=Library([options.meshes], options.max_vertices, derived),
        large=Library(folders, options.max_vertices, derived),
        report=Report(options.output, "The paper's results, reproduced"),
        has_pictures=not options.no_pictures,
        is_short=options.short,
    )
    if not session.library.files:
        sys.exit(f"There is no mesh of a suitable size in {options.meshes}.")
    for name in options.only:
        print(f"{name}, after {duration(time.monotonic() - start)}", file=sys.stderr, flush=True)
        SECTIONS[name](session)
        session.report.write(head(session, options, time.monotonic() - start))
    session.report.begin_section("All runs")
    session.report.csv("runs.csv", [run.row | {"used_for": "; ".join(run.used_for)} for run in program.runs])
    session.report.write(head(session, options, time.monotonic() - start))
    print(options.output / "report.md")
    if program.contradictions():
        sys.exit("The program contradicts itself; the report says where.")


def read_options() -> argparse.Namespace:
    driver = Driver(__doc__, tuple(SECTIONS), folders=("meshes", "large"))
    driver.add_program()
    driver.add_meshes()
    driver.add_threads()
    driver.add_argument("--large", type=Path, help="a folder with the two large meshes of figure 10")
    driver.add_argument("--output", type=Path, required=True, help="the folder to write to")
    driver.add_argument("--resume", action="store_true", help="use the runs that a same call has left in OUTPUT/runs")
    driver.add_argument("--short", action="store_true", help="tiny meshes, few sweeps of paper mode: tests this driver")
    text = f"leave larger meshes out (--short: {MAX_VERTICES_OF_SHORT})"
    driver.add_argument("--max-vertices", type=int, default=math.inf, help=text)
    text = "end a run after this (7200)"
    driver.add_argument("--run-limit", type=float, default=7200.0, metavar="SECONDS", help=text)
    driver.add_argument("--no-pictures", action="store_true", help="leave out the pictures of surfaces and spheres")
    options = driver.parse()
    if options.short:
        options.max_vertices = min(options.max_vertices, MAX_VERTICES_OF_SHORT)
    return options


def head(session: Session, options: argparse.Namespace, passed: float) -> list[str]:
    """The verdict, what it was measured with, and how."""
    runs = session.program.runs
    facts = [
        f"Program: {session.program.version}.",
        f"Machine: {describe_machine()}; {session.program.threads} threads in every run, one run after the other.",
        f"This report took {duration(passed)}, with {len(runs)} runs, {sum(run.is_reused for run in runs)} of them from"
        " an earlier session with the same program, meshes and options.",
        f"Sections: {', '.join(options.only)}.",
    ]
    if options.short:
        facts.append(f"Short version: meshes of at most {options.max_vertices:,} vertices, few sweeps of paper mode.")
    difference = max((run.row.get("difference_to_program", 0.0) for run in runs), default=0.0)
    wrong = [f"**The program contradicts itself:** {line}" for line in session.program.contradictions()]
    how = (
        "How it is measured: all figures are computed by this driver from the mesh and the sphere that the program"
        " wrote, by eq. 12 to 14 and without weights, at the radius of eq. 11 of each map where nothing else is said:"
        " the paper, too, compares maps at one radius. A face is inverted if det(u0, u1, u2) <= 0, decided exactly; its"
        " distortion is that of the flat triangle without its sign. Seconds are those of the program's own report,"
        " from reading the file to writing it; CPU seconds are the process's, of all threads. The program's own"
        f" figures of the same maps differ from the driver's by at most {difference:.1e}, relatively. A command that"
        " several sections need is run once; `runs.csv` lists all runs and where they are used."
    )
    notes = [f"- {note}" for note in dict.fromkeys(session.library.notes)]
    lacking = ["What this folder of meshes lacks:", "\n".join(notes)] if notes else []
    return [experiments.verdict(session), "\n".join(f"- {fact}" for fact in facts), *wrong, how, *lacking]


if __name__ == "__main__":
    main()
