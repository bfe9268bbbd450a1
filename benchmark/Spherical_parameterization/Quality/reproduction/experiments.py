"""The experiments: Table 1 and figures 1 to 11 of the paper, and what a reader has to know to trust them."""

from __future__ import annotations

import math

from measuring import meshes
from measuring.maps import Statistics
from measuring.meshes import MeshFile
from measuring.reports import Curve, Diagram, draw, geometric_mean, listed, number, percent, seconds, statistics
from measuring.runs import CERTIFIED, FAILED, Run

from .experiment import ABOVE, ANGLE, BLD, CONVERGED, DEFAULT, INVERTED, FULL_SWEEPS, ISOMETRIC, MESH, METHOD, PACKAGE
from .experiment import SECONDS, SHORT_SWEEPS, SIZE, SWEEPS, Experiment, Session
from .models import MODELS, SAME_COUNT, TABLE_1
from .paper_values import COUNTS
from .paper_values import TABLE_1 as PAPER_ROWS

PAPER_ENERGY = ["--energy", "isometric", "--schedule", "0.1,10"]
BIJECTIVE = {"bld": [], **{method: ["--method", method] for method in ("hierarchical", "stereographic", "harmonic")}}
WITHOUT_PROMISE = {method: ["--method", method] for method in ("conformal", "arap")}
EQUAL = 0.005  # what differs by less, relatively, counts as equal

STARTS = ("stereographic", "harmonic", "hierarchical", "conformal")
START_MODELS = (*TABLE_1, "spot", "blub", "brain", "horse", "armadillo", "bimba")
MAX_OF_AVERAGE, MAX_OF_MAXIMUM = 0.03, 0.10  # by which results of different starts may differ

MIN_VERTICES_OF_LARGE = 200_000
SWEEPS_OF_LARGE = 200  # of paper mode, of which all 2000 would take an hour on these two

MAX_VERTICES_OF_LONG_RUN, LONG_SWEEPS = 5000, 20000
CLOSE = 0.05  # paper mode's maximum above that of the converged default


def methods(session: Session) -> dict[str, list[str]]:
    compared = {"Harmonic": BIJECTIVE["harmonic"], "Hierarchical": BIJECTIVE["hierarchical"]}
    return compared | {"ARAP": WITHOUT_PROMISE["arap"], BLD: session.paper(), PACKAGE: DEFAULT}


def table_1(session: Session) -> None:
    experiment = Experiment(
        session,
        "table1",
        "Table 1: distortion, inverted faces and seconds",
        "Each model as it was found, and in a copy with as many vertices as the paper's. Rows in italics repeat the"
        " paper: another mesh of that model, on another machine. Maps with inverted faces can have any area at a face that is"
        " about to turn, and so any radius of eq. 11; the last column has the same map at the radius that the method"
        " gave it.",
    )
    columns = METHOD | MESH | SIZE | ISOMETRIC | {"area": "D_area max / avg / dev"} | ANGLE | INVERTED | SECONDS
    columns |= {"cpu_seconds": "CPU seconds"} | SWEEPS | {"own": "D_iso max / avg / dev at the map's own radius"}
    of_models = {name: session.library.copies(name) for name in TABLE_1}
    if not any(of_models.values()):
        others = session.library.stand_ins(len(TABLE_1))
        session.library.notes.append("Table 1: none of the paper's models is among the meshes; others stand for them.")
        of_models = {file.name: {"": file} for file in others}
    for model, copies in of_models.items():
        if not copies:
            session.library.notes.append(f"Table 1: {MODELS[model].title}: there is no mesh of it.")
            continue
        experiment.add_text(f"### {MODELS[model].title if model in MODELS else model}")
        for kind, file in copies.items():
            runs = experiment.run_methods(file, methods(session), model=model, copy=kind)
            session.comparison.append((kind, runs[PACKAGE], runs[BLD]))
        for (of_model, method), row in PAPER_ROWS.items():
            if of_model == model:
                measures = {name: statistics(getattr(row, name), 2) for name in ("isometric", "area", "angle")}
                texts = {"method": method, "mesh": "the paper's mesh and machine", "size": f"{COUNTS[model][0]:,}"}
                texts |= measures | {"inverted": f"{row.inverted:,g}"}
                texts |= {"seconds": "–" if row.seconds is None else seconds(row.seconds)}
                experiment.rows.append({key: f"*{text}*" for key, text in texts.items()})
        experiment.tabulate(columns)
        session.forget_maps()
    experiment.finish(columns)


def verdict(session: Session) -> str:
    """The first paragraph: where the default is better than paper mode, and where it is not. Nothing of it is fixed."""
    if not session.comparison:
        return "This run did not compare the package's default with paper mode: it did not include Table 1."
    pairs = [pair for pair in session.comparison if pair[1].has_map and pair[2].has_map]
    parts = [
        f"The package's default against the method as published (paper mode), on {len(pairs)} meshes, both measured in"
        f" this run with {session.program.threads} threads, D_iso at the radius of eq. 11."
    ]
    if session.is_short:
        parts.append(
            f"This is the short version: paper mode was ended after {SHORT_SWEEPS} of its {FULL_SWEEPS} sweeps and the"
            " meshes are small, so these figures show that the driver works and do not compare the methods."
        )
    if pairs:
        for name, key, digits in (
            ("maximum", "isometric_maximum", 3),
            ("average", "isometric_average", 3),
            ("time", "seconds", 2),
        ):
            parts.append(_compared(name, [(kind, a.row[key], b.row[key], a.mesh.name) for kind, a, b in pairs], digits))
    only = [default.mesh.name for _, default, paper in session.comparison if default.has_map and not paper.has_map]
    neither = [default.mesh.name for _, default, _ in session.comparison if not default.has_map]
    if only:
        parts.append(f"Paper mode has no map at all of {listed(only)}, where the default has one.")
    if neither:
        parts.append(f"The default has no map of {listed(neither)}.")
    limited = sum("limit" in paper.stop_reason for _, _, paper in pairs)
    parts.append(f"Paper mode ended at its limit of sweeps, not by its stopping rule, on {limited} of {len(pairs)}.")
    return " ".join(parts)


def _compared(name: str, values: list[tuple[str, float, float, str]], digits: int) -> str:
    """A sentence on one quantity, of which less is better; the values are kind, the default's, the paper's, mesh."""
    ratios = {mesh: default / paper for _, default, paper, mesh in values}
    higher = [f"{mesh} ({b:.{digits}f} against {a:.{digits}f})" for _, a, b, mesh in values if a > (1 + EQUAL) * b]
    by_kind = []
    for kind in dict.fromkeys(value[0] for value in values):
        of_kind = [default < (1 - EQUAL) * paper for which, default, paper, _ in values if which == kind]
        by_kind.append(f"{sum(of_kind)} of {len(of_kind)}{f' ({kind})' if kind else ''}")
    low, high = min(ratios, key=ratios.get), max(ratios, key=ratios.get)
    text = f"**The {name}** of the default is lower on {listed(by_kind)}: {geometric_mean(list(ratios.values())):.3g}"
    text += f" times paper mode's in the geometric mean, from {ratios[low]:.3g} ({low}) to {ratios[high]:.3g} ({high})"
    return text + (f"; paper mode is lower on {listed(higher)}." if higher else ".")


def figure_1(session: Session) -> None:
    files = session.library.some(("hand",), "Figure 1")
    experiment = Experiment(
        session,
        "figure1",
        "Figure 1: D_iso against the last s",
        "The paper: as s grows, the maximum falls rapidly; the average falls at first and then rises slightly. Here"
        " every point is a run of its own, with s from 0.1 to the value given; 0 is eq. 6 alone. Two more curves show"
        " the same energy with the package's own optimiser, and the package's dial, which has no scale.",
    )
    sweeps = str(session.paper_sweeps)
    values = (0.0, 1.0, 10.0) if session.is_short else (0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0)
    dial_values = (0.0, 12.0, 50.0) if session.is_short else (0.0, 3.0, 6.0, 12.0, 25.0, 50.0)

    def schedule(s: float, without: list[str]) -> list[str]:
        return ["--schedule", f"{min(s, 0.1):g},{s:g}"] if s > 0.0 else without

    paper, newton = "paper mode, last s", "the paper's energy, the package's start, steps and barrier, last s"
    dial = "default of the package, sharpness"
    series = {
        paper: [(s, ["--paper", *schedule(s, ["--schedule", f"0.1,10,{sweeps}"]), "--iterations", sweeps]) for s in values],
        newton: [(s, ["--energy", "isometric", *schedule(s, ["--sharpness", "0"]), *CONVERGED]) for s in values],
        dial: [(b, ["--sharpness", f"{b:g}", *CONVERGED]) for b in dial_values],
    }
    points: dict[str, list[tuple[float, Statistics]]] = {name: [] for name in series}
    for file in files:
        for name, settings in series.items():
            runs = [(x, experiment.run(file, options, series=name, x=f"{x:g}")) for x, options in settings]
            points[name] = [(x, run.distortion.isometric) for x, run in runs if run.has_map]
            experiment.add_text(f"*{name}*: " + _course(points[name]) if points[name] else "")
    for image, names, label in (("figure1", (paper, newton), "last s"), ("figure1_sharpness", (dial,), "sharpness")):
        diagrams = []
        for key in ("maximum", "average"):
            curves = [
                Curve(name, [x for x, _ in points[name]], [getattr(y, key) for _, y in points[name]]) for name in names
            ]
            diagrams.append(Diagram(f"D_iso {key}", label, f"D_iso {key}", curves))
        draw(experiment.report.folder / f"{image}.png", diagrams)
        experiment.report.image(f"{image}.png", f"Figure 1: D_iso against the {label}.")
    experiment.finish({"series": "Series", "x": "s or sharpness"} | MESH | ISOMETRIC | SWEEPS | SECONDS)


def _course(points: list[tuple[float, Statistics]]) -> str:
    texts = []
    for key in ("maximum", "average"):
        values = [(getattr(y, key), x) for x, y in points]
        (first, start), (last, end), (lowest, at) = values[0], values[-1], min(values)
        texts.append(
            f"from {start:g} to {end:g} the {key} goes from {number(first)} to {number(last)}, lowest at {at:g}"
            f" ({number(lowest)})"
        )
    return "; ".join(texts) + "."


def figure_2(session: Session) -> None:
    experiment = Experiment(
        session,
        "figure2",
        "Figure 2: rules for the radius",
        "The distortion at the radius that each rule ended with. The paper: eq. 11 always has both the lower maximum"
        " and the lower average, and it is trapped easily from a bad start, which is why the method takes eq. 9 until"
        " convergence and eq. 11 after it (two-phase).",
    )
    names = ("cow",) if session.is_short else ("bunny", "hand", "cow", "fandisk")
    for file in session.library.some(names, "Figure 2"):
        fixed = math.sqrt(file.mesh.area() / (4.0 * math.pi))  # eq. 10 has the sphere's area equal to the mesh's
        rules = {"eq. 10, fixed": f"fixed={fixed:.17g}", "eq. 9": "area", "eq. 11": "optimal", "two-phase": "two-phase"}
        for mode, options in (("paper mode", session.paper()), ("the package's optimiser", PAPER_ENERGY)):
            runs = {}
            for rule, value in rules.items():
                run = experiment.run(file, [*options, "--radius", value], mode=mode, rule=rule)
                if run.has_map:
                    runs[rule] = run.own_distortion.isometric
            for key in ("maximum", "average") if runs else ():
                lowest = min(runs, key=lambda rule: getattr(runs[rule], key))
                experiment.add_text(f"{file.name}, {mode}: the lowest {key} with {lowest}.")
    columns = {"mode": "Optimiser", "rule": "Rule", "radius": "Radius", "own": "D_iso max / avg / dev at that radius"}
    experiment.finish(MESH | columns | {"isometric": "the same at the radius of eq. 11"} | SWEEPS | SECONDS)


def figure_3(session: Session) -> None:
    experiment = Experiment(
        session,
        "figure3",
        "Figure 3: different starts",
        "The paper: almost the same result from different initial maps. Here the package's optimiser starts from each"
        f" of its four initial maps and may take {CONVERGED[1]} sweeps, so that all can converge; the results of a mesh"
        f" count as the same if they are within {percent(MAX_OF_AVERAGE)} in the average and"
        f" {percent(MAX_OF_MAXIMUM)} in the maximum of D_iso, largest against smallest. A start that is no bijection"
        " cannot be used, and is listed below the table.",
    )
    columns = MESH | METHOD | ISOMETRIC | SWEEPS | SECONDS
    names = ("fandisk",) if session.is_short else START_MODELS
    from_all = {f"from {start}": ["--initial", start, *CONVERGED] for start in STARTS}
    by_mesh = {}
    for file in session.library.some(names, "Figure 3"):
        by_mesh[file.name] = experiment.run_methods(file, from_all)
        session.forget_maps()
    _tell_spread(experiment, by_mesh, "the package's optimiser")
    experiment.tabulate(columns)
    experiment.add_text("The same in paper mode, with its own limit of sweeps:")
    names = ("fandisk",) if session.is_short else ("fandisk", "bunny", "cow")
    files = session.library.some(names, "Figure 3, paper mode")
    files += [file for file in session.library.copies("fandisk").values() if file not in files]
    from_all = {f"from {start}": session.paper("--initial", start) for start in STARTS}
    by_mesh = {file.name: experiment.run_methods(file, from_all) for file in files}
    _tell_spread(experiment, by_mesh, "paper mode")
    experiment.finish(columns)


def _tell_spread(experiment: Experiment, by_mesh: dict[str, dict[str, Run]], optimizer: str) -> None:
    same, different, undecided = [], [], []
    for name, runs in by_mesh.items():
        usable = [run.row for run in runs.values() if run.exit_status == CERTIFIED]
        if len(usable) < 2:
            undecided.append(name)
            continue
        values = {key: [row[f"isometric_{key}"] for row in usable] for key in ("average", "maximum")}
        spread = {key: max(of_key) / min(of_key) - 1.0 for key, of_key in values.items()}
        is_same = spread["average"] <= MAX_OF_AVERAGE and spread["maximum"] <= MAX_OF_MAXIMUM
        text = f"{name} ({percent(spread['average'])} in the average, {percent(spread['maximum'])} in the maximum)"
        (same if is_same else different).append(text)
    text = f"With {optimizer}, the starts lead to the same result on {len(same)} of {len(by_mesh)} meshes. "
    text += f"Exceptions: {listed(different)}. " if different else "There is no exception. "
    experiment.add_text(text + (f"Too few starts to decide: {listed(undecided)}." if undecided else ""))


def figure_4(session: Session) -> None:
    copies = session.library.copies("bimba")
    variants = [(file, kind) for kind, file in copies.items()]
    if len(copies) < 2:
        for first in session.library.some(("bimba",), "Figure 4"):
            refined = meshes.refine_everywhere(first.mesh)
            split = session.library.derive(f"{first.name}_split", "split into four", refined)
            session.library.notes.append(f"Figure 4: {split.name} is made by this driver, each face split into four.")
            variants = [(first, "unchanged"), (split, split.origin)]
    text = "The paper: the distortion of Bimba as found and of the remeshed one differ little."
    _compare_tessellations(session, "4", "one shape, two tessellations", text, variants, has_edges=False)


def figure_5(session: Session) -> None:
    library, variants = session.library, []
    for first in library.some(("fandisk",), "Figure 5"):
        graded = library.derive(f"{first.name}_graded", "one half split twice", meshes.refine_one_side(first.mesh, 2))
        refined = meshes.refine_along_one_axis(first.mesh, 2)
        stretched = library.derive(f"{first.name}_stretched", "split twice along", refined)
        variants = [(first, "unchanged"), (graded, graded.origin), (stretched, stretched.origin)]
        coarse = library.copies("fandisk").get(SAME_COUNT, first)
        variants += [(coarse, "simplified")] if coarse is not first else []
    text = (
        "The paper remeshes Fandisk with faces of different sizes, and finds the result insensitive to that. Here: the"
        " mesh itself, a simplified one with needles if there is one, and two that this driver makes without changing"
        " the shape: all edges in one half of it halved twice (faces of very different size), and only the edges along"
        " the longest axis halved twice (stretched faces)."
    )
    _compare_tessellations(session, "5", "faces of varying size and stretched faces", text, variants, has_edges=True)


def _compare_tessellations(
    session: Session, figure: str, title: str, text: str, variants: list[tuple[MeshFile, str]], has_edges: bool
) -> None:
    experiment = Experiment(session, f"figure{figure}", f"Figure {figure}: {title}", text)
    two = {BLD: session.paper(), PACKAGE: DEFAULT}
    figures: dict[str, list[tuple[str, float, float]]] = {method: [] for method in two}
    for file, what in variants:
        for i, (method, run) in enumerate(experiment.run_methods(file, two, what=what).items(), -len(two)):
            if run.has_map:
                by_area = run.map.area_weighted_average()
                experiment.rows[i]["weighted"] = number(by_area)
                figures[method].append((what, run.row["isometric_maximum"], by_area))
    for method, (first, *others) in ((method, values) for method, values in figures.items() if values):
        changes = [
            f"{what}: {100 * (maximum / first[1] - 1):+.1f} % in the maximum, {100 * (average / first[2] - 1):+.1f} %"
            " in the average by area"
            for what, maximum, average in others
        ]
        experiment.add_text(f"{method}, against the first mesh: {'; '.join(changes)}.")
    caption = f"Figure {figure}: in brackets D_iso max, D_iso avg and inverted faces."
    experiment.draw(caption, list(two), 3.0, has_edges=has_edges)
    experiment.add_text(
        "The averages of eq. 12 are over faces, so they lean to where the faces are small; that by area does not."
    )
    columns = MESH | {"what": "Tessellation"} | SIZE | METHOD | ISOMETRIC | {"weighted": "D_iso avg by area"}
    experiment.finish(columns | INVERTED | SWEEPS | SECONDS)


def figure_6(session: Session) -> None:
    n = ["--iterations", str(session.paper_sweeps)]
    schedules = {
        "(a) eq. 6, 100 sweeps": ["--paper", "--schedule", "0.1,10,100", "--iterations", "100"],
        "(b) eq. 7, s = 5": ["--paper", "--schedule", "5,5,0", *n],
        "(c) eq. 7, s = 0.1": ["--paper", "--schedule", "0.1,0.1,0", *n],
        "(d) eq. 7, s from 0.1 to 10": ["--paper", "--schedule", "0.1,10,0", *n],
        "(e) eq. 6, 100 sweeps, then s from 0.1 to 10": session.paper(),
        PACKAGE: DEFAULT,
    }
    experiment = Experiment(
        session,
        "figure6",
        "Figure 6: schedules of s",
        f"Paper mode with the schedules of the paper's figure, at most {n[1]} sweeps in all, and the package's default"
        " beside it. (b) and (c) are AMIPS with a fixed s. The paper: the adaptive schedule after eq. 6 (e) ends with"
        " the lowest maximum.",
    )
    *_, last, _ = schedules
    for file in session.library.copies("cow").values() or session.library.some(("cow",), "Figure 6"):
        runs = experiment.run_methods(file, schedules, bound=last)
        ranked = sorted((run.row["isometric_maximum"], name[:3]) for name, run in runs.items() if run.has_map)
        experiment.add_text(f"{file.name}, by the maximum: {', '.join(f'{name} {number(x)}' for x, name in ranked)}.")
    caption = "Figure 6: in brackets D_iso max, D_iso avg, faces above the maximum of (e), inverted faces."
    experiment.draw(caption, [name.replace(", then", ",\nthen") for name in schedules], 8.0)
    experiment.finish(MESH | METHOD | ISOMETRIC | {"above": "Faces above (e)'s max"} | SWEEPS | SECONDS)


def figure_7(session: Session) -> None:
    experiment = Experiment(
        session,
        "figure7",
        "Figure 7: energy against sweeps",
        "The average energy of a face (eq. 3; 2 at best) during the 100 sweeps of eq. 6 that paper mode begins with,"
        " from the harmonic map. The second curve takes the same start and the same energy with Newton steps and the"
        " determinant in the energy's place of the area, which makes its energy a little larger at the same map.",
    )
    newton = ["--initial", "harmonic", *PAPER_ENERGY[:-1], "0.1,10,100", "--iterations", "100"]
    modes = {"gradient steps, as published": ["--paper", "--iterations", "100"], "Newton steps of the package": newton}
    shown_at = (1, 2, 5, 10, 20, 50, 100)
    diagrams, records = [], []
    for file in session.library.some(("hand", "cow"), "Figure 7"):
        curves = []
        for mode, options in modes.items():
            run = experiment.run(file, options, method=mode)
            history = [(sweep, energy) for sweep, energy, _ in run.report.get("history", [])[:100]]
            curves.append(Curve(mode, *map(list, zip(*history))) if history else Curve(mode, [], []))
            records += [{"mesh": file.name, "mode": mode, "sweep": i, "energy": energy} for i, energy in history]
            energies = {0: run.report.get("energy", {}).get("initial_average")} | dict(history)
            experiment.rows[-1] |= {f"at{i}": number(energies.get(i)) for i in (0, *shown_at)}
        diagrams.append(Diagram(file.name, "sweep", "energy of a face, log scale", curves, "y", has_markers=False))
    if diagrams:
        draw(experiment.report.folder / "figure7.png", diagrams)
        experiment.report.image("figure7.png", "Figure 7: the energy of a face against the sweep.")
    experiment.records = records
    experiment.finish(MESH | {"method": "Steps", "at0": "Start"} | {f"at{i}": f"Sweep {i}" for i in shown_at})


def figure_8(session: Session) -> None:
    _figure_of_methods(session, "8", "simple", ("fandisk", "skull", "maxplanck", "santa"), 3.0)


def figure_9(session: Session) -> None:
    _figure_of_methods(session, "9", "complex", ("buddha", "bunny", "hand", "cow"), 8.0)


def _figure_of_methods(session: Session, figure: str, kind: str, names: tuple[str, ...], high: float) -> None:
    experiment = Experiment(
        session,
        f"figure{figure}",
        f"Figure {figure}: the methods on {kind} models",
        "The maps of Table 1, of the copies as found where there are such. The surface on the left and the sphere on"
        f" the right have the same colors, D_iso from 1 to {high:g}; inverted faces are magenta. In brackets: D_iso"
        " max, D_iso avg, the number of faces above the maximum of BLD in paper mode, the number of inverted faces.",
    )
    for file in session.library.some(names[:1] if session.is_short else names, f"Figure {figure}"):
        experiment.run_methods(file, methods(session), bound=BLD)
    experiment.draw(f"Figure {figure}: {', '.join(methods(session))}.", list(methods(session)), high)
    experiment.finish(MESH | METHOD | ISOMETRIC | ABOVE | INVERTED, tells_inverted=False)


def figure_10(session: Session) -> None:
    experiment = Experiment(
        session,
        "figure10",
        "Figure 10: two large models",
        "The paper takes a parallel method of others as the start, because Harmonic fails on models of this size. Here"
        f" that start is the hierarchical map; Harmonic is tried too. Paper mode is ended after {SWEEPS_OF_LARGE}"
        " sweeps here.",
    )
    files = [file for file in map(session.large.best, ("vaselion", "buste")) if file is not None]
    files = [file for file in files if file.number_of_vertices >= MIN_VERTICES_OF_LARGE]
    if session.is_short:
        files = session.library.stand_ins(1)
    elif len(files) < 2:
        note = "vaselion_369650 and buste_522114 are not both there; --large names their folder."
        session.library.notes.append(f"Figure 10: {note}")
    start = ["--paper", "--initial", "hierarchical", "--iterations", str(min(SWEEPS_OF_LARGE, session.paper_sweeps))]
    of_figure = methods(session) | {BLD: start}
    del of_figure["ARAP"]
    for file in files:
        experiment.run_methods(file, of_figure)
    experiment.draw("Figure 10: in brackets D_iso max, D_iso avg and inverted faces.", list(of_figure), 3.0)
    experiment.finish(MESH | SIZE | METHOD | ISOMETRIC | INVERTED | SWEEPS | SECONDS)


def figure_11(session: Session) -> None:
    experiment = Experiment(
        session,
        "figure11",
        "Figure 11: conformal maps",
        "BLD with the conformal energy against the classical conformal map, which promises no bijection. D_angle is 2"
        " at best. The paper: Conformal is not bijective at the ears of the bunny and the fingers of the hand, and has no bound on"
        " the maximum.",
    )
    bld = "BLD of the package, conformal energy"
    two = {"Conformal": WITHOUT_PROMISE["conformal"], bld: ["--energy", "conformal"]}
    copies = [file for name in ("bunny", "hand") for file in session.library.copies(name).values()]
    for file in copies or session.library.some(("bunny",), "Figure 11"):
        runs = experiment.run_methods(file, two, bound=bld, measure="angle")
        if all(run.has_map for run in runs.values()):
            a, b = (run.row for run in runs.values())
            experiment.add_text(
                f"{file.name}: BLD's maximum is {number(b['angle_maximum'] / a['angle_maximum'])} times Conformal's,"
                f" its average {number(b['angle_average'] / a['angle_average'], 4)} times; inverted faces"
                f" {a['inverted_faces']:,} with Conformal, {b['inverted_faces']:,} with BLD."
            )
    caption = "Figure 11: in brackets D_angle max, D_angle avg, faces above the maximum of BLD, inverted faces."
    experiment.draw(caption, list(two), 4.0, "angle")
    experiment.finish(MESH | SIZE | METHOD | ANGLE | ABOVE | INVERTED | SWEEPS | SECONDS)


def yardstick(session: Session) -> None:
    """Paper mode against the default after convergence, and the trap of the flat area where it falls behind."""
    experiment = Experiment(
        session,
        "yardstick",
        "Paper mode as the yardstick",
        "Is paper mode at its best here? Its maximum is compared with that of the package's default after convergence."
        " Three points on a great circle span a flat triangle of positive area, so the published energy lets a face lie"
        " across a great circle and stay there; the column *across* counts the faces whose plane comes closer to the"
        " center than a tenth of the radius.",
    )
    longer = "paper mode, more sweeps"
    for file in session.library.some(("cow",) if session.is_short else ("bunny", "fandisk", "armadillo"), "Yardstick"):
        variants = {BLD: session.paper(), "default, converged": ["--iterations", "5000"]}
        if file.number_of_vertices <= MAX_VERTICES_OF_LONG_RUN and not session.is_short:
            variants[longer] = ["--paper", "--iterations", str(LONG_SWEEPS)]
        runs = {}
        for name, options in variants.items():
            runs[name] = experiment.run(file, options, method=name)
            if runs[name].has_map:
                experiment.rows[-1]["across"] = runs[name].map.number_across()
        maxima = {name: run.row["isometric_maximum"] for name, run in runs.items() if run.has_map}
        if BLD in maxima and "default, converged" in maxima:
            excess = maxima[BLD] / maxima["default, converged"] - 1.0
            distance = f"within {percent(CLOSE)}" if excess <= CLOSE else f"{percent(excess)} more"
            text = f"{file.name}: paper mode's maximum is {number(maxima[BLD])}, {distance}"
            text += " of the converged default's" if excess <= CLOSE else " than the converged default's"
            text += f"; with as many sweeps as it takes {number(maxima[longer])}." if longer in maxima else "."
            experiment.add_text(text)
    experiment.finish(MESH | METHOD | ISOMETRIC | INVERTED | {"across": "Across"} | SWEEPS | SECONDS)


def certificates(session: Session) -> None:
    """Runs every method on every mesh of the folder; compares what the program says with the folds that are there."""
    experiment = Experiment(
        session,
        "certificates",
        "Every method on every mesh",
        "The exit status of the program on all meshes of the folder, against this driver's own exact count of inverted"
        " faces. ✓: a certified bijection, and no face is inverted; n inverted: the method says that its map is not"
        " one-to-one, and n faces are inverted; –: no map, for the reason given below.",
    )
    every = BIJECTIVE | WITHOUT_PROMISE
    counts = dict.fromkeys(every, 0)
    rows = []
    files = session.library.stand_ins(2) if session.is_short else session.library.files
    for file in files:
        row = {"mesh": file.name}
        for name, options in every.items():
            run = experiment.run(file, options, method=name)
            inverted = run.row.get("inverted_faces", 0)
            counts[name] += run.exit_status == CERTIFIED
            if run.exit_status == CERTIFIED:
                row[name] = f"✗ {inverted:,} inverted" if inverted else "✓"
            else:
                row[name] = "–" if run.exit_status == FAILED or not run.has_map else f"{inverted:,} inverted"
        rows.append(row)
        session.forget_maps()
    experiment.add_text(f"Certified of {len(files)}: {listed([f'{name} {count}' for name, count in counts.items()])}.")
    experiment.rows = rows
    experiment.finish(MESH | {name: name for name in every}, tells_inverted=False)
