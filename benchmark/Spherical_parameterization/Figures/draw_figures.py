#!/usr/bin/env python3
"""Draws the figures of the user manual with the command line program, on a folder of meshes.

Needs the Debian packages python3-numpy and python3-matplotlib, and no display. The same program and meshes give the
same files. All figures take some minutes, most of which the method as published takes. The meshes are not part of the
project; those that are missing are named.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

try:
    import matplotlib  # noqa: F401 (only to see whether it is there)
    import numpy  # noqa: F401
except ImportError as error:
    sys.exit(
        f"{error}. Install python3-numpy and python3-matplotlib, and run this with that Python (/usr/bin/python3)."
    )

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

from drawing.choices import radius_rules, sharpness
from drawing.distortions import distortion, initial_and_result, methods
from drawing.models import Cast
from drawing.pulled_back import conformal, opening, package_picture, texture
from drawing.session import Session
from drawing.sheet import Sheet
from measuring.environment import find_program, find_shared_meshes
from measuring.meshes import MeshError
from measuring.program import Program
from measuring.report import listed

PROJECT = Path(__file__).resolve().parents[3]
RUN_LIMIT = 600.0  # seconds
MANUAL = PROJECT / "doc" / "Spherical_parameterization" / "fig"


@dataclass(frozen=True)
class Figure:
    """A figure, its file, and the models that it shows."""

    file: str
    draw: Callable[..., Sheet]
    models: tuple[str, ...]


FIGURES = {
    "opening": Figure("opening.jpg", opening, ("armadillo",)),
    "package_picture": Figure("spherical_parameterization.png", package_picture, ("bunny",)),
    "distortion": Figure("distortion.jpg", distortion, ("max planck", "bunny", "horse", "octopus")),
    "initial_and_result": Figure("initial_and_result.jpg", initial_and_result, ("coarse bunny",)),
    "sharpness": Figure("sharpness.jpg", sharpness, ("hand",)),
    "radius_rules": Figure("radius_rules.png", radius_rules, ("hand",)),
    "conformal": Figure("conformal.jpg", conformal, ("bunny",)),
    "texture": Figure("texture.jpg", texture, ("horse",)),
    "methods": Figure("methods.jpg", methods, ("buddha", "coarse bunny", "hand", "cow")),
}


def main() -> None:
    options = read_options()
    cast = Cast(options.meshes, options.mesh)
    figures = {name: FIGURES[name] for name in options.only}
    missing = cast.missing([model for figure in figures.values() for model in figure.models])
    if missing:
        sys.exit(f"{options.meshes} has no {listed(missing)} (.off or .ply). Nothing has been drawn.")
    options.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        runs = options.runs or Path(scratch)
        program = Program(options.program, options.threads, runs, options.runs is not None, RUN_LIMIT)
        session = Session(program, cast, options.scale)
        for figure in figures.values():
            path = options.output / figure.file
            figure.draw(session, *figure.models).save(path)
            print(path)


def read_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, help="the command line program (the one in the project's build folder)")
    parser.add_argument(
        "--meshes", type=Path, help="a folder with the manual's meshes (../shared/data/meshes, if it is there)"
    )
    parser.add_argument("--mesh", type=Path, help="draw this mesh in the place of all others: an OFF or PLY file")
    parser.add_argument("--output", type=Path, default=MANUAL, help="the folder to write to (that of the manual)")
    parser.add_argument("--only", help=f"some figures, separated by commas, of: {', '.join(FIGURES)} (all)")
    parser.add_argument("--scale", type=float, default=1.0, help="draw smaller, or larger, figures (1)")
    parser.add_argument("--runs", type=Path, help="keep the maps in this folder, and use those that are there")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="of the program (all cores)")
    options = parser.parse_args()
    options.program = options.program or find_program(PROJECT / "build", "spherical_parameterization")
    if options.program is None:
        parser.error("there is no program in the project's build folder: build it, or name it with --program")
    if not os.access(options.program, os.X_OK):
        parser.error(f"--program: {options.program} cannot be run")
    options.program = options.program.resolve()
    if options.mesh is None:
        options.meshes = options.meshes or find_shared_meshes(PROJECT)
        if options.meshes is None:
            parser.error("--meshes is needed: there is no folder of shared meshes beside the project")
        if not options.meshes.is_dir():
            parser.error(f"--meshes: {options.meshes} is no folder")
    names = options.only.split(",") if options.only else list(FIGURES)
    unknown = [name for name in names if name not in FIGURES]
    if unknown:
        parser.error(f"--only: {listed(unknown)} unknown; there are {', '.join(FIGURES)}")
    options.only = names
    if options.threads < 1:
        parser.error("--threads has to be 1 or more")
    if not options.scale > 0.0:
        parser.error("--scale has to be positive")
    return options


if __name__ == "__main__":
    try:
        main()
    except MeshError as error:
        sys.exit(str(error))
