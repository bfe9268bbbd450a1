"""Figures of what the options change: the sharpness and the radius."""

from __future__ import annotations

import numpy as np
from matplotlib.ticker import NullLocator

from .session import ISOMETRIC, ISOMETRIC_LABEL, Mapped, Session, extremes
from .sheet import SMALL_TEXT, TEXT_COLOR, Sheet

PREFERENCES = ("average", "balance", "worst")
# The hues of the scale of the distortion, and ways to draw a line that differ without colours.
LINES = (("#3b528b", "-"), ("#1f9e89", "--"), ("#c2560a", "-."))

RULES = (("two-phase", "o"), ("optimal", "s"), ("area", "^"), ("balanced", "D"))
STATISTICS = ("maximum", "average")
FIXED_RADII = np.linspace(0.7, 1.6, 10)  # in radii of the sphere with the area of the surface


def sharpness(session: Session, name: str) -> Sheet:
    """Three preferences: where the distortion is, and how many faces have more than so much."""
    sheet = session.sheet(1400, 940)
    axes = sheet.axes(165, 520, 1205, 320)
    for i, (preference, (color, dashes)) in enumerate(zip(PREFERENCES, LINES)):
        mapped = session.map(name, "--prefer", preference)
        distortion = mapped.run.distortion
        x = 20 + 460 * i
        sheet.place(mapped.surface(mapped.distortion_colors, sheet.pixels(310)), x + 65, 5)
        sheet.text(x + 220, 340, f"--prefer {preference}", family="monospace")
        sheet.text(x + 220, 382, extremes(distortion.isometric))
        values = np.sort(distortion.isometric_of_faces[~np.isnan(distortion.isometric_of_faces)])
        shares = 1.0 - np.arange(len(values)) / len(values)
        axes.plot(values, shares, dashes, color=color, linewidth=sheet.length(4), label=f"--prefer {preference}")
        axes.plot(values[-1:], shares[-1:], "o", color=color, markersize=sheet.length(13), clip_on=False)
    sheet.color_bar(400, 425, 600, ISOMETRIC, ISOMETRIC_LABEL)
    axes.set(xscale="log", yscale="log", xlim=(1.0, None), ylim=(shares[-1] * 0.8, 1.2))
    axes.yaxis.set_major_formatter(lambda share, _: f"{100.0 * share:g} %")
    _plain_ticks(axes.xaxis)
    _grid(sheet, axes)
    axes.set_xlabel(ISOMETRIC_LABEL)
    axes.set_ylabel("share of faces above", labelpad=sheet.length(8))
    _legend(sheet, axes, "lower left", "monospace")
    return sheet


def radius_rules(session: Session, name: str) -> Sheet:
    """The distortion of maps to spheres of fixed radii, and of those whose radius the rules have chosen."""
    sheet = session.sheet(1400, 740)
    axes = sheet.axes(150, 20, 1220, 620)
    area = session.cast.subject(name).file.mesh.area()
    unit = np.sqrt(area / (4.0 * np.pi))
    fixed = [session.map(name, "--radius", f"fixed={radius * unit:.6g}") for radius in FIXED_RADII]
    for key, (color, dashes) in zip(STATISTICS, LINES):
        values = [_at_own_radius(mapped, key) for mapped in fixed]
        axes.plot(FIXED_RADII, values, dashes, color=color, linewidth=sheet.length(4), label=f"fixed=R: {key}")
    for rule, marker in RULES:
        mapped = session.map(name, "--radius", rule)
        for key in STATISTICS:
            axes.plot(
                mapped.run.map.own_radius / unit,
                _at_own_radius(mapped, key),
                marker,
                color="none",
                markeredgecolor=TEXT_COLOR,
                markeredgewidth=sheet.length(3),
                markersize=sheet.length(20),
                label=rule if key == STATISTICS[0] else None,
            )
    _grid(sheet, axes)
    axes.set_xlabel("radius, in radii of the sphere with the area of the surface")
    axes.set_ylabel(ISOMETRIC_LABEL)
    _legend(sheet, axes, "upper center")
    return sheet


def _at_own_radius(mapped: Mapped, key: str) -> float:
    return getattr(mapped.run.own_distortion.isometric, key)


def _plain_ticks(axis) -> None:
    """Numbers without powers of ten on a logarithmic scale of distortions."""
    least, largest = axis.get_view_interval()
    steps = [x for x in (1, 1.5, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100) if least <= x <= largest]
    axis.set_ticks(steps, labels=[f"{x:g}" for x in steps])
    axis.set_minor_locator(NullLocator())


def _grid(sheet: Sheet, axes) -> None:
    axes.grid(True, linewidth=sheet.length(1), color="#cccccc")
    axes.set_axisbelow(True)


def _legend(sheet: Sheet, axes, place: str, family: str = "sans-serif") -> None:
    font = {"family": family, "size": sheet.length(SMALL_TEXT)}
    axes.legend(loc=place, prop=font, framealpha=1.0, edgecolor="none")
