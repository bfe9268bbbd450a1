#!/usr/bin/env python3
"""Measures the performance of the package on a folder of meshes: the page of the manual, in one run.

Writes report.md, runs.csv and plots. If all sections are measured, it also writes manual/, a copy of the page with new
tables and figures, to be copied to doc/Spherical_parameterization. The page shows some of the meshes, the report all of
them. The tables of other programs, of kernels, of maps between surfaces and of stages are updated separately. Runs are
sequential, except for those of several processes at once: leave the machine idle meanwhile. Forty meshes of up to two
million vertices take about twenty minutes with --repeat 9, of which the published algorithm takes a fifth; --short takes
seconds.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import sections
from measuring.drivers import MANUAL, PROGRAM, PROJECT, Driver, describe_build, describe_machine, describe_version
from measuring.drivers import find_program
from measuring.meshes import find_mesh_files
from measuring.reports import Report, duration, fill_in
from sections import LARGE, MIN_VERTICES, Session
from timings import Kernels, Timings

PAGE = MANUAL / "Performance.txt"
SECTIONS = ("comparison", "absolute", "growth", "limits", "threads", "memory", "cohort", "trade")
PAPER_MESHES = ("bunny_3485", "fandisk_6475", "hand_10345", "santa_10241", "bunny_20002")
MAX_VERTICES_OF_SHORT = 700
REPETITIONS, REPETITIONS_OF_SHORT = 5, 2


def main() -> None:
    options = read_options()
    start = time.monotonic()
    version = describe_version()
    session = make_session(options)
    for name in options.only:
        print(f"{name}, after {duration(time.monotonic() - start)}", file=sys.stderr, flush=True)
        getattr(sections, name)(session)
        session.report.write(head(session, options, version, time.monotonic() - start))
    session.report.begin_section("All runs")
    rows = [{"job": str(job), **row} for job, of_job in session.timings.rows.items() for row in of_job]
    session.report.csv("runs.csv", rows)
    session.report.write(head(session, options, version, time.monotonic() - start))
    if len(options.only) == len(SECTIONS):
        write_manual(session, options.output / "manual")
    print(options.output / "report.md")
    wrong = session.timings.different_maps() + session.objections
    wrong += [f"{job}: {text}" for job, text in session.timings.failures.items() if "--paper" not in job.arguments]
    sys.exit("\n".join(wrong) or 0)


def read_options() -> argparse.Namespace:
    driver = Driver(__doc__, SECTIONS, folders=("build", "meshes", "large"))
    text = "the build folder with the program and kernel_benchmark (that of the project)"
    driver.add_argument("--build", type=Path, default=PROJECT / "build", help=text)
    driver.add_meshes()
    driver.add_threads()
    driver.add_argument("--large", type=Path, help="a folder of larger meshes, above 60,000 vertices")
    driver.add_argument("--output", type=Path, required=True, help="the folder to write to")
    driver.add_argument("--repeat", type=int, help=f"number of runs; results are medians ({REPETITIONS})")
    text = f"the meshes for the published algorithm, separated by commas ({','.join(PAPER_MESHES)})"
    driver.add_argument("--paper-meshes", help=text)
    driver.add_argument("--short", action="store_true", help="few small meshes and runs: a test of this driver")
    text = "time limit of a run (7200)"
    driver.add_argument("--run-limit", type=float, default=7200.0, metavar="SECONDS", help=text)
    options = driver.parse()
    options.repeat = options.repeat or (REPETITIONS_OF_SHORT if options.short else REPETITIONS)
    if options.repeat < 1:
        driver.error("--repeat must be at least 1")
    return options


def make_session(options: argparse.Namespace) -> Session:
    paths = [find_program(options.build, name) for name in (PROGRAM, "kernel_benchmark")]
    if None in paths:
        sys.exit(f"{options.build} lacks {PROGRAM} or kernel_benchmark: build them, or name another folder.")
    low, high = (100, MAX_VERTICES_OF_SHORT) if options.short else (MIN_VERTICES, float("inf"))
    corpus, notes = [], []
    for file in find_mesh_files([options.meshes], high):
        objection = file.objection() if file.number_of_vertices >= low else "too small"
        if not objection:
            corpus.append(file)
        elif not options.short:
            notes.append(f"{file.path.name} is omitted: {objection}.")
    corpus.sort(key=lambda file: (file.number_of_vertices, file.name))
    if not corpus:
        sys.exit(f"{options.meshes} contains no closed mesh of genus 0 of a suitable size.")
    runs = options.output / "runs"
    runs.mkdir(parents=True, exist_ok=True)
    paper_meshes = [corpus[0].name] if options.short else list(PAPER_MESHES)
    return Session(
        timings=Timings(paths[0], runs, options.run_limit),
        kernels=Kernels(paths[1], runs, options.run_limit),
        corpus=corpus[-2:] if options.short else corpus,
        large=find_mesh_files([options.large]) if options.large is not None and not options.short else [],
        folder_for_derived=options.output / "derived",
        report=Report(options.output, "Performance"),
        threads=options.threads,
        repetitions=options.repeat,
        paper_meshes=options.paper_meshes.split(",") if options.paper_meshes else paper_meshes,
        is_short=options.short,
        notes=notes,
    )


def head(session: Session, options: argparse.Namespace, version: str, passed: float) -> list[str]:
    """The machine, the programs and the command of the measurements."""
    large = " --large FOLDER" if options.large is not None else ""
    command = f"measure_performance.py --build BUILD --meshes FOLDER{large} --output REPORT --repeat {options.repeat}"
    where = [
        f"Machine: {describe_machine()}.",
        f"Programs: {session.timings.program(session.threads).version};"
        f" {describe_build(options.build, PROGRAM)}.",
        f"Threads: {session.threads}, unless stated otherwise. Sequential runs, except for those of several processes;"
        f" medians of {session.repetitions} runs, and of at most 3 for the published algorithm, for meshes of at least"
        f" {LARGE:,} vertices, and for time against distortion.",
        f"Date and command: {version}, `{command} --threads {session.threads}`.",
    ]
    session.parts["environment"] = ["\n".join(f"- {fact}" for fact in where)]
    facts = [*where, f"Sections: {', '.join(options.only)}.", f"This report took {duration(passed)}."]
    if options.short:
        facts.append("Short version: it only shows that the driver works.")
    return ["\n".join(f"- {fact}" for fact in [*facts, *session.notes])]


def write_manual(session: Session, folder: Path) -> None:
    """Writes a copy of the page with the new measurements."""
    text = PAGE.read_text(encoding="utf-8")
    for section, paragraphs in session.parts.items():
        text = fill_in(text, section, "\n\n".join(paragraphs) + "\n")
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "fig").mkdir(parents=True)
    (folder / PAGE.name).write_text(text, encoding="utf-8")
    for figure in session.figures:
        shutil.copy(figure, folder / "fig")


if __name__ == "__main__":
    main()
