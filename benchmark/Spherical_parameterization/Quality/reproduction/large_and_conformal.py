"""Figures 10 and 11: two large models, and conformal maps."""

from __future__ import annotations

from measuring.report import Column, number

from .pictures import Picture
from .session import (
    ANGLE,
    DEFAULT,
    FOLDED,
    HARMONIC,
    HIERARCHICAL,
    ISOMETRIC,
    MESH,
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

LEAST_VERTICES_OF_LARGE = 200_000
LARGE_SWEEPS = 200  # of paper mode, of which all 2000 would take an hour on these two


def figure_10(session: Session) -> None:
    report = session.report
    report.begin_section("Figure 10: two large models")
    files = [file for file in map(session.large.best, ("vaselion", "buste")) if file is not None]
    files = [file for file in files if file.number_of_vertices >= LEAST_VERTICES_OF_LARGE]
    if len(files) < 2 and session.is_short:
        files = session.library.stand_ins(2, [])
        session.large.notes.append("Figure 10: small meshes stand for the large ones in the short version.")
    elif len(files) < 2:
        session.large.notes.append(
            f"Figure 10: {2 - len(files)} of its two large models (vaselion_369650, buste_522114) are not there;"
            " --large names their folder."
        )
    if not files:
        report.paragraph("Skipped: there is no large mesh.")
        return
    report.paragraph(
        "The paper takes a parallel method of others as the start, because Harmonic fails on models of this size. Here"
        " that start is the hierarchical map; Harmonic is tried too."
        + ("" if session.is_short else f" Paper mode is ended after {LARGE_SWEEPS} sweeps here.")
    )
    paper = session.paper("--initial", "hierarchical")
    if not session.is_short:
        paper += ["--iterations", str(LARGE_SWEEPS)]
    methods = {
        "Harmonic": HARMONIC,
        "Hierarchical, the start": HIERARCHICAL,
        "BLD, paper mode from the hierarchical map": paper,
        "default of the package": DEFAULT,
    }
    table, records, runs, cells = [], [], [], []
    for file in files:
        of_file = {name: session.program.run(file, options, "Figure 10") for name, options in methods.items()}
        runs += of_file.values()
        for name, run in of_file.items():
            table.append(shown(run, method=name, minutes=number(run.seconds / 60, 2)))
            records.append(record(run, method=name))
        cells.append([cell(run) for run in of_file.values()])
    session.draw(
        Picture("figure10.png", list(methods), [file.name for file in files], cells, "D_iso", 3.0),
        "Figure 10: in brackets D_iso max, D_iso avg and folded faces.",
    )
    columns = [MESH, SIZE, Column("Method", "method", is_number=False), ISOMETRIC, FOLDED, SWEEPS, STOP]
    report.table([*columns, Column("Minutes", "minutes")], table)
    report.csv("figure10.csv", records)
    report.items(failures(runs))


def figure_11(session: Session) -> None:
    report, library = session.report, session.library
    report.begin_section("Figure 11: conformal maps")
    report.paragraph(
        "BLD with the conformal energy against the classical conformal map, which promises no bijection. D_angle is 2"
        " at best. The paper: Conformal folds at the ears of the bunny and the fingers of the hand, and has no bound on"
        " the maximum."
    )
    methods = {
        "Conformal": ["--method", "conformal"],
        "BLD of the package, conformal energy": ["--energy", "conformal"],
    }
    files = list(dict.fromkeys(f for name in ("bunny", "hand") for f in library.copies(name).values()))
    if not files:
        files = [f for f in (library.one("bunny", "Figure 11"),) if f is not None]
    table, records, runs, cells, texts = [], [], [], [], []
    for file in files:
        conformal, bld = (session.program.run(file, options, "Figure 11") for options in methods.values())
        runs += [conformal, bld]
        for name, run in zip(methods, (conformal, bld)):
            above = count_above(run, bld, "D_angle")
            table.append(shown(run, method=name, above=None if above is None else f"{above:,}"))
            records.append(record(run, method=name, faces_above_maximum_of_bld=above))
        cells.append([cell(run, bld, "D_angle") for run in (conformal, bld)])
        if conformal.has_map and bld.has_map:
            a, b = conformal.row, bld.row
            texts.append(
                f"{file.name}: BLD's maximum is {number(b['angle_maximum'] / a['angle_maximum'])} times Conformal's,"
                f" its average {number(b['angle_average'] / a['angle_average'], 4)} times; folded faces"
                f" {a['folded_faces']:,} with Conformal, {b['folded_faces']:,} with BLD"
            )
    if not files:
        return
    report.paragraph(". ".join(texts) + "." if texts else "There are no two maps to compare.")
    session.draw(
        Picture("figure11.png", list(methods), [file.name for file in files], cells, "D_angle", 4.0),
        "Figure 11: in brackets D_angle max, D_angle avg, faces above the maximum of BLD, folded faces.",
    )
    columns = [MESH, SIZE, Column("Method", "method", is_number=False), ANGLE, Column("Faces above BLD's max", "above")]
    report.table([*columns, FOLDED, SWEEPS, STOP, SECONDS], table)
    report.csv("figure11.csv", records)
    report.items(failures(runs))
