#!/usr/bin/env python3
"""Usage: scripts/test_mutants.py [--count N] [--seed S] [--tests FOLDER] [--jobs J] DIRECTORY

Do the tests notice a mistake? Makes N mutants of the hierarchy, the descent, the certificate and the readers, 200 by default, each of
which differs in one comparison, sum, condition or number, and prints how many of them no test kills, and which. Sites are drawn by a
generator that is seeded with S, so the same ones again. With --tests, those of another checkout judge, by the same mutants.

All mutants are compiled at once, into a copy of the package in DIRECTORY, and the environment variable MUTANT says which one acts:
building takes as long as that of the tests, then each mutant as long as the tests that it passes. It is killed if a test fails or
crashes, or takes three times as long as without it. What was found out already is kept in DIRECTORY, so it may be stopped.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = pathlib.Path("include/CGAL/Spherical_parameterization")
# What is mutated, and the tests that judge it first: those of its own room. The others follow for what these let pass.
ROOMS = {
    "internal/hierarchy": ["hierarchy"],
    "internal/descent": ["descent", "parameterizers"],
    "internal/certificate": ["certificate"],
    "internal/surface": ["mesh"],
    "internal/files": ["files"],
    "Cortex/internal": ["files"],
}
TESTS = ["numbers", "hierarchy", "certificate", "files", "mesh", "descent", "measuring", "initializers", "areas", "parameterizers",
         "harmonics", "sampling", "corpus", "surfaces", "program"]
SWITCH = """// Which mutant acts, and the operators that ask; see scripts/test_mutants.py.
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MUTANTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MUTANTS_H
#include <cstdlib>
#include <type_traits>
namespace mutants {
inline const int active = std::getenv("MUTANT") ? std::atoi(std::getenv("MUTANT")) : 0;
template <class A, int i> struct Left { const A& a; };
// a < Operator<i>() < b is read from the left, so precedence is what it was.
#define MUTANT_OPERATOR(name, before, after)                                                                   \\
  template <int i> struct name {};                                                                             \\
  template <class A, int i> Left<A, i> operator before(const A& a, name<i>) { return {a}; }                    \\
  template <class A, int i, class B> auto operator before(Left<A, i> l, const B& b)                            \\
  { return active == i ? l.a after b : l.a before b; }
MUTANT_OPERATOR(Less, <, <=)
MUTANT_OPERATOR(Less_equal, <=, <)
MUTANT_OPERATOR(Greater, >, >=)
MUTANT_OPERATOR(Greater_equal, >=, >)
MUTANT_OPERATOR(Equal, ==, !=)
MUTANT_OPERATOR(Not_equal, !=, ==)
MUTANT_OPERATOR(Plus, +, -)
MUTANT_OPERATOR(Minus, -, +)
template <int i, class T> T number(T before, T after) { return active == i ? after : before; }
template <int i> bool condition(bool c) { return c != (active == i); }
} // namespace mutants
#endif
"""
OPERATORS = {"<": "Less", "<=": "Less_equal", ">": "Greater", ">=": "Greater_equal", "==": "Equal", "!=": "Not_equal", "+": "Plus",
             "-": "Minus"}
SITE = re.compile(r"(?<=[\w)\]]) (?P<operator><=|>=|==|!=|<|>|\+|-) (?=[\w(\-*&])|(?P<number>\b\d+\.\d*\b)|\bif\((?P<condition>)")
# Where a mutant could not be compiled, or would be no mistake: types, constants, checks of the arguments of templates.
NO_SITE = re.compile(r"^\s*(#|//|template|using|static_assert|static constexpr|constexpr|class|struct|CGAL_assertion)|constexpr|operator|"
                     r"std::enable_if|static_cast<[^>]*$|typename")


def closing(text, begin):
    """The position of the parenthesis that closes the one before `begin`."""
    depth = 1
    for i in range(begin, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return -1


def sites_of(path, text):
    """The locations in a file where a mistake may be made: begin, end and what replaces it, with {} for the number of the mutant."""
    result = []
    position = 0
    for line in text.splitlines(keepends=True):
        code = line.split("//")[0]
        if not NO_SITE.search(code) and '"' not in code and "'" not in code:
            for match in SITE.finditer(code):
                begin, end = position + match.start(), position + match.end()
                if match["operator"]:
                    name = OPERATORS[match["operator"]]
                    new = f" {match['operator']} ::mutants::{name}<{{}}>() {match['operator']} "
                elif match["number"]:
                    new = f"::mutants::number<{{}}>({match['number']}, 1. + 2. * {match['number']})"
                else:
                    stop = closing(text, end)
                    condition = text[end:stop]
                    if ";" in condition or "//" in condition:
                        continue
                    end = stop
                    new = "if(::mutants::condition<{}>(static_cast<bool>(" + condition.replace("{", "{{").replace("}", "}}") + "))"
                result.append((str(path), begin, end, new))
        position += len(line)
    return result


def drawn_sites(root, seed):
    sites = []
    for room in ROOMS:
        for path in sorted((root / INCLUDE / room).rglob("*.h")):
            sites += sites_of(path.relative_to(root), path.read_text())
    random.Random(seed).shuffle(sites)
    return sites


def write_copy(directory, tests, sites):
    """Copies the package, with the mutants of the sites, whose numbers begin with 1."""
    contents = {}
    for root, is_test in ((ROOT, False), (tests, True)):
        names = subprocess.run(["git", "ls-files"], cwd=root, check=True, capture_output=True, text=True).stdout.splitlines()
        contents.update({n: (root / n).read_bytes() for n in names if n.startswith("test/") == is_test and (root / n).is_file()})
    by_file = {}
    for number, (path, begin, end, new) in sites.items():
        by_file.setdefault(path, []).append((begin, end, new.format(number)))
    license = "#include <CGAL/license/Spherical_parameterization.h>\n"
    for path, changes in by_file.items():
        text = contents[path].decode()
        for begin, end, new in sorted(changes, reverse=True):
            text = text[:begin] + new + text[end:]
        contents[path] = text.replace(license, license + "#include <mutants.h>\n", 1).encode()
    contents["include/mutants.h"] = SWITCH.encode()
    # What is as it was keeps its time, so that a run that goes on does not build anew.
    source = directory / "source"
    for path in [p for p in source.rglob("*") if p.is_file() and str(p.relative_to(source)) not in contents]:
        path.unlink()
    for name, content in contents.items():
        path = source / name
        if not path.is_file() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            shutil.copymode((tests if name.startswith("test/") else ROOT) / name if name != "include/mutants.h" else __file__, path)


def overlap(a, b):
    return a[0] == b[0] and a[1] < b[2] and b[1] < a[2]


def select(sites, count, refused):
    """The first `count` sites that are not refused and do not overlap."""
    chosen = {}
    for site in sites:
        if len(chosen) == count:
            break
        if site[:3] not in refused and not any(overlap(site, other) for other in chosen.values()):
            chosen[len(chosen) + 1] = site
    return chosen


def compiled(directory, sites, jobs):
    """Whether the sources of the library compile; if not, the numbers of the mutants of which the compiler complains."""
    source = directory / "source"
    flags = ["-std=c++17", "-fsyntax-only", "-DNDEBUG", "-DCGAL_EIGEN3_ENABLED", "-DCGAL_LINKED_WITH_TBB", "-isystem",
             "/usr/include/eigen3", "-I", str(source / "include"), "-fno-diagnostics-show-caret", "-ftemplate-backtrace-limit=0"]

    def check(unit):
        return subprocess.run(["g++", *flags, "-x", "c++", str(unit)], capture_output=True, text=True).stderr

    everything = source / "all.cpp"
    everything.write_text("".join(f"#include <CGAL/Spherical_parameterization/{p}.h>\n"
                                  for p in ("sampling", "surface_maps", "harmonics", "cortex", "repair")) +
                          "#include <CGAL/spherical_parameterization.h>\n")
    units = [everything, *sorted((source / "src").glob("*.cpp"))]
    bad = set()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for errors in pool.map(check, units):
            for path, line in re.findall(r"^(\S+?\.h):(\d+):\d+: +(?:error|required from)", errors, re.MULTILINE):
                path = pathlib.Path(path)
                if path.is_file() and path.name != "mutants.h":
                    text = path.read_text().splitlines()[int(line) - 1]
                    bad.update(int(n) for n in re.findall(r"mutants::\w+<(\d+)>", text))
    return bad


def run_test(directory, test, mutant, limit):
    """Whether a program of tests passes, and the seconds it took."""
    build = directory / "build"
    folder = directory / "runs" / f"{test}_{mutant}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    begin = time.monotonic()
    command = [str(build / "test/Spherical_parameterization" / f"test_{test}"), "--gtest_fail_fast", "--gtest_brief=1"]
    try:
        process = subprocess.run(command, cwd=folder, timeout=limit, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env={**os.environ, "MUTANT": str(mutant)})
        passes = process.returncode == 0
    except subprocess.TimeoutExpired:
        passes = False
    shutil.rmtree(folder, ignore_errors=True)
    return passes, time.monotonic() - begin


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--tests", type=pathlib.Path, default=ROOT)
    parser.add_argument("directory", type=pathlib.Path)
    arguments = parser.parse_args()
    directory = arguments.directory.resolve()
    directory.mkdir(parents=True, exist_ok=True)
    results = directory / "results.json"
    known = json.loads(results.read_text()) if results.exists() else {"refused": [], "seconds": {}, "killed": {}}

    sites = drawn_sites(ROOT, arguments.seed)
    refused = {tuple(site) for site in known["refused"]}
    while True:
        chosen = select(sites, arguments.count, refused)
        write_copy(directory, arguments.tests.resolve(), chosen)
        bad = compiled(directory, chosen, arguments.jobs)
        print(f"{len(chosen)} mutants of {len(sites)} sites; {len(bad)} do not compile and are replaced", flush=True)
        if not bad:
            break
        refused |= {chosen[n][:3] for n in bad}
        known["refused"] = sorted(refused)
        results.write_text(json.dumps(known))

    build = directory / "build"
    subprocess.run(["cmake", "-S", directory / "source", "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                    "-DSPHERICAL_PARAMETERIZATION_BUILD_EXAMPLES=OFF", "-DSPHERICAL_PARAMETERIZATION_BUILD_BENCHMARKS=OFF",
                    "-DSPHERICAL_PARAMETERIZATION_QUICK_BUILD=ON", "-DCMAKE_CXX_FLAGS=-w"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "-j", str(arguments.jobs), "--target", *(f"test_{test}" for test in TESTS),
                    "spherical_parameterization"], check=True, stdout=subprocess.DEVNULL)
    for test in TESTS:
        if test not in known["seconds"]:
            passes, known["seconds"][test] = run_test(directory, test, 0, 3600)
            if not passes:
                sys.exit(f"test_{test} fails without a mutant")
    results.write_text(json.dumps(known))

    def judge(number):
        room = next(r for r in ROOMS if str(INCLUDE / r) in chosen[number][0])
        order = ROOMS[room] + sorted((t for t in TESTS if t not in ROOMS[room]), key=lambda t: known["seconds"][t])
        for test in order:
            if not run_test(directory, test, number, 10 + 3 * arguments.jobs * known["seconds"][test])[0]:
                return number, test
        return number, None

    # By the site, which another seed or a change of the sources does not confuse.
    key = {n: f"{path}:{begin}:{(ROOT / path).stat().st_mtime_ns}:{new}" for n, (path, begin, _, new) in chosen.items()}
    left = [n for n in chosen if key[n] not in known["killed"]]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for number, test in pool.map(judge, left):
            known["killed"][key[number]] = test
            results.write_text(json.dumps(known))
            path, begin, end, _ = chosen[number]
            text = (ROOT / path).read_text()
            line = text.count("\n", 0, begin) + 1
            print(f"{number}: {path}:{line}: {text[begin:end].strip()}: " + (f"killed by test_{test}" if test else "SURVIVES"), flush=True)
    n_killed = sum(known["killed"][key[n]] is not None for n in chosen)
    print(f"{n_killed} of {len(chosen)} mutants are killed")


main()
