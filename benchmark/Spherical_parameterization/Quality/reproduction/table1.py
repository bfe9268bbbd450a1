"""Table 1, and the pictures of its maps: figures 8 and 9."""

from __future__ import annotations

import math

from measuring.mesh_files import MeshFile
from measuring.program import Run
from measuring.report import Column, listed, number, seconds, statistics

from .models import COMPLEX, MODELS, SIMPLE, TABLE_1
from .paper_values import COUNTS
from .paper_values import TABLE_1 as PAPER_ROWS
from .pictures import Picture
from .session import (
    ANGLE,
    ARAP,
    FULL_SWEEPS,
    AREA,
    CPU_SECONDS,
    Comparison,
    DEFAULT,
    FOLDED,
    HARMONIC,
    HIERARCHICAL,
    ISOMETRIC,
    MESH,
    OWN_RADIUS,
    SECONDS,
    SIZE,
    STOP,
    SWEEPS,
    Session,
    cell,
    count_above,
    failures,
    record,
    shown,
)

BLD, PACKAGE = "BLD, paper mode", "default of the package"
MOST_VERTICES_OF_UNKNOWN_MESHES = 20_000
EQUAL = 0.005  # what differs by less, relatively, counts as equal


def methods(session: Session) -> dict[str, list[str]]:
    return {
        "Harmonic": HARMONIC,
        "Hierarchical": HIERARCHICAL,
        "ARAP": ARAP,
        BLD: session.paper(),
        PACKAGE: DEFAULT,
    }


def table_1(session: Session) -> None:
    report, library = session.report, session.library
    report.begin_section("Table 1: distortion, folded faces and seconds")
    report.paragraph(
        "Each model as it was found, and in a copy with as many vertices as the paper's. Rows in italics repeat the"
        " paper: another mesh of that model, on another machine. Maps with folds can have any area at a face that is"
        " about to turn, and so any radius of eq. 11; the last column has the same map at the radius that the method"
        " gave it."
    )
    records: list[dict] = []
    runs: list[Run] = []
    missing = [model for model in TABLE_1 if not library.copies(model.name)]
    for model in TABLE_1:
        if model not in missing:
            report.paragraph(f"### {model.title}")
            runs += _table_of(session, library.copies(model.name), model.name, records)
    if len(missing) == len(TABLE_1):
        most = library.most_vertices or MOST_VERTICES_OF_UNKNOWN_MESHES
        unknown = [file for file in library.stand_ins(len(library.files), []) if file.number_of_vertices <= most]
        library.notes.append(
            f"Table 1: none of the paper's models is among the meshes; {len(unknown)} others stand for them."
        )
        for file in unknown:
            report.paragraph(f"### {file.name}")
            runs += _table_of(session, {"": file}, "", records)
    elif missing:
        titles = listed([model.title for model in missing])
        library.notes.append(f"Table 1: {titles}: no mesh of these models{_limit(session)}.")
    if records:
        report.csv("table1.csv", records)
    report.items(failures(runs))


def figure_8(session: Session) -> None:
    _pictures(session, "8", "simple", SIMPLE, 3.0)


def figure_9(session: Session) -> None:
    _pictures(session, "9", "complex", COMPLEX, 8.0)


def verdict(session: Session) -> str:
    """The first paragraph: where the default is better than paper mode, and where it is not. Nothing of it is fixed."""
    if not session.comparison:
        return "This run did not compare the package's default with paper mode: it did not include Table 1."
    default_only = [pair.mesh.name for pair in session.comparison if pair.default.has_map and not pair.paper.has_map]
    neither = [pair.mesh.name for pair in session.comparison if not pair.default.has_map]
    pairs = [pair for pair in session.comparison if pair.default.has_map and pair.paper.has_map]
    parts = [
        f"The package's default against the method as published (paper mode), on {len(pairs)} meshes, both measured in"
        f" this run with {session.program.threads} threads, D_iso at the radius of eq. 11."
    ]
    if session.is_short:
        parts.append(
            f"This is the short version: paper mode was ended after {session.paper_sweeps} of its {FULL_SWEEPS} sweeps"
            " and the meshes are small, so these figures show that the driver works and do not compare the methods."
        )
    if pairs:
        quantities = (
            ("The maximum", lambda run: run.row["isometric_maximum"], number),
            ("The average", lambda run: run.row["isometric_average"], number),
            ("The time", lambda run: run.seconds, lambda x: f"{seconds(x)} s"),
        )
        parts += [_compared(name, value, text, pairs) for name, value, text in quantities]
    if default_only:
        parts.append(f"Paper mode has no map at all of {listed(default_only)}, where the default has one.")
    if neither:
        parts.append(f"The default has no map of {listed(neither)}.")
    limited = sum("limit" in pair.paper.stop_reason for pair in pairs)
    if not session.is_short:
        parts.append(
            f"Paper mode ended at its limit of sweeps, and not by its stopping rule, on {limited} of"
            f" {len(pairs)} meshes."
        )
    return " ".join(parts)


def _compared(name: str, value, text, pairs: list[Comparison]) -> str:
    """A sentence on one quantity, of which less is better."""
    ratios = [(value(pair.default) / value(pair.paper), pair) for pair in pairs]
    lower = [pair for ratio, pair in ratios if ratio < 1 - EQUAL]
    higher = [pair for ratio, pair in sorted(ratios, key=lambda r: -r[0]) if ratio > 1 + EQUAL]
    mean = math.exp(sum(math.log(ratio) for ratio, _ in ratios) / len(ratios))
    least, largest = min(ratios, key=lambda r: r[0]), max(ratios, key=lambda r: r[0])
    if not lower and not higher:
        words = "the same"
    elif not higher:
        words = "better"
    elif not lower:
        words = "worse"
    elif 2 * len(lower) > len(pairs):
        words = "better on most" if mean < 1 else "better on most, but worse in the mean"
    elif 2 * len(higher) > len(pairs):
        words = "worse on most" if mean > 1 else "worse on most, but better in the mean"
    else:
        words = "neither better nor worse"
    by_kind = []
    for kind in dict.fromkeys(pair.kind for pair in pairs):
        of_kind = [pair for pair in pairs if pair.kind == kind]
        by_kind.append(f"{sum(pair in lower for pair in of_kind)} of {len(of_kind)}{f' ({kind})' if kind else ''}")
    result = (
        f"**{name}: the default is {words}**: lower on {listed(by_kind)}, {mean:.3g} times paper mode's in the"
        f" geometric mean, from {least[0]:.3g} ({least[1].mesh.name}) to {largest[0]:.3g}"
        f" ({largest[1].mesh.name})"
    )
    if higher:
        cases = [f"{p.mesh.name} ({text(value(p.paper))} against {text(value(p.default))})" for p in higher]
        result += f"; paper mode is lower on {listed(cases)}"
    return result + "."


def _limit(session: Session) -> str:
    most = session.library.most_vertices
    return f" with at most {most:,} vertices" if most else ""


def _table_of(session: Session, copies: dict[str, MeshFile], model: str, records: list[dict]) -> list[Run]:
    """Runs all methods on the copies of a model, and adds the table."""
    rows, runs = [], []
    for method, options in methods(session).items():
        name = "BLD" if method == BLD else method
        for kind, file in copies.items():
            run = session.program.run(file, options, "Table 1")
            runs.append(run)
            rows.append(shown(run, method=method, mesh=f"{file.name} ({kind})" if kind else file.name))
            records.append(record(run, source="this run", model=model, method=method, copy=kind))
        paper = PAPER_ROWS.get((model, name))
        if paper is not None:
            vertices, faces = COUNTS[model]
            time = "–" if paper.seconds is None else seconds(paper.seconds)
            texts = {
                "method": name,
                "mesh": "the paper's mesh and machine",
                "size": f"{vertices:,} / {faces:,}",
                **{name: statistics(getattr(paper, name), 2) for name in ("isometric", "area", "angle")},
                "folded": f"{paper.folded:,g}",
                "seconds": time,
            }
            rows.append({key: f"*{text}*" for key, text in texts.items()})
            values = {"source": "paper", "model": model, "method": name, "vertices": vertices, "faces": faces}
            values |= {"folded_faces": paper.folded, "seconds": paper.seconds}
            for measure in ("isometric", "area", "angle"):
                values |= {f"{measure}_{key}": x for key, x in vars(getattr(paper, measure)).items()}
            records.append(values)
    for kind, file in copies.items():
        default, paper_mode = (
            next(run for run in runs if run.mesh is file and list(run.arguments) == options)
            for options in (DEFAULT, session.paper())
        )
        session.comparison.append(Comparison(kind, default, paper_mode))
    method_column = Column("Method", "method", is_number=False)
    columns = [
        method_column,
        MESH,
        SIZE,
        ISOMETRIC,
        AREA,
        ANGLE,
        FOLDED,
        SECONDS,
        CPU_SECONDS,
        SWEEPS,
        STOP,
        OWN_RADIUS,
    ]
    session.report.table(columns, rows)
    session.forget_maps()
    return runs


def _pictures(session: Session, figure: str, kind: str, names: tuple[str, ...], largest: float) -> None:
    report, library = session.report, session.library
    report.begin_section(f"Figure {figure}: the methods on {kind} models")
    report.paragraph(
        "The maps of Table 1, of the copies as found where there are such. The surface on the left and the sphere on"
        f" the right have the same colours, D_iso from 1 to {largest:g}; folded faces are magenta. In brackets: D_iso"
        " max, D_iso avg, the number of faces above the maximum of BLD in paper mode, the number of folded faces."
    )
    files = {MODELS[name].title: library.best(name) for name in names if library.best(name) is not None}
    if not files:
        stand_in = library.one(names[0], f"Figure {figure}")
        files = {stand_in.name: stand_in} if stand_in is not None else {}
    table, records, cells, row_titles = [], [], [], []
    for title, file in files.items():
        runs = {
            method: session.program.run(file, options, f"Figure {figure}")
            for method, options in methods(session).items()
        }
        cells.append([cell(run, runs[BLD]) for run in runs.values()])
        row_titles.append(file.name)
        for method, run in runs.items():
            above = count_above(run, runs[BLD])
            table.append(shown(run, method=method, above=None if above is None else f"{above:,}"))
            records.append(record(run, model=title, method=method, faces_above_maximum_of_bld=above))
    if not files:
        return
    name = f"figure{figure}.png"
    titles = list(methods(session))
    picture = Picture(name, titles, row_titles, cells, "D_iso", largest)
    session.draw(picture, f"Figure {figure}: {', '.join(titles)}.")
    columns = [
        MESH,
        Column("Method", "method", is_number=False),
        ISOMETRIC,
        Column("Faces above BLD's max", "above"),
        FOLDED,
    ]
    report.table(columns, table)
    report.csv(f"figure{figure}.csv", records)
