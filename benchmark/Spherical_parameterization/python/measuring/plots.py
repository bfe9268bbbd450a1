"""Curves, by matplotlib without a display."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402 (the backend has to be chosen first)
from matplotlib.ticker import NullLocator  # noqa: E402

MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*")
DOTS_PER_INCH = 130


@dataclass(frozen=True)
class Curve:
    name: str
    x: list[float]
    y: list[float]
    is_connected: bool = True


@dataclass(frozen=True)
class Axes:
    """One diagram of a figure."""

    title: str
    x_label: str
    y_label: str
    curves: list[Curve]
    is_log: bool = False  # of y
    has_markers: bool = True
    is_x_log: bool = False
    ticks: tuple[float, ...] = ()  # of x; chosen by matplotlib if there are none
    starts_at_zero: bool = False  # y
    marked: tuple[float, str] | None = None  # an x, and what is there


def _plain(x: float, _: int) -> str:
    """A number without powers of ten."""
    return f"{x:,.10g}"


def draw(path: Path, diagrams: list[Axes]) -> None:
    """Draws diagrams side by side into one PNG file."""
    figure, all_axes = plt.subplots(1, len(diagrams), figsize=(5.4 * len(diagrams), 4.0), squeeze=False)
    for axes, diagram in zip(all_axes[0], diagrams):
        for i, curve in enumerate(diagram.curves):
            marker = MARKERS[i % len(MARKERS)] if diagram.has_markers else None
            axes.plot(
                curve.x,
                curve.y,
                marker=marker,
                markersize=4,
                linewidth=1.3 if curve.is_connected else 0.0,
                label=curve.name,
            )
        axes.set(title=diagram.title, xlabel=diagram.x_label, ylabel=diagram.y_label)
        if diagram.is_log:
            axes.set_yscale("log")
        if diagram.is_x_log:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter(_plain)
        if diagram.ticks:
            axes.set_xticks(diagram.ticks)
            axes.xaxis.set_minor_locator(NullLocator())
        if diagram.starts_at_zero:
            axes.set_ylim(bottom=0.0)
        if diagram.marked is not None:
            x, text = diagram.marked
            axes.axvline(x, color="grey", linewidth=0.9, linestyle="--", label=text)
        axes.grid(True, linewidth=0.4, alpha=0.5)
        if diagram.curves:
            axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)
