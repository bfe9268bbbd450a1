"""Builds the compiled part and the program with CMake, as the rest of the project. Everything else is in pyproject.toml.

If the environment names a build folder of the project, SPHERICAL_PARAMETERIZATION_BUILD_DIR, what is there is installed.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

NAME = "spherical_parameterization"
ROOT = Path(__file__).resolve().parent


class Build(build_ext):
    """Builds the module, and the program where its libraries are found, which is put beside it."""

    def build_extension(self, ext):
        folder = os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD_DIR")
        if folder is None:
            folder = str(Path(self.build_temp).resolve())
            self.run_cmake("-S", ROOT, "-B", folder, *self.options())
        self.run_cmake("--build", folder, "--parallel", str(os.cpu_count() or 1))
        module = Path(self.get_ext_fullpath(ext.name))
        built = Path(folder, "python", NAME, module.name)
        if not built.is_file():
            sys.exit(f"error: {built} has not been built: CMake says above what is missing, such as the headers of Python")
        module.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, module)
        program = Path(folder, "program", NAME + (".exe" if os.name == "nt" else ""))
        if program.is_file():
            (module.parent / "bin").mkdir(exist_ok=True)
            shutil.copy(program, module.parent / "bin")

    @staticmethod
    def run_cmake(*arguments):
        try:
            subprocess.run(["cmake", *arguments], check=True)
        except FileNotFoundError:
            sys.exit("error: CMake 3.18 or newer is not installed, which compiles the module")
        except subprocess.CalledProcessError as error:
            sys.exit(f"error: CMake has failed, with exit status {error.returncode}; its messages are above")

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


class Sources(sdist):
    """Adds the page of the program as one file, so that whoever builds from the archive needs neither Node.js nor a network."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        node, npm = shutil.which("node"), shutil.which("npm")
        if node is None or npm is None:
            self.warn("Node.js or npm is not installed: programs built from this archive will not write pages without them")
            return
        folder = ROOT / "build" / "page_of_sources"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "page.stamp").unlink(missing_ok=True)
        subprocess.run([node, ROOT / "page" / "make_page.mjs", npm, folder], check=True)
        if not (folder / "page.stamp").is_file():  # npm's registry is out of reach
            sys.exit("error: the page of the program could not be bundled; see above")
        shutil.copy(folder / "page_text.cpp", Path(base_dir, "page"))


version = re.search(r"VERSION (\d[\d.]+)\n", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension(f"{NAME}._core", [])], cmdclass={"build_ext": Build, "sdist": Sources})
