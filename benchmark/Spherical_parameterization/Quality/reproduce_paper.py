#!/usr/bin/env python3
"""Reproduces the tables and figures of the paper with the command line program, on a folder of meshes.

Writes report.md, one CSV file for each table and figure, plots and pictures. Needs the Debian packages python3-numpy
and python3-matplotlib. Runs are made one after the other, so that their seconds can be compared: leave the machine
alone meanwhile.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
import time
from pathlib import Path

try:
    import matplotlib  # noqa: F401 (only to see whether it is there)
    import numpy  # noqa: F401
except ImportError as error:
    sys.exit(
        f"{error}. Install python3-numpy and python3-matplotlib, and run this with that Python (/usr/bin/python3)."
    )

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from measuring.environment import find_program, find_shared_meshes, processor
from measuring.program import Program
from measuring.report import Report, duration, listed
from reproduction.checks import certificates, contradictions, yardstick
from reproduction.large_and_conformal import figure_10, figure_11
from reproduction.models import Library
from reproduction.optimization import figure_1, figure_2, figure_6, figure_7
from reproduction.pictures import Painter
from reproduction.robustness import figure_3, figure_4, figure_5
from reproduction.session import FULL_SWEEPS, SHORT_SWEEPS, Session
from reproduction.table1 import figure_8, figure_9, table_1, verdict

PROJECT = Path(__file__).resolve().parents[3]
MOST_VERTICES_OF_SHORT = 3500
SECTIONS = {
    "table1": table_1,
    "fig1": figure_1,
    "fig2": figure_2,
    "fig3": figure_3,
    "fig4": figure_4,
    "fig5": figure_5,
    "fig6": figure_6,
    "fig7": figure_7,
    "fig8": figure_8,
    "fig9": figure_9,
    "fig10": figure_10,
    "fig11": figure_11,
    "yardstick": yardstick,
    "certificates": certificates,
}


def main() -> None:
    options = read_options()
    start = time.monotonic()
    program = Program(options.program, options.threads, options.output / "runs", options.resume, options.run_limit)
    most = options.most_vertices
    derived = options.output / "derived"
    folders = [folder for folder in (options.large, options.output / "large") if folder is not None and folder.is_dir()]
    session = Session(
        program=program,
        library=Library([options.meshes], most, derived),
        large=Library(folders + [options.meshes], most, derived),
        report=Report(options.output, "The paper's results, reproduced"),
        painter=Painter(None if options.no_pictures else options.output, options.short),
        is_short=options.short,
    )
    if not session.library.files:
        sys.exit(f"There is no mesh (OFF or PLY{f', at most {most} vertices' if most else ''}) in {options.meshes}.")
    for name in options.only:
        print(f"{name}, after {duration(time.monotonic() - start)}", file=sys.stderr, flush=True)
        SECTIONS[name](session)
        session.forget_maps()
        session.report.write(head(session, options, time.monotonic() - start))
    write_all_runs(session)
    session.report.write(head(session, options, time.monotonic() - start))
    print(options.output / "report.md")
    if contradictions(program.runs):
        sys.exit("The program contradicts itself; the report says where.")


def read_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, help="the command line program (the one in the project's build folder)")
    parser.add_argument(
        "--meshes", type=Path, help="a folder of OFF and PLY files (../shared/data/meshes, if it is there)"
    )
    parser.add_argument("--large", type=Path, help="a folder with the two large meshes of figure 10")
    parser.add_argument("--output", type=Path, required=True, help="the folder to write to")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="for all runs (all cores)")
    parser.add_argument("--only", help=f"some sections, separated by commas, of: {', '.join(SECTIONS)} (all)")
    parser.add_argument(
        "--resume", action="store_true", help="use the runs that an earlier, same call has left in OUTPUT/runs"
    )
    parser.add_argument(
        "--short", action="store_true", help="small meshes, few sweeps of paper mode: a test of this driver"
    )
    parser.add_argument(
        "--most-vertices", type=int, help=f"leave larger meshes out (--short: {MOST_VERTICES_OF_SHORT})"
    )
    parser.add_argument(
        "--run-limit", type=float, default=7200.0, metavar="SECONDS", help="end a run after this (7200)"
    )
    parser.add_argument("--no-pictures", action="store_true", help="leave out the pictures of surfaces and spheres")
    options = parser.parse_args()

    options.program = options.program or find_program(PROJECT / "build", "spherical_parameterization")
    if options.program is None:
        parser.error("there is no program in the project's build folder: build it, or name it with --program")
    if not os.access(options.program, os.X_OK):
        parser.error(f"--program: {options.program} cannot be run")
    options.program = options.program.resolve()
    options.meshes = options.meshes or find_shared_meshes(PROJECT)
    if options.meshes is None:
        parser.error("--meshes is needed: there is no folder of shared meshes beside the project")
    for name in ("meshes", "large"):
        folder = getattr(options, name)
        if folder is not None and not folder.is_dir():
            parser.error(f"--{name}: {folder} is no folder")
    names = options.only.split(",") if options.only else list(SECTIONS)
    unknown = [name for name in names if name not in SECTIONS]
    if unknown:
        parser.error(f"--only: {listed(unknown)} unknown; there are {', '.join(SECTIONS)}")
    options.only = [name for name in SECTIONS if name in names]  # in the paper's order
    if options.threads < 1:
        parser.error("--threads has to be 1 or more")
    if options.short and options.most_vertices is None:
        options.most_vertices = MOST_VERTICES_OF_SHORT
    return options


def head(session: Session, options: argparse.Namespace, passed: float) -> list[str]:
    """The verdict, what it was measured with, and how."""
    program = session.program
    runs = program.runs
    reused = [run for run in runs if run.is_reused]
    facts = [
        f"Program: {program.version}.",
        (
            f"Machine: {processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()};"
            f" {program.threads} threads in every run, one run after the other."
        ),
        f"This report took {duration(passed)}, with {len(runs)} runs"
        f" ({duration(sum(run.process_seconds for run in runs))})"
        + (
            f", {len(reused)} of them from an earlier session with the same program, meshes and options."
            if reused
            else "."
        ),
        f"Sections: {', '.join(options.only)}" + (" (not all)." if len(options.only) < len(SECTIONS) else "."),
    ]
    if options.short:
        facts.append(
            f"Short version: meshes of at most {options.most_vertices:,} vertices, paper mode with"
            f" {SHORT_SWEEPS} sweeps instead of {FULL_SWEEPS}."
        )
    if session.painter.is_idle:
        facts.append("There are no rendered pictures: they were not asked for.")
    difference = max((run.row.get("difference_to_program", 0.0) for run in runs), default=0.0)
    parts = [verdict(session), "\n".join(f"- {fact}" for fact in facts)]
    wrong = contradictions(runs)
    if wrong:
        parts.append("**The program contradicts itself:**")
        parts.append("\n".join(f"- {line}" for line in wrong))
    parts.append(
        "How it is measured: all figures are computed by this driver from the mesh and the sphere that the program"
        " wrote, by eq. 12 to 14 and without weights, at the radius of eq. 11 of each map where nothing else is said:"
        " the paper, too, compares maps at one radius. A face is folded if det(u0, u1, u2) <= 0, decided exactly; its"
        " distortion is that of the flat triangle without its sign. Seconds are those of the program's own report,"
        " from reading the file to writing it; CPU seconds are the process's, of all threads. The program's own"
        f" figures of the same maps differ from the driver's by at most {difference:.1e}, relatively. A command that"
        " several sections need is run once; `runs.csv` lists all runs and where they are used."
    )
    notes = session.notes()
    if notes:
        parts.append("What this folder of meshes lacks:")
        parts.append("\n".join(f"- {note}" for note in notes))
    return parts


def write_all_runs(session: Session) -> None:
    rows = [
        {**run.row, "is_reused": run.is_reused, "used_for": "; ".join(run.used_for)} for run in session.program.runs
    ]
    session.report.begin_section("All runs")
    session.report.csv("runs.csv", rows)


if __name__ == "__main__":
    main()
