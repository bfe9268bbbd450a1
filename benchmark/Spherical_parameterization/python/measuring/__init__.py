"""The library behind the drivers of the benchmarks.

From the bottom up: meshes reads and refines meshes; maps judges maps, and shares no code with the package; commands
runs programs with limits (limited), and any program that maps meshes; runs keeps what the package's own program gave;
pictures draws surfaces and spheres; reports writes what a reader sees; drivers has what the command lines share. Needs
the Debian packages python3-numpy and python3-matplotlib, and no display.
"""

import os
import sys
from importlib.util import find_spec

if not find_spec("numpy") or not find_spec("matplotlib"):
    sys.exit("Install python3-numpy and python3-matplotlib, and run this with that Python (/usr/bin/python3).")

os.environ["MPLBACKEND"] = "Agg"
