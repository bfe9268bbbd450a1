"""Figures 1, 2, 6 and 7: what the sharpness, the radius and the schedule do, and how fast the energy falls."""

from __future__ import annotations

import math

from measuring.plots import Axes, Curve, draw
from measuring.program import Run
from measuring.report import Column, number

from .models import SAME_COUNT
from .pictures import Picture
from .session import (
    DEFAULT,
    ISOMETRIC,
    MESH,
    CONVERGED,
    PAPER_ENERGY,
    SECONDS,
    STOP,
    SWEEPS,
    Session,
    cell,
    count_above,
    failures,
    record,
    shown,
)


def figure_1(session: Session) -> None:
    report = session.report
    report.begin_section("Figure 1: D_iso against the last s")
    mesh = session.library.one("hand", "Figure 1")
    if mesh is None:
        return
    sweeps = str(session.paper_sweeps)
    values = (0.0, 1.0, 10.0) if session.is_short else (0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0)

    def schedule(s: float) -> list[str]:
        return ["--s-first", f"{min(s, 0.1):g}", "--s-last", f"{s:g}"]

    def paper(s: float) -> list[str]:
        # s = 0 is eq. 6 to the end.
        options = ["--paper", "--average-sweeps", sweeps] if s == 0.0 else ["--paper", *schedule(s)]
        return [*options, "--iterations", sweeps]

    def newton(s: float) -> list[str]:
        return ["--energy", "isometric", *(schedule(s) if s > 0.0 else ["--sharpness", "0"]), *CONVERGED]

    def dial(b: float) -> list[str]:
        return ["--sharpness", f"{b:g}", *CONVERGED]

    dial_values = (0.0, 12.0, 50.0) if session.is_short else (0.0, 3.0, 6.0, 12.0, 25.0, 50.0)
    series = (
        ("paper mode, last s", values, paper),
        ("the paper's energy, the package's start, steps and barrier, last s", values, newton),
        ("default of the package, sharpness", dial_values, dial),
    )
    table, records, runs = [], [], []
    curves: dict[str, list[tuple[float, Run]]] = {}
    for name, parameters, options in series:
        for x in parameters:
            run = session.program.run(mesh, options(x), "Figure 1")
            runs.append(run)
            table.append(shown(run, series=name, x=f"{x:g}"))
            records.append(record(run, series=name, parameter=x))
            if run.has_map:
                curves.setdefault(name, []).append((x, run))
    report.paragraph(
        f"On {mesh.name}. The paper: as s grows, the maximum falls rapidly; the average falls at first and then rises"
        " slightly. Here every point is a run of its own, with s from 0.1 to the value given; 0 is eq. 6 alone. Two"
        " more curves show the same energy with the package's own optimiser, and the package's dial, which has no"
        " scale."
    )
    for name, points in curves.items():
        report.paragraph(_course(name, points))

    def diagram(which: str, title: str, chosen: list[str], label: str) -> Axes:
        lines = [
            Curve(
                name,
                [x for x, _ in curves[name]],
                [getattr(run.distortion.isometric, which) for _, run in curves[name]],
            )
            for name in chosen
        ]
        return Axes(title, label, title, lines)

    by_s, by_dial = [name for name in list(curves) if "sharpness" not in name], [n for n in curves if "sharpness" in n]
    draw(
        report.folder / "figure1.png",
        [
            diagram("maximum", "D_iso max", by_s, "last s"),
            diagram("average", "D_iso avg", by_s, "last s"),
        ],
    )
    report.image("figure1.png", f"Figure 1: D_iso of {mesh.name} against the last s.")
    draw(
        report.folder / "figure1_sharpness.png",
        [
            diagram("maximum", "D_iso max", by_dial, "sharpness"),
            diagram("average", "D_iso avg", by_dial, "sharpness"),
        ],
    )
    report.image(
        "figure1_sharpness.png", f"The same for the package's default: D_iso of {mesh.name} against the sharpness."
    )
    columns = [
        Column("Series", "series", is_number=False),
        Column("s or sharpness", "x"),
        ISOMETRIC,
        SWEEPS,
        STOP,
        SECONDS,
    ]
    report.table(columns, table)
    report.csv("figure1.csv", records)
    report.items(failures(runs))


def _course(name: str, points: list[tuple[float, Run]]) -> str:
    def of(key: str) -> tuple[str, str, str, str]:
        values = [(run.row[f"isometric_{key}"], x) for x, run in points]
        least, at = min(values)
        return number(values[0][0]), number(values[-1][0]), number(least), f"{at:g}"

    first, last = points[0][0], points[-1][0]
    (m0, m1, m, m_at), (a0, a1, a, a_at) = of("maximum"), of("average")
    return (
        f"*{name}*: from {first:g} to {last:g} the maximum goes from {m0} to {m1}, lowest at {m_at} ({m}); the average"
        f" from {a0} to {a1}, lowest at {a_at} ({a})."
    )


def figure_2(session: Session) -> None:
    report = session.report
    report.begin_section("Figure 2: rules for the radius")
    report.paragraph(
        "The distortion at the radius that each rule ended with. The paper: eq. 11 always has both the lower maximum"
        " and the lower average, and it is trapped easily from a bad start, which is why the method takes eq. 9 until"
        " convergence and eq. 11 after it (two-phase)."
    )
    names = ("cow",) if session.is_short else ("bunny", "hand", "cow", "fandisk")
    table, records, runs = [], [], []
    for name in names:
        mesh = session.library.one(name, "Figure 2")
        if mesh is None or any(row["mesh"] == mesh.name for row in table):
            continue
        # Eq. 10 has the sphere's area equal to the mesh's.
        fixed = math.sqrt(mesh.mesh.area() / (4.0 * math.pi))
        rules = {
            "eq. 10, fixed": f"fixed={fixed:.17g}",
            "eq. 9": "area",
            "eq. 11": "optimal",
            "two-phase": "two-phase",
        }
        for mode, options in (("paper mode", session.paper()), ("the package's optimiser", PAPER_ENERGY)):
            group = []
            for rule, value in rules.items():
                run = session.program.run(mesh, [*options, "--radius", value], "Figure 2")
                runs.append(run)
                row = shown(run, mode=mode, rule=rule)
                if run.has_map:
                    own, group = run.own_distortion.isometric, [*group, (rule, run)]
                    row["own"] = " / ".join(number(x) for x in (own.maximum, own.average, own.deviation))
                table.append(row)
                records.append(record(run, mode=mode, rule=rule, eq10_radius=fixed))
            if group:
                lowest = [
                    min(group, key=lambda g: g[1].row[f"own_radius_isometric_{key}"])[0]
                    for key in ("maximum", "average")
                ]
                session.report.paragraph(
                    f"{mesh.name}, {mode}: the lowest maximum with {lowest[0]}, the lowest average with {lowest[1]}."
                )
    columns = [
        MESH,
        Column("Optimiser", "mode", is_number=False),
        Column("Rule", "rule", is_number=False),
        Column("Radius", "radius"),
        Column("D_iso max / avg / dev at that radius", "own"),
        Column("D_iso max / avg / dev at the radius of eq. 11", "isometric"),
        SWEEPS,
        SECONDS,
    ]
    if table:
        report.table(columns, table)
        report.csv("figure2.csv", records)
    report.items(failures(runs))


def figure_6(session: Session) -> None:
    report, library = session.report, session.library
    report.begin_section("Figure 6: schedules of s")
    sweeps = session.paper_sweeps
    n = ["--iterations", str(sweeps)]
    average_sweeps = ["--average-sweeps", "100"]
    schedules = {
        "(a) eq. 6, 100 sweeps": ["--paper", *average_sweeps, "--iterations", "100"],
        "(b) eq. 7, s = 5": ["--paper", "--s-first", "5", "--s-last", "5", "--average-sweeps", "0", *n],
        "(c) eq. 7, s = 0.1": ["--paper", "--s-first", "0.1", "--s-last", "0.1", "--average-sweeps", "0", *n],
        "(d) eq. 7, s from 0.1 to 10": ["--paper", "--average-sweeps", "0", *n],
        "(e) eq. 6, 100 sweeps, then s from 0.1 to 10": session.paper(),
        "default of the package": DEFAULT,
    }
    report.paragraph(
        f"Paper mode with the schedules of the paper's figure, at most {sweeps} sweeps in all, and the package's"
        " default beside it. (b) and (c) are AMIPS with a fixed s. The paper: the adaptive schedule after eq. 6 (e)"
        " ends with the lowest maximum."
    )
    table, records, runs, cells, row_titles = [], [], [], [], []
    cow = library.one("cow", "Figure 6")
    files = list(dict.fromkeys(f for f in (cow, library.copy("cow", SAME_COUNT)) if f is not None))
    for file in files:
        of_file = {name: session.program.run(file, options, "Figure 6") for name, options in schedules.items()}
        runs += of_file.values()
        bound = next(run for name, run in of_file.items() if name.startswith("(e)"))
        for name, run in of_file.items():
            above = count_above(run, bound)
            table.append(shown(run, schedule=name, above=None if above is None else f"{above:,}"))
            records.append(record(run, schedule=name, faces_above_maximum_of_e=above))
        ranked = sorted(
            (run.row["isometric_maximum"], name) for name, run in of_file.items() if run.has_map and name[0] == "("
        )
        if ranked:
            order = ", ".join(f"{name[:3]} {number(value)}" for value, name in ranked)
            report.paragraph(f"{file.name}, the paper's five by their maximum: {order}.")
        cells.append([cell(run, bound) for run in of_file.values()])
        row_titles.append(file.name)
    if not files:
        return
    titles = [name.replace(", then", ",\nthen") for name in schedules]
    session.draw(
        Picture("figure6.png", titles, row_titles, cells, "D_iso", 8.0),
        "Figure 6: in brackets D_iso max, D_iso avg, faces above the maximum of (e), folded faces.",
    )
    columns = [
        MESH,
        Column("Schedule", "schedule", is_number=False),
        ISOMETRIC,
        Column("Faces above (e)'s max", "above"),
    ]
    report.table([*columns, SWEEPS, STOP, SECONDS], table)
    report.csv("figure6.csv", records)
    report.items(failures(runs))


def figure_7(session: Session) -> None:
    report = session.report
    report.begin_section("Figure 7: energy against sweeps")
    report.paragraph(
        "The average energy of a face (eq. 3; 2 at best) during the 100 sweeps of eq. 6 that paper mode begins with,"
        " from the harmonic map. The second curve takes the same start and the same energy with Newton steps and the"
        " determinant in the energy's place of the area, which makes its energy a little larger at the same map."
    )
    newton = ["--initial", "harmonic", *PAPER_ENERGY, "--average-sweeps", "100", "--iterations", "100"]
    modes = {"gradient steps, as published": ["--paper", "--iterations", "100"], "Newton steps of the package": newton}
    records, diagrams, table, runs = [], [], [], []
    shown_at = (1, 2, 5, 10, 20, 50, 100)
    hand = session.library.one("hand", "Figure 7")
    cow = session.library.one("cow", "Figure 7", without=(hand,) if hand else ())
    for file in filter(None, (hand, cow)):
        curves = []
        for mode, options in modes.items():
            run = session.program.run(file, options, "Figure 7")
            runs.append(run)
            history = [(sweep, energy) for sweep, energy, _ in run.report.get("history", [])[:100]]
            if not history:
                continue
            curves.append(Curve(mode, [sweep for sweep, _ in history], [energy for _, energy in history]))
            records += [
                {"mesh": file.name, "mode": mode, "sweep": sweep, "energy": energy} for sweep, energy in history
            ]
            row = {
                "mesh": file.name,
                "mode": mode,
                "start": number(run.report.get("energy", {}).get("initial_average")),
            }
            counted = list(enumerate(history, 1))
            table.append(row | {f"at{i}": number(energy) for i, (_, energy) in counted if i in shown_at})
        diagrams.append(Axes(file.name, "sweep", "energy of a face, log scale", curves, is_log=True, has_markers=False))
    if not records:
        report.paragraph("No run has told its history.")
    else:
        draw(report.folder / "figure7.png", diagrams)
        report.image("figure7.png", "Figure 7: the energy of a face against the sweep.")
        columns = [MESH, Column("Steps", "mode", is_number=False), Column("Start", "start")]
        report.table(columns + [Column(f"Sweep {i}", f"at{i}") for i in shown_at], table)
        report.csv("figure7.csv", records)
    report.items(failures(runs))
