"""The default stage by stage: absolute times, growth with the size, threads, and memory, all from the same runs."""

from __future__ import annotations

from measuring.mesh_files import MeshFile
from measuring.plots import Axes, Curve
from measuring.report import Column, listed, number

from .benchmark_program import Job
from .session import (
    LARGE,
    LEAST_VERTICES,
    LEAST_VERTICES_OF_THREADS,
    MESH,
    VERTICES,
    Session,
    geometric_mean,
    span,
    speed,
)

STAGES = ("reading", "hierarchy", "embedding", "optimization", "certificate")
TOTAL = "mesh to map"

Result = tuple[MeshFile, dict]  # a mesh, and its medians


def absolute(session: Session) -> None:
    session.report.begin_section("Seconds")
    session.report.paragraph(
        f"Medians of {session.repetitions} runs, each in a process of its own, with {session.threads} threads. The"
        " total is from the mesh in memory to the certified map, without parsing the file."
    )
    results = _results(session, session.threads)
    named = [MESH, VERTICES, *(Column(stage.capitalize(), stage) for stage in STAGES), Column("Total, s", TOTAL)]
    columns = [*named, Column("Parsing", "parsing"), Column("Sweeps", "sweeps"), Column("D_iso max / avg", "d")]
    rows = [
        {
            **_head(file),
            **{stage: f"{values[stage]:.3f}" for stage in (*STAGES, TOTAL, "parsing")},
            "sweeps": f"{values['sweeps']:.0f}",
            "d": f"{number(values['D_iso max'])} / {number(values['D_iso avg'])}",
        }
        for file, values in results
    ]
    session.tabulate("absolute", columns, rows)
    records = [
        {"threads": threads, **values} for threads in session.thread_counts for _, values in _results(session, threads)
    ]
    session.report.csv("stages.csv", records)
    session.report.items(session.failures(_jobs(session, session.measured_meshes)))


def growth(session: Session) -> None:
    report = session.report
    report.begin_section("Growth")
    results = _results(session, session.threads)
    series = _results(session, session.threads, session.series)
    if len(results) < 2 or len(series) < 2:
        session.tell("growth", "There are too few meshes.")
        return
    series_of = {threads: _results(session, threads, session.series) for threads in session.thread_counts}
    session.tell("growth", _growth_verdict(results, series_of))
    columns = [MESH, VERTICES, Column("Threads", "threads"), *(Column(stage.capitalize(), stage) for stage in STAGES)]
    columns += [Column("Total, µs a vertex", TOTAL), Column("Sweeps", "sweeps"), Column("Total, s", "seconds")]
    rows = [
        {
            **_head(file),
            "threads": threads,
            **{stage: number(_microseconds(file, values, stage), 2) for stage in (*STAGES, TOTAL)},
            "sweeps": f"{values['sweeps']:.0f}",
            "seconds": number(values[TOTAL], 2),
        }
        for threads, of_threads in series_of.items()
        for file, values in of_threads
    ]
    session.tabulate("growth", columns, rows)

    def per_vertex(of: list[Result], stage: str, name: str, is_connected: bool = True) -> Curve:
        x = [file.number_of_vertices for file, _ in of]
        return Curve(name, x, [_microseconds(file, values, stage) for file, values in of], is_connected)

    all_curves = []
    for threads in session.thread_counts:
        words = _words(threads)
        all_curves.append(per_vertex(_results(session, threads), TOTAL, words, is_connected=False))
        all_curves.append(per_vertex(series_of[threads], TOTAL, f"{words}, one shape"))
    x_label, y_label = "vertices", "microseconds a vertex"
    left = Axes("All meshes, mesh to map", x_label, y_label, all_curves, is_x_log=True, starts_at_zero=True)
    curves = [per_vertex(series, stage, stage) for stage in STAGES]
    right = Axes("One shape, stage by stage", x_label, y_label, curves, is_x_log=True, starts_at_zero=True)
    session.draw("performance_growth.png", [left, right], "Microseconds a vertex against the number of vertices.")


def threads(session: Session) -> None:
    report = session.report
    report.begin_section("Threads")
    if len(session.thread_counts) < 2:
        session.tell("threads", "There is one thread only.")
        return
    least = _least_vertices(session)
    alone, together = (dict(_results(session, n)) for n in session.thread_counts)
    both = [file for file in alone if file in together]
    different = [file.name for file in both if not _has_same_bits(alone[file], together[file])]
    files = [file for file in both if file.number_of_vertices >= least]
    if not files:
        session.tell("threads", f"There is no mesh of at least {least:,} vertices.")
        return

    def gain(file: MeshFile, stage: str) -> float:
        jobs = [_job(session, file, n) for n in session.thread_counts]
        return session.median_ratio(*jobs, stage)

    def ceiling(file: MeshFile) -> float:
        return session.threads * session.median_ratio(_job(session, file, 1), _job_at_once(session, file), TOTAL)

    totals = [gain(file, TOTAL) for file in files]
    text = (
        f"With {session.threads} threads, meshes of {least:,} vertices and more are mapped {span(totals)} times as fast"
        f" as with one, {speed(geometric_mean(totals))} times in the geometric mean: medians of the ratios of runs"
        " of the same round. "
    )
    with_ceiling = [file for file in files if _has_ceiling(session, file)]
    if with_ceiling:
        ceilings = [ceiling(file) for file in with_ceiling]
        shares = [gain(file, TOTAL) / most for file, most in zip(with_ceiling, ceilings, strict=True)]
        text += (
            f"Below {LARGE:,} vertices, {session.threads} processes with one thread each that map the same mesh at the"
            f" same time get {span(ceilings)} times as much done as one, {speed(geometric_mean(ceilings))} times in the"
            " geometric mean (column `At once`). They share the caches and the memory but never wait for each other;"
            f" the threads of one map get {100.0 * geometric_mean(shares):.0f} % of that on the same meshes. "
        )
    text += f"The maps of {listed(different)} differ." if different else f"All {len(both)} maps have the same bits."
    session.tell("threads", text)
    columns = [MESH, VERTICES, *(Column(stage.capitalize(), stage) for stage in STAGES)]
    columns += [
        Column("Mesh to map", TOTAL),
        *([Column("At once", "ceiling")] if with_ceiling else []),
        Column("1 thread, s", "alone"),
        Column(f"{session.threads}, s", "together"),
    ]
    rows = [
        {
            **_head(file),
            **{stage: speed(gain(file, stage)) for stage in (*STAGES, TOTAL)},
            "ceiling": speed(ceiling(file)) if file in with_ceiling else None,
            "alone": number(alone[file][TOTAL]),
            "together": number(together[file][TOTAL]),
        }
        for file in files
    ]
    session.tabulate("threads", columns, rows)
    x = [file.number_of_vertices for file in both]
    curves = [
        Curve(stage, x, [gain(file, stage) for file in both], is_connected=False)
        for stage in ("hierarchy", "embedding", "optimization", TOTAL)
    ]
    if with_ceiling:
        x = [file.number_of_vertices for file in with_ceiling]
        curves.append(Curve(f"{session.threads} processes at once", x, ceilings, is_connected=False))
    y_label = "times as much done as by one thread"
    axes = Axes("Threads", "vertices", y_label, curves, is_x_log=True, starts_at_zero=True)
    session.draw("performance_threads.png", [axes], f"How many times as much {session.threads} threads do as one.")


def memory(session: Session) -> None:
    report = session.report
    report.begin_section("Memory")
    results = [
        (file, values)
        for file, values in _results(session, session.threads)
        if isinstance(values["bytes/vertex"], float)
    ]
    if not results:
        session.tell("memory", "This system does not tell.")
        return
    alone = dict(_results(session, 1))
    peaks = [(values["bytes/vertex"], file) for file, values in (*results, *alone.items())]
    (least, _), (most, worst) = (choose(peaks, key=lambda peak: peak[0]) for choose in (min, max))
    text = (
        f"At its peak, the default needs {least:.0f} to {most:.0f} bytes a vertex ({worst.name}) beside the caller's mesh;"
        f" on the largest mesh, {results[-1][0].name}, {results[-1][1]['bytes/vertex']:.0f}."
    )
    session.tell("memory", text)
    columns = [MESH, VERTICES, Column(f"Bytes a vertex, {session.threads} threads", "bytes")]
    columns += [Column("Bytes a vertex, 1 thread", "alone"), Column("MB in all", "megabytes")]
    rows = [
        {
            **_head(file),
            "bytes": f"{values['bytes/vertex']:.0f}",
            "alone": f"{alone[file]['bytes/vertex']:.0f}" if file in alone else None,
            "megabytes": number(1e-6 * values["bytes/vertex"] * file.number_of_vertices, 1),
        }
        for file, values in results
    ]
    session.tabulate("memory", columns, rows)


def _job(session: Session, mesh: MeshFile, number_of_threads: int) -> Job:
    arguments = ("--repeat", "1", *session.stages.threads(number_of_threads))
    return Job(session.stages, mesh, arguments, session.repetitions_of(mesh))


def _least_vertices(session: Session) -> int:
    """Of the meshes on which threads are judged."""
    return LEAST_VERTICES if session.is_short else LEAST_VERTICES_OF_THREADS


def _job_at_once(session: Session, mesh: MeshFile) -> Job:
    """As many maps at the same time as there are threads, each made by one."""
    arguments = ("--repeat", "1", *session.stages.threads(1))
    return Job(session.stages, mesh, arguments, session.repetitions_of(mesh), copies=session.threads)


def _is_for_ceiling(session: Session, mesh: MeshFile) -> bool:
    return len(session.thread_counts) > 1 and _least_vertices(session) <= mesh.number_of_vertices < LARGE


def _has_ceiling(session: Session, mesh: MeshFile) -> bool:
    return _is_for_ceiling(session, mesh) and session.medians(_job_at_once(session, mesh)) is not None


def _jobs(session: Session, meshes: list[MeshFile]) -> list[Job]:
    jobs = []
    for mesh in meshes:
        jobs += [_job(session, mesh, n) for n in session.thread_counts]
        if _is_for_ceiling(session, mesh):
            jobs.append(_job_at_once(session, mesh))
    return jobs


def _results(session: Session, number_of_threads: int, meshes: list[MeshFile] | None = None) -> list[Result]:
    """The medians of those meshes that could be measured, by default of all."""
    session.measure(_jobs(session, session.measured_meshes))
    meshes = session.measured_meshes if meshes is None else meshes
    number_of_threads = min(number_of_threads, session.thread_counts[-1])
    results = [(file, session.medians(_job(session, file, number_of_threads))) for file in meshes]
    return [(file, values) for file, values in results if values is not None]


def _words(number_of_threads: int) -> str:
    return "1 thread" if number_of_threads == 1 else f"{number_of_threads} threads"


def _head(file: MeshFile) -> dict:
    return {"mesh": file.name, "vertices": f"{file.number_of_vertices:,}"}


def _microseconds(file: MeshFile, values: dict, stage: str) -> float:
    return 1e6 * values[stage] / file.number_of_vertices


def _has_same_bits(first: dict, second: dict) -> bool:
    return first["fingerprint"] == second["fingerprint"] != "differs"


def _growth_verdict(results: list[Result], series_of: dict[int, list[Result]]) -> str:
    """What follows from all results with the most threads, and from those of one shape with any number of them."""

    def total(result: Result) -> float:
        return _microseconds(*result, TOTAL)

    def factor(of: list[Result]) -> float:
        totals = [total(result) for result in of]
        return max(totals) / min(totals)

    number_of_threads = max(series_of)
    series = series_of[number_of_threads]
    least, most = min(results, key=total), max(results, key=total)
    in_series = [total(result) for result in series]
    (first, _), (last, values) = series[0], series[-1]
    text = (
        f"With {_words(number_of_threads)}, all meshes from {results[0][0].number_of_vertices:,} to"
        f" {results[-1][0].number_of_vertices:,} vertices take {number(total(least), 1)} ({least[0].name}) to"
        f" {number(total(most), 1)} ({most[0].name}) microseconds a vertex, a factor of"
        f" {speed(total(most) / total(least))}. One shape, simplified and subdivided, from"
        f" {first.number_of_vertices:,} to {last.number_of_vertices:,} vertices, takes"
        f" {number(min(in_series), 1)} to {number(max(in_series), 1)}, a"
        f" factor of {speed(factor(series))}, and {number(values[TOTAL], 1)} seconds in the end"
    )
    if number_of_threads > 1 and len(series_of[1]) == len(series):
        text += f"; with 1 thread, the factor is {speed(factor(series_of[1]))}"
    text += "."
    return text + _verdict_of_families(results)


def _verdict_of_families(results: list[Result]) -> str:
    """How far the times a vertex of one shape differ that is there in sizes of a factor of ten and more.

    A shape is told by what its name has before the number of vertices.
    """
    families: dict[str, list[Result]] = {}
    for result in results:
        families.setdefault(result[0].name.rsplit("_", 1)[0], []).append(result)
    words = []
    for shape, members in families.items():
        sizes = [file.number_of_vertices for file, _ in members]
        if max(sizes) >= 10 * min(sizes):
            totals = [_microseconds(*member, TOTAL) for member in members]
            words.append(f"{shape}, {min(sizes):,} to {max(sizes):,} vertices, by {speed(max(totals) / min(totals))}")
    return f" Within one shape, they differ at most: {'; '.join(words)}." if words else ""
