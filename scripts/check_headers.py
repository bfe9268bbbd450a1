#!/usr/bin/env python3
"""Usage: scripts/check_headers.py COMPILER [OPTION...]

Checks that each header of the package includes all that it needs, by compiling it. A header may follow another one in a
file if it includes that one itself, as its lines come after it in any case: so few files check all headers.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

if len(sys.argv) < 2:
    sys.exit(__doc__)
include = pathlib.Path(__file__).resolve().parent.parent / "include"
headers = {str(path.relative_to(include)): path.read_text() for path in include.rglob("*.h")}
included = {}


def all_included(header):
    """returns the headers of the package that a header includes, directly or through others"""
    if header not in included:
        direct = {name for name in re.findall(r"^#include <(.*)>$", headers[header], re.M) if name in headers}
        included[header] = direct.union(*(all_included(name) for name in direct))
    return included[header]


# Those that include most come first; each of the others goes below the first chain that includes it at its lower end.
chains = []
for header in sorted(headers, key=lambda name: (-len(all_included(name)), name)):
    for chain in chains:
        if header in all_included(chain[-1]):
            chain.append(header)
            break
    else:
        chains.append([header])

failures = 0
for chain in chains:
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as source:
        source.write("".join(f"#include <{header}>\n" for header in reversed(chain)))
        source.flush()
        command = [*sys.argv[1:], "-std=c++17", "-fsyntax-only", f"-I{include}", source.name]
        if subprocess.run(command).returncode != 0:
            failures += 1
            print("One of these does not compile on its own:", *reversed(chain), sep="\n  ", file=sys.stderr)
print(f"{len(headers)} headers in {len(chains)} files, {failures} failures")
sys.exit(failures > 0)
