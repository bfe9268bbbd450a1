"""What more or less time buys: D_iso against the number of sweeps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measuring.mesh_files import MeshFile
from measuring.plots import Axes, Curve
from measuring.report import Column, percent

from .benchmark_program import Job
from .session import Session, geometric_mean

SECTION = "trade"
SWEEPS = (0, 6, 12, 25, 50, 100, 200, 400, 800, 1600)
SHORT_SWEEPS = (0, 25, 50)
TIMES = (0.25, 0.5, 1.0, 2.0, 4.0)  # in units of the default's
NOISE = 0.03  # times that differ by no more are the same
MOST_REPETITIONS = 3
MOST_VERTICES = 60_000
MAXIMUM, AVERAGE, SECONDS = "D_iso max", "D_iso avg", "mesh to map"


@dataclass(frozen=True)
class Point:
    """A setting, in geometric means over the meshes."""

    name: str
    sweeps: float  # that were made
    time: float  # in units of the default's
    maximum: float  # in units of the lowest of the same mesh
    average: float


def trade(session: Session) -> None:
    report = session.report
    report.begin_section("Time against distortion")
    files = [file for file in session.corpus if file.number_of_vertices <= MOST_VERTICES]
    settings: list[int | None] = [*(SHORT_SWEEPS if session.is_short else SWEEPS), None]
    jobs = {(file, sweeps): _job(session, file, sweeps) for file in files for sweeps in settings}
    session.measure(list(jobs.values()))
    medians = {key: session.medians(job) for key, job in jobs.items()}
    files = [file for file in files if all(medians[file, sweeps] is not None for sweeps in settings)]
    report.items(session.failures(list(jobs.values())))
    if not files:
        session.tell(SECTION, "There is no mesh of a suitable size.")
        return
    points = sorted((_point(medians, files, settings, sweeps) for sweeps in settings), key=lambda point: point.sweeps)
    default = next(point for point in points if point.name == "default")
    report.paragraph(
        f"Each of {len(files)} meshes is mapped with at most so many sweeps over the finest mesh; the hierarchy and the"
        " sweeps over its levels are the same for all. The default may make 90 and ends when it has converged. Times"
        " are in units of the default's, distortions in units of the lowest that any setting reached on the same mesh;"
        " their means are geometric, those of the sweeps arithmetic."
    )
    columns = [Column("Sweeps at most", "name"), Column("Sweeps made", "sweeps"), Column("Time", "time")]
    columns += [Column("D_iso max", "maximum"), Column("D_iso avg", "average")]
    session.tabulate(SECTION, columns, [_shown(point, point.name) for point in points])
    session.tell(SECTION, _verdict(default, points, len(files)))
    columns = [Column("Time allowed", "name"), columns[1], Column("Time taken", "time"), *columns[3:]]
    session.tabulate(SECTION, columns, [_shown(_at(points, time), f"{time:g}") for time in TIMES])
    records = [
        {"sweeps at most": "default" if sweeps is None else sweeps, **medians[file, sweeps]}
        for file in files
        for sweeps in settings
    ]
    report.csv("trade.csv", records)
    diagrams = []
    for name, key in ((MAXIMUM, "maximum"), (AVERAGE, "average")):
        of_curve = [point for point in points if point.sweeps > 0]  # the first map is far off
        curve = Curve(f"{len(files)} meshes", [p.time for p in of_curve], [getattr(p, key) for p in of_curve])
        mark = (1.0, "default")
        diagrams.append(Axes(name, "time, 1 = default", "1 = lowest", [curve], is_x_log=True, ticks=TIMES, marked=mark))
    session.draw("performance_trade.png", diagrams, f"D_iso against time, geometric means over {len(files)} meshes.")


def _job(session: Session, file: MeshFile, sweeps: int | None) -> Job:
    arguments = ["--repeat", "1", *session.stages.threads(session.threads)]
    if sweeps is not None:
        arguments += ["--iterations", str(sweeps)]
    return Job(session.stages, file, tuple(arguments), min(session.repetitions, MOST_REPETITIONS), SECTION)


def _point(medians: dict, files: list[MeshFile], settings: list[int | None], sweeps: int | None) -> Point:
    def mean_to_lowest(key: str) -> float:
        return geometric_mean([medians[f, sweeps][key] / min(medians[f, s][key] for s in settings) for f in files])

    time = geometric_mean([medians[f, sweeps][SECONDS] / medians[f, None][SECONDS] for f in files])
    made = sum(medians[f, sweeps]["sweeps"] for f in files) / len(files)
    name = "default" if sweeps is None else str(sweeps)
    return Point(name, made, time, mean_to_lowest(MAXIMUM), mean_to_lowest(AVERAGE))


def _at(points: list[Point], time: float) -> Point | None:
    """What that much time buys: between the settings, by the logarithm of the time; beyond, the last one, which takes
    less. None if it is too little for any.
    """
    times = np.maximum.accumulate([point.time for point in points])  # more sweeps take no less but for noise
    if time < (1.0 - NOISE) * times[0]:
        return None
    time = float(np.clip(time, times[0], times[-1]))

    def between(values: list[float]) -> float:
        return float(np.interp(np.log(time), np.log(times), values))

    return Point(
        "",
        between([point.sweeps for point in points]),
        time,
        between([point.maximum for point in points]),
        between([point.average for point in points]),
    )


def _shown(point: Point | None, name: str) -> dict:
    if point is None:
        return {"name": name, "sweeps": "–", "time": "no map", "maximum": "–", "average": "–"}
    return {
        "name": name,
        "sweeps": f"{point.sweeps:.0f}",
        "time": f"{point.time:.2f}",
        "maximum": f"{point.maximum:.4f}",
        "average": f"{point.average:.4f}",
    }


def _verdict(default: Point, points: list[Point], n_meshes: int) -> str:
    texts = []
    for time in TIMES:
        point = _at(points, time)
        if point is not None and time != 1.0 and abs(point.time / time - 1.0) <= NOISE:
            texts.append(
                f"with {time:g} times its time, the maximum is {_change(point.maximum / default.maximum)} and the"
                f" average {_change(point.average / default.average)}"
            )
    first, last = points[0], points[-1]
    reach = (
        f"On the {n_meshes} meshes of up to {MOST_VERTICES:,} vertices, the limits lead from {first.time:.2f} to"
        f" {last.time:.2f} times the default's time, and to {last.sweeps:.0f} sweeps on average until they have converged"
        " or are ended."
    )
    return reach + (f" Against the default: {'; '.join(texts)}." if texts else "")


def _change(ratio: float) -> str:
    if abs(ratio - 1.0) < 0.0005:
        return "the same"
    return f"{percent(abs(ratio - 1.0))} {'higher' if ratio > 1.0 else 'lower'}"
