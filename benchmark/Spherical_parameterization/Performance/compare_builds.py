#!/usr/bin/env python3
"""Compares two builds of kernel_benchmark, kernel by kernel, on a machine that others may be using as well.

A build is a program kernel_benchmark, a folder with the sources of the package, or a git revision of them, which is checked
out and built in a temporary folder (Release).

The two run in turn, in random order within each round, on the same map of the same mesh, and each time as a new process from
a new copy of the program: a copy lies elsewhere in the memory, which alone can change the time of a kernel by 5 %. What is
compared are the two times of a round, so that no drift of the machine is taken for a change.

If the builds are alike, either has the same chance to be the faster one of a round, and the signed-rank test of Wilcoxon
holds, whatever the noise is like. The intervals that are printed belong to it: with a probability of 95 %, the ratios of the
times, NEW over OLD, lie in them, those of all kernels at once.

The verdict of a kernel: slower or faster, if the interval does not hold 1; same, if it does and no change of 5 % is in it;
unclear else, and more rounds are needed.
"""

import argparse
import bisect
import contextlib
import csv
import itertools
import json
import math
import os
import pathlib
import random
import shutil
import statistics
import subprocess
import sys
import tempfile

LEVEL = 0.05  # the chance that any kernel is called changed though none has
SMALL_CHANGE = 0.05
PROGRAM = "kernel_benchmark"


class Failure(Exception):
    """What ends the comparison, for the user to read."""


def run(command, **options):
    """Runs a command; returns what it prints."""
    command = [str(word) for word in command]
    result = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if result.returncode != 0:
        raise Failure(f"{' '.join(command)} fails with {result.returncode}:\n{result.stderr or result.stdout}")
    return result.stdout


def build_sources(sources, folder):
    """Builds the benchmark of the package in `sources`; returns the program."""
    run(
        [
            "cmake",
            "-S",
            sources,
            "-B",
            folder,
            "-DCMAKE_BUILD_TYPE=Release",
            "-DSPHERICAL_PARAMETERIZATION_BUILD_TESTS=OFF",
            "-DSPHERICAL_PARAMETERIZATION_BUILD_EXAMPLES=OFF",
            "-DSPHERICAL_PARAMETERIZATION_BUILD_BENCHMARKS=ON",
        ]
    )
    run(["cmake", "--build", folder, "--target", PROGRAM, "--config", "Release"])
    programs = [path for path in folder.rglob(PROGRAM) if path.is_file() and os.access(path, os.X_OK)]
    if not programs:
        raise Failure(f"{sources} does not build {PROGRAM}.")
    return programs[0]


def check_out(stack, revision, folder):
    """Puts a revision of the repository that this script is in into `folder`, until the stack is left."""
    git = ["git", "-C", pathlib.Path(__file__).resolve().parent]
    try:
        commit = run([*git, "rev-parse", "--verify", "--quiet", revision + "^{commit}"]).strip()
    except Failure:
        raise Failure(f"{revision} is no program, no folder of sources, and no git revision.") from None
    run([*git, "worktree", "add", "--detach", folder, commit])
    stack.callback(run, [*git, "worktree", "remove", "--force", folder])


def find_program(stack, build, folder):
    """Returns the program of a build; `folder` is for what has to be made first."""
    path = pathlib.Path(build)
    if path.is_file():
        return path.resolve()
    sources = path
    if not (path / "CMakeLists.txt").is_file():
        sources = folder / "sources"
        check_out(stack, build, sources)
    print(f"{build}: building ...", file=sys.stderr)
    return build_sources(sources, folder / "build")


class Measurement:
    """Runs programs on one map of one mesh; `folder` is for the map and for copies."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.arguments = [f"--map={folder / 'map.off'}"] + ([options.mesh] if options.mesh else [])

    def names(self, program):
        """The kernels of a program that are asked for. The first call makes the map."""
        text = run([program, "--benchmark_list_tests=true", *self.filter(), *self.arguments])
        return [line for line in text.splitlines() if line]

    def times(self, program):
        """Measures in a new process: for each kernel the shortest time of an item, in nanoseconds."""
        copy = self.folder / PROGRAM
        shutil.copy(program, copy)
        text = run(
            [
                copy,
                "--benchmark_format=json",
                f"--benchmark_min_time={self.options.min_time}",
                f"--benchmark_repetitions={self.options.repetitions}",
                "--benchmark_enable_random_interleaving=true",
                *self.filter(),
                *self.arguments,
            ]
        )
        copy.unlink()
        times = {}
        for entry in json.loads(text)["benchmarks"]:
            if entry.get("run_type", "iteration") == "iteration":
                name = entry.get("run_name", entry["name"])
                times[name] = min(times.get(name, math.inf), 1e9 / entry["items_per_second"])
        return times

    def filter(self):
        return [f"--benchmark_filter={self.options.kernels}"]


def rank_sum_counts(count):
    """How many of the 2^count sets of ranks have the sums 0, 1, 2, ..."""
    counts = [1]
    for rank in range(1, count + 1):
        longer = counts + [0] * rank
        counts = [value + (longer[k - rank] if k >= rank else 0) for k, value in enumerate(longer)]
    return counts


def number_of_outer_averages(count, level):
    """How many of the averages of two of `count` values, themselves included, lie outside of the interval on each side, so
    that it misses the centre of their symmetric distribution with a probability of at most `level`; 0 if it cannot."""
    cumulative = list(itertools.accumulate(rank_sum_counts(count)))
    return bisect.bisect_right(cumulative, level / 2 * 2**count)


def ratio_with_interval(logarithms, level):
    """The ratio (of Hodges and Lehmann) and its interval, from the logarithms of the ratios of all rounds."""
    averages = sorted((a + b) / 2 for a, b in itertools.combinations_with_replacement(logarithms, 2))
    outer = number_of_outer_averages(len(logarithms), level)
    interval = (averages[outer - 1], averages[-outer]) if outer else (-math.inf, math.inf)
    return math.exp(statistics.median(averages)), math.exp(interval[0]), math.exp(interval[1])


def verdict_of(low, high):
    if low > 1:
        return "slower"
    if high < 1:
        return "faster"
    return "same" if low > 1 / (1 + SMALL_CHANGE) and high < 1 + SMALL_CHANGE else "unclear"


def measure(options, programs, measurement, kernels):
    """The times of each kernel, one list for each program."""
    times = {name: ([], []) for name in kernels}
    for number in range(options.rounds):
        if sys.stderr.isatty():
            print(f"\rround {number + 1} of {options.rounds} ", end="", file=sys.stderr, flush=True)
        for which in random.sample((0, 1), 2):
            found = measurement.times(programs[which])
            for name in kernels:
                times[name][which].append(found[name])
    if sys.stderr.isatty():
        print("\r" + " " * 40 + "\r", end="", file=sys.stderr)
    return times


def print_table(rows, is_csv):
    header = ("kernel", "old [ns]", "new [ns]", "ratio", "from", "to", "verdict")
    texts = [
        [row[0], *(f"{value:.2f}" for value in row[1:3]), *(f"{value:.4f}" for value in row[3:6]), row[6]]
        for row in rows
    ]
    if is_csv:
        csv.writer(sys.stdout, lineterminator="\n").writerows([header, *texts])
        return
    widths = [max(len(row[i]) for row in [header, *texts]) for i in range(len(header))]
    aligned = ["<", *">>>>>", "<"]
    for row in [header, *texts]:
        print("| " + " | ".join(f"{cell:{a}{w}}" for cell, a, w in zip(row, aligned, widths)) + " |")
        if row is header:
            print(
                "|"
                + "|".join(":" + "-" * (w + 1) if a == "<" else "-" * (w + 1) + ":" for a, w in zip(aligned, widths))
                + "|"
            )


def compare(options, stack):
    """Returns whether a kernel has become slower than is allowed."""
    folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="compare_builds_")))
    programs = []
    for which in ("old", "new"):
        (folder / which).mkdir()
        programs.append(find_program(stack, getattr(options, which), folder / which))

    measurement = Measurement(options, folder)
    old, new = (measurement.names(program) for program in programs)
    kernels = [name for name in old if name in new]
    if not kernels:
        raise Failure("There is no kernel that both builds have.")
    for which, names, others in (("old", old, new), ("new", new, old)):
        for name in names:
            if name not in others:
                print(f"{name}: only the {which} build has it.", file=sys.stderr)
    level = LEVEL / len(kernels)
    if not number_of_outer_averages(options.rounds, level):
        raise Failure(f"No change of {len(kernels)} kernels can be told in {options.rounds} rounds; make more.")

    rows = []
    for name, (old_times, new_times) in measure(options, programs, measurement, kernels).items():
        logarithms = [math.log(b / a) for a, b in zip(old_times, new_times)]
        ratio, low, high = ratio_with_interval(logarithms, level)
        # The first word is the name, the rest tells what the times are.
        rows.append(
            (
                name.split("/")[0],
                statistics.median(old_times),
                statistics.median(new_times),
                ratio,
                low,
                high,
                verdict_of(low, high),
            )
        )
    print_table(rows, options.csv)
    if options.fail_above is None:
        return False
    return any(row[6] == "slower" and row[3] > 1 + options.fail_above / 100 for row in rows)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", metavar="OLD", help="a build")
    parser.add_argument("new", metavar="NEW", help="a build")
    parser.add_argument("--mesh", help="the mesh; by default CGAL's armadillo")
    parser.add_argument("--kernels", metavar="REGEX", default=".*", help="only the kernels whose names match")
    parser.add_argument("--rounds", type=int, help="by default 40")
    parser.add_argument(
        "--repetitions",
        type=int,
        metavar="N",
        help="how often a process measures each kernel; the shortest time counts; by default 4",
    )
    parser.add_argument(
        "--min-time", type=float, default=0.005, metavar="SECONDS", help="of each repetition (default: 0.005)"
    )
    parser.add_argument("--short", action="store_true", help="12 rounds of 2 repetitions: sees large changes only")
    parser.add_argument(
        "--fail-above",
        type=float,
        metavar="PERCENT",
        help="end with status 1 if a kernel is slower, by more than so much",
    )
    parser.add_argument("--csv", action="store_true", help="print comma-separated values instead of Markdown")
    options = parser.parse_args()
    options.rounds = options.rounds or (12 if options.short else 40)
    options.repetitions = options.repetitions or (2 if options.short else 4)
    return options


def main():
    options = parse_arguments()
    try:
        with contextlib.ExitStack() as stack:
            return 1 if compare(options, stack) else 0
    except Failure as failure:
        print(failure, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
