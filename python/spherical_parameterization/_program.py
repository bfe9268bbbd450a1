"""The command line program that is installed with the module."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NoReturn

NAME = "spherical_parameterization"


def find_program() -> str:
    """Return the path of the program: the one beside the module, or the first one on the PATH that is not a Python script."""
    own = Path(__file__).parent / "bin" / (NAME + (".exe" if os.name == "nt" else ""))
    if own.is_file():
        return str(own)
    for folder in os.get_exec_path():
        path = shutil.which(NAME, path=folder)
        if path is None:
            continue
        with open(path, "rb") as file:
            if file.read(2) != b"#!":  # this file, as pip installs it
                return path
    sys.exit(
        f"{NAME}: the program is neither installed with this module nor on the path. Add its folder to PATH; or install the libraries"
        " that it needs, such as CLI11 and Eigen, and reinstall the module."
    )


def run() -> NoReturn:
    """Run the program with the arguments of this process. It replaces this process where the system supports that."""
    command = [find_program(), *sys.argv[1:]]
    if os.name == "posix":
        os.execv(command[0], command)
    sys.exit(subprocess.call(command))
