#!/usr/bin/env python3
"""Compares two builds of kernel_benchmark, kernel by kernel, on a machine that may be shared.

A build is a program kernel_benchmark, a folder with the sources of the package, or a git revision, which is checked out
and built in a temporary folder (Release).

The two run alternately, in random order within each round, on the same map of the same mesh, each time as a new process
from a new copy of the program: its address in memory alone can change the time of a kernel by 5 %. The two times of the
same round are compared, so that a drift of the machine does not count as a change.

If the builds are alike, either is equally likely to be the faster one of a round, and the signed-rank test of Wilcoxon is
valid for any distribution of the noise. The printed intervals follow from it: with a probability of 95 %, they contain
the ratios of the times, NEW over OLD, of all kernels together.

The verdict of a kernel is "slower" or "faster" if the interval does not contain 1; "same" if it does, and excludes changes
of 5 %; otherwise "unclear", and more rounds are needed.
"""

import contextlib
import itertools
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "python"))

import numpy as np
from measuring.drivers import Driver, find_program
from measuring.reports import table

LEVEL = 0.05  # the probability that any kernel is reported as changed although none has
SMALL_CHANGE = 0.05
PROGRAM = "kernel_benchmark"
COLUMNS = {"kernel": "kernel", "old": "old [ns]", "new": "new [ns]", "ratio": "ratio", "low": "from", "high": "to"}


class Failure(Exception):
    """A message for the user that ends the comparison."""


def run(command):
    """Runs a command; returns what it prints."""
    command = [str(word) for word in command]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise Failure(f"{' '.join(command)} fails with {result.returncode}:\n{result.stderr or result.stdout}")
    return result.stdout


def provide_program(stack, build, folder):
    """Returns the program of a build, which is built in `folder` if needed."""
    sources = pathlib.Path(build)
    if sources.is_file():
        return sources.resolve()
    if not (sources / "CMakeLists.txt").is_file():
        git = ["git", "-C", pathlib.Path(__file__).resolve().parent]
        try:
            commit = run([*git, "rev-parse", "--verify", "--quiet", build + "^{commit}"]).strip()
        except Failure:
            raise Failure(f"{build} is no program, no folder of sources, and no git revision.") from None
        sources = folder / "sources"
        run([*git, "worktree", "add", "--detach", sources, commit])
        stack.callback(run, [*git, "worktree", "remove", "--force", sources])
    print(f"{build}: building ...", file=sys.stderr)
    parts = [f"-DSPHERICAL_PARAMETERIZATION_BUILD_{part}" for part in ("TESTS=OFF", "EXAMPLES=OFF", "BENCHMARKS=ON")]
    run(["cmake", "-S", sources, "-B", folder / "build", "-DCMAKE_BUILD_TYPE=Release", *parts])
    run(["cmake", "--build", folder / "build", "--target", PROGRAM, "--config", "Release"])
    program = find_program(folder / "build", PROGRAM)
    if program is None:
        raise Failure(f"{sources} does not build {PROGRAM}.")
    return program


class Measurement:
    """Runs programs on one map of one mesh; `folder` is for the map and for copies."""

    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.arguments = [f"--map={folder / 'map.off'}"] + ([options.mesh] if options.mesh else [])

    def names(self, program):
        """The selected kernels of a program, without those that measure the machine."""
        settings = ["--benchmark_list_tests=true", f"--benchmark_filter={self.options.kernels}"]
        text = run([program, *settings, *self.arguments])
        return [line for line in text.splitlines() if line and not line.startswith("machine_")]

    def times(self, program, kernels):
        """Measures in a new process: for each kernel the shortest time of an item, in nanoseconds."""
        copy = self.folder / PROGRAM
        shutil.copy(program, copy)
        settings = {"format": "json", "min_time": self.options.min_time, "repetitions": self.options.repetitions}
        settings |= {"enable_random_interleaving": "true", "filter": f"^({'|'.join(kernels)})$"}
        text = run([copy, *(f"--benchmark_{name}={value}" for name, value in settings.items()), *self.arguments])
        copy.unlink()
        times = dict.fromkeys(kernels, np.inf)
        for entry in json.loads(text)["benchmarks"]:
            if entry.get("run_type", "iteration") == "iteration":
                name = entry.get("run_name", entry["name"])
                times[name] = min(times[name], 1e9 / entry["items_per_second"])
        return [times[name] for name in kernels]


def number_of_outer_averages(count, level):
    """How many of the averages of two of `count` values, themselves included, lie outside of the interval on each side,
    so that it misses the center of their symmetric distribution with a probability of at most `level`; 0 if it cannot.
    """
    chances = np.ones(1)  # that the ranks of the positive values have the sum 0, 1, 2, ...
    for rank in range(1, count + 1):
        chances = 0.5 * (np.append(chances, np.zeros(rank)) + np.append(np.zeros(rank), chances))
    return int(np.searchsorted(np.cumsum(chances), level / 2, side="right"))


def ratio_with_interval(logarithms, level):
    """The ratio (of Hodges and Lehmann) and its interval, from the logarithms of the ratios of all rounds."""
    averages = sorted((a + b) / 2 for a, b in itertools.combinations_with_replacement(logarithms, 2))
    outer = number_of_outer_averages(len(logarithms), level)
    interval = (averages[outer - 1], averages[-outer]) if outer else (-np.inf, np.inf)
    return np.exp([np.median(averages), *interval])


def verdict_of(low, high):
    if low > 1:
        return "slower"
    if high < 1:
        return "faster"
    return "same" if low > 1 / (1 + SMALL_CHANGE) and high < 1 + SMALL_CHANGE else "unclear"


def compare(options, stack):
    """Returns whether a kernel has become slower than allowed."""
    folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="compare_builds_")))
    programs = []
    for which in ("old", "new"):
        (folder / which).mkdir()
        programs.append(provide_program(stack, getattr(options, which), folder / which))
    measurement = Measurement(options, folder)
    old, new = (measurement.names(program) for program in programs)
    kernels = [name for name in old if name in new]
    if not kernels:
        raise Failure("The builds have no common kernel.")
    for name in [name for name in old + new if name not in kernels]:
        print(f"{name}: only in the {'old' if name in old else 'new'} build.", file=sys.stderr)
    level = LEVEL / len(kernels)
    if not number_of_outer_averages(options.rounds, level):
        raise Failure(f"{options.rounds} rounds are too few to detect a change of {len(kernels)} kernels; make more.")

    times = np.empty((2, options.rounds, len(kernels)))
    for number in range(options.rounds):
        if sys.stderr.isatty():
            print(f"\rround {number + 1} of {options.rounds} ", end="", file=sys.stderr, flush=True)
        for which in random.sample((0, 1), 2):
            times[which, number] = measurement.times(programs[which], kernels)
    rows, is_slower = [], False
    for i, name in enumerate(kernels):
        ratio, low, high = ratio_with_interval(np.log(times[1, :, i] / times[0, :, i]), level)
        verdict = verdict_of(low, high)
        is_slower |= options.fail_above is not None and verdict == "slower" and ratio > 1 + options.fail_above / 100
        row = {"kernel": name.split("/")[0], "verdict": verdict}  # the rest of the name says which times are measured
        row |= {which: f"{np.median(times[k, :, i]):.2f}" for k, which in enumerate(("old", "new"))}
        rows.append(row | {"ratio": f"{ratio:.4f}", "low": f"{low:.4f}", "high": f"{high:.4f}"})
    print(table(COLUMNS | {"verdict": "verdict"}, rows, is_aligned=True))
    return is_slower


def main():
    driver = Driver(__doc__)
    driver.add_argument("old", metavar="OLD", help="a build")
    driver.add_argument("new", metavar="NEW", help="a build")
    driver.add_argument("--mesh", help="the mesh, in the format OFF; by default CGAL's armadillo")
    driver.add_argument("--kernels", metavar="REGEX", default=".*", help="only the kernels whose names match")
    driver.add_argument("--rounds", type=int, help="by default 40")
    text = "how often a process measures each kernel; the shortest time counts; by default 4"
    driver.add_argument("--repetitions", type=int, metavar="N", help=text)
    text = "of each repetition (0.005)"
    driver.add_argument("--min-time", type=float, default=0.005, metavar="SECONDS", help=text)
    driver.add_argument("--short", action="store_true", help="12 rounds of 2 repetitions: detects large changes only")
    text = "end with status 1 if a kernel is slower by more than this"
    driver.add_argument("--fail-above", type=float, metavar="PERCENT", help=text)
    options = driver.parse()
    options.rounds = options.rounds or (12 if options.short else 40)
    options.repetitions = options.repetitions or (2 if options.short else 4)
    try:
        with contextlib.ExitStack() as stack:
            return 1 if compare(options, stack) else 0
    except Failure as failure:
        print(failure, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
