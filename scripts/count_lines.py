#!/usr/bin/env python3
"""Usage: scripts/count_lines.py [FOLDER]

Counts the lines of code of the package, or of another checkout of it: those that are neither blank nor comment, in the layout of
clang-format, for each part of the library, and all lines of tests, program and examples.
"""

import collections
import pathlib
import re
import sys

PARTS = ("Sampling", "Surface_maps", "Harmonics", "Cortex", "Repair")
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'', re.DOTALL)


def lines_of_code(path):
    code = TOKEN.sub(lambda token: "" if token[0].startswith(("//", "/*")) else token[0], path.read_text())
    return sum(1 for line in code.splitlines() if line.strip())


def part_of(path):
    return next((part for part in PARTS if part in path.parts), "core")


def all_lines(root, folders, patterns):
    files = [path for folder in folders for pattern in patterns for path in (root / folder).rglob(pattern)]
    return sum(len(path.read_text().splitlines()) for path in files), len(files)


def main():
    if len(sys.argv) > 2 or sys.argv[1:] in (["-h"], ["--help"]):
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) == 2 else pathlib.Path(__file__).resolve().parent.parent
    counts = collections.Counter()
    headers = collections.Counter()
    longest = []
    for path in [*(root / "include").rglob("*.h"), *(root / "src").rglob("*.cpp")]:
        relative = path.relative_to(root)
        counts[part_of(relative)] += lines_of_code(path)
        headers[part_of(relative)] += 1
        longest.append((len(path.read_text().splitlines()), str(relative)))
    for part in ("core", *PARTS):
        print(f"{part:14}{counts[part]:7} lines of code in {headers[part]} files")
    print(f"{'library':14}{sum(counts.values()):7} lines of code in {sum(headers.values())} files")
    top = root / "include/CGAL/Spherical_parameterization"
    print(f"{len(list(top.glob('*.h')))} public headers at the top; the longest file has {max(longest)[0]} lines: {max(longest)[1]}")
    tests, _ = all_lines(root, ["test", "python/tests"], ["*.h", "*.cpp", "*.py"])
    program, n_program = all_lines(root, ["program"], ["*.h", "*.cpp"])
    examples, n_examples = all_lines(root, ["examples"], ["*.cpp"])
    print(f"tests: {tests} lines; program: {program} lines in {n_program} files; examples: {examples} lines in {n_examples} files")


main()
