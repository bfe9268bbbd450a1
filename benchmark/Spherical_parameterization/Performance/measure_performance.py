#!/usr/bin/env python3
"""Measures how fast the package is, on a folder of meshes: the page of the manual on performance, in one run.

Writes report.md, one CSV file for each section and plots; and, when all sections have been measured, manual/, a copy of
the page with the new tables and figures, to be copied over doc/Spherical_parameterization. Its last two sections, on
other programs and on kernels, are by hand. Needs the Debian packages python3-numpy and python3-matplotlib. Runs are
made one after the other, but for those that say "at once": leave the machine alone meanwhile. Forty meshes of up to two
million vertices take some twenty minutes with --repeat 9, of which paper mode takes a fifth; --short takes less than a
minute.
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

from measuring.environment import describe_build, describe_version, find_program, find_shared_meshes, processor
from measuring.mesh_files import MeshFile, find_mesh_files
from measuring.meshes import MeshError, why_not_a_sphere
from measuring.program import CERTIFIED, Program
from measuring.report import Report, duration, listed
from performance.benchmark_program import BenchmarkProgram, Measurement
from performance.cohort import cohort
from performance.comparison import comparison, method_of
from performance.limits import limits
from performance.manual import Manual
from performance.session import LARGE, LEAST_VERTICES, Session
from performance.stages import absolute, growth, memory, threads
from performance.trade import trade

PROJECT = Path(__file__).resolve().parents[3]
PAGE = PROJECT / "doc" / "Spherical_parameterization" / "Performance.txt"
SECTIONS = {
    "comparison": comparison,
    "absolute": absolute,
    "growth": growth,
    "limits": limits,
    "threads": threads,
    "memory": memory,
    "cohort": cohort,
    "trade": trade,
}
PAPER_MESHES = ("bunny_3485", "fandisk_6475", "hand_10345", "santa_10241", "bunny_20002")
MOST_VERTICES_OF_SHORT = 3500
REPETITIONS, REPETITIONS_OF_SHORT = 5, 2


def main() -> None:
    options = read_options()
    start = time.monotonic()
    version = describe_version(PROJECT)
    session = make_session(options)
    for name in options.only:
        print(f"{name}, after {duration(time.monotonic() - start)}", file=sys.stderr, flush=True)
        SECTIONS[name](session)
        write(session, options, version, time.monotonic() - start)
    write_all_runs(session)
    write(session, options, version, time.monotonic() - start)
    is_whole = len(options.only) == len(SECTIONS) and not options.short
    wrong = contradictions(session) + failures(session) + session.objections + session.manual.write(is_whole)
    print(options.output / "report.md")
    if wrong:
        sys.exit("\n".join(wrong))


def read_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--build", type=Path, default=PROJECT / "build", help="where the programs have been built (the project's build)"
    )
    parser.add_argument(
        "--meshes", type=Path, help="a folder of OFF and PLY files (../shared/data/meshes, if it is there)"
    )
    parser.add_argument("--large", type=Path, help="a folder with more of them, above 60,000 vertices")
    parser.add_argument("--output", type=Path, required=True, help="the folder to write to")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="as many as cores (all)")
    parser.add_argument("--repeat", type=int, help=f"runs of which the medians are taken ({REPETITIONS})")
    parser.add_argument("--only", help=f"some sections, separated by commas, of: {', '.join(SECTIONS)} (all)")
    parser.add_argument(
        "--paper-meshes",
        help=f"the meshes that paper mode is run on, separated by commas ({','.join(PAPER_MESHES)})",
    )
    parser.add_argument(
        "--resume", action="store_true", help="use the runs that an earlier, same call has left in OUTPUT/runs, but for the cohort"
    )
    parser.add_argument("--short", action="store_true", help="few small meshes and runs: a test of this driver")
    parser.add_argument(
        "--run-limit", type=float, default=7200.0, metavar="SECONDS", help="end a run after this (7200)"
    )
    options = parser.parse_args()

    options.meshes = options.meshes or find_shared_meshes(PROJECT)
    if options.meshes is None:
        parser.error("--meshes is needed: there is no folder of shared meshes beside the project")
    for name in ("build", "meshes", "large"):
        folder = getattr(options, name)
        if folder is not None and not folder.is_dir():
            parser.error(f"--{name}: {folder} is no folder")
    names = options.only.split(",") if options.only else list(SECTIONS)
    unknown = [name for name in names if name not in SECTIONS]
    if unknown:
        parser.error(f"--only: {listed(unknown)} unknown; there are {', '.join(SECTIONS)}")
    options.only = [name for name in SECTIONS if name in names]
    if options.threads < 1:
        parser.error("--threads has to be 1 or more")
    options.repeat = options.repeat or (REPETITIONS_OF_SHORT if options.short else REPETITIONS)
    if options.repeat < 1:
        parser.error("--repeat has to be 1 or more")
    return options


def make_session(options: argparse.Namespace) -> Session:
    runs = options.output / "runs"

    def path_of(name: str) -> Path:
        path = find_program(options.build, name)
        if path is None:
            sys.exit(f"There is no program {name} in {options.build}: build it, or name another folder with --build.")
        return path

    def benchmark(name: str) -> BenchmarkProgram:
        return BenchmarkProgram(path_of(name), runs, options.resume, options.run_limit)

    most = MOST_VERTICES_OF_SHORT if options.short else None
    corpus, notes = [], []
    for file in find_mesh_files(options.meshes, most):
        objection = objection_to(file) if file.number_of_vertices >= LEAST_VERTICES else "it is too small"
        if not objection:
            corpus.append(file)
        elif not options.short:
            notes.append(f"{file.path.name} is left out: {objection}.")
    corpus.sort(key=lambda file: (file.number_of_vertices, file.name))
    if options.short:
        corpus = corpus[-2:]
    if not corpus:
        limits_of_size = f"{LEAST_VERTICES:,}{f' to {most:,}' if most else ' or more'} vertices"
        sys.exit(f"There is no closed mesh of genus 0 with {limits_of_size} (OFF or PLY) in {options.meshes}.")
    paper_meshes = list(PAPER_MESHES)
    if options.paper_meshes:
        paper_meshes = options.paper_meshes.split(",")
    elif options.short:
        paper_meshes = [corpus[0].name]
    return Session(
        program=Program(
            path_of("spherical_parameterization"), options.threads, runs, options.resume, options.run_limit
        ),
        stages=benchmark("performance_benchmark"),
        limits=benchmark("machine_limits"),
        corpus=corpus,
        large=find_mesh_files(options.large) if options.large is not None and not options.short else [],
        simplify=path_of("simplify_mesh"),
        folder_for_derived=options.output / "derived",
        report=Report(options.output, "Performance"),
        manual=Manual(PAGE, options.output / "manual"),
        threads=options.threads,
        repetitions=options.repeat,
        paper_meshes=paper_meshes,
        is_short=options.short,
        notes=notes,
    )


def objection_to(file: MeshFile) -> str:
    """Why a mesh is none that can be mapped, as far as is easily seen."""
    try:
        return why_not_a_sphere(file.mesh)
    except MeshError as error:
        return str(error)
    finally:
        file.forget()


def write(session: Session, options: argparse.Namespace, version: str, passed: float) -> None:
    """Writes the report as far as it has come."""
    where = [
        f"Machine: {processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}.",
        f"Programs: {session.program.version}; {describe_build(options.build, 'performance_benchmark')}.",
        f"Threads: {session.threads}, where nothing else is said. One run after the other, but for those at once; medians"
        f" of {session.repetitions} runs, of at most 3 for what takes long: paper mode, meshes of {LARGE:,} vertices and"
        " more, the floor, and time against distortion.",
        f"When, and how: {version}, {command(options)}.",
    ]
    if options.resume:
        runs = [*session.program.runs, *_measurements(session)]
        where.append(f"{sum(run.is_reused for run in runs)} of {len(runs)} runs are from an earlier session.")
    facts = [
        *where,
        f"Sections: {', '.join(options.only)}" + (" (not all)." if len(options.only) < len(SECTIONS) else "."),
        f"This report took {duration(passed)}.",
    ]
    if options.short:
        facts.append("Short version: it shows that the driver works, and no more.")
    parts = ["\n".join(f"- {fact}" for fact in facts)]
    wrong = contradictions(session)
    if wrong:
        parts += ["**The programs contradict themselves:**", "\n".join(f"- {line}" for line in wrong)]
    if session.notes:
        parts += ["About the meshes:", "\n".join(f"- {note}" for note in dict.fromkeys(session.notes))]
    session.report.write(parts)
    session.manual.set("environment", "\n".join(f"- {fact}" for fact in where))


def command(options: argparse.Namespace) -> str:
    """The command that measures the same, without the names of folders."""
    words = [Path(__file__).name, "--build BUILD", "--meshes FOLDER"]
    if options.large is not None:
        words.append("--large FOLDER")
    words += ["--output REPORT", f"--repeat {options.repeat}", f"--threads {options.threads}"]
    if options.short:
        words.append("--short")
    if len(options.only) < len(SECTIONS):
        words.append(f"--only {','.join(options.only)}")
    if options.paper_meshes:
        words.append(f"--paper-meshes {options.paper_meshes}")
    return f"`{' '.join(words)}`"


def contradictions(session: Session) -> list[str]:
    """Maps that are not what the programs say, and results that differ between runs."""
    lines = [
        f"{run.mesh.name}, `{run.command}`: exit status 0, but {run.row['folded_faces']} faces are folded"
        for run in session.program.runs
        if run.exit_status == CERTIFIED and run.row.get("folded_faces")
    ]
    fingerprints: dict[tuple, set] = {}
    for measurement in session.stages.measurements:
        key = (measurement.mesh.name, *_without_threads(measurement.arguments))
        fingerprints.setdefault(key, set()).update(row["fingerprint"] for row in measurement.rows)
    lines += [f"{' '.join(key)}: the map differs between runs" for key, found in fingerprints.items() if len(found) > 1]
    return lines


def failures(session: Session) -> list[str]:
    """What could not be measured; paper mode may have no map."""
    lines = [
        f"{measurement.mesh.name}, `{measurement.words}`: {measurement.message}"
        for measurement in _measurements(session)
        if measurement.message
    ]
    lines += [
        f"{run.mesh.name}, `{run.command}`: {run.message}"
        for run in session.program.runs
        if not run.has_map and method_of(run) == "default"
    ]
    return list(dict.fromkeys(lines))


def _without_threads(arguments: tuple[str, ...]) -> list[str]:
    """What a result may depend on."""
    words = list(arguments)
    if "--threads" in words:
        position = words.index("--threads")
        del words[position : position + 2]
    return words


def _measurements(session: Session) -> list[Measurement]:
    return session.stages.measurements + session.limits.measurements


def write_all_runs(session: Session) -> None:
    session.report.begin_section("All runs")
    rows = [
        {
            "arguments": " ".join(measurement.arguments),
            "copies": measurement.copies,
            "is_reused": measurement.is_reused,
            **row,
        }
        for measurement in session.stages.measurements
        for row in measurement.rows
    ]
    session.report.csv("runs.csv", rows)


if __name__ == "__main__":
    main()
