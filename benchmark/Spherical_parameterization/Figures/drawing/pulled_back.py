"""Figures of what is carried over from the sphere to the surface: a grid, squares, a drawn map."""

from __future__ import annotations

from typing import Callable

import numpy as np
from rendering.painting import SAMPLES

from .patterns import Globe, planet, squares
from .session import ANGLE_LABEL, ISOMETRIC_LABEL, Session, extremes
from .sheet import Sheet


def opening(session: Session, name: str) -> Sheet:
    """A surface and its sphere; equal places have equal colours, and the lines are meridians and parallels."""
    mapped = session.map(name)
    sheet, globe = session.sheet(1400, 700), Globe(step=15.0, width=0.5)
    sheet.place(mapped.surface(globe, sheet.pixels(690)), 5, 5)
    sheet.place(mapped.sphere(globe, sheet.pixels(600)), 770, 50)
    return sheet


def package_picture(session: Session, name: str) -> Sheet:
    """The same, small, for the overview of packages."""
    mapped = session.map(name)
    sheet, globe = session.sheet(260, 140), Globe(step=30.0, width=2.0)
    sheet.place(mapped.surface(globe, sheet.pixels(132)), 4, 4)
    sheet.place(mapped.sphere(globe, sheet.pixels(112)), 143, 14)
    return sheet


def texture(session: Session, name: str) -> Sheet:
    """A drawing in longitude and latitude, the sphere that it covers, and the surface that the sphere was made from."""
    mapped = session.map(name)
    sheet = session.sheet(1400, 500)
    sheet.place(_unrolled(planet, sheet.pixels(250)), 12, 105)
    sheet.place(mapped.sphere(planet, sheet.pixels(400)), 535, 30)
    sheet.place(mapped.surface(planet, sheet.pixels(440)), 950, 5)
    sheet.text(262, 470, "the texture")
    sheet.text(735, 470, "on the sphere")
    sheet.text(1170, 470, "on the surface")
    return sheet


def conformal(session: Session, name: str) -> Sheet:
    """The same squares of the sphere on a surface, by the default map and by the conformal one."""
    sheet = session.sheet(1400, 820)
    for i, (title, options) in enumerate((("isometric (default)", []), ("conformal", ["--energy", "conformal"]))):
        mapped = session.map(name, *options)
        distortion = mapped.run.distortion
        sheet.place(mapped.surface(squares, sheet.pixels(660)), 20 + 700 * i, 5)
        sheet.text(350 + 700 * i, 700, title)
        sheet.text(350 + 700 * i, 745, f"{ISOMETRIC_LABEL}: {extremes(distortion.isometric)}")
        sheet.text(350 + 700 * i, 790, f"{ANGLE_LABEL}: {extremes(distortion.angle)}")
    return sheet


def _unrolled(pattern: Callable[[np.ndarray], np.ndarray], height: int) -> np.ndarray:
    """A pattern in longitude and latitude, twice as wide as high."""
    fine = SAMPLES * height
    longitudes, latitudes = np.meshgrid(
        np.pi * ((np.arange(2 * fine) + 0.5) / fine - 1.0), np.pi * (0.5 - (np.arange(fine) + 0.5) / fine)
    )
    directions = [np.cos(latitudes) * np.sin(longitudes), np.sin(latitudes), np.cos(latitudes) * np.cos(longitudes)]
    picture = pattern(np.stack(directions, axis=-1))
    return picture.reshape(height, SAMPLES, 2 * height, SAMPLES, 3).mean(axis=(1, 3))
