#!/usr/bin/env python3
"""Compares the outputs and programs that README.md and the manual quote with those of the programs in the build folder.

Usage: scripts/check_outputs.py [FILE ...]

A quotation stands between `<!-- output: COMMAND ARGUMENTS -->` and `<!-- end output -->`. COMMAND is an example in C++ or Python by its
name, `spherical_parameterization` or `python3`. It runs in a folder where `meshes` has the meshes of CGAL, after the commands that are quoted
before it on the same page. The lines must appear in the output in this order; `...` stands for any text, alone in a line for any
lines. The lines between `<!-- excerpt: FILE -->` and `<!-- end excerpt -->` must be lines of FILE, in this order.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Iterator, List, Tuple

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build"


def find_quotations(page: Path, kind: str) -> Iterator[Tuple[str, List[str]]]:
    for command, text in re.findall(rf"<!-- {kind}: (.*?) -->\n(.*?)<!-- end {kind} -->", page.read_text(encoding="utf-8"), re.DOTALL):
        lines = [line.strip() for line in text.splitlines()]
        yield command, [line for line in lines if line and not line.startswith("```")]


def resolve(command: str) -> List[str]:
    name, *arguments = shlex.split(command)
    if name == "spherical_parameterization":
        return [str(BUILD / "program" / name), *arguments]
    if name == "python3":
        return [os.environ.get("PYTHON", "/usr/bin/python3"), *arguments]
    if name.endswith(".py"):
        return [os.environ.get("PYTHON", "/usr/bin/python3"), str(ROOT / "python" / "examples" / name), *arguments]
    example = BUILD / "examples" / "Spherical_parameterization" / name
    if example.is_file():
        return [str(example), *arguments]
    return [str(BUILD / "test" / "Spherical_parameterization" / "all_examples" / "all_examples"), name, *arguments]


def find_missing(quoted: List[str], printed: List[str], skips_all: bool = False) -> str:
    """Returns the first quoted line that is not printed where it should be, or nothing."""
    k = 0
    skips = True  # the beginning of an output may be left out
    for line in quoted:
        if line == "...":
            skips = True
            continue
        pattern = re.compile(".*".join(map(re.escape, line.split("..."))))
        while k < len(printed) and not pattern.fullmatch(printed[k]):
            if not skips:
                return line
            k += 1
        if k == len(printed):
            return line
        k += 1
        skips = skips_all
    return ""


def check(page: Path) -> int:
    n_wrong = 0
    for name, quoted in find_quotations(page, "excerpt"):
        lines = [line.strip() for line in (ROOT / name).read_text(encoding="utf-8").splitlines()]
        missing = find_missing(quoted, lines, skips_all=True)
        if missing:
            n_wrong += 1
            print(f"{page.relative_to(ROOT)}: error: {name} does not have the line: {missing}")
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python"), "COLUMNS": "100"}
    with tempfile.TemporaryDirectory() as folder:
        data = Path(os.environ.get("CGAL_DATA_DIR", BUILD / "data"))
        (Path(folder) / "meshes").symlink_to(data / "meshes")
        for command, quoted in find_quotations(page, "output"):
            done = subprocess.run(
                resolve(command), cwd=folder, env=environment, timeout=300, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
            )
            printed = [line.strip() for line in done.stdout.splitlines() if line.strip()]
            missing = find_missing(quoted, printed)
            if done.returncode or missing:
                n_wrong += 1
                print(f"{page.relative_to(ROOT)}: error: {command} ends with {done.returncode}, and does not print: {missing}")
                print(*("    " + line for line in printed), sep="\n")
    return n_wrong


def main() -> None:
    pages = [Path(name).resolve() for name in sys.argv[1:]]
    pages = pages or [ROOT / "README.md", *sorted((ROOT / "doc" / "Spherical_parameterization").glob("*.txt"))]
    n_quotations = sum(len(list(find_quotations(page, "output"))) for page in pages)
    n_wrong = sum(map(check, pages))
    print(f"{n_quotations} quoted outputs, {n_wrong} wrong")
    if n_wrong or not n_quotations:
        sys.exit(1)


if __name__ == "__main__":
    main()
