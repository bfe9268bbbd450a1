#!/usr/bin/env python3
"""Maps pairs of surfaces onto each other, in both directions, and prints the table of correspondences of the user manual.

FOLDER contains pairs.txt, with two names and a kind in each line, and optionally pairs_wide.txt, with randomly drawn pairs, which are
mapped in one direction. The meshes are NAME.off.gz or NAME.obj.gz. For the kind `corres`, the files NAME.vts of both meshes list
corresponding vertices, line by line, counted from 1, and NAME.sym.vts their mirror images. For the kind `landmarks`, NAME.vts, or
NAME/landmarks0.txt and so on for NAME/input0 and NAME/input1, list landmarks, counted from 0. Pairs with landmarks in .vts files are
mapped once more without them, and the landmarks then measure the error. Of tosca_between, the other combinations of first and second
surfaces have a row of their own. Takes 20 minutes; needs numpy and scipy.

With --noise SEED, coordinates of all meshes get normally distributed noise of 1e-5 of the largest extent, to show how far results
depend on small differences.

The expected error of a map is correlated with its errors over the vertices; the table has the means over the maps. With --manual FILE,
the table is also written to a page of the manual.

With --bounds FILE, the pairs of that file whose meshes are available are mapped and compared with its bounds. This needs no scipy,
because the error is then measured by straight distances. Fails if a bound is exceeded.
"""

from __future__ import annotations

import gzip
import json
import math
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import numpy as np
from measuring.commands import run_command
from measuring.drivers import Driver
from measuring.meshes import Mesh, read_mesh, write_mesh
from measuring.reports import fill_in, table

ROWS = {
    "faust": "people, scanned (FAUST)",
    "faust, random": "the same, random pairs",
    "tosca": "animals and persons, two poses of one body (TOSCA)",
    "tosca, random": "the same, random pairs",
    "tosca_between": "a gorilla and a person (TOSCA)",
    "tosca_between, combinations": "the same, other combinations",
    "shrec": "four-legged animals, 21 landmarks (SHREC)",
    "shrec, landmarks hidden": "the same, landmarks hidden: error at them",
    "cat_horse": "cat and horse, 17 landmarks",
}
COLUMNS = {
    "name": "surfaces",
    "maps": "maps",
    "error": "mean error in % (largest map)",
    "bad": "maps above 8 %",
    "turned": "half-turns",
    "uncertain": "uncertain: below 8 %, above 10 %",
    "expected": "expected error in %, rank correlation",
    "missed": "landmarks missed",
    "energy": "energy",
}
MORE_COLUMNS = {"d_iso": "mean D_iso", "seconds": "seconds"}  # which the manual lacks


class Bounds(NamedTuple):
    """The largest error and energy of a map, and the lowest PSNR of the remesh that it maps to; infinite without a bound."""

    first: str
    second: str
    kind: str
    error: float
    energy: float
    psnr: float


def read_bounds(path: Path) -> list[Bounds]:
    """reads lines of two names, a kind and three numbers, where '-' means no bound"""
    bounds = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            try:
                first, second, kind, error, energy, psnr = line.split()
                most = (math.inf if bound == "-" else float(bound) for bound in (error, energy))
                bounds.append(Bounds(first, second, kind, *most, -math.inf if psnr == "-" else float(psnr)))
            except ValueError:
                sys.exit(f"{path}: not two names, a kind and three numbers: {line}")
    return bounds


def read_pairs(path: Path) -> list[tuple[str, str, str, str]]:
    """reads two names and a kind in each line, and returns them with the folder of the pair; nothing if there is no such file"""
    lines = path.read_text().splitlines() if path.exists() else []
    return [(first, second, kind, first.split("/")[0]) for first, second, kind in map(str.split, lines)]


def combinations(pairs: list[tuple[str, str, str, str]], row: str) -> list[tuple[str, str]]:
    """returns the other combinations of first and second surfaces of a row, in both directions"""
    chosen = [(first, second) for first, second, _, folder in pairs if folder == row]
    others = [(first, second) for first, _ in chosen for _, second in chosen if (first, second) not in chosen]
    return [pair for first, second in others for pair in ((first, second), (second, first))]


def numbers_in(path: Path, first: int) -> np.ndarray:
    """returns the first number of each line, counted from 0"""
    return np.array([int(line.split()[0]) - first for line in path.read_text().splitlines() if line.strip()])


def distances(mesh: Mesh, sources: np.ndarray, targets: np.ndarray) -> np.ndarray:
    """returns the lengths of shortest paths along edges between pairs of vertices, over the root of the area, in percent"""
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import dijkstra

    points, faces = mesh.vertices, mesh.faces
    ends = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    lengths = 100.0 / np.sqrt(mesh.area()) * np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    graph = csr_matrix((lengths, (ends[:, 0], ends[:, 1])), (len(points), len(points)))
    result = np.full(len(sources), np.inf)
    for limit in (5.0, 20.0, np.inf):  # most paths are short, and those from a vertex to all others take long
        left = np.isinf(result)
        if left.any():
            origins, inverse = np.unique(sources[left], return_inverse=True)
            result[left] = dijkstra(graph, directed=False, indices=origins, limit=limit)[inverse, targets[left]]
    return result


class Pairs:
    """The pairs of a folder, mapped by the program."""

    def __init__(self, program: Path, folder: Path | None, meshes: Path | None, work: Path, noise: int | None) -> None:
        self.program, self.folder, self.meshes, self.work, self.noise = program.resolve(), folder, meshes, work, noise
        self.results: dict[str, list[dict[str, Any]]] = {}

    def mesh(self, name: str) -> Path:
        """unpacks a mesh, and adds the noise, which depends on the seed and on the name"""
        for extension in (".off", ".obj"):
            packed = self.folder / (name + extension + ".gz")
            if packed.exists():
                path = self.work / (name.replace("/", "_") + extension)
                path.write_bytes(gzip.decompress(packed.read_bytes()))
                if self.noise is not None:
                    mesh = read_mesh(path)
                    random = np.random.default_rng([self.noise, *name.encode()])
                    size = 1e-5 * np.ptp(mesh.vertices, axis=0).max()
                    write_mesh(path, Mesh(mesh.vertices + random.normal(scale=size, size=mesh.vertices.shape), mesh.faces))
                return path
        raise FileNotFoundError(f"{self.folder / name}: there is no such mesh")

    def landmarks(self, name: str) -> Path:
        """writes a file with the landmarks of a mesh, whose lines may have more numbers than the index"""
        path = self.folder / (name + ".vts")
        path = path if path.exists() else self.folder / (name.replace("input", "landmarks") + ".txt")
        written = self.work / (name.replace("/", "_") + ".landmarks")
        written.write_text("".join(f"{index}\n" for index in numbers_in(path, 0)), encoding="utf-8")
        return written

    def energy(self, facts: dict[str, Any]) -> float:
        """returns the mean of both averages of the energy"""
        energy = facts["match"]["energy"]
        return 0.5 * float(energy["average"] + energy["average_over_target"])

    def execute(self, arguments: list[Any]) -> dict[str, Any]:
        """runs the program, and returns its report"""
        report = self.work / "result.json"
        outcome = run_command([self.program, *arguments, "--json", report, "--quiet"])
        if outcome.status != 0:
            raise SystemExit(outcome.message)
        facts: dict[str, Any] = json.loads(report.read_text())
        return facts

    def map_pair(self, first: str, second: str, kind: str) -> tuple[dict[str, Any], Mesh, np.ndarray]:
        """maps one surface onto another one, and returns the report, the target, and the images of the vertices"""
        paths = [self.mesh(first), self.mesh(second)]
        result = self.work / "result.off"
        arguments: list[Any] = ["match", *paths, "-o", result]
        if kind == "landmarks":
            arguments += ["--landmarks", self.landmarks(first), self.landmarks(second)]
        else:
            arguments += ["--expected-errors", self.work / "lh.errors"]
        return self.execute(arguments), read_mesh(paths[1]), read_mesh(result).vertices

    def run(self, first: str, second: str, kind: str, row: str) -> None:
        """maps one surface onto another one, for a row of the table"""
        facts, target, images = self.map_pair(first, second, kind)
        facts["error"], facts["is_swapped"], facts["correlation"] = 0.0, False, 0.0
        if kind != "landmarks":
            from scipy.spatial import cKDTree
            from scipy.stats import spearmanr

            base = 1 if kind == "corres" else 0
            known = numbers_in(self.folder / (first + ".vts"), base)
            true = numbers_in(self.folder / (second + ".vts"), base)
            found = cKDTree(target.vertices).query(images[known])[1]
            errors = distances(target, true, found)
            facts["error"] = float(errors.mean())
            expected = np.frombuffer((self.work / "lh.errors").read_bytes()[15:], dtype=">f4")  # a file of FreeSurfer
            facts["correlation"] = float(spearmanr(expected[known], errors)[0])
            mirror = self.folder / (second + ".sym.vts")
            if mirror.exists():
                mirrored = numbers_in(mirror, 1)
                straight = np.linalg.norm(target.vertices[mirrored] - target.vertices[found], axis=1).mean()
                if 100.0 * straight / np.sqrt(target.area()) < facts["error"]:  # paths are longer
                    facts["is_swapped"] = float(distances(target, mirrored, found).mean()) < facts["error"]
        print(first, second, f"{facts['error']:.2f}", file=sys.stderr)
        self.results.setdefault(row, []).append(facts)

    def figures(self, pair: Bounds) -> Bounds | None:
        """returns the bounded figures of a pair, or nothing if its files are missing"""
        error, psnr = -math.inf, math.inf
        if pair.kind == "remesh":  # of a mesh of CGAL; each vertex should be mapped to itself
            if self.meshes is None:
                return None
            path, remesh, result = self.meshes / f"{pair.first}.off", self.work / "remesh.off", self.work / "result.off"
            psnr = float(self.execute(["remesh", path, pair.second, "-o", remesh])["remesh"]["psnr"])
            facts = self.execute(["match", path, remesh, "-o", result])
            target, images, true = read_mesh(remesh), read_mesh(result).vertices, read_mesh(path).vertices
        elif self.folder is None:
            return None
        else:
            facts, target, images = self.map_pair(pair.first, pair.second, pair.kind)
            if pair.kind == "corres":
                images = images[numbers_in(self.folder / (pair.first + ".vts"), 1)]
                true = target.vertices[numbers_in(self.folder / (pair.second + ".vts"), 1)]
        if pair.kind != "landmarks":
            error = 100.0 * float(np.linalg.norm(images - true, axis=1).mean() / np.sqrt(target.area()))
        return Bounds(*pair[:3], error, self.energy(facts), psnr)

    def check(self, bounds: list[Bounds]) -> None:
        """compares pairs with their bounds"""
        failures, count = [], 0
        for pair in bounds:
            found = self.figures(pair)
            if found is None:
                continue
            count += 1
            shown = (f"{x:.4f}" if math.isfinite(x) else "-" for x in found[3:])
            print(*found[:3], *shown)
            if not (found.error <= pair.error and found.energy <= pair.energy and found.psnr >= pair.psnr):
                failures.append(f"{pair.first} {pair.second} exceeds {pair.error:g}, {pair.energy:g} or {pair.psnr:g}")
        sys.exit("\n".join(failures) or (0 if count else "The files of all pairs are missing."))

    def rows(self) -> list[dict[str, str]]:
        """returns a row of the table for each kind of pairs"""
        rows = []
        for name in [*(row for row in ROWS if row in self.results), *(row for row in self.results if row not in ROWS)]:
            runs = self.results[name]
            errors = [run["error"] for run in runs]
            match = [run["match"] for run in runs]
            n_landmarks = sum(len(m["landmark_distances"]) for m in match)
            row = {"name": ROWS.get(name, name), "maps": str(len(runs))}
            if any(errors):
                flagged = [error for m, error in zip(match, errors) if m["is_uncertain"]]
                n_wrong = sum(error > 10.0 for error in errors)
                expected = statistics.mean(100 * m["expected_error"] for m in match)
                correlation = statistics.mean(run["correlation"] for run in runs)
                row |= {"error": f"{statistics.mean(errors):.2f} ({max(errors):.2f})"}
                row |= {"bad": str(sum(error > 8.0 for error in errors))}
                row |= {"turned": str(sum(run["is_swapped"] for run in runs))}
                counts = [sum(error < 8.0 for error in flagged), sum(error > 10.0 for error in flagged)]
                row |= {"uncertain": f"{counts[0]}, {counts[1]} of {n_wrong}"}
                row |= {"expected": f"{expected:.2f}, {correlation:.2f}"}
            if n_landmarks:
                row |= {"missed": f"{sum(m['missed_landmarks'] for m in match)} of {n_landmarks}"}
            row |= {"energy": f"{statistics.mean(self.energy(run) for run in runs):.2f}"}
            row |= {"d_iso": f"{statistics.mean(m['D_iso']['average'] for m in match):.2f}"}
            seconds = [run["seconds"]["total"] - run["seconds"]["output"] for run in runs]
            rows.append(row | {"seconds": f"{statistics.mean(seconds):.1f}"})
        return rows


def main() -> None:
    """reads the command line"""
    driver = Driver(__doc__, folders=("pairs",))
    driver.add_program()
    driver.add_argument("--pairs", type=Path, metavar="FOLDER", help="the folder of pairs")
    driver.add_argument("--cgal-meshes", type=Path, metavar="FOLDER", help="the folder of the meshes of CGAL, for --bounds")
    driver.add_argument("--bounds", type=Path, metavar="FILE", help="bounds that pairs are compared with")
    driver.add_argument("--manual", type=Path, metavar="FILE", help="a page of the manual whose table is filled in")
    driver.add_argument("--noise", type=int, metavar="SEED", help="add noise to the coordinates")
    arguments = driver.parse()
    if not (arguments.pairs or arguments.bounds):
        driver.error("--pairs or --bounds is needed")
    with tempfile.TemporaryDirectory() as work:
        pairs = Pairs(arguments.program, arguments.pairs, arguments.cgal_meshes, Path(work), arguments.noise)
        if arguments.bounds:
            pairs.check(read_bounds(arguments.bounds))
        for first, second, kind, row in read_pairs(arguments.pairs / "pairs.txt"):
            for one, other in ((first, second), (second, first)):
                pairs.run(one, other, kind, row)
                if kind == "landmarks" and (arguments.pairs / (one + ".vts")).exists():
                    pairs.run(one, other, "hidden", f"{row}, landmarks hidden")
        for one, other in combinations(read_pairs(arguments.pairs / "pairs.txt"), "tosca_between"):
            pairs.run(one, other, "corres", "tosca_between, combinations")
        for first, second, kind, row in read_pairs(arguments.pairs / "pairs_wide.txt"):
            pairs.run(first, second, kind, f"{row}, random")
        rows = pairs.rows()
        print(table(COLUMNS | MORE_COLUMNS, rows))
        if arguments.manual:
            text = arguments.manual.read_text(encoding="utf-8")
            arguments.manual.write_text(fill_in(text, "pairs", table(COLUMNS, rows) + "\n"), encoding="utf-8")


if __name__ == "__main__":
    main()
