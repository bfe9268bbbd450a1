#!/usr/bin/env python3
"""Usage: check.py COMPILER [OPTION...]

Checks that each mistake in the files of this folder is reported in one sentence: that the compiler makes one error of each line
with a comment "error: WORDS", which holds these words, and no other; where it says "first error: WORDS", others may follow.
The first line of a file may give an option.
"""

import os
import pathlib
import re
import subprocess
import sys

if len(sys.argv) < 2:
    sys.exit(__doc__)
failures = 0
for path in sorted(pathlib.Path(__file__).parent.glob("*.cpp")):
    source = path.read_text()
    options = re.findall(r"\A// (-.*)", source)
    command = [*sys.argv[1:], "-std=c++17", "-fsyntax-only", *options, str(path)]
    output = subprocess.run(command, stderr=subprocess.PIPE, text=True, env={**os.environ, "LC_ALL": "C"}).stderr
    errors = re.findall(r"^\S+:\d+:\d+: (?:fatal )?error: .*", output, re.M)
    problems = []
    for words in re.findall("// first error: (.*)", source):
        if errors and words in errors[0]:
            errors.clear()
    for number, line in enumerate(source.splitlines(), 1):
        for words in re.findall("// error: (.*)", line):
            error = next((error for error in errors if words in error), None)
            if error is None or f"{path}:{number}:" not in output:
                problems.append(f"{path}:{number}: no error says '{words}'")
            else:
                errors.remove(error)
    problems += [f"{path}: one error too many: {error}" for error in errors]
    if problems:
        failures += 1
        print(output, *problems, sep="\n", file=sys.stderr)
sys.exit(failures > 0)
