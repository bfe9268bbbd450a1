"""What a reader sees: a report in Markdown with CSV files and curves, numbers in words, and parts of the manual."""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path

import numpy as np

from .maps import Statistics

MARKERS = "os^DvPX*"
DOTS_PER_INCH = 130


class Report:
    """Collects sections; all of them can be written at any time, so that a run that is killed leaves what it had."""

    def __init__(self, folder: Path, title: str):
        self.folder = folder
        self._title = title
        self._sections: list[tuple[str, list[str]]] = []
        folder.mkdir(parents=True, exist_ok=True)

    def begin_section(self, title: str, text: str = "") -> None:
        self._sections.append((title, [text] if text else []))

    def paragraph(self, text: str) -> None:
        self._sections[-1][1].append(text)

    def items(self, lines: list[str]) -> None:
        if lines:
            self.paragraph("\n".join(f"- {line}" for line in dict.fromkeys(lines)))

    def csv(self, name: str, rows: list[dict]) -> None:
        """Writes the rows with all digits, whatever the report shows of them."""
        if rows:
            with (self.folder / name).open("w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, list(dict.fromkeys(key for row in rows for key in row)))
                writer.writeheader()
                writer.writerows(rows)
            self.paragraph(f"All figures of this section, with all digits: [{name}]({name}).")

    def image(self, name: str, caption: str) -> None:
        self.paragraph(f"![{caption}]({name})\n\n*{caption}*")

    def write(self, head: list[str]) -> None:
        """Writes report.md: the title, the paragraphs of the head, and what has been collected."""
        parts = [f"# {self._title}", *head]
        for title, paragraphs in self._sections:
            parts += [f"## {title}", *paragraphs]
        (self.folder / "report.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")


def table(columns: dict[str, str], rows: list[dict], is_aligned: bool = False) -> str:
    """A table in Markdown: for each key of the rows that is shown, the heading. Cells that are missing are empty."""
    cells = [["" if row.get(key) is None else str(row[key]).replace("|", "\\|") for key in columns] for row in rows]
    are_numbers = [all(re.match(r"[-+*–∞]*[\d(]|[-*–]*$", row[i]) for row in cells) for i in range(len(columns))]
    lines = [list(columns.values()), ["---:" if is_number else "---" for is_number in are_numbers], *cells]
    if is_aligned:
        widths = [max(len(line[i]) for line in lines) for i in range(len(columns))]
        lines = [[f"{x:>{w}}" if n else f"{x:<{w}}" for x, w, n in zip(line, widths, are_numbers)] for line in lines]
        return "\n".join("| " + " | ".join(line) + " |" for line in lines)
    rule = "|" + "|".join(lines.pop(1)) + "|"
    texts = ["| " + " | ".join(line) + " |" for line in lines]
    return "\n".join([texts[0], rule, *texts[1:]])


def fill_in(text: str, name: str, content: str) -> str:
    """A page of the manual with new content between `<!-- begin NAME -->` and `<!-- end NAME -->`."""
    pattern = rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)"
    text, count = re.subn(pattern, lambda m: m.group(1) + content + m.group(2), text, flags=re.DOTALL)
    if count != 1:
        raise SystemExit(f"The page of the manual has {count} places for {name}.")
    return text


@dataclass(frozen=True)
class Curve:
    name: str
    x: list[float]
    y: list[float]
    is_connected: bool = True


@dataclass(frozen=True)
class Diagram:
    title: str
    x_label: str
    y_label: str
    curves: list[Curve]
    logarithmic: str = ""  # axes: x, y or both
    starts_at_zero: bool = False  # y
    has_markers: bool = True
    ticks: tuple[float, ...] = ()  # of x; chosen by matplotlib if there are none
    marked: tuple[float, str] | None = None  # an x, and what is there


def draw(path: Path, diagrams: list[Diagram]) -> None:
    """Draws diagrams side by side into one PNG file."""
    import matplotlib.pyplot as plt  # which takes longer to load than most drivers take, and most draw nothing
    from matplotlib.ticker import NullLocator

    figure, all_axes = plt.subplots(1, len(diagrams), figsize=(5.4 * len(diagrams), 4.0), squeeze=False)
    for axes, diagram in zip(all_axes[0], diagrams):
        for curve, marker in zip(diagram.curves, cycle(MARKERS)):
            style = {"marker": marker if diagram.has_markers else None, "linewidth": 1.3 * curve.is_connected}
            axes.plot(curve.x, curve.y, markersize=4, label=curve.name, **style)
        axes.set(title=diagram.title, xlabel=diagram.x_label, ylabel=diagram.y_label)
        if "y" in diagram.logarithmic:
            axes.set_yscale("log")
        if diagram.starts_at_zero:
            axes.set_ylim(bottom=0.0)
        if "x" in diagram.logarithmic:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter(lambda x, _: f"{x:,.10g}")
        if diagram.ticks:
            axes.set_xticks(diagram.ticks)
            axes.xaxis.set_minor_locator(NullLocator())
        if diagram.marked is not None:
            axes.axvline(diagram.marked[0], color="grey", linewidth=0.9, linestyle="--", label=diagram.marked[1])
        axes.grid(True, linewidth=0.4, alpha=0.5)
        axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)


def number(x: float | None, digits: int = 3) -> str:
    """A number of a table: `digits` decimals, and powers of ten where these would say nothing or fill the page."""
    if x is None:
        return ""
    if not math.isfinite(x):
        return "–" if math.isnan(x) else "∞"
    return f"{x:.{digits}f}" if abs(x) < 1000 else f"{x:.2e}"


def statistics(values: Statistics, digits: int = 3) -> str:
    return " / ".join(number(x, digits) for x in (values.maximum, values.average, values.deviation))


def factor(x: float) -> str:
    """A factor, with as many digits as it is known to."""
    return f"{x:.0f}" if x >= 20 else f"{x:.1f}" if x >= 10 else f"{x:.2f}"


def span(values: list[float]) -> str:
    """From the lowest factor to the highest."""
    low, high = factor(min(values)), factor(max(values))
    return low if low == high else f"{low} to {high}"


def geometric_mean(values: list[float]) -> float:
    return float(np.exp(np.mean(np.log(values)))) if len(values) else math.nan


def seconds(x: float) -> str:
    return f"{x:.2f}" if x < 100 else f"{x:.0f}"


def percent(x: float) -> str:
    return f"{100 * x:.1f} %"


def listed(words: list[str]) -> str:
    """a, b and c"""
    return ", ".join(words[:-1]) + " and " + words[-1] if len(words) > 1 else "".join(words) or "none"


def duration(x: float) -> str:
    minutes, rest = divmod(round(x), 60)
    return f"{minutes} min {rest} s" if minutes else f"{rest} s"
