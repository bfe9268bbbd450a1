#!/usr/bin/env python3
"""Draws the figures of the user manual with the command line program, on a folder of meshes.

The same program and meshes give the same files. All figures take some minutes, most of which the method as published
takes. The meshes are not part of the project; those that are missing are named.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import figures
from measuring.drivers import MANUAL, Driver
from measuring.meshes import MeshError
from measuring.reports import listed
from measuring.runs import Program

RUN_LIMIT = 600.0  # seconds
FIGURES = {  # by the names of their functions: the file, and the models that are shown
    "opening": ("opening.jpg", ("armadillo",)),
    "package_picture": ("spherical_parameterization.png", ("bunny",)),
    "distortion": ("distortion.jpg", ("max planck", "bunny", "horse", "octopus")),
    "sharpness": ("sharpness.jpg", ("hand",)),
    "radius_rules": ("radius_rules.png", ("hand",)),
    "conformal": ("conformal.jpg", ("bunny",)),
    "remesh": ("remesh.jpg", ("coarse bunny",)),
    "repair": ("repair.jpg", ("coarse bunny",)),
    "surfaces": ("surfaces.jpg", ("steer", "horse")),
    "texture": ("texture.jpg", ("horse",)),
    "methods": ("methods.jpg", ("buddha", "coarse bunny", "hand", "cow")),
}


def main() -> None:
    driver = Driver(__doc__, tuple(FIGURES), folders=("meshes",))
    driver.add_program()
    driver.add_meshes()
    driver.add_threads()
    driver.add_argument("--mesh", type=Path, help="draw this mesh instead of all others")
    driver.add_argument("--output", type=Path, default=MANUAL / "fig", help="the folder to write to (the manual's)")
    driver.add_argument("--scale", type=float, default=1.0, help="draw smaller, or larger, figures (1)")
    driver.add_argument("--runs", type=Path, help="keep the maps in this folder, and use those that are there")
    options = driver.parse()
    if not options.scale > 0.0:
        driver.error("--scale has to be positive")
    with tempfile.TemporaryDirectory() as scratch:
        runs = options.runs or Path(scratch)
        program = Program(options.program, options.threads, runs, options.runs is not None, RUN_LIMIT)
        session = figures.Session(program, options.meshes, options.mesh, options.scale)
        names = dict.fromkeys(name for key in options.only for name in FIGURES[key][1])
        missing = [figures.MODELS[name].file for name in names if session.file_of(name) is None]
        if missing:
            sys.exit(f"{options.meshes} has no {listed(missing)}. Nothing has been drawn.")
        options.output.mkdir(parents=True, exist_ok=True)
        for key in options.only:
            file, models = FIGURES[key]
            getattr(figures, key)(session, *models).save(options.output / file)
            print(options.output / file)


if __name__ == "__main__":
    try:
        main()
    except MeshError as error:
        sys.exit(str(error))
