"""The page and the table of a subject."""

from __future__ import annotations

import html
from typing import Any, Dict, List, Sequence

# The columns: key, title, description
COLUMNS = (
    ("hemisphere", "Hemisphere", ""),
    ("map", "Map", "to the sphere, or to an atlas"),
    ("vertices", "Vertices", "of the white surface"),
    ("one_to_one", "Bijective", "certified by exact arithmetic"),
    ("D_iso_average", "D_iso, average", "isometric distortion of faces, at least 1; for an atlas, between surface and atlas"),
    ("D_iso_maximum", "D_iso, maximum", "of the worst face"),
    ("D_area_average", "D_area, average", "area distortion, at least 2"),
    ("D_angle_average", "D_angle, average", "angle distortion, at least 2"),
    ("agreement", "Agreement", "correlation of the sulcal depths with those of the atlas, at most 1"),
    ("certain", "Certain", "no if the alignment is ambiguous, or the sulcal depths correlate too little: inspect such a registration"),
    ("seconds", "Seconds", "of computing time"),
)

STYLE = """body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 75rem; padding: 0 1rem; color: #1a1a1a; background: #fff }
table { border-collapse: collapse } th, td { padding: .3rem .7rem; text-align: right; border-bottom: 1px solid #ccc }
th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left } .wrong { color: #a40000; font-weight: 600 }
th button { font: inherit; font-weight: 600; border: 0; background: none; cursor: pointer; padding: 0; text-align: inherit; color: #00539c }
div.table { overflow-x: auto } dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem } dd { margin: 0 }"""

SCRIPT = """document.querySelectorAll("th button").forEach((button) => button.addEventListener("click", () => {
  const head = button.closest("th"), k = [...head.parentNode.children].indexOf(head), body = document.querySelector("tbody");
  const up = head.getAttribute("aria-sort") !== "ascending", key = (row) => row.children[k].dataset.value;
  const order = (a, b) => (isNaN(a) || isNaN(b) ? String(a).localeCompare(b) : a - b);
  document.querySelectorAll("th").forEach((other) => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  [...body.children].sort((a, b) => (up ? 1 : -1) * order(key(a), key(b))).forEach((row) => body.append(row));
}));"""


def as_text(value: Any) -> str:
    if value is None:
        return "n/a"  # as in the tables of BIDS
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def make_table(rows: Sequence[Dict[str, Any]]) -> str:
    """Returns the rows as tab-separated values."""
    lines = ["\t".join(key for key, _, _ in COLUMNS)]
    lines += ["\t".join(as_text(row.get(key)) for key, _, _ in COLUMNS) for row in rows]
    return "\n".join(lines) + "\n"


def make_page(title: str, program: str, rows: Sequence[Dict[str, Any]], failures: Sequence[str], pages: Dict[str, str]) -> str:
    """Returns the page of a subject: failures, the table, and links to the pages of its surfaces."""

    def cell(key: str, value: Any) -> str:
        text = as_text(value)
        wrong = key in ("one_to_one", "certain") and value is False
        return f'<td data-value="{html.escape(text)}"{" class=wrong" if wrong else ""}>{html.escape(text)}</td>'

    heads = "".join(f'<th scope="col"><button type="button" title="{html.escape(text)}">{name}</button></th>' for _, name, text in COLUMNS)
    body = "\n".join("<tr>" + "".join(cell(key, row.get(key)) for key, _, _ in COLUMNS) + "</tr>" for row in rows)
    parts: List[str] = [f"<h1>{html.escape(title)}</h1>"]
    if failures:
        items = "".join(f"<li>{html.escape(text)}</li>" for text in failures)
        parts.append(f'<h2>Failures</h2><ul class="wrong">{items}</ul>')
    if rows:
        parts.append(f'<div class="table"><table><thead><tr>{heads}</tr></thead><tbody>\n{body}\n</tbody></table></div>')
        parts.append("<p>Click on a column header to sort the table.</p><dl>")
        parts += [f"<dt>{name}</dt><dd>{text}</dd>" for _, name, text in COLUMNS if text]
        parts.append("</dl>")
    if pages:
        links = "".join(f'<li><a href="{html.escape(path)}">{html.escape(name)}</a></li>' for name, path in pages.items())
        parts.append(f"<h2>Surfaces and spheres</h2><ul>{links}</ul>")
    content = "\n".join(parts)
    return f"""<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{html.escape(title)}</title>
<style>{STYLE}</style></head>
<body>
{content}
<p>{html.escape(program)}</p>
<script>{SCRIPT}</script>
</body>
</html>
"""
