#!/usr/bin/env python3
"""Usage: scripts/repair_wheel.py WHEEL OUTPUT

Puts the libraries that a wheel is linked with into it, with their licences, and writes it to OUTPUT with the tag of the oldest
C library that it runs with. Only the libraries stay outside that PEP 600 takes for granted. Needs patchelf, and Debian's packages
of the libraries, for their licences.
"""

import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# The C and C++ libraries, and the loader
OUTSIDE = re.compile(r"(lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s)|ld-linux[\w-]*)\.so\b")
# The first C library that a distribution of Linux came with along with these symbols of the C++ library
C_LIBRARY_OF_CXX = {28: 31, 29: 34, 30: 35}


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def is_binary(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def libraries_of(path):
    """Returns the names and paths of all libraries that the loader finds for a binary."""
    found = re.findall(r"^\s*(\S+) => (/\S+|not found)", run("ldd", path), re.M)
    missing = [name for name, file in found if not file.startswith("/")]
    if missing:
        sys.exit(f"error: {path}: the loader does not find {missing[0]}")
    return {name: Path(file) for name, file in found if not OUTSIDE.match(name)}


def oldest_c_library(binaries):
    symbols = "".join(run("objdump", "-T", path) for path in binaries)
    minor = max(map(int, re.findall(r"\bGLIBC_2\.(\d+)", symbols)))
    cxx = max(map(int, re.findall(r"\bGLIBCXX_3\.4\.(\d+)", symbols)), default=0)
    if cxx > max(C_LIBRARY_OF_CXX):
        sys.exit(f"error: GLIBCXX_3.4.{cxx} is newer than any that is known here: add it to C_LIBRARY_OF_CXX")
    return max([minor] + [c_library for needed, c_library in C_LIBRARY_OF_CXX.items() if cxx >= needed])


def licence_of(library):
    # The files of Debian's packages are listed with or without /usr.
    for path in (library.resolve(), Path(str(library.resolve()).replace("/usr/lib/", "/lib/", 1))):
        owner = subprocess.run(["dpkg", "-S", str(path)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        if owner:
            return owner.split(":")[0], Path("/usr/share/doc", owner.split(":")[0], "copyright")
    sys.exit(f"error: {library} belongs to no package, so its licence is not known")


def main(wheel, output):
    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, "-m", "wheel", "unpack", "-d", folder, wheel)
        (root,) = Path(folder).iterdir()
        (package,) = (path.parent for path in root.glob("*/__init__.py"))
        (info,) = root.glob("*.dist-info")
        inside = root / (package.name + ".libs")
        inside.mkdir()
        binaries = [path for path in package.rglob("*") if path.is_file() and is_binary(path)]
        libraries = {}
        for path in binaries:
            libraries.update(libraries_of(path))
        names = {}
        for name, path in libraries.items():
            # Another wheel may have brought another build of it into the same process.
            digest = hashlib.sha256(path.read_bytes()).hexdigest()[:8]
            names[name] = re.sub(r"\.so\b", f"-{digest}.so", name, count=1)
            shutil.copy(path.resolve(), inside / names[name])
            owner, licence = licence_of(path)
            if licence.is_file():
                shutil.copy(licence, info / f"LICENSE.{owner}")
            else:
                print(f"warning: the licence of {name} is not installed: {licence}", file=sys.stderr)
        copies = [inside / name for name in names.values()]
        for path in binaries + copies:
            path.chmod(0o755)
            run("strip", "--strip-unneeded", path)
            renamed = [part for old, new in names.items() for part in ("--replace-needed", old, new)]
            way = Path("/".join([".."] * len(path.parent.relative_to(root).parts)), inside.name) if path in binaries else Path()
            run("patchelf", *renamed, path)
            run("patchelf", "--force-rpath", "--set-rpath", f"$ORIGIN/{way}".rstrip("/."), path)
        for path in copies:
            run("patchelf", "--set-soname", path.name, path)
        platform = f"manylinux_2_{oldest_c_library(binaries + copies)}"
        text = (info / "WHEEL").read_text()
        (info / "WHEEL").write_text(re.sub(r"^(Tag: .*-)linux_", rf"\g<1>{platform}_", text, flags=re.M))
        Path(output).mkdir(parents=True, exist_ok=True)
        run(sys.executable, "-m", "wheel", "pack", "-d", output, root)


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(*sys.argv[1:])
