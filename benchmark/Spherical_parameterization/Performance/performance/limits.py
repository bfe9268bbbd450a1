"""A sweep against what the machine would need at least for its bytes and its operations."""

from __future__ import annotations

from measuring.mesh_files import MeshFile
from measuring.plots import Axes, Curve
from measuring.report import Column, number

from .benchmark_program import Job
from .session import MESH, VERTICES, Session, span, speed

SECTION = "limits"
SWEEP, FOR_BYTES, FOR_OPERATIONS = "sweep ns/vertex", "ns for bytes", "ns for operations"
RATES = ("GB/s", "G sums and products/s", "G divisions/s", "G roots/s", "G exponentials/s")
MOST_REPETITIONS = 3
MESHES = ("bunny_3485", "fandisk_6475", "hand_10345", "bunny_20002", "hand_42068")  # besides the series

COLUMNS = [
    MESH,
    VERTICES,
    Column("Threads", "threads"),
    Column("Sweep, ns a vertex", "sweep"),
    Column("Bytes, ns", "bytes"),
    Column("Operations, ns", "operations"),
    Column("Sweep / bytes", "to_bytes"),
    Column("Sweep / operations", "to_operations"),
    Column("GB/s", "bandwidth"),
]


def limits(session: Session) -> None:
    report = session.report
    report.begin_section("The floor of a sweep")
    jobs = [_job(session, file) for file in _meshes(session)]
    session.measure(jobs)
    measured = [job for job in jobs if _values(session, job, 0) is not None]
    report.items(session.failures(jobs))
    if not measured:
        session.tell(SECTION, "None of the meshes could be measured.")
        return
    number_of_rows = len(measured[0].program.measure(measured[0], 0).rows)
    by_threads = [[(job.mesh, _values(session, job, row)) for job in measured] for row in range(number_of_rows)]
    session.tell(SECTION, _work(by_threads[0]))
    session.tell(SECTION, _verdict(by_threads))
    rows = [_shown(*result) for results in by_threads for result in results]
    session.tabulate(SECTION, COLUMNS, rows)
    report.csv("limits.csv", [values for results in by_threads for _, values in results])
    diagrams = []
    for results in by_threads:
        x = [file.number_of_vertices for file, _ in results]
        names = {SWEEP: "sweep", FOR_OPERATIONS: "operations alone", FOR_BYTES: "bytes alone"}
        curves = [Curve(name, x, [values[key] for _, values in results]) for key, name in names.items()]
        title = _threads(results[0][1])
        diagrams.append(Axes(title, "vertices", "nanoseconds a vertex", curves, is_log=True, is_x_log=True))
    caption = "A sweep, and the least time for its operations and for its bytes."
    session.draw("performance_limits.png", diagrams, caption)


def _meshes(session: Session) -> list[MeshFile]:
    files = [file for file in map(session.one, MESHES) if file is not None]
    if session.is_short or not files:
        files = session.corpus[:1]
    by_path = {file.path: file for file in files + session.series}
    return sorted(by_path.values(), key=lambda file: file.number_of_vertices)


def _job(session: Session, file: MeshFile) -> Job:
    repetitions = min(session.repetitions, MOST_REPETITIONS)
    return Job(session.limits, file, session.limits.threads(session.threads), repetitions)


def _values(session: Session, job: Job, row: int) -> dict | None:
    """The median of the sweep, and what the machine does at best: a floor is what nothing has disturbed."""
    values = session.medians(job, row)
    if values is not None:
        rows = session.rows(job, row)
        values |= {key: min(of_run[key] for of_run in rows) for key in (FOR_BYTES, FOR_OPERATIONS)}
        values |= {key: max(of_run[key] for of_run in rows) for key in RATES}
        values["sweep/bytes"] = values[SWEEP] / values[FOR_BYTES]
        values["sweep/operations"] = values[SWEEP] / values[FOR_OPERATIONS]
    return values


def _threads(values: dict) -> str:
    return "1 thread" if values["threads"] == 1 else f"{values['threads']:.0f} threads"


def _shown(file: MeshFile, values: dict) -> dict:
    return {
        "mesh": file.name,
        "vertices": f"{file.number_of_vertices:,}",
        "threads": f"{values['threads']:.0f}",
        "sweep": number(values[SWEEP], 0),
        "bytes": number(values[FOR_BYTES], 1),
        "operations": number(values[FOR_OPERATIONS], 0),
        "to_bytes": speed(values["sweep/bytes"]),
        "to_operations": speed(values["sweep/operations"]),
        "bandwidth": number(values["GB/s"], 1),
    }


def _work(results: list[tuple[MeshFile, dict]]) -> str:
    file, values = results[-1]
    return (
        f"Per vertex of {file.name}, a sweep has to read or write {values['bytes/vertex']:.0f} bytes and to do"
        f" {values['sums and products/vertex']:.0f} additions and multiplications, {values['divisions/vertex']:.1f}"
        f" divisions, {values['roots/vertex']:.1f} square roots and {values['exponentials/vertex']:.1f} exponentials,"
        f" for {values['derivatives/vertex']:.2f} evaluations of the star with its derivatives and"
        f" {values['values/vertex']:.2f} without. One thread of this machine does"
        f" {_rate(values['G sums and products/s'])} billion of the first a second, {_rate(values['G divisions/s'])} of"
        f" the second, {_rate(values['G roots/s'])} of the third and {_rate(values['G exponentials/s'])} of the last,"
        f" and reads or writes {values['GB/s']:.1f} GB a second in arrays of that size."
    )


def _rate(x: float) -> str:
    return f"{x:.2f}" if x < 10 else f"{x:.0f}"


def _verdict(by_threads: list[list[tuple[MeshFile, dict]]]) -> str:
    texts = []
    for results in by_threads:
        to_operations = [values["sweep/operations"] for _, values in results]
        to_bytes = [values["sweep/bytes"] for _, values in results]
        (first, small), (last, large) = results[0], results[-1]
        texts.append(
            f"With {_threads(large)}, a sweep takes {span(to_operations)} times the time for its operations and"
            f" {span(to_bytes)} times that for its bytes; it takes {small[SWEEP]:.0f} nanoseconds a vertex on"
            f" {first.name} and {large[SWEEP]:.0f} on {last.name}, while the bytes alone would take"
            f" {small[FOR_BYTES]:.1f} and {large[FOR_BYTES]:.1f}."
        )
    return " ".join(texts)
