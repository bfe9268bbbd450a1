"""Figures of where the distortion is: on four models, and before and after the descent."""

from __future__ import annotations

from .session import EDGE_WIDTH, ISOMETRIC, ISOMETRIC_LABEL, Session, extremes
from .sheet import Sheet


def distortion(session: Session, *names: str) -> Sheet:
    """Surface and sphere of several models, default settings."""
    width = 350
    sheet = session.sheet(width * len(names), 840)
    for i, name in enumerate(names):
        mapped = session.map(name)
        x, colors = width * i, mapped.distortion_colors
        sheet.place(mapped.surface(colors, sheet.pixels(336)), x + 7, 5)
        sheet.place(mapped.sphere(colors, sheet.pixels(290)), x + 30, 350)
        sheet.text(x + 0.5 * width, 668, mapped.subject.model.title)
        sheet.text(x + 0.5 * width, 710, extremes(mapped.run.distortion.isometric))
    _isometric_bar(sheet, 758)
    return sheet


def initial_and_result(session: Session, name: str) -> Sheet:
    """Two initial maps and the result, with the edges of the mesh."""
    sheet = session.sheet(1400, 637)
    starts = (("harmonic map", ["--method", "harmonic"]), ("hierarchical map", ["--method", "hierarchical"]))
    for i, (title, options) in enumerate((*starts, ("result", []))):
        mapped = session.map(name, *options)
        x = 20 + 460 * i
        sheet.place(mapped.sphere(mapped.distortion_colors, sheet.pixels(440), EDGE_WIDTH), x, 5)
        sheet.text(x + 220, 470, title)
        sheet.text(x + 220, 512, extremes(mapped.run.distortion.isometric))
    _isometric_bar(sheet, 555)
    return sheet


def methods(session: Session, *names: str) -> Sheet:
    """The methods side by side. What folds is of a colour that the scale does not have."""
    width, height = 280, 350
    columns = (
        ("harmonic", ["--method", "harmonic"]),
        ("hierarchical", ["--method", "hierarchical"]),
        ("as rigid\nas possible", ["--method", "arap"]),
        ("BLD as\npublished", ["--paper"]),
        ("BLD by\ndefault", []),
    )
    sheet = session.sheet(width * len(columns), 90 + height * len(names) + 82)
    for i, (title, options) in enumerate(columns):
        x = width * i
        sheet.text(x + 0.5 * width, 42, title)
        for j, name in enumerate(names):
            mapped, y = session.map(name, *options), 90 + height * j
            sheet.place(mapped.surface(mapped.distortion_colors, sheet.pixels(220)), x + 30, y)
            folded = mapped.run.map.number_folded
            lines = extremes(mapped.run.distortion.isometric, "\n") + (f"\n{folded:,} folded" if folded else "\n")
            sheet.text(x + 0.5 * width, y + 280, lines)
    _isometric_bar(sheet, 90 + height * len(names))
    return sheet


def _isometric_bar(sheet: Sheet, y: float) -> None:
    sheet.color_bar(400, y, 600, ISOMETRIC, ISOMETRIC_LABEL)
