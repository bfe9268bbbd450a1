"""The default of the package against the paper's own algorithm."""

from __future__ import annotations

import statistics

from measuring.mesh_files import MeshFile
from measuring.plots import Axes, Curve
from measuring.program import Run
from measuring.report import Column, listed, number, seconds

from .session import MESH, VERTICES, Session, geometric_mean, span, speed

SECTION = "comparison"
MOST_PAPER_RUNS = 3  # as it takes long
SHORT_SWEEPS = 150  # of paper mode: 100 of eq. 6, and some of eq. 7
EQUAL = 0.0005  # what is larger by less, relatively, is not worse

COLUMNS = [
    MESH,
    VERTICES,
    Column("Paper, s", "paper_seconds"),
    Column("Package, s", "default_seconds"),
    Column("Ratio", "ratio"),
    Column("Paper, D_iso max / avg", "paper_distortion"),
    Column("Package, D_iso max / avg", "default_distortion"),
    Column("Paper, sweeps", "paper_sweeps"),
    Column("Paper ended", "paper_stop", is_number=False),
]


def comparison(session: Session) -> None:
    report = session.report
    report.begin_section("Against the paper's algorithm")
    report.paragraph(
        "Seconds from the mesh in memory to the certified map, as the program reports them: medians of"
        f" {session.repetitions} runs of the default and of {_number_of_paper_runs(session)} of paper mode, in turns."
        " D_iso is computed by this driver from the maps that were written, at the radius of eq. 11."
    )
    if session.is_short:
        report.paragraph(f"Short version: paper mode ends after {SHORT_SWEEPS} sweeps, so its figures say nothing.")
    rows, records, pairs = [], [], []
    for name in session.paper_meshes:
        file = session.one(name)
        if file is None:
            session.notes.append(f"Against the paper's algorithm: {name} is not among the meshes.")
            continue
        defaults, published = _run(session, file)
        runs = [*defaults, *published]
        records += [{"method": method_of(run), **run.row, "mapping_seconds": run.mapping_seconds} for run in runs]
        for run in runs:
            run.forget_map()
        file.forget()
        without_map = next((run for run in runs if not run.has_map), None)
        if without_map is not None:
            report.paragraph(f"{file.name}, {method_of(without_map)}: no map. {without_map.message}")
            continue
        pairs.append((defaults, published))
        rows.append(_shown(defaults, published))
    if not rows:
        session.tell(SECTION, "None of the meshes of paper mode could be compared; `--paper-meshes` names others.")
        return
    session.tell(SECTION, _verdict(pairs))
    session.tabulate(SECTION, COLUMNS, rows)
    report.csv("comparison.csv", records)
    _draw(session, pairs)


def method_of(run: Run) -> str:
    return "paper" if "--paper" in run.arguments else "default"


def _number_of_paper_runs(session: Session) -> int:
    return 1 if session.is_short else min(session.repetitions, MOST_PAPER_RUNS)


def _run(session: Session, file: MeshFile) -> tuple[list[Run], list[Run]]:
    """The runs of the default and those of paper mode, made in turns."""
    paper = ["--paper"] + (["--iterations", str(SHORT_SWEEPS)] if session.is_short else [])
    rounds = _number_of_paper_runs(session)
    defaults, published = [], []
    for k in range(rounds):
        defaults += [session.program.run(file, [], SECTION, i) for i in range(k, session.repetitions, rounds)]
        published.append(session.program.run(file, paper, SECTION, k))
        if not published[-1].has_map:
            break
    return defaults, published


def _seconds(runs: list[Run]) -> float:
    return statistics.median(run.mapping_seconds for run in runs)


def _ratio(defaults: list[Run], published: list[Run]) -> float:
    return _seconds(published) / _seconds(defaults)


def _distortion(run: Run) -> str:
    folded = run.row["folded_faces"]
    text = f"{number(run.row['isometric_maximum'])} / {number(run.row['isometric_average'])}"
    return f"{text}, {folded} folded" if folded else text


def _shown(defaults: list[Run], published: list[Run]) -> dict:
    paper = published[0]
    return {
        "mesh": paper.mesh.name,
        "vertices": f"{paper.mesh.number_of_vertices:,}",
        "paper_seconds": seconds(_seconds(published)),
        "default_seconds": f"{_seconds(defaults):.3f}",
        "ratio": speed(_ratio(defaults, published)),
        "paper_distortion": _distortion(paper),
        "default_distortion": _distortion(defaults[0]),
        "paper_sweeps": paper.sweeps,
        "paper_stop": paper.stop_reason,
    }


def _verdict(pairs: list[tuple[list[Run], list[Run]]]) -> str:
    ratios = [_ratio(*pair) for pair in pairs]
    text = (
        f"The default is {span(ratios)} times as fast as the paper's algorithm, {speed(geometric_mean(ratios))} times"
        " in the geometric mean"
    )
    for name, key in (("maximum", "isometric_maximum"), ("average", "isometric_average")):
        worse = [
            f"{default.mesh.name} ({number(default.row[key])} against {number(paper.row[key])})"
            for (default, *_), (paper, *_) in pairs
            if default.row[key] > (1.0 + EQUAL) * paper.row[key]
        ]
        joint = "; its" if name == "maximum" else ", its"
        text += f"{joint} {name} is " + (f"larger on {listed(worse)}" if worse else "nowhere larger")
    return text + "."


def _draw(session: Session, pairs: list[tuple[list[Run], list[Run]]]) -> None:
    pairs = sorted(pairs, key=lambda pair: pair[0][0].mesh.number_of_vertices)
    vertices = [defaults[0].mesh.number_of_vertices for defaults, _ in pairs]
    curves = [
        Curve("the paper's algorithm", vertices, [_seconds(published) for _, published in pairs]),
        Curve("default", vertices, [_seconds(defaults) for defaults, _ in pairs]),
    ]
    axes = Axes("Mesh to certified map", "vertices", "seconds", curves, is_log=True, is_x_log=True)
    session.draw("performance_comparison.png", [axes], "Seconds of the paper's algorithm and of the default.")
