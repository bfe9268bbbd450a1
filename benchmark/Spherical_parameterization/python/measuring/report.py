"""The report: Markdown for people, one CSV file for each table, and the places of the images."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

from .distortion import Statistics


@dataclass(frozen=True)
class Column:
    """A column of a table in the report: its heading, and the name of its cells' text in a row."""

    heading: str
    key: str
    is_number: bool = True


class Report:
    """Collects the sections; writes all of them again at any time, so that a run that is killed leaves what it had."""

    def __init__(self, folder: Path, title: str):
        self.folder = folder
        self._title = title
        self._sections: list[tuple[str, list[str]]] = []
        folder.mkdir(parents=True, exist_ok=True)

    def begin_section(self, title: str) -> None:
        self._sections.append((title, []))

    def paragraph(self, text: str) -> None:
        self._sections[-1][1].append(text)

    def items(self, lines: list[str]) -> None:
        if lines:
            self.paragraph("\n".join(f"- {line}" for line in lines))

    def table(self, columns: list[Column], rows: list[dict]) -> None:
        self.paragraph(table_text(columns, rows))

    def csv(self, name: str, rows: list[dict]) -> None:
        """Writes the rows with all digits, whatever the report shows of them."""
        keys = list(dict.fromkeys(key for row in rows for key in row))
        with (self.folder / name).open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, keys)
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


def table_text(columns: list[Column], rows: list[dict]) -> str:
    """A table in Markdown; a row without a value for a column has an empty cell there."""
    lines = ["| " + " | ".join(column.heading for column in columns) + " |"]
    lines.append("|" + "|".join("---:" if column.is_number else "---" for column in columns) + "|")
    for row in rows:
        cells = ["" if row.get(c.key) is None else str(row[c.key]).replace("|", "\\|") for c in columns]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def number(x: float | None, digits: int = 3) -> str:
    """A number of a table: `digits` decimals, and powers of ten where these would say nothing or fill the page."""
    if x is None:
        return ""
    if math.isnan(x):
        return "–"
    if math.isinf(x):
        return "∞"
    return f"{x:.{digits}f}" if abs(x) < 1000 else f"{x:.2e}"


def statistics(values: Statistics, digits: int = 3) -> str:
    return " / ".join(number(x, digits) for x in (values.maximum, values.average, values.deviation))


def seconds(x: float) -> str:
    return f"{x:.2f}" if x < 100 else f"{x:.0f}"


def percent(x: float) -> str:
    return f"{100 * x:.1f} %"


def listed(words: list[str]) -> str:
    """a, b and c"""
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1] if words else "none"


def duration(x: float) -> str:
    minutes, rest = divmod(round(x), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min {rest} s" if hours else f"{minutes} min {rest} s" if minutes else f"{rest} s"
