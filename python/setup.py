"""Builds the compiled part with CMake, as the rest of the project. Everything else is in pyproject.toml.

If the environment names a build folder of the project, SPHERICAL_PARAMETERIZATION_BUILD_DIR, its module is installed.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

TARGET = "spherical_parameterization_python"
ROOT = Path(__file__).resolve().parent.parent


class Build(build_ext):
    def build_extension(self, ext):
        folder = os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD_DIR")
        if folder is None:
            folder = str(Path(self.build_temp).resolve())
            subprocess.run(["cmake", "-S", ROOT, "-B", folder, *self.options()], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", TARGET], check=True)
        path = Path(self.get_ext_fullpath(ext.name))
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(Path(folder, "python", "spherical_parameterization", path.name), path)

    @staticmethod
    def options():
        parts = ("TESTS", "EXAMPLES", "BENCHMARKS")
        options = [f"-DSPHERICAL_PARAMETERIZATION_BUILD_{part}=OFF" for part in parts]
        options += ["-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}"]
        try:
            import pybind11

            options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:
            pass  # Debian's pybind11-dev has no package of Python
        return options


version = re.search(r"VERSION (\d[\d.]+)\n", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("spherical_parameterization._core", [])], cmdclass={"build_ext": Build})
