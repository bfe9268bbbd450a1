#!/usr/bin/env python3
"""Tests what the drivers of the benchmarks stand on: the judge, the runs of programs, the statistics, the pictures.

Usage: test_drivers.py PROGRAM [options of unittest]
"""

import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

FOLDER = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path += [str(FOLDER / folder) for folder in ("python", "Performance", "Quality", "Figures")]

import numpy as np
from compare_builds import ratio_with_interval, verdict_of
from draw_figures import FIGURES
from measure_ablation import HEURISTICS, INTERNAL, apply_changes
from measuring.commands import MappingProgram, run_command
from measuring.drivers import MANUAL, PROJECT
from measuring.maps import map_between
from measuring.meshes import Mesh, MeshError, MeshFile, read_mesh, read_number_of_vertices, refine_along_one_axis
from measuring.meshes import refine_one_side, subdivide_smoothly, write_mesh
from measuring.pictures import find_fragments, turned_like, view_of_surface
from PIL import Image

FACES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]


def octahedron(top=(0.0, 0.0, 1.0), faces=FACES):
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), top, (0, 0, -1)]
    return Mesh(np.array(points, float), np.array(faces))


def double_cover():
    """All faces are positive, but the star of either pole is a pentagram."""
    angles = 0.8 * np.pi * np.arange(5)
    points = [*zip(np.cos(angles), np.sin(angles), np.zeros(5)), (0, 0, 1), (0, 0, -1)]
    faces = [(i, (i + 1) % 5, 5) for i in range(5)] + [((i + 1) % 5, i, 6) for i in range(5)]
    return Mesh(np.array(points, float), np.array(faces))


def run_driver(script, *arguments):
    command = [sys.executable, str(FOLDER / script), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class WithFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def write(self, name, mesh):
        write_mesh(self.folder / name, mesh)
        return self.folder / name


class Judge(unittest.TestCase):
    def objection(self, mesh, sphere, **options):
        return map_between(mesh, sphere, **options).objection()

    def test_one_to_one_maps(self):
        mesh = octahedron()
        self.assertEqual(self.objection(mesh, mesh), "")
        other_order = [np.roll(face, i) for i, face in enumerate(FACES[::-1])]
        self.assertEqual(self.objection(mesh, octahedron(faces=other_order)), "")
        self.assertEqual(self.objection(octahedron((0.3, 0.2, 2.0)), octahedron((0.6, 0.0, 0.8))), "")
        mirrored = Mesh(-mesh.vertices, mesh.faces)
        self.assertEqual(self.objection(mesh, mirrored, may_be_mirrored=True), "")
        self.assertIn("8 of 8 faces are inverted", self.objection(mesh, mirrored))
        for scale in (1e-300, 1e300):
            scaled = Mesh(scale * mesh.vertices, mesh.faces)
            self.assertEqual(self.objection(scaled, scaled), "")
            self.assertAlmostEqual(map_between(scaled, mesh).distortion().isometric.maximum, 1.0)

    def test_what_is_none(self):
        mesh = octahedron()
        self.assertIn("4 of 8 faces are inverted", self.objection(mesh, octahedron((0.6, 0.0, -0.8))))
        on_equator = octahedron((0.6, 0.8, 0.0))
        self.assertIn("4 of 8 faces are inverted", self.objection(mesh, on_equator))
        self.assertIn("on no sphere", self.objection(mesh, octahedron((0.0, 0.0, 1.001))))
        self.assertIn("cover the sphere 2 times", self.objection(double_cover(), double_cover()))
        opened = octahedron(faces=FACES[:-1])
        self.assertIn("no closed surface", self.objection(opened, opened))
        for sphere in (octahedron(faces=[*FACES[:-1], (0, 5, 3)]), opened, octahedron((0.0, 0.0, np.inf))):
            self.assertRaises(MeshError, map_between, mesh, sphere)

    def test_exact_signs(self):
        """A vertex on an edge, or as little beside it as doubles can distinguish."""
        shear = np.array([[1.0, 3.0, 7.0], [0.0, 1.0, 5.0], [0.0, 0.0, 1.0]])  # no sign changes, but much cancels
        for z, number_inverted in ((0.0, 4), (5e-324, 0), (-5e-324, 4), (2.0**-50, 0), (-(2.0**-50), 4)):
            sphere = octahedron((0.5, 0.5, z))
            if abs(z) > 1e-300:
                sphere = Mesh(sphere.vertices @ shear, sphere.faces)
            self.assertEqual(map_between(octahedron(), sphere).number_inverted, number_inverted, z)

    def test_distortions(self):
        distortion = map_between(octahedron(), octahedron((0.6, 0.0, 0.8))).distortion()
        for statistics, expected in ((distortion.isometric, (1.533, 1.225)), (distortion.angle, (2.309, 2.108))):
            self.assertEqual((round(statistics.maximum, 3), round(statistics.average, 3)), expected)


class Meshes(WithFolder):
    def test_formats(self):
        mesh = octahedron((0.1, 1.0 / 3.0, 1e-17))
        for ending in (".off", ".ply", ".obj"):
            path = self.write(f"mesh{ending}", mesh)
            again = read_mesh(path)
            self.assertEqual(read_number_of_vertices(path), 6)
            np.testing.assert_array_equal(again.vertices, mesh.vertices)
            np.testing.assert_array_equal(again.faces, mesh.faces)
        header = (self.folder / "mesh.ply").read_bytes().partition(b"end_header\n")[0]
        for order, name in (("<", b"binary_little_endian"), (">", b"binary_big_endian")):
            faces = np.array([(3, face) for face in mesh.faces], [("n", "u1"), ("f", order + "i4", 3)])
            content = header.replace(b"ascii", name) + b"end_header\n" + mesh.vertices.astype(order + "f8").tobytes()
            path = self.folder / "binary.ply"
            path.write_bytes(content + faces.tobytes())
            np.testing.assert_array_equal(read_mesh(path).vertices, mesh.vertices)
            np.testing.assert_array_equal(read_mesh(path).faces, mesh.faces)

    def test_files_that_are_none(self):
        path = self.write("mesh.off", octahedron())
        text = path.read_text()
        faces = [text.replace("3 0 2 4", other) for other in ("4 0 2 4 1", "3 0 2 7")]
        for wrong in ("", "nothing", text[:-9], *faces):
            path.write_text(wrong)
            self.assertRaises(MeshError, read_mesh, path)

    def test_refinements_are_closed(self):
        mesh = octahedron((0.3, 0.2, 2.0))
        for refined in (subdivide_smoothly(mesh), refine_one_side(mesh, 2), refine_along_one_axis(mesh, 2)):
            self.assertEqual(refined.objection(), "")
            self.assertGreater(len(refined.faces), len(mesh.faces))
        self.assertAlmostEqual(refine_one_side(mesh, 2).area(), mesh.area())


class Programs(WithFolder):
    def verdict(self, command, mesh=octahedron(), max_seconds=0.0, max_bytes=0.0):
        file = MeshFile(self.write("it's a mesh.off", mesh))
        mapping = MappingProgram("", command, self.folder, max_seconds, max_bytes).run(file)
        return mapping.verdict, mapping.reason

    def test_verdicts(self):
        copy = "cp {input} {output}"
        self.assertEqual(self.verdict(copy)[0], "certified")
        self.assertEqual(self.verdict("cp {input.obj} {output.obj}")[0], "certified")
        self.assertEqual(self.verdict("cp {input.ply} {output}")[0], "no map")
        inverted = self.write("inverted.ply", octahedron((0.6, 0.0, -0.8)))
        self.assertEqual(self.verdict(f"cp '{inverted}' {{output.ply}} # {{input}}")[0], "not bijective")
        self.assertEqual(self.verdict("echo {input}: bad luck >&2; exit 1 # {output}"), ("refused", "bad luck"))
        self.assertEqual(self.verdict("true {input} {output}"), ("no map", "succeeded, but wrote no map"))
        self.assertEqual(self.verdict("./no_such {input} {output}")[0], "not run")
        self.assertEqual(self.verdict("kill -SEGV $$ # {input} {output}"), ("broke down", "ended by SIGSEGV"))
        self.assertEqual(self.verdict("sh -c 'kill -SEGV $$' && true {input} {output}")[0], "broke down")
        self.assertEqual(self.verdict("sleep 9 & sleep 9 # {input} {output}", max_seconds=0.2)[0], "timed out")
        work = "head -c 300000000 /dev/zero | tail -n 1 > /dev/null && cp {input} {output}"
        self.assertEqual(self.verdict(work)[0], "certified")
        self.assertEqual(self.verdict(work, max_bytes=1e8)[0], "refused")
        for wrong in ("cp {input} .", "cat {input} {input.ply} > {output}", "cp {input} {output.stl}"):
            self.assertRaises(SystemExit, self.verdict, wrong)

    def test_what_a_command_uses(self):
        work = "import time; x = [0] * 20_000_000; t = time.process_time()\nwhile time.process_time() < t + 0.1: pass"
        outcome = run_command(["/bin/sh", "-c", f"'{sys.executable}' -c '{work}'; true"])
        self.assertGreater(outcome.cpu_seconds, 0.1)
        self.assertGreater(outcome.peak_bytes, 1e8)
        self.assertLess(run_command(["/bin/true"]).peak_bytes, 3e7)  # and not the memory of this process

    def test_robustness(self):
        for name, top in (("hard_a", 1.0), ("inverted", -0.8), ("invalid_b", 1.0)):
            self.write(f"{name}.off", octahedron((0.6 * (top < 0.0), 0.0, top)))
        command = "case {input} in *invalid*) exit 1;; esac; cp {input} {output}"
        answer = run_driver("Robustness/robustness_benchmark.py", "--program", command, "--list", self.folder)
        self.assertEqual(answer.returncode, 1, answer.stderr)
        self.assertRegex(answer.stdout, r"\| all +\| +3 \| +1 \| +1 \| +1 \|")
        self.assertRegex(answer.stdout, r"hard_\* +\| +1 \| +1 \| +0 \| +0 \|")
        self.assertIn("inverted.off: 4 of 8 faces are inverted", answer.stdout)

    def test_comparison(self):
        mesh, tilted = self.write("mesh.off", octahedron()), self.write("tilted.off", octahedron((0.6, 0.0, 0.8)))
        package = self.folder / "package"
        package.write_text('#!/bin/sh\ncp "$1" "$3"\n')
        package.chmod(stat.S_IRWXU)
        programs = [f"tilted=cp '{tilted}' {{output}} # {{input}}", "bad=exit 1 # {input} {output}"]
        programs = [word for program in programs for word in ("--program", program)]
        arguments = ["--package", package, *programs, "--repeat", 2, mesh]
        answer = run_driver("Performance/comparison_benchmark.py", *arguments)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        ratios = r"1\.533 \| +1\.225 \| +1\.414 \| +1\.266 \| +1\.155 \| +1\.054 \|"
        self.assertRegex(answer.stdout, rf"\| mesh +\| tilted +\| certified \| +0 \| +1\.533 .* {ratios}")
        self.assertRegex(answer.stdout, rf"(?s)geometric means.*\| tilted +\| +1 \| +1 \| +0 \| +0 \| +1 \|.* {ratios}")
        self.assertRegex(answer.stdout, r"\| bad +\| +1 \| +0 \| +0 \| +1 \| +0 \|")
        answer = run_driver("Performance/comparison_benchmark.py", "--package", "false", mesh)
        self.assertEqual(answer.returncode, 1, answer.stdout)

    def test_quality(self):
        mesh = self.write("mesh.off", subdivide_smoothly(octahedron((0.3, 0.2, 2.0))))
        bounds = self.folder / "bounds.txt"
        arguments = ["--program", PROGRAM, "--bounds", bounds, mesh]
        for bound, status in (("9", 0), ("1.001", 1)):
            bounds.write_text(f"# a comment\nmesh symmetric-dirichlet/worst D_iso {bound} -\n")
            answer = run_driver("Quality/quality_benchmark.py", *arguments)
            self.assertEqual(answer.returncode, status, answer.stderr)
            self.assertEqual("D_iso maximum is" in answer.stderr, status == 1)
        bounds.write_text("other symmetric-dirichlet/worst D_iso 9 -\n")
        self.assertIn("There are none", run_driver("Quality/quality_benchmark.py", *arguments).stderr)


class Builds(WithFolder):
    def test_statistics(self):
        random = np.random.default_rng(3)

        def verdict(ratio, noise):
            return verdict_of(*ratio_with_interval(np.log(ratio) + noise * random.standard_normal(40), 0.01)[1:])

        self.assertEqual(verdict(1.0, 0.02), "same")
        self.assertEqual(verdict(1.05, 0.02), "slower")
        self.assertEqual(verdict(1 / 1.05, 0.02), "faster")
        self.assertEqual(verdict(1.02, 0.3), "unclear")
        misses = 0
        for _ in range(400):  # the interval misses 1 as often as it may
            _, low, high = ratio_with_interval(0.1 * random.standard_normal(12), 0.1)
            misses += not low < 1.0 < high
        self.assertTrue(15 < misses < 65, misses)

    def test_comparison(self):
        """With programs that take no time, but claim to: a tenth more for one of the kernels."""
        for name, factor in (("a", 1.0), ("b", 1.1)):
            entries = [("load", 100.0), ("sweep/real_time", 100.0 * factor)]
            results = [
                f'{{"name": "{kernel}", "run_type": "iteration", "items_per_second": {1e9 / nanoseconds}}}'
                for kernel, nanoseconds in entries
            ]
            path = self.folder / name
            text = f"""case $1 in *list*) printf 'load\\nsweep/real_time\\nmachine_bytes\\n';;
                *) echo {name} >> '{self.folder}/calls'; echo '{{"benchmarks": [{", ".join(results)}]}}';; esac"""
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(stat.S_IRWXU)
        builds = [self.folder / "a", self.folder / "b"]
        answer = run_driver("Performance/compare_builds.py", "--short", "--fail-above", 5, *builds)
        self.assertEqual(answer.returncode, 1, answer.stderr)
        self.assertRegex(answer.stdout, r"\| load +\| +100\.00 \| +100\.00 \| +1\.0000 .*\| same +\|")
        self.assertRegex(answer.stdout, r"\| sweep +\| +100\.00 \| +110\.00 \| +1\.1000 .*\| slower +\|")
        calls = (self.folder / "calls").read_text().split()
        rounds = {"".join(calls[k : k + 2]) for k in range(0, len(calls), 2)}
        self.assertEqual((len(calls), rounds), (24, {"ab", "ba"}))  # in turn, and in random order
        for wrong, text in ((["--rounds", 6, *builds], "make more"), ([builds[0], "no-such-build"], "no git revision")):
            answer = run_driver("Performance/compare_builds.py", *wrong)
            self.assertEqual(answer.returncode, 2)
            self.assertIn(text, answer.stderr)


class Ablation(WithFolder):
    def test_heuristics_are_in_the_headers(self):
        for heuristic, alternatives in HEURISTICS.items():
            for alternative, changes in alternatives.items():
                with self.subTest(heuristic, alternative=alternative):
                    shutil.copytree(PROJECT / INTERNAL, self.folder / INTERNAL, dirs_exist_ok=True)
                    apply_changes(changes, self.folder)


class Pictures(WithFolder):
    def test_the_nearest_of_random_triangles_is_seen(self):
        random, size, number = np.random.default_rng(1), 24, 30
        points = random.uniform(-6.0, size + 6.0, (3 * number, 3))
        faces = np.arange(3 * number).reshape(number, 3)
        # As many portions as a large mesh has, each of which has to leave what is nearer in the others.
        with unittest.mock.patch("measuring.pictures.MAX_AT_ONCE", 100):
            fragments = find_fragments(points, faces, size)
        x, y = (values.ravel() + 0.5 for values in np.meshgrid(np.arange(size), np.arange(size)))
        places = np.stack([x, y, np.ones(size * size)])
        depths = np.full((number, size * size), -np.inf)
        for f in range(number):
            weights = np.linalg.solve(np.vstack([points[faces[f]][:, :2].T, np.ones(3)]), places)
            depths[f] = np.where(weights.min(axis=0) >= 0.0, points[faces[f]][:, 2] @ weights, -np.inf)
        is_seen = depths.max(axis=0) > -np.inf
        np.testing.assert_array_equal(fragments.pixel, np.flatnonzero(is_seen))
        np.testing.assert_array_equal(fragments.face, depths.argmax(axis=0)[is_seen])
        np.testing.assert_allclose(fragments.depth, depths.max(axis=0)[is_seen])

    def test_a_surface_fits_into_its_picture_and_a_sphere_is_turned_like_it(self):
        random = np.random.default_rng(2)
        points = random.normal(size=(200, 3)) * [1.0, 3.0, 0.3] + 5.0
        for direction in (None, random.normal(size=3), (0.0, 1.0, 0.0)):
            seen = view_of_surface(points, direction).pixels_of(points, 100)[:, :2]
            np.testing.assert_allclose(seen.min(axis=0) + seen.max(axis=0), 100)
            self.assertTrue(94 < np.ptp(seen, axis=0).max() < 98)
        centered = points - 0.5 * (points.min(axis=0) + points.max(axis=0))
        directions = centered / np.linalg.norm(centered, axis=1, keepdims=True)
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        faces = np.arange(len(points) - 2)[:, None] + [0, 1, 2]
        turned = turned_like(points, directions @ rotation * np.linalg.det(rotation), faces)
        np.testing.assert_allclose(turned, turned_like(points, directions, faces), atol=1e-9)
        self.assertGreater(np.mean(np.einsum("ij,ij->i", turned, directions)), 0.9)

    def test_figures_of_the_manual(self):
        mesh = octahedron((0.5, 0.0, 3.0))
        for _ in range(4):
            mesh = subdivide_smoothly(mesh)
        mesh, scale = self.write("mesh.ply", mesh), 0.25
        arguments = ["--program", PROGRAM, "--meshes", self.folder, "--mesh", mesh, "--scale", scale]
        arguments += ["--runs", self.folder / "runs"]
        answer = run_driver("Figures/draw_figures.py", *arguments, "--output", self.folder / "first")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        for file, _ in FIGURES.values():
            with Image.open(self.folder / "first" / file) as image, Image.open(MANUAL / "fig" / file) as of_manual:
                is_white = (np.asarray(image.convert("RGB")) > 220).all(axis=2)  # JPEG rings
                for a, b in zip(image.size, of_manual.size):
                    self.assertAlmostEqual(a / scale, b, delta=0.5 / scale, msg=file)
            self.assertTrue(0.05 < np.mean(is_white) < 0.95, f"{file} is empty, or has no background")
            rim = np.concatenate([is_white[0], is_white[-1], is_white[:, 0], is_white[:, -1]])
            self.assertTrue(rim.all(), f"something of {file} is cut off")
        arguments += ["--output", self.folder / "second", "--only", "texture"]
        answer = run_driver("Figures/draw_figures.py", *arguments)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        first, second = (self.folder / name / "texture.jpg" for name in ("first", "second"))
        self.assertEqual(first.read_bytes(), second.read_bytes())
        self.assertLess(sum(file.stat().st_size for file in (MANUAL / "fig").iterdir()), 1_700_000)

    def test_meshes_that_are_missing_are_named(self):
        arguments = ["--program", PROGRAM, "--meshes", self.folder, "--only", "opening,texture"]
        answer = run_driver("Figures/draw_figures.py", *arguments, "--output", self.folder / "nothing")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("armadillo_26002 and horse_19851", answer.stderr)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = os.path.abspath(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
