#!/usr/bin/env python3
"""Measures how fast the package is, on a folder of meshes: the page of the manual on performance, in one run.

Writes report.md, runs.csv and plots; and, when all sections have been measured, manual/, a copy of the page with the
new tables and figures, to be copied over doc/Spherical_parameterization. Its last two sections, on other programs and
on kernels, are by hand. Runs are made one after the other, but for those that say "at once": leave the machine alone
meanwhile. Forty meshes of up to two million vertices take some twenty minutes with --repeat 9, of which paper mode
takes a fifth; --short takes seconds.
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
    text = "where the program and kernel_benchmark have been built (the project's build)"
    driver.add_argument("--build", type=Path, default=PROJECT / "build", help=text)
    driver.add_meshes()
    driver.add_threads()
    driver.add_argument("--large", type=Path, help="a folder with more of them, above 60,000 vertices")
    driver.add_argument("--output", type=Path, required=True, help="the folder to write to")
    driver.add_argument("--repeat", type=int, help=f"runs of which the medians are taken ({REPETITIONS})")
    text = f"the meshes that paper mode is run on, separated by commas ({','.join(PAPER_MESHES)})"
    driver.add_argument("--paper-meshes", help=text)
    driver.add_argument("--short", action="store_true", help="few tiny meshes and runs: a test of this driver")
    text = "end a run after this (7200)"
    driver.add_argument("--run-limit", type=float, default=7200.0, metavar="SECONDS", help=text)
    options = driver.parse()
    options.repeat = options.repeat or (REPETITIONS_OF_SHORT if options.short else REPETITIONS)
    if options.repeat < 1:
        driver.error("--repeat has to be 1 or more")
    return options


def make_session(options: argparse.Namespace) -> Session:
    paths = [find_program(options.build, name) for name in (PROGRAM, "kernel_benchmark")]
    if None in paths:
        sys.exit(f"{options.build} has no {PROGRAM} and kernel_benchmark: build them, or name another folder.")
    low, high = (100, MAX_VERTICES_OF_SHORT) if options.short else (MIN_VERTICES, float("inf"))
    corpus, notes = [], []
    for file in find_mesh_files([options.meshes], high):
        objection = file.objection() if file.number_of_vertices >= low else "it is too small"
        if not objection:
            corpus.append(file)
        elif not options.short:
            notes.append(f"{file.path.name} is left out: {objection}.")
    corpus.sort(key=lambda file: (file.number_of_vertices, file.name))
    if not corpus:
        sys.exit(f"There is no closed mesh of genus 0 and of a suitable size in {options.meshes}.")
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
    """What was measured with, and how."""
    large = " --large FOLDER" if options.large is not None else ""
    command = f"measure_performance.py --build BUILD --meshes FOLDER{large} --output REPORT --repeat {options.repeat}"
    where = [
        f"Machine: {describe_machine()}.",
        f"Programs: {session.timings.program(session.threads).version};"
        f" {describe_build(options.build, PROGRAM)}.",
        f"Threads: {session.threads}, where nothing else is said. One run after the other, but for those at once;"
        f" medians of {session.repetitions} runs, of at most 3 for what takes long: paper mode, meshes of {LARGE:,}"
        " vertices and more, and time against distortion.",
        f"When, and how: {version}, `{command} --threads {session.threads}`.",
    ]
    session.parts["environment"] = ["\n".join(f"- {fact}" for fact in where)]
    facts = [*where, f"Sections: {', '.join(options.only)}.", f"This report took {duration(passed)}."]
    if options.short:
        facts.append("Short version: it shows that the driver works, and no more.")
    return ["\n".join(f"- {fact}" for fact in [*facts, *session.notes])]


def write_manual(session: Session, folder: Path) -> None:
    """Writes a copy of the page in which all that has been measured is new."""
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
