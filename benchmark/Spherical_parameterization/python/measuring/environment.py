"""What there is to measure with: the machine, the programs, how they were built, and the meshes."""

from __future__ import annotations

import datetime
import os
import platform
import re
import shutil
import subprocess
from pathlib import Path


def processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or "unknown processor"


def find_program(folder: Path, name: str) -> Path | None:
    """Looks for a program in a build folder."""
    for path in sorted(folder.rglob(name)):
        if path.is_file() and os.access(path, os.X_OK):
            return path
    return None


def find_shared_meshes(project: Path) -> Path | None:
    """The folder of meshes that the tests use, if it is there."""
    shared = os.environ.get("SPHERICAL_PARAMETERIZATION_DATA_DIR") or project.parent / "shared" / "data"
    folder = Path(shared) / "meshes"
    return folder if folder.is_dir() else None


def describe_build(folder: Path, target: str) -> str:
    """How CMake has built a target in a folder: compiler, flags and TBB, as far as the folder tells."""
    facts = []
    cache = _read_cache(folder / "CMakeCache.txt")
    compiler = cache.get("CMAKE_CXX_COMPILER")
    if compiler:
        answer = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False)
        facts.append((answer.stdout.splitlines() or [Path(compiler).name])[0].strip())
    if cache.get("CMAKE_BUILD_TYPE"):
        facts.append(f"build type {cache['CMAKE_BUILD_TYPE']}")
    for file in folder.rglob("flags.make"):
        if file.parent.name == f"{target}.dir":
            flags = re.search(r"^CXX_FLAGS = (.*)$", file.read_text(encoding="utf-8"), re.MULTILINE)
            words = [word for word in flags.group(1).split() if not word.startswith("-W")] if flags else []
            facts.append(f"flags `{' '.join(words)}`")
            break
    version = _version_of(Path(cache.get("TBB_DIR", "")) / "TBBConfigVersion.cmake")
    facts.append(f"TBB {version}" if version else "TBB: not found")
    return ", ".join(facts) if cache else "unknown, as there is no CMakeCache.txt"


def describe_version(project: Path) -> str:
    """Today's date, and the commit of the sources, as far as git knows."""
    today = datetime.date.today().isoformat()
    git = shutil.which("git")
    if git is None:
        return today
    command = [git, "-C", str(project), "describe", "--always", "--exclude=*", "--dirty= with changes"]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    return f"{today}, sources at commit {answer.stdout.strip()}" if answer.returncode == 0 else today


def _read_cache(file: Path) -> dict[str, str]:
    if not file.is_file():
        return {}
    entries = re.findall(r"^(\w+):\w+=(.*)$", file.read_text(encoding="utf-8"), re.MULTILINE)
    return dict(entries)


def _version_of(file: Path) -> str | None:
    if not file.is_file():
        return None
    found = re.search(r"set\(PACKAGE_VERSION \"?([0-9][0-9.]*)", file.read_text(encoding="utf-8"))
    return found.group(1) if found else None
