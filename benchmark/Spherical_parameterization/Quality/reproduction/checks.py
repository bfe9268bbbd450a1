"""What a reader has to know to trust the rest: is paper mode a fair yardstick, do all methods keep their promises?"""

from __future__ import annotations

from measuring.program import CERTIFIED, FAILED, FOLDS, Run
from measuring.report import Column, listed, number, percent

from .session import FOLDED, ISOMETRIC, MESH, SECONDS, STOP, SWEEPS, Session, failures, record, shown

MOST_VERTICES_OF_LONG_RUN = 5000
LONG_SWEEPS = 20000
CLOSE = 0.05  # paper mode's maximum above that of the converged default
BIJECTIVE = {"bld": [], **{method: ["--method", method] for method in ("hierarchical", "stereographic", "harmonic")}}
WITHOUT_PROMISE = {method: ["--method", method] for method in ("conformal", "arap")}


def yardstick(session: Session) -> None:
    """Paper mode against the default after convergence, and the trap of the flat area where it falls behind."""
    report = session.report
    report.begin_section("Paper mode as the yardstick")
    report.paragraph(
        "Is paper mode at its best here? Its maximum is compared with that of the package's default after convergence."
        " A third run changes one thing in paper mode: the determinant takes the place of the flat area in the energy."
        " Three points on a great circle span a flat triangle of positive area, so the published energy lets a face lie"
        " across a great circle and stay there; the column *across* counts the faces whose plane comes closer to the"
        " centre than a tenth of the radius."
    )
    sweeps = ["--iterations", str(session.paper_sweeps)]
    with_determinant = [
        "--initial",
        "harmonic",
        "--energy",
        "isometric",
        "--update",
        "gradient",
        "--barrier",
        "determinant",
    ]
    with_determinant += ["--s-first", "0.1", "--s-last", "10", "--average-sweeps", "100", *sweeps]
    variants = {
        "paper mode": session.paper(),
        "the same, determinant barrier": with_determinant,
        "default, converged": ["--iterations", "5000"],
    }
    table, records, runs = [], [], []
    for name in ("cow",) if session.is_short else ("bunny", "fandisk", "armadillo"):
        file = session.library.one(name, "Yardstick")
        if file is None:
            continue
        of_file = {variant: session.program.run(file, options, "Yardstick") for variant, options in variants.items()}
        if file.number_of_vertices <= MOST_VERTICES_OF_LONG_RUN and "limit" in of_file["paper mode"].stop_reason:
            options = [*session.paper(), "--iterations", str(LONG_SWEEPS)]
            of_file["paper mode, more sweeps"] = session.program.run(file, options, "Yardstick")
        runs += of_file.values()
        for variant, run in of_file.items():
            across = run.map.number_across() if run.has_map else None
            table.append(shown(run, variant=variant, across=across))
            records.append(record(run, variant=variant, faces_across=across))
        report.paragraph(_judged(file.name, *list(of_file.values())[:3], of_file.get("paper mode, more sweeps")))
        session.forget_maps()
    columns = [
        MESH,
        Column("Variant", "variant", is_number=False),
        ISOMETRIC,
        FOLDED,
        Column("Across", "across"),
        SWEEPS,
    ]
    if table:
        report.table([*columns, STOP, SECONDS], table)
        report.csv("yardstick.csv", records)
    report.items(failures(runs))


def _judged(name: str, paper: Run, determinant: Run, default: Run, longer: Run | None) -> str:
    if not paper.has_map or not default.has_map:
        return f"{name}: there is nothing to compare."
    maximum, bound = paper.row["isometric_maximum"], default.row["isometric_maximum"]
    excess = maximum / bound - 1.0
    text = f"{name}: paper mode's maximum is {number(maximum)}, the converged default's {number(bound)}"
    if excess <= CLOSE:
        return f"{text}: within {percent(CLOSE)}."
    text += f", {percent(excess)} more."
    if paper.map.number_across() > 0:
        text += f" {paper.map.number_across()} of its faces lie across a great circle"
        if determinant.has_map:
            other = determinant.row["isometric_maximum"]
            text += f"; with the determinant it is {number(other)}, with {determinant.map.number_across()} such faces"
        text += "."
    elif determinant.has_map:
        text += (
            " No face lies across a great circle; with the determinant it is"
            f" {number(determinant.row['isometric_maximum'])}."
        )
    if "limit" in paper.stop_reason:
        text += f" It ended at its limit of {paper.sweeps} sweeps, before its stopping rule held."
    if longer is not None and longer.has_map:
        text += (
            f" With as many sweeps as it takes ({longer.sweeps}, {longer.stop_reason}) its maximum is"
            f" {number(longer.row['isometric_maximum'])}."
        )
    return text


def certificates(session: Session) -> None:
    """Runs every method on every mesh of the folder; compares what the program says with the folds that are there."""
    report = session.report
    report.begin_section("Every method on every mesh")
    report.paragraph(
        "The exit status of the program on all meshes of the folder, against this driver's own exact count of folded"
        " faces. ✓: a certified bijection, and no face is folded; n folds: the method says that its map is not"
        " one-to-one, and n faces are folded; –: no map, for the reason given below."
    )
    if session.is_short:
        files = session.library.stand_ins(6, [])
    else:
        files = session.library.files
    methods = BIJECTIVE | WITHOUT_PROMISE
    table, records, runs = [], [], []
    counts = {method: 0 for method in methods}
    for file in files:
        row: dict = {"mesh": file.name}
        for method, options in methods.items():
            run = session.program.run(file, options, "Every method on every mesh")
            runs.append(run)
            records.append(record(run, method=method))
            row[method] = _told(run)
            counts[method] += run.exit_status == CERTIFIED
        table.append(row)
        session.forget_maps()
    summary = [f"{method} {count} of {len(files)}" for method, count in counts.items()]
    report.paragraph(f"Certified: {listed(summary)}.")
    if table:
        report.table([MESH, *(Column(method, method) for method in methods)], table)
        report.csv("certificates.csv", records)
    report.items(failures([run for run in runs if run.exit_status != FOLDS]))


def contradictions(runs: list[Run]) -> list[str]:
    """Runs in which the program said one thing and its map another."""
    lines = []
    for run in runs:
        name = f"{run.mesh.name}, `{run.command}`"
        folded = run.row.get("folded_faces")
        if run.exit_status == CERTIFIED and folded:
            lines.append(f"{name}: exit status 0, but {folded} faces are folded")
        if run.exit_status != FAILED and not run.has_map:
            lines.append(f"{name}: {run.message}")
        one_to_one = run.report.get("one_to_one")
        if one_to_one is not None and one_to_one != (run.exit_status == CERTIFIED):
            lines.append(f"{name}: exit status {run.exit_status}, but the report says one_to_one: {one_to_one}")
    return lines


def _told(run: Run) -> str:
    if run.exit_status == CERTIFIED:
        return "✓" if not run.row["folded_faces"] else f"✗ {run.row['folded_faces']:,} folded"
    return "–" if run.exit_status == FAILED or not run.has_map else f"{run.row['folded_faces']:,} folds"
