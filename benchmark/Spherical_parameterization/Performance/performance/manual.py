"""The page of the user manual: the text is written by hand, its tables and figures come from here."""

from __future__ import annotations

import re
import shutil
from pathlib import Path


class Manual:
    """A copy of the page in which the parts that have been measured are new.

    In the page, `<!-- begin NAME -->` and `<!-- end NAME -->` enclose what belongs to a section.
    """

    def __init__(self, page: Path, folder: Path):
        self._page = page
        self._folder = folder
        self._parts: dict[str, list[str]] = {}
        self._figures: list[Path] = []

    def add(self, section: str, *paragraphs: str) -> None:
        self._parts.setdefault(section, []).extend(paragraphs)

    def set(self, section: str, paragraph: str) -> None:
        self._parts[section] = [paragraph]

    def add_figure(self, figure: Path) -> None:
        self._figures.append(figure)

    def write(self, is_whole: bool) -> list[str]:
        """Writes the copy beside the report if all is there that the page wants; returns what is wrong otherwise.

        Part of the measurements, `is_whole` being false, fits into the page at best: there is no copy then, not even an
        earlier one, as it would mix them with older ones.
        """
        shutil.rmtree(self._folder, ignore_errors=True)
        if not self._page.is_file():
            return [f"There is no {self._page.name} to fill in."]
        text = self._page.read_text(encoding="utf-8")
        objections = []
        for section, paragraphs in self._parts.items():
            pattern = rf"(<!-- begin {section} -->\n).*?(<!-- end {section} -->)"
            content = "\n\n".join(paragraphs) + "\n"
            text, count = re.subn(pattern, lambda m: m.group(1) + content + m.group(2), text, flags=re.DOTALL)
            if count != 1:
                objections.append(f"{self._page.name} has {count} places for the section {section}.")
        if is_whole:
            missing = set(re.findall(r"<!-- begin (\w+) -->", text)) - set(self._parts)
            objections += [f"{self._page.name}: nothing was measured for {section}." for section in sorted(missing)]
        if not is_whole or objections:
            return objections
        figures = self._folder / "fig"
        figures.mkdir(parents=True, exist_ok=True)
        (self._folder / self._page.name).write_text(text, encoding="utf-8")
        for figure in self._figures:
            shutil.copyfile(figure, figures / figure.name)
        return []
