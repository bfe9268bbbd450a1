#!/usr/bin/env python3
"""Tests draw_figures.py on one small mesh, the figures that the manual has, and what finds the visible faces.

Usage: test_draw_figures.py PROGRAM MESH [options of unittest]
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

FOLDER = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True  # leaves the sources as they are
sys.path += [str(FOLDER), str(FOLDER.parent / "python")]

import numpy as np
from draw_figures import FIGURES, MANUAL
from PIL import Image
from rendering.fragments import find_fragments
from rendering.views import turned_like, view_of_surface

SCRIPT = FOLDER / "draw_figures.py"
SCALE = 0.25
MOST_BYTES_OF_MANUAL = 1_500_000


def draw(*arguments):
    command = [sys.executable, str(SCRIPT), "--program", PROGRAM, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Drawing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.arguments = ["--mesh", MESH, "--scale", SCALE, "--runs", cls.folder / "runs"]
        cls.answer = draw(*cls.arguments, "--output", cls.folder / "first")

    def test_every_figure_is_drawn(self):
        self.assertEqual(self.answer.returncode, 0, self.answer.stderr)
        for name, figure in FIGURES.items():
            with self.subTest(name), Image.open(self.folder / "first" / figure.file) as image:
                pixels = np.asarray(image.convert("RGB"))
                is_white = (pixels > 220).all(axis=2)  # JPEG rings
                self.assertGreater(np.mean(~is_white), 0.05, "the figure is empty")
                self.assertGreater(np.mean(is_white), 0.05, "the figure has no background")
                rim = np.concatenate([is_white[0], is_white[-1], is_white[:, 0], is_white[:, -1]])
                self.assertTrue(rim.all(), "something is cut off")

    def test_figures_have_the_same_bytes_again(self):
        names = ["texture", "distortion", "radius_rules"]
        answer = draw(*self.arguments, "--output", self.folder / "second", "--only", ",".join(names))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(len(list((self.folder / "second").iterdir())), len(names))
        for name in names:
            first, second = (self.folder / run / FIGURES[name].file for run in ("first", "second"))
            self.assertEqual(first.read_bytes(), second.read_bytes(), name)

    def test_meshes_that_are_missing_are_named(self):
        empty = self.folder / "empty"
        empty.mkdir()
        answer = draw("--meshes", empty, "--output", self.folder / "nothing", "--only", "opening,texture")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("armadillo_26002 and horse_19851", answer.stderr)
        self.assertFalse((self.folder / "nothing").exists())

    def test_a_mesh_without_a_map_is_named(self):
        mesh = self.folder / "triangle.off"
        mesh.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        answer = draw("--mesh", mesh, "--output", self.folder / "none", "--only", "opening")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("triangle.off: there is no map to draw", answer.stderr)

    def test_the_manual_has_these_figures(self):
        for figure in FIGURES.values():
            with Image.open(self.folder / "first" / figure.file) as small, Image.open(MANUAL / figure.file) as large:
                for a, b in zip(small.size, large.size):
                    self.assertAlmostEqual(a / SCALE, b, delta=0.5 / SCALE, msg=figure.file)
        self.assertLess(sum(file.stat().st_size for file in MANUAL.iterdir()), MOST_BYTES_OF_MANUAL)


class Fragments(unittest.TestCase):
    def test_the_nearest_of_random_triangles_is_seen(self):
        random, size, number = np.random.default_rng(1), 40, 60
        points = random.uniform(-10.0, size + 10.0, (3 * number, 3))
        faces = np.arange(3 * number).reshape(number, 3)
        # As many portions as a large mesh has, each of which has to leave what is nearer in the others.
        with unittest.mock.patch("rendering.fragments.MOST_AT_ONCE", 100):
            fragments = find_fragments(points, faces, size)
        seen = {(p // size, p % size): (f, z) for p, f, z in zip(fragments.pixel, fragments.face, fragments.depth)}
        for y in range(size):
            for x in range(size):
                depth, face = -np.inf, -1
                for f in range(number):
                    matrix = np.vstack([points[faces[f]][:, :2].T, np.ones(3)])
                    weights = np.linalg.solve(matrix, [x + 0.5, y + 0.5, 1.0])
                    z = weights @ points[faces[f]][:, 2]
                    if weights.min() >= 0.0 and z > depth:
                        depth, face = z, f
                seen_face, seen_depth = seen.get((y, x), (-1, -np.inf))
                self.assertEqual(seen_face, face, (x, y))
                self.assertAlmostEqual(seen_depth, depth)

    def test_a_sphere_is_covered_without_gaps(self):
        size, rings = 64, 24
        angles = np.pi * np.arange(rings + 1) / rings
        longitude, latitude = np.meshgrid(2.0 * angles[:-1], angles)
        points = np.stack(
            [np.sin(latitude) * np.cos(longitude), np.sin(latitude) * np.sin(longitude), np.cos(latitude)]
        )
        points = 0.5 * size + 0.45 * size * points.reshape(3, -1).T
        i, j = (x.ravel() for x in np.meshgrid(np.arange(rings), np.arange(rings)))
        a, b = i * rings + j, i * rings + (j + 1) % rings
        faces = np.concatenate([np.stack([a, a + rings, b], 1), np.stack([b, a + rings, b + rings], 1)])
        with np.errstate(all="raise"):  # the faces at the poles have no area
            fragments = find_fragments(points, faces, size)
        y, x = (values.ravel() for values in np.mgrid[:size, :size] + 0.5)
        inside = np.flatnonzero(np.hypot(x - 0.5 * size, y - 0.5 * size) < 0.44 * size)
        self.assertEqual(len(np.setdiff1d(inside, fragments.pixel)), 0, "there is a gap")
        self.assertTrue((fragments.depth[np.isin(fragments.pixel, inside)] >= 0.5 * size).all(), "the back is seen")
        seen = fragments.interpolate(faces, points)
        np.testing.assert_allclose(seen[:, 0], x[fragments.pixel], atol=1e-6)
        np.testing.assert_allclose(seen[:, 1], y[fragments.pixel], atol=1e-6)


class Views(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(2)
        self.points = self.random.normal(size=(200, 3)) * [1.0, 3.0, 0.3] + 5.0

    def test_a_surface_fits_into_its_picture(self):
        size = 100
        for direction in [None, *self.random.normal(size=(20, 3)), (0.0, 1.0, 0.0)]:
            seen = view_of_surface(self.points, direction).pixels_of(self.points, size)[:, :2]
            self.assertTrue((seen > 1.0).all() and (seen < size - 1.0).all(), "something is cut off")
            np.testing.assert_allclose(seen.min(axis=0) + seen.max(axis=0), size)
            self.assertGreater(np.ptp(seen, axis=0).max(), 0.94 * size, "the picture is too small")

    def test_a_sphere_is_turned_like_its_surface(self):
        points = self.points - 0.5 * (self.points.min(axis=0) + self.points.max(axis=0))
        directions = points / np.linalg.norm(points, axis=1, keepdims=True)
        rotation, _ = np.linalg.qr(self.random.normal(size=(3, 3)))
        rotation *= np.linalg.det(rotation)
        faces = np.arange(len(points) - 2)[:, None] + [0, 1, 2]
        turned = turned_like(self.points, directions @ rotation, faces)
        np.testing.assert_allclose(turned, turned_like(self.points, directions, faces), atol=1e-9)
        self.assertGreater(np.mean(np.einsum("ij,ij->i", turned, directions)), 0.9)
        turned = turned_like(self.points, -directions, faces)
        self.assertAlmostEqual(np.linalg.det(turned[:3]), np.linalg.det(-directions[:3]), msg="the sphere is mirrored")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAM, MESH = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
