#!/usr/bin/env python3
"""Usage: make_options_page.py PAGE [PROGRAM]

Writes a page of the manual with what PROGRAM prints for --help, and for the --help of each of its commands. If PROGRAM is not
given or has not been built, the page says so."""

import pathlib
import re
import subprocess
import sys

NAME = "PkgSphericalParameterizationOptions"
MISSING = "The program was not built together with this manual; `spherical_parameterization COMMAND --help` prints the options."
INTRODUCTION = "This page shows what the program prints for `--help`, and for the `--help` of each command."


def help_of(program, *command):
    result = subprocess.run([program, *command, "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            encoding="utf-8", timeout=60)
    if result.returncode != 0:
        sys.exit(f"{' '.join([program, *command, '--help'])} has failed:\n{result.stdout}")
    return result.stdout.rstrip().splitlines()


def section(anchor, title, text):
    return ["", f"\\section {NAME}{anchor} {title}", "", "\\verbatim", *text, "\\endverbatim"]


def page_of(program):
    """The lines of the page."""
    lines = [f"\\page {NAME} Options of the Program", "\\cgalAutoToc", ""]
    if not program or not pathlib.Path(program).is_file():
        return [*lines, MISSING]
    overview = help_of(program)
    # The list of commands is indented by two spaces, as are options, which begin with a hyphen.
    commands = [match.group(1) for match in (re.match(r"  ([a-z]+) {2,}\S", line) for line in overview) if match]
    if not commands:
        sys.exit(f"{program} --help lists no commands")
    lines += [INTRODUCTION, *section("Overview", "Commands", overview)]
    for command in commands:
        lines += section(command.capitalize(), command, help_of(program, command))
    return lines


def main():
    page = pathlib.Path(sys.argv[1])
    text = "\n".join(line.rstrip() for line in page_of("".join(sys.argv[2:3])))
    if "*/" in text:
        sys.exit("the help of the program has */, which would end the comment that the page is written as")
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(f"/*!\n{text}\n*/\n", encoding="utf-8")


main()
