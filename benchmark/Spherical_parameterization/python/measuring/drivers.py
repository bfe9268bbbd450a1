"""What the command lines of the drivers share, and what a report contains of the machine and the build."""

from __future__ import annotations

import argparse
import datetime
import os
import platform
import re
import subprocess
from pathlib import Path

from .meshes import FORMATS
from .reports import listed

PROJECT = Path(__file__).resolve().parents[4]
MANUAL = PROJECT / "doc" / "Spherical_parameterization"
PROGRAM = "spherical_parameterization"


class Driver(argparse.ArgumentParser):
    """A command line. `parts` are what --only chooses from; `folders` the options that name folders which are there."""

    def __init__(self, text: str, parts: tuple[str, ...] = (), folders: tuple[str, ...] = ()):
        super().__init__(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
        self._parts, self._folders, self._needs_program = parts, folders, False
        if parts:
            self.add_argument("--only", metavar="PART,...", help=f"some of: {', '.join(parts)} (all)")

    def add_program(self) -> None:
        self._needs_program = True
        text = "the command line program (the one in the project's build folder)"
        self.add_argument("--program", type=Path, default=find_program(PROJECT / "build", PROGRAM), help=text)

    def add_meshes(self) -> None:
        text = f"a folder of meshes ({', '.join(FORMATS)}; by default ../shared/data/meshes beside the project)"
        self.add_argument("--meshes", type=Path, default=find_shared_meshes(), help=text)

    def add_threads(self) -> None:
        n_cores = len(os.sched_getaffinity(0))
        self.add_argument("--threads", type=int, default=n_cores, help="of the program (all cores)")

    def add_limits(self) -> None:
        text = "for each run; 0: any (600)"
        self.add_argument("--time-limit", type=float, default=600.0, metavar="SECONDS", help=text)
        text = "of address space for each process; 0: any (8192)"
        self.add_argument("--memory-limit", type=float, default=8192.0, metavar="MB", help=text)

    def parse(self) -> argparse.Namespace:
        """Reads and checks the command line."""
        options = self.parse_args()
        if self._needs_program and (options.program is None or not os.access(options.program, os.X_OK)):
            self.error("--program has to name the program: the project's build folder has none, or it cannot be run")
        for name in self._folders:
            folder = getattr(options, name)
            if folder is None and name == "meshes":
                self.error("--meshes is needed: there is no folder of shared meshes beside the project")
            if folder is not None and not folder.is_dir():
                self.error(f"--{name}: {folder} is no folder")
        if "threads" in options and options.threads < 1:
            self.error("--threads has to be 1 or more")
        if "time_limit" in options and not min(options.time_limit, options.memory_limit) >= 0.0:
            self.error("a limit is a positive number, or 0 for none")
        if self._parts:
            names = options.only.split(",") if options.only else list(self._parts)
            unknown = [name for name in names if name not in self._parts]
            if unknown:
                self.error(f"--only: {listed(unknown)} unknown; there are {', '.join(self._parts)}")
            options.only = [name for name in self._parts if name in names]
        return options


def find_program(folder: Path, name: str) -> Path | None:
    """Looks for a program in a build folder."""
    paths = (path for path in sorted(folder.rglob(name)) if path.is_file() and os.access(path, os.X_OK))
    return next(paths, None)


def find_shared_meshes() -> Path | None:
    """The folder of meshes that the tests use, if it is there."""
    shared = os.environ.get("SPHERICAL_PARAMETERIZATION_DATA_DIR") or PROJECT.parent / "shared" / "data"
    folder = Path(shared) / "meshes"
    return folder if folder.is_dir() else None


def describe_machine() -> str:
    processor = platform.processor() or "unknown processor"
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.is_file():
        found = re.search(r"^model name\s*: (.*)$", cpuinfo.read_text(encoding="utf-8"), re.MULTILINE)
        processor = found.group(1) if found else processor
    return f"{processor}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}"


def describe_build(folder: Path, target: str) -> str:
    """How CMake has built a target in a folder: compiler, flags and TBB, as far as the folder shows."""
    file = folder / "CMakeCache.txt"
    if not file.is_file():
        return "unknown, as there is no CMakeCache.txt"
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", file.read_text(encoding="utf-8"), re.MULTILINE))
    compiler = subprocess.run([cache["CMAKE_CXX_COMPILER"], "--version"], capture_output=True, text=True, check=False)
    facts = [compiler.stdout.splitlines()[0], f"build type {cache.get('CMAKE_BUILD_TYPE', 'unknown')}"]
    for flags_file in folder.rglob(f"{target}.dir/flags.make"):
        flags = re.search(r"^CXX_FLAGS = (.*)$", flags_file.read_text(encoding="utf-8"), re.MULTILINE)
        words = [word for word in flags.group(1).split() if not word.startswith("-W")] if flags else []
        facts.append(f"flags `{' '.join(words)}`")
    version_file = Path(cache.get("TBB_DIR", "")) / "TBBConfigVersion.cmake"
    text = version_file.read_text(encoding="utf-8") if version_file.is_file() else ""
    version = re.search(r"set\(PACKAGE_VERSION \"?([0-9][0-9.]*)", text)
    return ", ".join([*facts, f"TBB {version.group(1)}" if version else "TBB: not found"])


def describe_version() -> str:
    """Today's date, and the commit of the sources, as far as git knows."""
    today = datetime.date.today().isoformat()
    command = ["git", "-C", str(PROJECT), "describe", "--always", "--exclude=*", "--dirty= with changes"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return today
    return f"{today}, sources at commit {answer.stdout.strip()}"
