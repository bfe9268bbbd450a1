"""The sections of the report on performance; each of them fills in a part of the page of the manual."""

from __future__ import annotations

import statistics
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from measuring.commands import run_command
from measuring.meshes import MeshFile, subdivide_smoothly, write_mesh
from measuring.reports import Curve, Diagram, Report, draw, factor, geometric_mean, listed, number, percent, seconds
from measuring.reports import span, table
from measuring.runs import STAGES
from timings import TOTAL, Job, Kernels, Timings

MIN_VERTICES = 2500  # smaller meshes say little about speed
MIN_VERTICES_OF_THREADS = 20_000
LARGE = 300_000  # larger meshes, which take seconds, are measured less often
MAX_REPETITIONS_OF_LONG = 3  # of runs that take long

# The rows that the page of the manual has; the report has all of them.
MESHES_OF_MANUAL = (
    "triceratops_2832",
    "cow_2904",
    "bunny_3485",
    "hand_10345",
    "blob5_12929",
    "octopus_16554",
    "horse_19851",
    "armadillo_26002",
    "bimba_45k",
    "camel_156k",
    "armadillo_1664002",
)
FEW_MESHES_OF_MANUAL = ("bunny_3485", "armadillo_26002", "armadillo_1664002")
SWEEPS_OF_MANUAL = ("0", "6", "25", "100", "default", "1600")

SHORT_SWEEPS_OF_PAPER = 150  # 100 of eq. 6, and some of eq. 7
EQUAL = 0.0005  # a value that is larger by less, relatively, is not worse

MESHES_OF_LIMITS = ("bunny_3485", "fandisk_6475", "hand_10345", "bunny_20002", "hand_42068")  # besides the series
REPETITIONS_OF_LIMITS, REPETITIONS_OF_SHORT = 15, 2
RATES = ("machine_sums_and_products", "machine_divisions", "machine_square_roots", "machine_exponentials")

SWEEPS, SHORT_SWEEPS = (0, 6, 12, 25, 50, 100, 200, 400, 800, 1600), (0, 25, 50)
TIMES = (0.25, 0.5, 1.0, 2.0, 4.0)  # in units of the time of the default
NOISE = 0.03  # times that differ by less are the same
MAX_VERTICES_OF_TRADE = 60_000

MESH = {"mesh": "Mesh", "vertices": "Vertices"}
STAGE_COLUMNS = {stage: stage.capitalize() for stage in STAGES}

Result = tuple[MeshFile, dict]  # a mesh, and its medians


@dataclass
class Session:
    timings: Timings
    kernels: Kernels
    corpus: list[MeshFile]  # small ones first, at least one
    large: list[MeshFile]
    folder_for_derived: Path
    report: Report
    threads: int
    repetitions: int
    paper_meshes: list[str]
    is_short: bool
    notes: list[str] = field(default_factory=list)
    objections: list[str] = field(default_factory=list)  # to the measurements
    parts: dict[str, list[str]] = field(default_factory=dict)  # of the page of the manual
    figures: list[Path] = field(default_factory=list)
    _series: list[MeshFile] = field(default_factory=list)

    def one(self, name: str) -> MeshFile | None:
        return next((file for file in self.corpus + self.large if file.name == name), None)

    @property
    def series(self) -> list[MeshFile]:
        """One shape in several sizes: as it is, and subdivided."""
        if not self._series:
            first = self.corpus[0] if self.is_short else self.one("armadillo_26002") or self.corpus[-1]
            self._series, mesh = [first], first.mesh
            self.folder_for_derived.mkdir(parents=True, exist_ok=True)
            for _ in range(1 if self.is_short else 3):
                mesh = subdivide_smoothly(mesh)
                name = f"{first.name.rsplit('_', 1)[0]}_{len(mesh.vertices)}"
                path = self.folder_for_derived / f"{name}.off"
                if self.one(name) is None:
                    write_mesh(path, mesh)
                self._series.append(self.one(name) or MeshFile(path))
            first.forget()
        return self._series

    @property
    def measured_meshes(self) -> list[MeshFile]:
        """All meshes that are measured stage by stage."""
        files = {file.path: file for file in self.corpus + self.large + self.series}
        return sorted(files.values(), key=lambda file: (file.number_of_vertices, file.name))

    @property
    def thread_counts(self) -> list[int]:
        return [1, self.threads] if self.threads > 1 else [1]

    def job(self, mesh: MeshFile, threads: int, copies: int = 1) -> Job:
        is_large = mesh.number_of_vertices >= LARGE
        repetitions = min(self.repetitions, MAX_REPETITIONS_OF_LONG) if is_large else self.repetitions
        return Job(mesh, threads, repetitions=repetitions, copies=copies)

    def results(self, threads: int, meshes: list[MeshFile] | None = None) -> list[Result]:
        """The medians of those of the meshes, by default all, that could be measured."""
        jobs = []
        for mesh in self.measured_meshes:
            jobs += [self.job(mesh, n) for n in self.thread_counts]
            jobs += [self.job(mesh, 1, copies=self.threads)] if self.is_run_at_once(mesh) else []
        self.timings.measure(jobs)
        files = self.measured_meshes if meshes is None else meshes
        results = [(file, self.timings.medians(self.job(file, threads))) for file in files]
        return [(file, values) for file, values in results if values is not None]

    def is_run_at_once(self, mesh: MeshFile) -> bool:
        return self.threads > 1 and self.min_vertices_of_threads <= mesh.number_of_vertices < LARGE

    @property
    def min_vertices_of_threads(self) -> int:
        return 0 if self.is_short else MIN_VERTICES_OF_THREADS

    def add(self, section: str, text: str) -> None:
        """Adds a paragraph to the report and to the manual."""
        self.report.paragraph(text)
        self.parts.setdefault(section, []).append(text)

    def add_table(self, section: str, columns: dict, rows: list[dict], key: str = "", shown: tuple = ()) -> None:
        """Adds a table to the report; the manual gets the rows with one of the values `shown`, or all if there are none."""
        self.report.paragraph(table(columns, rows))
        of_manual = [row for row in rows if row.get(key) in shown] or rows
        self.parts.setdefault(section, []).append(table(columns, of_manual))

    def draw(self, name: str, diagrams: list[Diagram], caption: str, is_in_manual: bool = True) -> None:
        """Draws a figure for the report, and for the manual."""
        path = self.report.folder / name
        draw(path, diagrams)
        self.report.image(name, caption)
        if is_in_manual:
            self.figures.append(path)


def comparison(session: Session) -> None:
    session.report.begin_section(
        "Against the published algorithm",
        "Seconds from the mesh in memory to the certified map, as the program reports them: medians of alternating runs"
        " of the default and of the published algorithm (`--paper`).",
    )
    limit = ("--iterations", str(SHORT_SWEEPS_OF_PAPER)) if session.is_short else ()
    repetitions = min(session.repetitions, MAX_REPETITIONS_OF_LONG)
    jobs = []
    for file in filter(None, map(session.one, session.paper_meshes)):
        paper = Job(file, session.threads, ("--paper", *limit), repetitions, "comparison")
        jobs.append((Job(file, session.threads, (), session.repetitions, "comparison"), paper))
    session.timings.measure([job for pair in jobs for job in pair])
    pairs = [(default.mesh, *map(session.timings.medians, (default, paper))) for default, paper in jobs]
    pairs = [(file, default, paper) for file, default, paper in pairs if default and paper]
    if not pairs:
        session.add("comparison", "No mesh could be compared; `--paper-meshes` names others.")
        return
    ratios = [paper[TOTAL] / default[TOTAL] for _, default, paper in pairs]
    worse = {
        key: [
            f"{file.name} ({number(default[key])} against {number(paper[key])})"
            for file, default, paper in pairs
            if default[key] > (1.0 + EQUAL) * paper[key]
        ]
        for key in ("D_iso max", "D_iso avg")
    }
    where = {key: listed(files) if files else "no mesh" for key, files in worse.items()}
    session.add(
        "comparison",
        f"The default is {span(ratios)} times as fast as the published algorithm, {factor(geometric_mean(ratios))} times"
        f" in the geometric mean. Its maximum D_iso is larger on {where['D_iso max']}, its average on"
        f" {where['D_iso avg']}.",
    )
    columns = MESH | {"paper": "Published, s", "default": "Default, s", "ratio": "Ratio"}
    columns |= {"paper_d": "Published, D_iso max / avg", "default_d": "Default, D_iso max / avg"}
    rows = [
        _head(file)
        | {"paper": seconds(paper[TOTAL]), "default": f"{default[TOTAL]:.3f}", "ratio": factor(ratio)}
        | {"paper_d": _distortion(paper), "default_d": _distortion(default)}
        | {"sweeps": f"{paper['sweeps']:.0f}", "stop": paper["stop"]}
        for (file, default, paper), ratio in zip(pairs, ratios)
    ]
    columns |= {"sweeps": "Published, sweeps", "stop": "Published, end"}
    session.add_table("comparison", columns, rows)
    pairs.sort(key=lambda pair: pair[0].number_of_vertices)
    x = [file.number_of_vertices for file, *_ in pairs]
    curves = [Curve("published algorithm", x, [paper[TOTAL] for *_, paper in pairs])]
    curves.append(Curve("default", x, [default[TOTAL] for _, default, _ in pairs]))
    diagram = Diagram("Mesh to certified map", "vertices", "seconds", curves, "xy")
    caption = "Seconds of the published algorithm and of the default."
    session.draw("performance_comparison.png", [diagram], caption, is_in_manual=False)


def absolute(session: Session) -> None:
    session.report.begin_section(
        "Seconds",
        f"Medians of {session.repetitions} runs, each in a separate process, with {session.threads} threads. The total"
        " is from the mesh in memory to the certified map, without parsing the file.",
    )
    results = session.results(session.threads)
    columns = MESH | STAGE_COLUMNS | {TOTAL: "Total, s", "parsing": "Parsing", "sweeps": "Sweeps"}
    columns |= {"d": "D_iso max / avg"}
    rows = [
        _head(file)
        | {stage: f"{values[stage]:.3f}" for stage in (*STAGES, TOTAL, "parsing")}
        | {"sweeps": f"{values['sweeps']:.0f}", "d": _distortion(values)}
        for file, values in results
    ]
    session.add_table("absolute", columns, rows, "mesh", MESHES_OF_MANUAL)


def growth(session: Session) -> None:
    session.report.begin_section("Growth")
    results = session.results(session.threads)
    series_of = {threads: session.results(threads, session.series) for threads in session.thread_counts}
    series = series_of[session.threads]
    if len(results) < 2 or len(series) < 2:
        session.add("growth", "There are too few meshes.")
        return
    session.add("growth", _verdict_of_growth(results, series_of))
    columns = MESH | {"threads": "Threads"} | STAGE_COLUMNS
    columns |= {TOTAL: "Total, µs per vertex", "sweeps": "Sweeps", "seconds": "Total, s"}
    rows = [
        _head(file)
        | {"threads": threads, "sweeps": f"{values['sweeps']:.0f}", "seconds": number(values[TOTAL], 2)}
        | {stage: number(_microseconds((file, values), stage), 2) for stage in (*STAGES, TOTAL)}
        for threads, of_threads in series_of.items()
        for file, values in of_threads
    ]
    session.add_table("growth", columns, rows, "threads", (session.threads,))

    def per_vertex(of: list[Result], stage: str, name: str, is_connected: bool = True) -> Curve:
        x = [file.number_of_vertices for file, _ in of]
        return Curve(name, x, [_microseconds(result, stage) for result in of], is_connected)

    all_curves = []
    for threads in session.thread_counts:
        all_curves.append(per_vertex(session.results(threads), TOTAL, _words(threads), is_connected=False))
        all_curves.append(per_vertex(series_of[threads], TOTAL, f"{_words(threads)}, one shape"))
    labels = ("vertices", "microseconds per vertex")
    curves = [per_vertex(series, stage, stage) for stage in STAGES]
    diagrams = [
        Diagram("All meshes, mesh to map", *labels, all_curves, "x", starts_at_zero=True),
        Diagram("One shape, stage by stage", *labels, curves, "x", starts_at_zero=True),
    ]
    session.draw("performance_growth.png", diagrams, "Microseconds per vertex against the number of vertices.")


def _verdict_of_growth(results: list[Result], series_of: dict[int, list[Result]]) -> str:
    def spread(of: list[Result]) -> float:
        totals = [_microseconds(result) for result in of]
        return max(totals) / min(totals)

    threads = max(series_of)
    low, high = min(results, key=_microseconds), max(results, key=_microseconds)
    totals = [_microseconds(result) for result in series_of[threads]]
    (first, _), *_, (last, values) = series_of[threads]
    text = (
        f"With {_words(threads)}, the meshes from {results[0][0].number_of_vertices:,} to"
        f" {results[-1][0].number_of_vertices:,} vertices take {number(_microseconds(low), 1)} ({low[0].name}) to"
        f" {number(_microseconds(high), 1)} ({high[0].name}) microseconds per vertex, a factor of"
        f" {factor(spread(results))}. One shape, subdivided from {first.number_of_vertices:,} to"
        f" {last.number_of_vertices:,} vertices, takes {number(min(totals), 1)} to {number(max(totals), 1)} microseconds"
        f" per vertex, and {number(values[TOTAL], 1)} seconds at the largest size"
    )
    if threads > 1:
        text += f"; the factor is {factor(spread(series_of[threads]))}, and {factor(spread(series_of[1]))} with 1 thread"
    families: dict[str, list[Result]] = {}
    for result in results:
        families.setdefault(result[0].name.rsplit("_", 1)[0], []).append(result)
    words = []
    for shape, members in families.items():
        sizes = [file.number_of_vertices for file, _ in members]
        if max(sizes) >= 10 * min(sizes):
            words.append(f"{factor(spread(members))} ({shape}, {min(sizes):,} to {max(sizes):,} vertices)")
    return text + (f". Within one shape, the largest factor is {listed(words)}." if words else ".")


def limits(session: Session) -> None:
    session.report.begin_section("Lower bounds for a sweep")
    files = [file for file in map(session.one, MESHES_OF_LIMITS) if file is not None and not session.is_short]
    files = list({file.path: file for file in files + session.series}.values())
    by_threads: dict[int, list[Result]] = {threads: [] for threads in session.thread_counts}
    for file in sorted(files[:1] if session.is_short else files, key=lambda file: file.number_of_vertices):
        repetitions = REPETITIONS_OF_SHORT if session.is_short else REPETITIONS_OF_LIMITS
        results = session.kernels.run(file, "^(sweep|machine_)", session.threads, repetitions)
        if isinstance(results, str):
            session.objections.append(f"{file.name}, kernels: {results}")
            continue
        for threads, of_threads in by_threads.items():
            of_threads.append((file, _floor(results, threads)))
    if not by_threads[1]:
        session.add("limits", "None of the meshes could be measured.")
        return
    file, values = by_threads[1][-1]
    session.add(
        "limits",
        f"Per vertex of {file.name}, a sweep reads or writes at least {values['bytes']:.0f} bytes and performs"
        f" {values['sums_and_products']:.0f} additions and multiplications, {values['divisions']:.1f} divisions,"
        f" {values['square_roots']:.1f} square roots and {values['exponentials']:.1f} exponentials, for"
        f" {values['derivatives']:.2f} evaluations of the star with derivatives and {values['values']:.2f} without. One"
        f" thread of this machine performs {listed([factor(1e-9 * values[rate]) for rate in RATES])} billion of these"
        f" operations per second, and reads or writes {1e-9 * values['machine_bytes']:.1f} GB per second in arrays of"
        " that size.",
    )
    texts, rows, diagrams = [], [], []
    for threads, results in by_threads.items():
        (first, small), *_, (last, large) = (results[0], *results)
        texts.append(
            f"With {_words(threads)}, a sweep takes"
            f" {span([values['sweep'] / values['for_operations'] for _, values in results])} times the time of its"
            f" operations and {span([values['sweep'] / values['for_bytes'] for _, values in results])} times that of its"
            f" bytes: {small['sweep']:.0f} nanoseconds per vertex on {first.name} and {large['sweep']:.0f} on {last.name},"
            f" where the bytes alone would take {small['for_bytes']:.1f} and {large['for_bytes']:.1f}."
        )
        rows += [
            _head(file)
            | {"threads": threads, "sweep": number(values["sweep"], 0), "for_bytes": number(values["for_bytes"], 1)}
            | {"for_operations": number(values["for_operations"], 0), "rate": number(1e-9 * values["machine_bytes"], 1)}
            | {"to_bytes": factor(values["sweep"] / values["for_bytes"])}
            | {"to_operations": factor(values["sweep"] / values["for_operations"])}
            for file, values in results
        ]
        names = {"sweep": "sweep", "for_operations": "operations alone", "for_bytes": "bytes alone"}
        x = [file.number_of_vertices for file, _ in results]
        curves = [Curve(name, x, [values[key] for _, values in results]) for key, name in names.items()]
        diagrams.append(Diagram(_words(threads), "vertices", "nanoseconds per vertex", curves, "xy"))
    session.add("limits", " ".join(texts))
    columns = MESH | {"threads": "Threads", "sweep": "Sweep, ns per vertex", "for_bytes": "Bytes, ns"}
    columns |= {"for_operations": "Operations, ns", "to_bytes": "Sweep / bytes", "to_operations": "Sweep / operations"}
    session.report.paragraph(table(columns | {"rate": "GB/s"}, rows))
    caption = "A sweep, and the minimum time of its operations and of its bytes."
    session.draw("performance_limits.png", diagrams, caption, is_in_manual=False)


def _floor(results: dict[str, list[dict]], threads: int) -> dict:
    """The median of the sweep, its work per vertex, and the best rates of the machine, which no other process has
    disturbed. The divider, which also computes square roots, and the other units work in parallel.
    """
    sweep = "sweep" if threads == 1 else f"sweep_{threads}_threads/process_time/real_time"
    ending = "" if threads == 1 else f"/real_time/threads:{threads}"
    values = dict(results["sweep"][0])
    values["sweep"] = 1e9 / statistics.median(run["items_per_second"] for run in results[sweep])
    for rate in RATES:
        values[rate] = max(run["items_per_second"] for run in results[rate + ending])
    values["machine_bytes"] = max(run["bytes_per_second"] for run in results["machine_bytes" + ending])
    sums, divisions, roots, exponentials = (values[rate.removeprefix("machine_")] / values[rate] for rate in RATES)
    values["for_operations"] = 1e9 * max(sums + exponentials, divisions + roots)
    values["for_bytes"] = 1e9 * values["bytes"] / values["machine_bytes"]
    return values


def threads(session: Session) -> None:
    session.report.begin_section("Threads")
    if len(session.thread_counts) < 2:
        session.add("threads", "There is only one thread.")
        return
    n = session.threads
    alone, together = dict(session.results(1)), dict(session.results(n))
    both = [file for file in alone if file in together]
    files = [file for file in both if file.number_of_vertices >= session.min_vertices_of_threads]
    if not files:
        session.add("threads", "There is no mesh of a suitable size.")
        return

    def gain(file: MeshFile, stage: str = TOTAL) -> float:
        return session.timings.median_ratio(session.job(file, 1), session.job(file, n), stage)

    at_once = {file: session.job(file, 1, copies=n) for file in files if session.is_run_at_once(file)}
    ceilings = {
        file: n * session.timings.median_ratio(session.job(file, 1), job, TOTAL)
        for file, job in at_once.items()
        if session.timings.medians(job) is not None
    }
    totals = [gain(file) for file in files]
    text = (
        f"With {n} threads, meshes of at least {session.min_vertices_of_threads:,} vertices are mapped {span(totals)} times"
        f" as fast as with one, {factor(geometric_mean(totals))} times in the geometric mean (medians of the ratios of"
        " runs in the same round). "
    )
    if ceilings:
        shares = [gain(file) / ceiling for file, ceiling in ceilings.items()]
        at_best = list(ceilings.values())
        text += (
            f"Below {LARGE:,} vertices, {n} processes with one thread each that map the same mesh at the same time have"
            f" {span(at_best)} times the throughput of one, {factor(geometric_mean(at_best))} times in the geometric mean"
            " (column `Processes`). They share the caches and the memory, but never wait for each other; the threads of"
            f" one map reach {100.0 * geometric_mean(shares):.0f} % of that on the same meshes. "
        )
    different = [file.name for file in both if alone[file]["fingerprint"] != together[file]["fingerprint"]]
    text += f"The maps of {listed(different)} differ." if different else f"All {len(both)} maps have the same bits."
    session.add("threads", text)
    columns = MESH | STAGE_COLUMNS | {TOTAL: "Mesh to map", "at_once": "Processes"}
    columns |= {"alone": "1 thread, s", "all": f"{n} threads, s"}
    rows = [
        _head(file)
        | {stage: factor(gain(file, stage)) for stage in (*STAGES, TOTAL)}
        | {"at_once": factor(ceilings[file]) if file in ceilings else None}
        | {"alone": number(alone[file][TOTAL]), "all": number(together[file][TOTAL])}
        for file in files
    ]
    session.add_table("threads", columns, rows, "mesh", MESHES_OF_MANUAL)
    x = [file.number_of_vertices for file in files]
    stages = ("hierarchy", "embedding", "optimization", TOTAL)
    curves = [Curve(stage, x, [gain(file, stage) for file in files], is_connected=False) for stage in stages]
    x = [file.number_of_vertices for file in ceilings]
    curves.append(Curve(f"{n} processes at once", x, list(ceilings.values()), is_connected=False))
    diagram = Diagram("Threads", "vertices", "speedup over one thread", curves, "x", starts_at_zero=True)
    session.draw("performance_threads.png", [diagram], f"Speedup of {n} threads over one.")


def memory(session: Session) -> None:
    session.report.begin_section("Memory")
    rows, peaks = [], []
    for file in session.measured_meshes:
        row = _head(file)
        for n in session.thread_counts:
            ending = "" if n == 1 else f"_{n}_threads"
            results = session.kernels.run(file, f"^parameterization{ending}/", n)
            if isinstance(results, str):
                session.objections.append(f"{file.name}, memory: {results}")
                continue
            ((values,),) = results.values()
            peaks.append((values["bytes_per_vertex"], file.name))
            row[n] = f"{peaks[-1][0]:.0f}"
            row["megabytes"] = number(1e-6 * peaks[-1][0] * file.number_of_vertices, 1)
        rows.append(row)
    peaks = [(peak, name) for peak, name in peaks if peak == peak]
    if not peaks:
        session.add("memory", "This system does not report it.")
        return
    (low, _), (high, name) = min(peaks), max(peaks)
    largest = f"{rows[-1]['mesh']}, {rows[-1].get(session.threads, '–')}"
    text = f"At its peak, the default needs {low:.0f} to {high:.0f} ({name}) bytes per vertex in addition to the caller's mesh"
    session.add("memory", f"{text}; on the largest mesh, {largest}.")
    columns = {n: f"Bytes per vertex, {_words(n)}" for n in reversed(session.thread_counts)}
    session.add_table("memory", MESH | columns | {"megabytes": "Total, MB"}, rows, "mesh", FEW_MESHES_OF_MANUAL)


def cohort(session: Session) -> None:
    """A folder of meshes by one command, with one mesh on each core, and by one command per mesh, on all cores."""
    session.report.begin_section("A Folder of Meshes")
    meshes = [file for file in session.corpus if file.number_of_vertices < LARGE]
    program = session.timings.program(session.threads)

    def seconds_for(commands: list[list[MeshFile]]) -> float:
        with tempfile.TemporaryDirectory(dir=session.report.folder) as folder:
            start = time.monotonic()
            for files in commands:
                names = [file.path for file in files]
                outcome = run_command(
                    [program.path, "batch", *names, "--output-folder", folder, "--quiet", "--threads", session.threads]
                )
                if outcome.status != 0:
                    session.objections.append(f"`batch`: {outcome.message}")
            return time.monotonic() - start

    rounds = []
    for repetition in range(session.repetitions):
        ways = [[meshes], [[mesh] for mesh in meshes]]
        times = [seconds_for(way) for way in (ways if repetition % 2 == 0 else reversed(ways))]
        rounds.append(times if repetition % 2 == 0 else times[::-1])
    together = statistics.median(times[0] for times in rounds)
    ratio = statistics.median(times[1] / times[0] for times in rounds)
    vertices = [mesh.number_of_vertices for mesh in meshes]
    session.add(
        "cohort",
        f"With {session.threads} threads, {len(meshes)} meshes of {min(vertices):,} to {max(vertices):,} vertices,"
        f" {sum(vertices):,} in total, take {number(together, 2)} seconds from file to file with one command, and"
        f" {number(ratio, 2)} times as long with one command per mesh, one after the other.",
    )


@dataclass(frozen=True)
class Point:
    """A number of sweeps, in geometric means over the meshes."""

    name: str
    sweeps: float  # actual number
    time: float  # in units of the time of the default
    maximum: float  # in units of the lowest of the same mesh
    average: float

    def shown(self) -> dict:
        texts = {"sweeps": f"{self.sweeps:.0f}", "time": f"{self.time:.2f}"}
        return {"name": self.name} | texts | {key: f"{getattr(self, key):.4f}" for key in ("maximum", "average")}


def trade(session: Session) -> None:
    """D_iso against the number of sweeps and the time."""
    files = [file for file in session.corpus if file.number_of_vertices <= MAX_VERTICES_OF_TRADE]
    limits_of_sweeps = [*(SHORT_SWEEPS if session.is_short else SWEEPS), None]

    def job(file: MeshFile, sweeps: int | None) -> Job:
        arguments = () if sweeps is None else ("--iterations", str(sweeps))
        return Job(file, session.threads, arguments, min(session.repetitions, MAX_REPETITIONS_OF_LONG), "trade")

    session.timings.measure([job(file, sweeps) for file in files for sweeps in limits_of_sweeps])
    by_mesh = [{sweeps: session.timings.medians(job(file, sweeps)) for sweeps in limits_of_sweeps} for file in files]
    by_mesh = [of_mesh for of_mesh in by_mesh if all(of_mesh.values())]
    session.report.begin_section(
        "Time against distortion",
        f"Each of {len(by_mesh)} meshes is mapped with a maximum number of sweeps over the mesh; the hierarchy and the"
        " sweeps over its levels are the same for all. Times are relative to the default, distortions to the lowest that"
        " any setting reached on the same mesh; their means are geometric, those of the sweeps arithmetic.",
    )
    if not by_mesh:
        session.add("trade", "There is no mesh of a suitable size.")
        return
    points = []
    for sweeps in limits_of_sweeps:
        means = [
            geometric_mean([of[sweeps][key] / min(values[key] for values in of.values()) for of in by_mesh])
            for key in ("D_iso max", "D_iso avg")
        ]
        made = statistics.fmean(of[sweeps]["sweeps"] for of in by_mesh)
        time = geometric_mean([of[sweeps][TOTAL] / of[None][TOTAL] for of in by_mesh])
        points.append(Point("default" if sweeps is None else str(sweeps), made, time, *means))
    points.sort(key=lambda point: point.sweeps)
    columns = {"name": "Maximum number of sweeps", "sweeps": "Sweeps", "time": "Time"}
    distortions = {"maximum": "D_iso max", "average": "D_iso avg"}
    rows = [point.shown() for point in points]
    session.add_table("trade", columns | distortions, rows, "name", SWEEPS_OF_MANUAL)
    default = next(point for point in points if point.name == "default")
    text = (
        f"On the {len(by_mesh)} meshes of up to {MAX_VERTICES_OF_TRADE:,} vertices, the runs take {points[0].time:.2f} to"
        f" {points[-1].time:.2f} times the time of the default, and {points[-1].sweeps:.0f} sweeps on average until"
        " convergence or the highest limit."
    )
    rows, texts = [], []
    for time in TIMES:
        point = _at(points, time)
        if point is None:
            rows.append({"name": f"{time:g}", "sweeps": "–", "time": "no map", "maximum": "–", "average": "–"})
            continue
        rows.append(point.shown() | {"name": f"{time:g}"})
        if time != 1.0 and abs(point.time / time - 1.0) <= NOISE:
            changes = [_change(getattr(point, key) / getattr(default, key)) for key in distortions]
            texts.append(f"with {time:g} times the time, the maximum is {changes[0]} and the average {changes[1]}")
    session.add("trade", text + (f" Compared with the default: {'; '.join(texts)}." if texts else ""))
    columns = {"name": "Allowed time", "sweeps": "Sweeps", "time": "Time"}
    session.report.paragraph(table(columns | distortions, rows))
    shown = [point for point in points if point.sweeps > 0]  # the first map is far off
    diagrams = []
    for key, title in distortions.items():
        curve = Curve(f"{len(by_mesh)} meshes", [p.time for p in shown], [getattr(p, key) for p in shown])
        style = {"logarithmic": "x", "ticks": TIMES, "marked": (1.0, "default")}
        diagrams.append(Diagram(title, "time, 1 = default", "1 = lowest", [curve], **style))
    caption = f"D_iso against time, geometric means over {len(by_mesh)} meshes."
    session.draw("performance_trade.png", diagrams, caption)


def _at(points: list[Point], time: float) -> Point | None:
    """The result after that time: interpolated by the logarithm of the time; beyond the last setting, that one, which
    takes less. None if it is too short for any.
    """
    times = np.maximum.accumulate([point.time for point in points])  # more sweeps take less time by noise only
    if time < (1.0 - NOISE) * times[0]:
        return None
    time = float(np.clip(time, times[0], times[-1]))
    of_points = zip(*((point.sweeps, point.maximum, point.average) for point in points))
    sweeps, maximum, average = (float(np.interp(np.log(time), np.log(times), values)) for values in of_points)
    return Point("", sweeps, time, maximum, average)


def _change(ratio: float) -> str:
    if abs(ratio - 1.0) < 0.0005:
        return "the same"
    return f"{percent(abs(ratio - 1.0))} {'higher' if ratio > 1.0 else 'lower'}"


def _head(file: MeshFile) -> dict:
    return {"mesh": file.name, "vertices": f"{file.number_of_vertices:,}"}


def _distortion(values: dict) -> str:
    return f"{number(values['D_iso max'])} / {number(values['D_iso avg'])}"


def _words(number_of_threads: int) -> str:
    return "1 thread" if number_of_threads == 1 else f"{number_of_threads} threads"


def _microseconds(result: Result, stage: str = TOTAL) -> float:
    return 1e6 * result[1][stage] / result[0].number_of_vertices
