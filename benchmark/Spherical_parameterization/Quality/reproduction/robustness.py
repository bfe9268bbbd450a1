"""Figures 3, 4 and 5: other starts and other tessellations lead to the same result."""

from __future__ import annotations

from measuring import meshes
from measuring.mesh_files import MeshFile
from measuring.program import CERTIFIED, Run
from measuring.report import Column, listed, number, percent

from .models import AS_FOUND, MODELS, SAME_COUNT
from .pictures import Picture
from .session import (
    CONVERGED,
    DEFAULT,
    FOLDED,
    ISOMETRIC,
    MESH,
    SECONDS,
    SIZE,
    STOP,
    SWEEPS,
    Session,
    cell,
    failures,
    record,
    shown,
)

STARTS = ("stereographic", "harmonic", "hierarchical", "conformal")
START_MODELS = tuple("fandisk skull maxplanck santa buddha bunny hand cow spot blub brain horse armadillo bimba".split())
MOST_OF_AVERAGE, MOST_OF_MAXIMUM = 0.03, 0.10  # by which results of different starts may differ


def figure_3(session: Session) -> None:
    report = session.report
    report.begin_section("Figure 3: different starts")
    report.paragraph(
        "The paper: almost the same result from different initial maps. Here the package's optimiser starts from each"
        f" of its four initial maps and may take {CONVERGED[1]} sweeps, so that all can converge; the results of a mesh"
        f" count as the same if they are within {percent(MOST_OF_AVERAGE)} in the average and"
        f" {percent(MOST_OF_MAXIMUM)} in the maximum of D_iso, largest against smallest. A start that is no bijection"
        " cannot be used, and is listed below the table."
    )
    names = ("fandisk", "bunny", "cow") if session.is_short else START_MODELS
    files = _distinct(session, names, "Figure 3")
    records: list[dict] = []
    by_mesh = {file: _from_all_starts(session, file, CONVERGED, "package", records) for file in files}
    _tell_spread(session, by_mesh, "the package's optimiser")
    if files:
        largest = 8.0
        file = next((f for f in files if f.name.startswith("bunny")), files[0])
        cells = [[cell(run) for run in by_mesh[file].values()]]
        titles = [f"from {start}" for start in by_mesh[file]]
        session.draw(
            Picture("figure3.png", titles, [file.name], cells, "D_iso", largest), "Figure 3: one mesh, four starts."
        )

    report.paragraph("The same in paper mode, with its own limit of sweeps:")
    small = _distinct(
        session, ("fandisk", "cow") if session.is_short else ("fandisk", "bunny", "cow"), "Figure 3, paper mode"
    )
    extra = [file for file in (session.library.copy("fandisk", SAME_COUNT),) if file is not None and file not in small]
    by_mesh = {file: _from_all_starts(session, file, session.paper(), "paper", records) for file in small + extra}
    _tell_spread(session, by_mesh, "paper mode")
    if records:
        report.csv("figure3.csv", records)


def _distinct(session: Session, names: tuple[str, ...], figure: str) -> list[MeshFile]:
    """The meshes of some models, each once, filled up with others so that there are as many."""
    library = session.library
    files = [file for file in map(library.best, names) if file is not None]
    missing = [MODELS[name].title for name in names if library.best(name) is None]
    others = library.stand_ins(len(missing), files)
    if missing:
        instead = (
            f"taken in their place: {listed([file.name for file in others])}" if others else "nothing replaces them"
        )
        library.notes.append(f"{figure}: not among the meshes: {listed(missing)}; {instead}.")
    return files + others


def _from_all_starts(
    session: Session, file: MeshFile, options: list[str], optimizer: str, records: list
) -> dict[str, Run]:
    runs = {}
    for start in STARTS:
        paper = options[:1] == ["--paper"]
        arguments = [*options[:1], "--initial", start, *options[1:]] if paper else ["--initial", start, *options]
        runs[start] = session.program.run(file, arguments, "Figure 3")
        records.append(record(runs[start], optimizer=optimizer, start=start))
    return runs


def _tell_spread(session: Session, by_mesh: dict[MeshFile, dict[str, Run]], optimizer: str) -> None:
    table, same, different, undecided = [], [], [], []
    for file, runs in by_mesh.items():
        usable = [run for run in runs.values() if run.exit_status == CERTIFIED]
        for start, run in runs.items():
            table.append(shown(run, start=start))
        if len(usable) < 2:
            undecided.append(file.name)
            continue
        spread = [
            max(run.row[f"isometric_{key}"] for run in usable) / min(run.row[f"isometric_{key}"] for run in usable)
            - 1.0
            for key in ("average", "maximum")
        ]
        table.append(
            {
                "mesh": f"**{file.name}**",
                "start": "**spread**",
                "isometric": f"**{percent(spread[1])} / {percent(spread[0])}**",
            }
        )
        is_same = spread[0] <= MOST_OF_AVERAGE and spread[1] <= MOST_OF_MAXIMUM
        text = f"{file.name} ({percent(spread[0])} in the average, {percent(spread[1])} in the maximum)"
        (same if is_same else different).append(text)
    columns = [MESH, Column("Start", "start", is_number=False), ISOMETRIC, SWEEPS, STOP, SECONDS]
    session.report.table(columns, table)
    text = f"With {optimizer}, the starts lead to the same result on {len(same)} of {len(by_mesh)} meshes. "
    text += f"Exceptions: {'; '.join(different)}. " if different else "There is no exception. "
    text += f"Too few starts to tell: {listed(undecided)}." if undecided else ""
    session.report.paragraph(text.strip())
    session.report.items(failures([run for runs in by_mesh.values() for run in runs.values()]))


def figure_4(session: Session) -> None:
    library = session.library
    first, second = library.copy("bimba", AS_FOUND), library.copy("bimba", SAME_COUNT)
    if first is None or second is None:
        first = library.one("bimba", "Figure 4")
        if first is not None:
            second = library.derive(
                f"{first.name}_split", "every face split into four", meshes.refine_everywhere(first.mesh)
            )
            library.notes.append(
                f"Figure 4: {second.name} is made by this driver, every face of {first.name} split into four."
            )
    session.report.begin_section("Figure 4: one shape, two tessellations")
    if first is None or second is None:
        return
    session.report.paragraph(
        f"The paper: the distortion of Bimba as found and of the remeshed one differ little. Here {first.name} and "
        f"{second.name}, which differ in the number of vertices and in their regularity."
    )
    _compare_tessellations(session, "4", [(first, "unchanged"), (second, second.origin or "remeshed")], has_edges=False)


def figure_5(session: Session) -> None:
    library = session.library
    session.report.begin_section("Figure 5: faces of varying size and stretched faces")
    first = library.one("fandisk", "Figure 5")
    if first is None:
        return
    graded = library.derive(f"{first.name}_graded", "one half split twice", meshes.refine_one_side(first.mesh, 2))
    stretched = library.derive(
        f"{first.name}_stretched", "split twice along", meshes.refine_along_one_axis(first.mesh, 2)
    )
    variants = [(first, "unchanged"), (graded, graded.origin), (stretched, stretched.origin)]
    coarse = library.copy("fandisk", SAME_COUNT)
    if coarse is not None and coarse is not first:
        variants.insert(1, (coarse, "simplified"))
    session.report.paragraph(
        "The paper remeshes Fandisk with faces of different sizes, and finds the result insensitive to that. Here: the"
        f" mesh itself{', a simplified one with needles' if len(variants) > 3 else ''}, and two that this driver"
        " makes without changing the shape: all edges in one half of it halved twice (faces of very different size),"
        " and only the edges along the longest axis halved twice (stretched faces)."
    )
    _compare_tessellations(session, "5", variants, has_edges=True)


def _compare_tessellations(
    session: Session, figure: str, variants: list[tuple[MeshFile, str]], has_edges: bool
) -> None:
    report = session.report
    table, records, runs = [], [], []
    modes = {"BLD, paper mode": session.paper(), "default of the package": DEFAULT}
    by_mode: dict[str, list[Run]] = {}
    for mode, options in modes.items():
        by_mode[mode] = [session.program.run(file, options, f"Figure {figure}") for file, _ in variants]
        averages: list[float | None] = []
        for (file, what), run in zip(variants, by_mode[mode]):
            runs.append(run)
            weighted = run.map.area_weighted_average() if run.has_map else None
            averages.append(weighted)
            table.append(shown(run, mode=mode, what=what, weighted=number(weighted)))
            records.append(record(run, mode=mode, tessellation=what, isometric_average_weighted_by_area=weighted))
        texts = []
        reference = by_mode[mode][0]
        for (_, what), run, average in list(zip(variants, by_mode[mode], averages))[1:]:
            if reference.has_map and run.has_map:
                key = "isometric_maximum"
                change = [100 * (x / y - 1) for x, y in ((run.row[key], reference.row[key]), (average, averages[0]))]
                texts.append(f"{what}: {change[0]:+.1f} % in the maximum, {change[1]:+.1f} % in the average by area")
        if texts:
            report.paragraph(f"{mode}, against the unchanged mesh: {'; '.join(texts)}.")
    cells = [[cell(by_mode[mode][i]) for mode in modes] for i in range(len(variants))]
    row_titles = [what for _, what in variants]
    picture = Picture(f"figure{figure}.png", list(modes), row_titles, cells, "D_iso", 3.0, has_edges)
    session.draw(picture, f"Figure {figure}: in brackets D_iso max, D_iso avg and folded faces.")
    columns = [MESH, Column("Tessellation", "what", is_number=False), SIZE, Column("Method", "mode", is_number=False)]
    weighted_column = Column("D_iso avg by area", "weighted")
    report.table([*columns, ISOMETRIC, weighted_column, FOLDED, SWEEPS, SECONDS], table)
    report.paragraph(
        "The averages of eq. 12 are over faces, so they lean to where the faces are small; the one by area does not."
    )
    report.csv(f"figure{figure}.csv", records)
    report.items(failures(runs))
