"""The library behind the drivers of the benchmarks.

From the bottom up: meshes reads and refines meshes; maps judges maps, and shares no code with the package; runs starts
programs; pictures draws surfaces and spheres; reports writes what a reader sees; drivers has what their command lines
share. Needs the Debian packages python3-numpy and python3-matplotlib, and no display.
"""

import sys

try:
    import matplotlib
    import numpy  # noqa: F401 (only to see whether it is there)
except ImportError as error:
    sys.exit(f"{error}. Install python3-numpy and python3-matplotlib, and use that Python (/usr/bin/python3).")

matplotlib.use("Agg")
