#!/usr/bin/env python3
"""Maps pairs of surfaces onto each other, in both directions, and prints the table of the user manual.

FOLDER has pairs.txt, with two names and a kind in each line. The meshes are NAME.off.gz or NAME.obj.gz. Of the kind `corres`, the
files NAME.vts of both have the vertices that correspond, line by line, counted from 1, and NAME.sym.vts their mirror images. Of the kind
`landmarks`, NAME.vts, or for NAME/input0 and NAME/input1 the files NAME/landmarks0.txt and so on, have landmarks, counted from 0. Takes five
minutes; needs numpy and scipy.
"""

from __future__ import annotations

import gzip
import json
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any

sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))

import numpy as np
from measuring.commands import run_command
from measuring.drivers import Driver
from measuring.meshes import Mesh, read_mesh
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree


def numbers_in(path: Path, first: int) -> np.ndarray:
    """returns the first number of each line, counted from 0"""
    return np.array([int(line.split()[0]) - first for line in path.read_text().splitlines() if line.strip()])


def distances(mesh: Mesh, sources: np.ndarray) -> np.ndarray:
    """returns the lengths of shortest paths along edges, over the square root of the area, in percent"""
    points, faces = mesh.vertices, mesh.faces
    ends = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    lengths = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    graph = csr_matrix((lengths, (ends[:, 0], ends[:, 1])), (len(points), len(points)))
    return np.asarray(100.0 * dijkstra(graph, directed=False, indices=sources) / np.sqrt(mesh.area()))


class Pairs:
    """The pairs of a folder, mapped by the program."""

    def __init__(self, program: Path, folder: Path, work: Path) -> None:
        self.program, self.folder, self.work = program, folder, work
        self.results: dict[str, list[dict[str, Any]]] = {}

    def mesh(self, name: str) -> Path:
        """unpacks a mesh"""
        for extension in (".off", ".obj"):
            packed = self.folder / (name + extension + ".gz")
            if packed.exists():
                path = self.work / (name.replace("/", "_") + extension)
                path.write_bytes(gzip.decompress(packed.read_bytes()))
                return path
        raise FileNotFoundError(f"{self.folder / name}: there is no such mesh")

    def landmarks(self, name: str) -> Path:
        """returns the file with the landmarks of a mesh"""
        path = self.folder / (name + ".vts")
        return path if path.exists() else self.folder / (name.replace("input", "landmarks") + ".txt")

    def run(self, first: str, second: str, kind: str) -> None:
        """maps one surface onto another one"""
        paths = [self.mesh(first), self.mesh(second)]
        result, report = self.work / "result.off", self.work / "result.json"
        command = [str(self.program), str(paths[0]), "--onto", str(paths[1]), "-o", str(result), "--json", str(report), "--quiet"]
        if kind == "landmarks":
            command += ["--landmarks", str(self.landmarks(first)), str(self.landmarks(second))]
        outcome = run_command(command)
        if outcome.status != 0:
            raise SystemExit(outcome.message)
        facts = json.loads(report.read_text())
        facts["error"], facts["is_swapped"] = 0.0, False
        if kind == "corres":
            target, images = read_mesh(paths[1]), read_mesh(result).vertices
            places = numbers_in(self.folder / (first + ".vts"), 1)
            true = numbers_in(self.folder / (second + ".vts"), 1)
            sources, inverse = np.unique(true, return_inverse=True)
            found = cKDTree(target.vertices).query(images[places])[1]
            facts["error"] = float(distances(target, sources)[inverse, found].mean())
            mirror = self.folder / (second + ".sym.vts")
            if mirror.exists():
                sources, inverse = np.unique(numbers_in(mirror, 1), return_inverse=True)
                facts["is_swapped"] = float(distances(target, sources)[inverse, found].mean()) < facts["error"]
        print(first, second, f"{facts['error']:.2f}", file=sys.stderr)
        self.results.setdefault(first.split("/", maxsplit=1)[0], []).append(facts)

    def print_table(self) -> None:
        """prints a row for each folder of meshes"""
        for name, runs in self.results.items():
            errors = [run["error"] for run in runs]
            match = [run["match"] for run in runs]
            n_landmarks = sum(len(m["landmark_distances"]) for m in match)
            cells = [
                name,
                str(len(runs)),
                f"{statistics.mean(errors):.2f} ({max(errors):.2f})" if any(errors) else "",
                str(sum(run["is_swapped"] for run in runs)) if any(errors) else "",
                f"{sum(m['missed_landmarks'] for m in match)} of {n_landmarks}" if n_landmarks else "",
                f"{statistics.mean(0.5 * (m['energy']['average'] + m['energy']['average_over_target']) for m in match):.2f}",
                f"{statistics.mean(m['D_iso']['average'] for m in match):.2f}",
                f"{statistics.mean(run['seconds']['total'] - run['seconds']['output'] for run in runs):.1f}",
            ]
            print("| " + " | ".join(cells) + " |")


def main() -> None:
    """reads the command line"""
    driver = Driver(__doc__, folders=("pairs",))
    driver.add_program()
    driver.add_argument("--pairs", type=Path, required=True, metavar="FOLDER", help="the folder of pairs")
    arguments = driver.parse()
    with tempfile.TemporaryDirectory() as work:
        pairs = Pairs(arguments.program, arguments.pairs, Path(work))
        for line in (arguments.pairs / "pairs.txt").read_text().splitlines():
            first, second, kind = line.split()
            pairs.run(first, second, kind)
            pairs.run(second, first, kind)
        pairs.print_table()


if __name__ == "__main__":
    main()
