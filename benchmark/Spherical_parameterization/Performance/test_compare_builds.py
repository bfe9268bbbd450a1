#!/usr/bin/env python3
"""Tests compare_builds.py with programs that take no time, but claim to.

Usage: test_compare_builds.py
"""

import csv
import io
import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent / "compare_builds.py"

# Says what kernel_benchmark would say, with noise: a third of each time is that of the round, and the rest its own. It
# writes down how it is called.
PROGRAM = """#!{python} -IS
import json, pathlib, random, sys
NAME, TIMES, ITEMS, NOISE, FOLDER = {name!r}, {times!r}, {items!r}, {noise!r}, pathlib.Path({folder!r})
options = dict(word.lstrip("-").split("=", 1) for word in sys.argv[1:] if "=" in word)
if "benchmark_list_tests" in options:
    with open(options["map"], "a") as file:
        file.write(NAME)
    print("\\n".join(TIMES))
    sys.exit()
with open(FOLDER / "calls", "a") as file:
    print(NAME, sys.argv[0], pathlib.Path(options["map"]).read_text(), sys.argv[-1], file=file)
calls = (FOLDER / "calls").read_text().splitlines()
shared = random.Random((len(calls) - 1) // 2).uniform(1, 1.5)
own = random.Random(sum(call.startswith(NAME + " ") for call in calls) + 1000 * sum(map(ord, NAME)))
entries = []
for kernel, nanoseconds in TIMES.items():
    best = nanoseconds * shared * own.lognormvariate(0, NOISE)
    if own.random() < 0.03:
        best *= 3
    for disturbance in (1.5, 1, 2):
        rate = 1e9 / (best * disturbance)
        entries.append(dict(name=kernel, run_name=kernel, run_type="iteration", cpu_time=ITEMS / rate,
                            items_per_second=rate))
    entries.append(dict(name=kernel + "_mean", run_name=kernel, run_type="aggregate", items_per_second=1e15))
print(json.dumps(dict(benchmarks=entries)))
"""

KERNELS = {name: 100.0 + 10 * len(name) for name in ("load", "value", "sweep/real_time", "insertion", "reading")}


class Comparison(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def program(self, name, changes=None, items=10, noise=0.015, kernels=None):
        """A program with the times of KERNELS, but for `changes`, in the folder of the same name."""
        times = dict(kernels or KERNELS)
        for kernel, factor in (changes or {}).items():
            times[kernel] *= factor
        text = PROGRAM.format(
            python=sys.executable, name=name, times=times, items=items, noise=noise, folder=str(self.folder)
        )
        return self.executable(name, text)

    def executable(self, name, text):
        path = self.folder / name / "kernel_benchmark"
        path.parent.mkdir()
        path.write_text(text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    def run_script(self, *arguments, status=0, script=SCRIPT):
        command = [sys.executable, str(script), *map(str, arguments)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def rows(self, *arguments, status=0):
        """The rows by the names of the kernels."""
        text = self.run_script("--rounds", 30, "--csv", *arguments, status=status).stdout
        return {row["kernel"]: row for row in csv.DictReader(io.StringIO(text))}

    def assert_verdicts(self, rows, expected):
        self.assertEqual({name: row["verdict"] for name, row in rows.items()}, expected)

    def test_equal_builds(self):
        rows = self.rows("--fail-above", 0, self.program("a"), self.program("b"))
        self.assert_verdicts(rows, dict.fromkeys(("load", "value", "sweep", "insertion", "reading"), "same"))

    def test_changes_of_five_percent(self):
        old, new = self.program("a"), self.program("b", {"value": 1.05, "insertion": 1 / 1.05})
        rows = self.rows("--fail-above", 2, old, new, status=1)
        expected = dict.fromkeys(("load", "sweep", "reading"), "same")
        self.assert_verdicts(rows, {**expected, "value": "slower", "insertion": "faster"})
        self.assertAlmostEqual(float(rows["value"]["ratio"]), 1.05, delta=0.02)
        self.assertAlmostEqual(float(rows["insertion"]["ratio"]), 1 / 1.05, delta=0.02)
        self.assertLess(float(rows["value"]["from"]), 1.05)
        self.assertGreater(float(rows["value"]["to"]), 1.05)
        self.run_script("--short", "--fail-above", 10, old, new)
        self.run_script("--short", old, new)
        self.run_script("--fail-above", 2, new, old, status=1)  # because of the other one

    def test_noise_hides_changes(self):
        rows = self.rows("--fail-above", 0, self.program("a", noise=0.3), self.program("b", {"value": 1.05}, noise=0.3))
        self.assert_verdicts(rows, dict.fromkeys(("load", "value", "sweep", "insertion", "reading"), "unclear"))

    def test_time_is_that_of_an_item(self):
        rows = self.rows(self.program("a", items=10), self.program("b", items=20))
        self.assertEqual({row["verdict"] for row in rows.values()}, {"same"})

    def test_shortest_time_counts(self):
        rows = self.rows(self.program("a", noise=0.0), self.program("b", noise=0.0))
        self.assertTrue(140 <= float(rows["load"]["old [ns]"]) <= 1.5 * 140)  # not the mean, nor those disturbed

    def test_interleaving(self):
        old, new = self.program("a"), self.program("b")
        self.run_script("--rounds", 30, "--mesh", "some.off", old, new)
        calls = [line.split() for line in (self.folder / "calls").read_text().splitlines()]
        rounds = ["".join(call[0] for call in calls[k : k + 2]) for k in range(0, len(calls), 2)]
        self.assertEqual(len(rounds), 30)
        self.assertEqual(set(rounds), {"ab", "ba"})
        for _, path, written_by, mesh in calls:
            self.assertNotIn(pathlib.Path(path), (old, new))  # it is a copy
            self.assertEqual(written_by, "ab")  # the same map for both, and the first call makes it
            self.assertEqual(mesh, "some.off")

    def test_markdown(self):
        text = self.run_script("--short", self.program("a"), self.program("b")).stdout
        lines = text.splitlines()
        self.assertEqual(len(lines), 2 + len(KERNELS))
        self.assertEqual(len({len(line) for line in lines}), 1, text)
        self.assertRegex(lines[0], r"^\| kernel +\| +old \[ns\] \|")
        self.assertRegex(lines[1], r"^\|:-+\|-+:\|")

    def test_different_kernels(self):
        old, new = self.program("a", kernels={"x": 1.0, "y": 1.0}), self.program("b", kernels={"y": 1.0, "z": 1.0})
        result = self.run_script(old, new)
        self.assertIn("x: only the old build has it", result.stderr)
        self.assertIn("z: only the new build has it", result.stderr)
        self.assertRegex(result.stdout, r"(?m)^\| y ")
        self.assertNotRegex(result.stdout, r"(?m)^\| [xz] ")
        other = self.program("c", kernels={"w": 1.0})
        self.assertIn("no kernel that both", self.run_script(old, other, status=2).stderr)

    def test_too_few_rounds(self):
        old, new = self.program("a"), self.program("b")
        self.assertIn("make more", self.run_script("--rounds", 7, old, new, status=2).stderr)
        self.run_script("--rounds", 8, old, new)  # 2 / 2^8 is less than a fifth of 5 %

    def test_failing_programs(self):
        good, bad = self.program("a"), self.executable("bad", "#!/bin/sh\necho no luck >&2\nexit 3\n")
        for builds in ((good, bad), (bad, good)):
            self.assertIn("no luck", self.run_script(*builds, status=2).stderr)
        self.assertIn("no git revision", self.run_script(good, "no-such-build", status=2).stderr)

    @unittest.skipUnless(shutil.which("git") and shutil.which("cmake"), "needs git and cmake")
    def test_sources_and_revisions(self):
        sources = self.folder / "sources"
        sources.mkdir()
        script = sources / SCRIPT.name
        shutil.copy(SCRIPT, script)
        (sources / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.12)\nproject(p NONE)\n"
            "if(SPHERICAL_PARAMETERIZATION_BUILD_BENCHMARKS AND CMAKE_BUILD_TYPE STREQUAL Release)\n"
            "  add_custom_target(kernel_benchmark cp ${CMAKE_SOURCE_DIR}/program ${CMAKE_BINARY_DIR}/kernel_benchmark)\n"
            "endif()\n"
        )

        def git(*arguments):
            identity = ["-c", "user.name=nobody", "-c", "user.email=nobody@localhost"]
            environment = {key: value for key, value in os.environ.items() if not key.startswith("GIT_")}
            command = ["git", "-C", str(sources), *identity, *arguments]
            return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout

        git("init", "-q")
        for name, factor in (("a", 1.0), ("b", 1.2), ("c", 1.5)):
            shutil.copy(self.program(name, {"value": factor}), sources / "program")
            if name != "c":  # which stays uncommitted
                git("add", ".")
                git("commit", "-q", "-m", name)
        for builds, ratio in ((("HEAD~1", "HEAD"), 1.2), (("HEAD", sources), 1.25)):
            text = self.run_script("--short", "--csv", *builds, script=script).stdout
            row = next(row for row in csv.DictReader(io.StringIO(text)) if row["kernel"] == "value")
            self.assertAlmostEqual(float(row["ratio"]), ratio, delta=0.05)
            self.assertEqual(len(git("worktree", "list").splitlines()), 1)
        (sources / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.12)\nproject(p NONE)\n")
        self.assertIn("kernel_benchmark", self.run_script("HEAD", sources, status=2, script=script).stderr)


if __name__ == "__main__":
    unittest.main()
