import copy
import locale
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
import warnings
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["PROGRAM"]
TETRAHEDRON = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
FACES = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])


def surface(n, bumps=0.4, shift=0.0, threads=None):
    """An octahedron whose edges are divided into n, with bumps."""
    p = sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("octahedron", n), threads=threads)
    x, y, z = p.sphere.T
    radius = 1 + bumps * np.sin(5 * x + shift) * np.cos(4 * y) + 0.2 * z
    return p.sphere * radius[:, None], p.faces


def map_of(n, shift=0.0, threads=None):
    vertices, faces = surface(n, shift=shift, threads=threads)
    return vertices, faces, sp.parameterize(vertices, faces, threads=threads)[0]


def ellipsoid(a, b, c, degree):
    """The coefficients of a surface."""
    result = np.zeros((3, 2, degree + 1, degree + 1))
    result[0, 0, 1, 1], result[1, 1, 1, 1], result[2, 0, 1, 0] = np.array([a, b, c]) / np.sqrt(3)
    return result


def make_calls(n, **settings):
    """Each function that has threads as a function of its settings, which returns an array of what it finds."""
    first, second = map_of(n, **settings), map_of(n - 2, shift=0.3, **settings)
    return {
        "parameterize": lambda **s: sp.parameterize(*first[:2], **s)[0],
        "is_bijective": lambda **s: np.array(sp.is_bijective(*first[1:], **s)),
        "round_to_float": lambda **s: sp.round_to_float(*first[1:], **s),
        "measure_distortion": lambda **s: sp.measure_distortion(*first, **s).isometric.values,
        "compute_sulcal_measures": lambda **s: np.array(sp.compute_sulcal_measures(*first[:2], **s)),
        "measure_distance": lambda **s: np.array(sp.measure_distance(first[:2], second[:2], **s).from_first),
        "Locator": lambda **s: sp.Locator(*first[1:], **s).locate(second[2])[1],
        "remesh": lambda **s: sp.remesh(*first, ("cube", n), **s).vertices,
        "remesh with": lambda **s: sp.remesh(*first, second[1:], **s).vertices,
        "transfer": lambda **s: sp.transfer(first, second[1:], first[0], **s),
        "resample": lambda **s: sp.resample(first[1:], second[1:], first[0], areas=(first[0], second[0]), **s),
        "resample_sphere": lambda **s: sp.resample_sphere(first[1:], first[2], second[1:], **s),
        "expand": lambda **s: sp.expand(*first, 8, **s)[0],
        "reconstruct": lambda **s: sp.reconstruct(np.ones((3, 2, 41, 41)), first[2], **s),
        "standard_position": lambda **s: sp.standard_position(ellipsoid(3, 2, 1, 40), **s)[0],
        "map_surface": lambda **s: sp.map_surface(first, second, **s)[0],
        "align_spheres": lambda **s: sp.align_spheres(first, second, **s).rotations,
        "overlay": lambda **s: sp.overlay(first, second, **s).vertices1,
        "measure_distortion_between": lambda **s: np.array(sp.measure_distortion_between(first, second, **s).energy),
    }


@pytest.fixture(scope="module")
def calls():
    return make_calls(12)


def same(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def write_off(path, vertices, faces):
    rows = [" ".join(map(repr, row)) for row in vertices.tolist()] + ["3 %d %d %d" % tuple(row) for row in faces]
    path.write_text(f"OFF\n{len(vertices)} {len(faces)} 0\n" + "\n".join(rows) + "\n")


def read_points(path):
    words = path.read_text().split()
    return np.array(words[4 : 4 + 3 * int(words[1])], float).reshape(-1, 3)


def run_program(folder, *words):
    subprocess.run([PROGRAM, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)


@pytest.fixture(autouse=True)
def prints_nothing(capfd):
    yield
    assert capfd.readouterr() == ("", "")


def refused(code, call, *arguments, **keywords):
    with pytest.raises(sp.Error) as caught:
        call(*arguments, **keywords)
    assert caught.value.code == code
    return caught.value


# Arrays


@pytest.mark.parametrize("kind", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4"])
def test_takes_every_type_of_integers(kind):
    assert same(sp.parameterize(TETRAHEDRON, FACES.astype(kind))[0], sp.parameterize(TETRAHEDRON, FACES)[0])


def test_takes_arrays_in_any_layout_and_lists():
    vertices, faces = surface(6)
    expected = sp.parameterize(vertices, faces)[0]
    padded = np.zeros((len(vertices), 5))
    padded[:, 1:4] = vertices
    for v in (np.asfortranarray(vertices), padded[:, 1:4], vertices[::-1][::-1], vertices.tolist()):
        for f in (np.asfortranarray(faces), np.c_[np.full(len(faces), 3), faces][:, 1:], faces.tolist()):
            assert same(sp.parameterize(v, f)[0], expected)
    single = vertices.astype("f4")
    assert same(sp.parameterize(single, faces)[0], sp.parameterize(single.astype("f8"), faces)[0])
    faces.flags.writeable = vertices.flags.writeable = False
    assert same(sp.parameterize(vertices, faces)[0], expected)


def test_refuses_what_is_no_mesh():
    wrong = sp.ErrorCode.WRONG_PARAMETER
    masked = np.ma.masked_equal(TETRAHEDRON, -1)
    too_large = np.array([*FACES[:3], [1, 2**64 - 1, 2]], dtype="u8")
    for vertices, faces, words in (
        (TETRAHEDRON[:, :2], FACES, "(4, 2)"),
        (TETRAHEDRON, FACES.ravel(), "(12,)"),
        (TETRAHEDRON, too_large, f"row 3 has the vertex {2**64 - 1}"),
        (masked, FACES, "has masked values"),
        (list(masked), FACES, "has masked values"),
        (TETRAHEDRON, np.ma.masked_equal(FACES, 3), "has masked values"),
    ):
        assert words in str(refused(wrong, sp.parameterize, vertices, faces))
    for v in (4, -1, 2**40):
        error = refused(wrong, sp.is_bijective, [*FACES[:3], [1, v, 2]], TETRAHEDRON)
        assert error.face == 3 and f"vertex {v}, but there are 4" in str(error)
    error = refused(wrong, sp.transfer, (TETRAHEDRON, FACES, TETRAHEDRON), (FACES, TETRAHEDRON), masked)
    assert "has masked values" in str(error)
    assert same(sp.parameterize(np.ma.array(TETRAHEDRON), FACES)[0], sp.parameterize(TETRAHEDRON, FACES)[0])
    assert "3 rows" in str(refused(wrong, sp.measure_distortion, TETRAHEDRON, FACES, TETRAHEDRON[:3]))
    with pytest.raises(TypeError, match="float64; it has to hold integers"):
        sp.parameterize(TETRAHEDRON, FACES.astype(float))
    with pytest.raises(TypeError, match="complex128; it has to hold real numbers"):
        sp.parameterize(TETRAHEDRON.astype(complex), FACES)


def test_says_what_is_wrong_with_a_mesh_and_where():
    code = sp.ErrorCode
    assert sp.find_defect(TETRAHEDRON, FACES) is None
    no_faces, against = np.empty((0, 3), int), [[0, 2, 1], *FACES[1:]]
    infinite = np.where(np.arange(12).reshape(4, 3) == 7, np.nan, TETRAHEDRON)
    corners = np.r_[TETRAHEDRON, TETRAHEDRON[2:] - 9]
    on_an_edge = np.r_[FACES, np.array([0, 1, 4, 5])[FACES]]  # four faces have it, in any order
    orders = [np.random.default_rng(seed).permutation(8) for seed in range(20)]
    for expected, vertices, faces, words, where in (
        (code.EMPTY_MESH, TETRAHEDRON, no_faces, "", {}),
        (code.EMPTY_MESH, np.empty((0, 3)), no_faces, "", {}),
        (code.EMPTY_MESH, TETRAHEDRON, [], "", {}),
        (code.EMPTY_MESH, [], [], "", {}),
        (code.NON_CLOSED_MESH, TETRAHEDRON, FACES[:3], "", {"vertex": {1, 2, 3}, "other_vertex": {1, 2, 3}, "face": {0, 1, 2}}),
        (code.NO_SIMPLICIAL_COMPLEX, TETRAHEDRON, [*FACES, [0, 1, 1]], "", {"vertex": {1}, "face": {4}}),
        (code.NO_SIMPLICIAL_COMPLEX, TETRAHEDRON, against, "against each other", {"vertex": {0}, "other_vertex": {2}, "face": {2}}),
        (code.NON_FINITE_COORDINATE, infinite, FACES, "", {"vertex": {2}}),
        (code.SEVERAL_COMPONENTS, np.r_[TETRAHEDRON, TETRAHEDRON + 9], [*FACES, *(FACES + 4)], "", {}),
        (code.NON_CLOSED_MESH, TETRAHEDRON[FACES].reshape(-1, 3), np.arange(12).reshape(4, 3), "do not share them", {}),
        *((code.NO_SIMPLICIAL_COMPLEX, corners, on_an_edge[order], "has 4 faces", {}) for order in orders),
    ):
        raised = refused(expected, sp.parameterize, vertices, faces)
        found = sp.find_defect(vertices, faces)
        assert str(found) == str(raised) and found.code == expected and "CGAL::" not in str(found) and words in str(found)
        assert all(getattr(found, name) in values for name, values in where.items())
        copied = pickle.loads(pickle.dumps(found))
        assert isinstance(copied, ValueError) and str(copied) == str(found) and copied.code == found.code
        assert all(getattr(copied, name) == getattr(found, name) for name in where)
    refused(code.NO_SIMPLICIAL_COMPLEX, sp.measure_distortion, corners, on_an_edge, corners)


def test_refuses_settings_out_of_range(calls):
    wrong = sp.ErrorCode.WRONG_PARAMETER
    for call in calls.values():
        assert "threads" in str(refused(wrong, call, threads=0))
        with pytest.raises(TypeError):
            call(threads=1.5)
    for call in (calls["parameterize"], calls["map_surface"], calls["align_spheres"]):
        for setting, value in (("time_limit", 0), ("time_limit", np.nan), ("on_interrupt", "stop")):
            assert setting in str(refused(wrong, call, **{setting: value}))
        with pytest.raises(TypeError):
            call(callback=1)
    for setting, value in (("prefer", "best"), ("energy", 1)):
        assert setting in str(refused(wrong, sp.parameterize, TETRAHEDRON, FACES, **{setting: value}))
    refused(wrong, sp.parameterize, TETRAHEDRON, FACES, prefer="sampling", energy="conformal")
    with pytest.raises(TypeError):
        sp.parameterize(TETRAHEDRON, FACES, "worst")


# Files


def test_reads_meshes(tmp_path):
    vertices, faces = surface(4)
    points = [" ".join(map(repr, row)) for row in vertices.tolist()]
    corners = ["f %d %d %d" % tuple(f) for f in faces + 1]
    (tmp_path / "mesh.OBJ").write_text("\n".join(["v " + p for p in points] + corners))
    write_off(tmp_path / "mesh.off", vertices, faces)
    for path in (tmp_path / "mesh.OBJ", tmp_path / "mesh.off", str(tmp_path / "mesh.off")):
        assert all(map(same, sp.read_mesh(path), (vertices, faces)))
    (tmp_path / "cut.off").write_text("\n".join([f"OFF {len(vertices)} {len(faces)} 0", *points[:60]]))
    error = refused(sp.ErrorCode.INVALID_SURFACE_FILE, sp.read_mesh, tmp_path / "cut.off")
    assert "cut.off: the file ends after 60 of 66" in str(error)
    (tmp_path / "quad.off").write_text("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n")
    error = refused(sp.ErrorCode.NON_TRIANGULAR_MESH, sp.read_mesh, tmp_path / "quad.off")
    assert error.face == 1 and "quad.off: face 1 is not a triangle but has 4 corners" in str(error)
    refused(sp.ErrorCode.INVALID_SURFACE_FILE, sp.read_mesh, tmp_path)
    with pytest.raises(FileNotFoundError, match="none.off"):
        sp.read_mesh(tmp_path / "none.off")


def test_reads_meshes_in_a_locale_of_commas(tmp_path, monkeypatch):
    name = "de_DE.ISO-8859-1"
    write_off(tmp_path / "mesh.off", *surface(4))
    vertices, faces = sp.read_mesh(tmp_path / "mesh.off")
    coefficients = ellipsoid(1234.5, 2, 3, 2)
    sp.write_coefficients(tmp_path / "table.csv", coefficients)
    table = (tmp_path / "table.csv").read_bytes()
    with suppress(OSError):  # where glibc can make it
        subprocess.run(["localedef", "-i", "de_DE", "-f", "ISO-8859-1", tmp_path / name])
    for folder in (None, tmp_path):
        try:
            with monkeypatch.context() as patch:
                if folder:
                    patch.setenv("LOCPATH", str(folder))
                locale.setlocale(locale.LC_ALL, name)
            break
        except locale.Error:
            pass
    else:
        pytest.skip("no locale with commas")
    try:
        assert locale.localeconv()["decimal_point"] == ","
        assert all(map(same, sp.read_mesh(tmp_path / "mesh.off"), (vertices, faces)))
        assert same(sp.read_coefficients(tmp_path / "table.csv"), coefficients)
        sp.write_coefficients(tmp_path / "table.csv", coefficients)
        assert (tmp_path / "table.csv").read_bytes() == table
    finally:
        locale.setlocale(locale.LC_ALL, "C")



def test_writes_and_reads_coefficients(tmp_path):
    coefficients = random_coefficients(3, 7)
    coef, table = tmp_path / "shape.coef", tmp_path / "shape.csv"
    ortho = {"normalization": "ortho", "csphase": -1}
    converted = coefficients * np.sqrt(4 * np.pi) * (-1.0) ** np.arange(7)
    for path in (coef, table):
        for settings, written in (({}, coefficients), (ortho, converted)):
            sp.write_coefficients(path, written, **settings)
            np.testing.assert_allclose(sp.read_coefficients(path), coefficients, rtol=1e-13)
            np.testing.assert_allclose(sp.read_coefficients(path, **ortho), converted, rtol=1e-13)
    sp.write_coefficients(table, coefficients)
    assert same(sp.read_coefficients(table), coefficients)
    sp.write_coefficients(table, converted[0], **ortho)
    assert table.read_text().startswith("degree,order,f1,normalization,csphase\n0,0,")
    assert np.allclose(sp.read_coefficients(table), coefficients[:1])

    wrong = sp.ErrorCode.WRONG_PARAMETER
    assert ".coef" in str(refused(wrong, sp.write_coefficients, tmp_path / "shape.txt", coefficients))
    assert "(2, 7, 7)" in str(refused(wrong, sp.write_coefficients, coef, coefficients[0]))
    table.write_text("degree,order\n")
    assert "shape.csv: " in str(refused(sp.ErrorCode.INVALID_HARMONICS_FILE, sp.read_coefficients, table))


# The map


def test_isolated_vertices_have_no_image():
    sphere, report = sp.parameterize(np.r_[TETRAHEDRON, [[9, 9, 9]]], FACES)
    assert np.isnan(sphere[4]).all() and np.isfinite(sphere[:4]).all() and report.number_of_isolated_vertices == 1
    assert sp.is_bijective(FACES, sphere)


def test_has_the_bits_of_the_program(tmp_path):
    vertices, faces = surface(12)
    write_off(tmp_path / "mesh.off", vertices, faces)
    run_program(tmp_path, "mesh.off", "-o", "sphere.off")
    assert same(sp.parameterize(vertices, faces)[0], read_points(tmp_path / "sphere.off"))
    for option in ("prefer worst", "prefer average", "prefer sampling", "energy conformal", "energy isometric"):
        name, value = option.split()
        run_program(tmp_path, "mesh.off", "-o", "sphere.off", "--" + name, value)
        assert same(sp.parameterize(vertices, faces, **{name: value})[0], read_points(tmp_path / "sphere.off")), option


def test_samples_and_maps_surfaces_with_the_bits_of_the_program(tmp_path, capfd):
    first, second = map_of(10), map_of(12, shift=0.3)
    write_off(tmp_path / "1.off", *first[:2])
    write_off(tmp_path / "2.off", *second[:2])
    run_program(tmp_path, "remesh", "1.off", "cube=5", "-o", "remesh.off")
    sphere = sp.parameterize(*first[:2], prefer="sampling")[0]
    assert same(sp.remesh(*first[:2], sphere, ("cube", 5)).vertices, read_points(tmp_path / "remesh.off"))

    run_program(tmp_path, "match", "1.off", "2.off", "-o", "image.off", "--sphere", "directions.off")
    warning = capfd.readouterr().err  # of the program; the module prints nothing
    directions, report = sp.map_surface(first, second)
    assert same(directions, read_points(tmp_path / "directions.off"))
    assert report.is_uncertain == ("the alignment of the surfaces is ambiguous" in warning)
    assert 2 <= report.energy < 2.2 and report.agreement > 0.5
    assert report.expected_errors.shape == (len(first[0]),) and (report.expected_errors >= 0).all()
    assert report.expected_errors.min() <= report.expected_error <= report.expected_errors.max()
    image = sp.remesh(*second, (first[1], directions))
    np.testing.assert_allclose(image.vertices, read_points(tmp_path / "image.off"), atol=1e-14)
    assert np.array_equal(image.faces, first[1])


def test_rounds_to_numbers_of_32_bits():
    faces, sphere = map_of(8)[1:]
    short = sp.round_to_float(faces, sphere)
    assert short.dtype == np.float32 and np.array_equal(short, sphere.astype(np.float32))  # nothing folds
    # a vertex so near to an edge that these numbers fold its faces, unless it moves
    a, b, c = faces[0]
    n = len(sphere)
    near = sphere[b] + sphere[c] + 1e-9 * sphere[a]
    faces = np.vstack([[a, b, n], [b, c, n], [c, a, n], faces[1:]])
    sphere = np.vstack([sphere, near * np.linalg.norm(sphere[0]) / np.linalg.norm(near)])
    short = sp.round_to_float(faces, sphere)
    assert sp.is_bijective(faces, sphere) and sp.is_bijective(faces, short)
    np.testing.assert_allclose(short, sphere, atol=1e-5)
    refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.round_to_float, faces, -sphere)


def test_measures_each_face():
    vertices, faces, sphere = map_of(8)
    assert sp.is_bijective(faces, sphere) and not sp.is_bijective(faces, -sphere)
    d = sp.measure_distortion(vertices, faces, sphere)
    reversed_faces = sp.measure_distortion(vertices, faces[::-1], sphere)
    thrice = sp.measure_distortion(vertices, faces, 3 * vertices)
    for name, of_similarity in (("isometric", 3), ("area", 9 + 1 / 9), ("angle", 2)):
        measure = getattr(d, name)
        assert measure.values.shape == (len(faces),) and measure.deviation > 0
        np.testing.assert_allclose([measure.maximum, measure.average], [measure.values.max(), measure.values.mean()])
        np.testing.assert_allclose(measure.deviation, measure.values.std(), rtol=1e-6)
        np.testing.assert_allclose(getattr(reversed_faces, name).values, measure.values[::-1], rtol=1e-8)
        np.testing.assert_allclose(getattr(thrice, name).values, of_similarity, rtol=1e-8)
    np.testing.assert_allclose(d.radius, np.linalg.norm(sphere, axis=1).mean())
    assert not d.is_inverted.any() and d.number_of_inverted_faces == 0
    refused(sp.ErrorCode.EMPTY_MESH, sp.measure_distortion, vertices, faces[:0], sphere)
    sphere[0] *= -1
    is_inverted = sp.measure_distortion(vertices, faces, sphere).is_inverted
    assert is_inverted.any() and np.array_equal(is_inverted, np.linalg.det(sphere[faces]) < 0)


def test_measures_folds():
    vertices, faces = surface(12)
    folding = sp.compute_sulcal_measures(vertices, faces)
    radius = np.linalg.norm(vertices, axis=1)
    for values in folding:
        assert values.shape == (len(vertices),)
        assert np.corrcoef(values, radius)[0, 1] < -0.5
    refused(sp.ErrorCode.NON_CLOSED_MESH, sp.compute_sulcal_measures, vertices, faces[1:])


def test_measures_distances():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    faces = [[0, 1, 2], [0, 2, 3]]
    long = square * [3, 1, 1]
    distance = sp.measure_distance((long, faces), (square + [0, 0, 2], faces))
    np.testing.assert_allclose(distance.from_second, 2)
    # beyond the square, the distance at x is the root of 4 + (x - 1)^2
    np.testing.assert_allclose(distance.from_first.root_mean_square, np.sqrt(4 + 8 / 9), rtol=1e-3)
    np.testing.assert_allclose(distance.from_first.maximum, np.sqrt(8), rtol=1e-2)
    np.testing.assert_allclose(distance.diagonal, np.sqrt(10))
    np.testing.assert_allclose(distance.psnr, 20 * np.log10(np.sqrt(10) / distance.from_first.root_mean_square))
    few = sp.measure_distance((long, faces), (square, faces), number_of_points=9)
    assert few.from_first.maximum < 2 * (1 - 1e-2)

    code = sp.ErrorCode
    refused(code.WRONG_PARAMETER, sp.measure_distance, (long, faces), (square, faces), number_of_points=0)
    broken = np.where(square == 1, np.nan, square)
    error = refused(code.NON_FINITE_COORDINATE, sp.measure_distance, (long, faces), (broken, faces))
    assert error.vertex == 1 and str(error).startswith("surface2: vertices: vertex 1")
    error = refused(code.EMPTY_MESH, sp.measure_distance, (long, faces), (square, []))
    assert str(error).startswith("surface2: ")
    with pytest.raises(TypeError, match="surface1 has to be a tuple: .vertices, faces"):
        sp.measure_distance(long, (square, faces))


def test_fills_holes():
    vertices, faces = surface(8)
    at_first = np.any(faces == 0, axis=1)
    opened = faces[~at_first]
    assert "repair_surface() fills holes" in str(refused(sp.ErrorCode.NON_CLOSED_MESH, sp.parameterize, vertices, opened))
    rows = np.vstack([vertices, np.full((100, 3), np.nan)])  # what follows the vertices in memory is not read
    filled = sp.fill_holes(rows[: len(vertices)], opened)
    (hole,) = filled.holes
    assert hole.number_of_edges == at_first.sum() and 0 < hole.share < 0.2 and hole.perimeter > 0
    assert hole.number_of_faces == len(filled.faces) - len(opened) > 0
    assert same(filled.vertices[: len(vertices)], vertices) and same(filled.faces[: len(opened)], opened)
    assert sp.find_defect(filled.vertices, filled.faces) is None
    untouched = sp.fill_holes(vertices, opened, max_edges=3)
    assert untouched.holes[0].number_of_faces == 0 and len(untouched.faces) == len(opened)
    assert sp.fill_holes(vertices, faces).holes == []
    for edges in (2, -1):
        refused(sp.ErrorCode.WRONG_PARAMETER, sp.fill_holes, vertices, opened, max_edges=edges)
    error = refused(sp.ErrorCode.NO_SIMPLICIAL_COMPLEX, sp.fill_holes, vertices, [[0, 1, 2], [0, 3, 4]])
    assert error.vertex == 0 and "vertex 0" in str(error)
    vertices[2, 0] = np.nan
    assert refused(sp.ErrorCode.NON_FINITE_COORDINATE, sp.fill_holes, vertices, opened).vertex == 2


def test_repairs_surfaces():
    vertices, faces = surface(8)
    untouched = sp.repair_surface(vertices, faces)
    assert same(untouched.vertices, vertices) and same(untouched.faces, faces) and untouched.report.patches == []
    assert same(untouched.source_faces, np.arange(len(faces)))
    broken = faces.copy()
    broken[3] = broken[3, ::-1]
    soup = vertices[broken.ravel()]  # no two faces have a vertex in common
    repaired = sp.repair_surface(soup, np.arange(3 * len(faces)).reshape(-1, 3))
    assert repaired.report.reversed_faces == 1 and len(repaired.vertices) == len(vertices)
    assert repaired.report.merged_vertices == 3 * len(faces) - len(vertices)
    assert same(repaired.vertices, soup[repaired.source_vertices])
    opened = sp.repair_surface(vertices, faces[1:])
    assert len(opened.report.patches) == 1 and opened.source_faces[-1] == -1 and 0 < opened.report.added_area < 0.05
    assert sp.find_defect(opened.vertices, opened.faces) is None
    cube = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
    squares = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4], [3, 4, 7]]
    assert sp.repair_surface(cube, squares).report.triangulated_polygons == 5
    error = refused(sp.ErrorCode.NON_CLOSED_MESH, sp.repair_surface, vertices, faces[: len(faces) // 2])
    assert "and the limit is 5 %" in str(error)
    assert len(sp.repair_surface(vertices, faces[: len(faces) // 2], max_added_area=1, refine=False).faces) > 0
    refused(sp.ErrorCode.WRONG_PARAMETER, sp.repair_surface, vertices, [[0, 1, 10**6]])
    refused(sp.ErrorCode.EMPTY_MESH, sp.repair_surface, vertices, [])
    with pytest.raises(TypeError, match="row of integers"):
        sp.repair_surface(vertices, [[0.5, 1, 2]])


def test_finds_handles():
    assert sp.find_handles(*surface(8)) == []
    m, n = 20, 6
    i, j = np.divmod(np.arange(m * n), n)
    a, b, c, d = ((i + s) % m * n + (j + t) % n for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)))
    torus = np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)
    u, v = 2 * np.pi * i / m, 2 * np.pi * j / n
    points = np.stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)], axis=1)
    (handle,) = sp.find_handles(points, torus)
    assert handle.path.shape == (n,) and handle.length == pytest.approx(2 * n * np.sin(np.pi / n))
    assert "find_handles" in str(refused(sp.ErrorCode.NO_TOPOLOGICAL_SPHERE, sp.parameterize, points, torus))
    refused(sp.ErrorCode.NON_CLOSED_MESH, sp.find_handles, points, torus[1:])
    refused(sp.ErrorCode.WRONG_PARAMETER, sp.find_handles, points, torus, max_handles=0)


def test_goes_on_from_a_map():
    vertices, faces, sphere = map_of(8)
    assert sp.parameterize(vertices, faces, initial=2 * sphere)[1].initial_energy == pytest.approx(
        sp.parameterize(vertices, faces)[1].average_energy, rel=1e-3
    )
    sphere, report = sp.parameterize(vertices, faces, initial="schnyder")
    assert sp.is_bijective(faces, sphere) and report.number_of_levels == 0 and not report.used_last_resort
    refused(sp.ErrorCode.WRONG_PARAMETER, sp.parameterize, vertices, faces, initial="tutte")
    sphere[7] *= -1
    error = refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.parameterize, vertices, faces, initial=sphere)
    assert 7 in faces[error.face] and str(error).startswith("initial is not bijective")
    sphere[3] = np.inf
    assert refused(sp.ErrorCode.NON_FINITE_COORDINATE, sp.parameterize, vertices, faces, initial=sphere).vertex == 3


# Threads and interruption


def test_any_number_of_threads_gives_the_same_bits():
    vertices, faces = surface(40)
    expected = sp.parameterize(vertices, faces, threads=1)[0]
    results = []
    run = lambda threads: results.append(sp.parameterize(vertices, faces, threads=threads)[0])
    workers = [threading.Thread(target=run, args=(threads,)) for threads in (1, 2, 2**70, None)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(results) == 4 and all(same(result, expected) for result in results)


def compare_threads():
    """Prints which functions start threads that they should not, which none at all, and which find something else by them.

    No thread may be there before.
    """
    tasks = lambda: len(os.listdir("/proc/self/task"))
    n = tasks()
    calls = make_calls(16, threads=1)
    faces, sphere = map_of(16, threads=1)[1:]
    error = sp.ErrorCode.NO_1_TO_1_MAPPING
    calls["explain a map"] = lambda **s: np.array(refused(error, sp.Locator, faces, -sphere, **s).face)
    for name, call in calls.items():
        child = os.fork()
        if child == 0:
            by_one = call(threads=1)
            n_of_one = tasks()
            by_all = call()
            os._exit(int(n_of_one > n) + 2 * int(tasks() == n) + 4 * int(not same(by_one, by_all)))
        status = os.waitpid(child, 0)[1]
        if status != 0:
            print(name, status)


@pytest.mark.skipif(not Path("/proc/self/task").is_dir() or os.cpu_count() == 1, reason="needs Linux and two cores")
def test_one_thread_is_that_of_the_caller_and_gives_the_same_bits():
    words = [sys.executable, "-c", "import test_module; test_module.compare_threads()"]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    found = subprocess.run(words, cwd=Path(__file__).parent, env=environment, check=True, stdout=subprocess.PIPE)
    assert found.stdout == b""


def test_other_python_threads_go_on():
    vertices, faces = surface(80)
    ticks, is_over = [], threading.Event()

    def tick():
        while not is_over.wait(0.005):
            ticks.append(time.perf_counter())

    ticker = threading.Thread(target=tick)
    ticker.start()
    begin = time.perf_counter()
    sp.parameterize(vertices, faces)
    end = time.perf_counter()
    is_over.set()
    ticker.join()
    assert sum(begin + 0.02 < t < end - 0.02 for t in ticks) >= 3


def fail(*arguments):
    raise RuntimeError("mine")


def test_the_callback_is_told_and_may_stop():
    vertices, faces = surface(10)
    calls = []
    report = sp.parameterize(vertices, faces, callback=lambda *arguments: calls.append(arguments))[1]
    assert len(calls) == report.number_of_iterations > 3 and report.stop_reason == "converged"
    assert calls[-1][1] < calls[0][1] and calls[-1][2] == pytest.approx(report.radius, rel=0.01)
    sphere, stopped = sp.parameterize(vertices, faces, callback=lambda i, energy, radius: [i] if i < 2 else [])
    assert stopped.stop_reason == "stopped by the visitor" and stopped.number_of_iterations < 4
    assert sp.is_bijective(faces, sphere)

    with pytest.raises(RuntimeError, match="mine"):
        sp.parameterize(vertices, faces, callback=fail)


def test_the_callback_is_told_of_maps_between_surfaces_and_may_stop_them():
    first, second = map_of(18), map_of(12, shift=1.0)
    calls = []
    report = sp.map_surface(first, second, callback=lambda *arguments: calls.append(arguments))[1]
    sizes, energies = np.array(calls).T
    assert sizes[0] == energies[0] == 0 and (np.diff(sizes) >= 0).all()
    assert sizes[-1] == len(first[0]) and energies[-1] == 0 # while the energy is measured
    assert energies[energies > 0][-1] == pytest.approx(report.energy, rel=0.1)
    directions, stopped = sp.map_surface(first, second, callback=lambda n, energy: energy == 0)
    assert stopped.stop_reason == "stopped by the visitor" and stopped.number_of_sweeps < report.number_of_sweeps
    assert sp.is_bijective(first[1], directions)

    calls.clear()
    alignment = sp.align_spheres(first, second, callback=lambda *arguments: calls.append(arguments))
    assert len(calls) > 3 and set(calls) == {(0, 0.0)} and not alignment.is_stopped
    assert sp.align_spheres(first, second, callback=lambda *_: False).is_stopped

    for call in (sp.map_surface, sp.align_spheres):
        with pytest.raises(RuntimeError, match="mine"):
            call(first, second, callback=fail)


def test_a_time_limit_gives_what_has_been_reached():
    vertices, faces, sphere = first = map_of(40)
    sphere, report = sp.parameterize(vertices, faces, time_limit=1e-6)
    assert report.stop_reason == "time limit" and sp.is_bijective(faces, sphere)
    second = map_of(30, shift=1.0)
    directions, report = sp.map_surface(first, second, time_limit=1e-6)
    assert report.stop_reason == "time limit" and sp.is_bijective(faces, directions)
    assert sp.align_spheres(first, second, time_limit=1e-6).is_stopped


@contextmanager
def interruption():
    """Comes by the clock of the processor, however busy that is; what Ctrl-C sends is answered by the same handler."""
    previous = signal.signal(signal.SIGVTALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_VIRTUAL, 0.1)
    yield
    signal.signal(signal.SIGVTALRM, previous)


@pytest.mark.parametrize("callback", [None, lambda *_: time.sleep(0.02)])
def test_an_interruption_stops_the_run(callback):
    vertices, faces = surface(160)
    with interruption():
        sphere, report = sp.parameterize(vertices, faces, callback=callback, on_interrupt="return")
    assert report.stop_reason == "stopped by the visitor" and sp.is_bijective(faces, sphere)
    with interruption(), pytest.raises(KeyboardInterrupt):
        sp.parameterize(vertices, faces, callback=callback)


def test_an_interruption_stops_maps_between_surfaces():
    first, second = map_of(50), map_of(48, shift=1.0)
    for other in (second, first):  # the latter may be in the alignment
        with interruption():
            directions, report = sp.map_surface(first, other, on_interrupt="return")
        assert sp.is_bijective(first[1], directions)
        assert other is first or report.stop_reason == "stopped by the visitor"
    with interruption():
        assert sp.align_spheres(first, second, on_interrupt="return").is_stopped
    for call in (
        lambda: sp.map_surface(first, second),
        lambda: sp.align_spheres(first, second),
        lambda: sp.measure_distance(first[:2], second[:2], number_of_points=100_000_000),  # it would take minutes
    ):
        with interruption(), pytest.raises(KeyboardInterrupt):
            call()


# Sampling


def test_locates_directions():
    vertices, faces, sphere = map_of(8)
    locator = sp.Locator(faces, sphere)
    directions = np.random.default_rng(1).normal(size=(500, 3))
    face, coordinates = locator.locate(directions)
    found = np.einsum("kc,kcx->kx", coordinates, sphere[faces[face]])
    np.testing.assert_allclose(np.cross(found, directions), 0, atol=1e-13)
    assert ((found * directions).sum(1) > 0).all() and coordinates.min() >= 0
    face, coordinates = locator.locate(sphere)
    assert np.array_equal(faces[face][coordinates == 1], np.arange(len(sphere)))
    for copied in (pickle.loads(pickle.dumps(locator)), copy.deepcopy(locator)):
        assert all(map(same, copied.locate(directions), locator.locate(directions)))
    error = refused(sp.ErrorCode.INVALID_DIRECTION, locator.locate, [[1, 0, 0], [0, 0, 0], [0, np.nan, 0]])
    assert error.vertex == 1 and "2 such rows" in str(error)
    sphere[5] *= -1
    assert 5 in faces[refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.Locator, faces, sphere).face]


@pytest.mark.parametrize(
    "solid, n", [("octahedron", 4 * 7**2 + 2), ("cube", 6 * 7**2 + 2), ("icosahedron", 10 * 7**2 + 2)]
)
def test_remeshes_over_a_solid_or_a_mesh(solid, n):
    vertices, faces, sphere = map_of(8)
    result = sp.remesh(vertices, faces, sphere, (solid, 7))
    assert result.vertices.shape == (n, 3) and len(result.faces) == 2 * n - 4
    assert sp.is_bijective(result.faces, result.sphere)
    face, coordinates = sp.Locator(faces, sphere).locate(result.sphere)
    np.testing.assert_allclose(result.vertices, np.einsum("kc,kcx->kx", coordinates, vertices[faces[face]]))
    directions = np.r_[[[9, 9, 9]], result.sphere]  # with a vertex that has no face
    again = sp.remesh(vertices, faces, sphere, (result.faces + 1, directions))
    assert same(again.vertices[1:], result.vertices) and same(again.sphere[1:], result.sphere)
    assert np.isnan(again.vertices[0]).all() and np.array_equal(again.faces, result.faces + 1)


def test_refuses_wrong_domains():
    vertices, faces, sphere = map_of(4)
    for domain in (("sphere", 5), ("cube", 0), ("cube", 5001)):
        assert "domain[" in str(refused(sp.ErrorCode.WRONG_PARAMETER, sp.remesh, vertices, faces, sphere, domain))
    for domain in ("cube", 5, ("cube", 2.5)):
        with pytest.raises(TypeError):
            sp.remesh(vertices, faces, sphere, domain)
    error = refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.remesh, vertices, faces, sphere, (faces, -sphere))
    assert str(error).startswith("domain: ")


def test_transfers_numbers_and_labels():
    vertices, faces, sphere = map_of(8)
    fine = sp.remesh(vertices, faces, sphere, ("octahedron", 30))
    source, target = (vertices, faces, sphere), (fine.faces, np.r_[fine.sphere, [[0, 0, 0]]])
    points = sp.transfer(source, target, vertices)
    np.testing.assert_allclose(points[:-1], fine.vertices)
    assert np.isnan(points[-1]).all()
    assert sp.transfer(source, target, vertices[:, 0].astype("f4")).dtype == np.float32
    face = sp.Locator(faces, sphere).locate(fine.sphere[fine.faces].sum(1))[0]
    for labels in (np.arange(len(faces)), np.arange(len(faces)) % 2 == 0, np.arange(len(faces)).astype("U")):
        assert np.array_equal(sp.transfer(source, target, labels, of="faces"), labels[face])
    sides = np.where(vertices[:, :2] > 0, "right", "left")
    carried = sp.transfer(source, target, sides)
    assert carried.shape == (len(points), 2) and set(carried[:-1].ravel()) == {"left", "right"} and carried[-1, 0] == ""
    assert (carried[:-1, 0] == np.where(fine.vertices[:, 0] > 0, "right", "left")).mean() > 0.9
    assert "258 rows" in str(refused(sp.ErrorCode.WRONG_PARAMETER, sp.transfer, source, target, vertices[:9]))
    with pytest.raises(TypeError):
        sp.transfer(source, target, vertices.astype(complex))


# Surfaces


def spheres():
    """Two spheres, one of them finer, and the directions of the finer one."""
    fine, coarse = (sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("icosahedron", n)) for n in (16, 5))
    x, y, z = coarse.sphere.T
    turned = np.stack([0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z], axis=1) @ [[1, 0, 0], [0, 0.6, 0.8], [0, -0.8, 0.6]]
    return (fine.faces, fine.sphere), (coarse.faces, turned), fine.sphere


def test_resamples_values_and_labels():
    fine, coarse, points = spheres()
    heights = points[:, 2]
    for settings in ({}, {"areas": (fine[1], coarse[1])}, {"method": "nearest"}):
        resampled = sp.resample(fine, coarse, points, **settings)
        assert resampled.shape == coarse[1].shape and abs(resampled - coarse[1]).max() < 0.2
        columns = np.stack([heights, 2 * heights], axis=1)
        assert same(sp.resample(fine, coarse, columns, **settings)[:, 0], sp.resample(fine, coarse, heights, **settings))
    interpolated = sp.resample(fine, coarse, points)
    interpolated /= np.linalg.norm(interpolated, axis=1)[:, None]
    assert abs(interpolated - coarse[1]).max() < 1e-14

    halves = np.where(heights > 0, "north", "south")
    resampled = sp.resample(fine, coarse, halves)
    clear = abs(coarse[1][:, 2]) > 0.1
    assert (resampled[clear] == np.where(coarse[1][:, 2] > 0, "north", "south")[clear]).all()
    assert sp.resample(fine, coarse, heights.astype(np.float32)).dtype == np.float32
    assert sp.resample(fine, coarse, np.arange(len(points), dtype=np.int16)).dtype == np.int16

    mask = heights > 0
    resampled, valid = sp.resample(fine, coarse, np.where(mask, 1.0, np.nan), mask=mask, return_valid=True)
    assert abs(resampled - valid).max() < 1e-14 and valid[coarse[1][:, 2] > 0].all() and 0 < valid.sum() < len(valid)
    labels = sp.resample(fine, coarse, np.where(mask, 5, -3), mask=mask)
    assert same(labels, np.where(valid, 5, 0))


def test_carries_a_sphere_through_a_registration():
    fine, coarse, points = spheres()
    turn = np.array([[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]])
    assert abs(sp.resample_sphere(fine, 100 * points @ turn, coarse) - 100 * coarse[1] @ turn).max() < 1e-12


def test_refuses_to_resample():
    fine, coarse, points = spheres()
    codes = sp.ErrorCode
    for settings in (
        {"method": "best"},
        {"method": "adaptive"},
        {"method": "nearest", "areas": (fine[1], coarse[1])},
        {"areas": (coarse[1], fine[1])},
        {"areas": (points[:, 0], coarse[1])},
        {"mask": np.ones(3, bool)},
    ):
        refused(codes.WRONG_PARAMETER, sp.resample, fine, coarse, points, **settings)
    refused(codes.WRONG_PARAMETER, sp.resample, fine, coarse, points[1:])
    refused(codes.WRONG_PARAMETER, sp.resample_sphere, fine, points[1:], coarse)
    with pytest.raises(TypeError):
        sp.resample(fine, coarse, points, mask=np.ones(len(points)))
    for code, source, target, words in (
        (codes.NO_1_TO_1_MAPPING, fine, (coarse[0], -coarse[1]), "target: sphere is not bijective: face 0"),
        (codes.NON_CLOSED_MESH, (fine[0][1:], points), coarse, "source: "),
        (codes.WRONG_PARAMETER, (fine[0] - 1, points), coarse, "source: "),
    ):
        assert str(refused(code, sp.resample, source, target, points)).startswith(words)


def test_maps_and_refines_two_surfaces():
    first, second = map_of(8), map_of(10)
    landmarks = np.stack([first[0].argmax(0), second[0].argmax(0)], axis=1)  # where x, y or z is largest
    assert len(sp.map_surface(first, second, landmarks=[])[1].landmark_distances) == 0
    directions, report = sp.map_surface(first, second, landmarks=landmarks)
    assert sp.is_bijective(first[1], directions) and report.number_of_missed_landmarks == 0
    np.testing.assert_allclose(report.landmark_distances, 0, atol=1e-12)
    images = sp.remesh(*second, (first[1], directions)).vertices
    np.testing.assert_allclose(images[landmarks[:, 0]], second[0][landmarks[:, 1]], atol=1e-12)
    soft = sp.map_surface(first, second, landmarks=landmarks, landmark_weight=1e-3)[1]
    assert soft.energy < report.energy and soft.landmark_distances.max() > 1e-6

    refinement = sp.overlay((*first[:2], directions), second)
    n = len(refinement.vertices1)
    assert len(sp.overlay((*first[:2], directions), second, max_vertices=n).vertices2) == n
    for call in (sp.overlay, sp.measure_distortion_between):
        refused(sp.ErrorCode.TOO_LARGE_OVERLAY, call, (*first[:2], directions), second, max_vertices=n - 1)
        refused(sp.ErrorCode.WRONG_PARAMETER, call, first, second, max_vertices=-1)
    area = lambda p, f: np.linalg.norm(np.cross(p[f[:, 1]] - p[f[:, 0]], p[f[:, 2]] - p[f[:, 0]]), axis=1)
    for points, face, (vertices, faces, _) in (
        (refinement.vertices1, refinement.faces1, first),
        (refinement.vertices2, refinement.faces2, second),
    ):
        parts = np.bincount(face, area(points, refinement.faces), len(faces))
        np.testing.assert_allclose(parts, area(vertices, faces), rtol=1e-6)


def test_measures_maps_between_surfaces():
    first, second = map_of(8), map_of(10)
    begin = time.perf_counter()
    directions, report = sp.map_surface(first, second)
    seconds = time.perf_counter() - begin
    stages = [getattr(report, "seconds_for_" + s) for s in ("reading", "alignment", "descent", "overlay")]
    assert min(stages) > 0 and seconds / 2 < sum(stages) < seconds
    between = sp.measure_distortion_between((*first[:2], directions), second)
    assert not report.is_energy_sampled
    assert report.energy == pytest.approx(np.mean(between.energy[1:]))
    for name in ("isometric", "energy"):
        assert getattr(report.distortion, name) == pytest.approx(getattr(between, name))
    assert between.number_of_triangles == len(sp.overlay((*first[:2], directions), second).faces)

    # the same faces: the map is linear on each of them, and is compared with the lengths of its image at the same area
    vertices, faces, sphere = first
    stretched = vertices * [1, 1, 2]
    corners = np.stack([vertices[faces], stretched[faces]])
    edges = corners[:, :, 1:] - corners[:, :, :1]
    gram = edges @ edges.transpose(0, 1, 3, 2)
    areas = np.sqrt(np.linalg.det(gram)) / 2
    squares = np.linalg.eigvals(np.linalg.solve(gram[0], gram[1])).real * areas[0].sum() / areas[1].sum()
    s1, s2 = np.sqrt(np.sort(squares, axis=1).T)
    between = sp.measure_distortion_between(first, (stretched, faces, sphere))
    for measure, values in (
        (between.isometric, np.maximum(s2, 1 / s1)),
        (between.area, s1 * s2 + 1 / (s1 * s2)),
        (between.angle, s1 / s2 + s2 / s1),
        (between.energy, (s1**2 + s2**2 + 1 / s1**2 + 1 / s2**2) / 2),
    ):
        np.testing.assert_allclose(measure, [values.max(), *(np.average(values, weights=a) for a in areas)])
    assert between.number_of_triangles - between.number_of_slivers >= len(faces)
    all_left_out = sp.measure_distortion_between(first, (stretched, faces, sphere), smallest_area=0.9)
    assert all_left_out.number_of_slivers == between.number_of_triangles and all_left_out.area.maximum == np.inf
    refused(sp.ErrorCode.WRONG_PARAMETER, sp.measure_distortion_between, first, second, smallest_area=1)


def turned(first, angle):
    turn = np.array([[0, 0, 1], [np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0]])
    return (*first[:2], first[2] @ turn.T), turn


def test_aligns_spheres():
    first = map_of(16)
    second, turn = turned(first, 2.0)
    for settings in ({}, {"features": [(first[0][:, i], first[0][:, i]) for i in range(3)]}):
        alignment = sp.align_spheres(first, second, **settings)
        np.testing.assert_allclose(alignment.rotations[0], turn, atol=0.01)
        assert alignment.scores[0] > 0.98 and (np.diff(alignment.scores) <= 0).all() and not alignment.is_stopped
        assert alignment.margin == alignment.scores[0] - np.r_[alignment.scores, 0][1] > 0
    assert sp.align_spheres(first, second, time_limit=1e-9).margin == 0


def test_compares_features_by_weights_and_leaves_out_what_is_masked():
    first = map_of(8)
    points = first[0]
    second, _ = turned(first, 0)
    directions, report = sp.map_surface(first, second, features=[(points[:, i], points[:, i]) for i in range(3)])
    assert report.agreement > 0.99 and report.energy == pytest.approx(2, abs=1e-6)
    np.testing.assert_allclose(sp.remesh(*second, (first[1], directions)).vertices, points, atol=1e-3)

    counts = points[:, 2] < 0.5 * points[:, 2].max()
    spoilt = np.where(counts, points[:, 0], 9 - points[:, 1])
    features = [(points[:, 0], spoilt), (points[:, 1], points[:, 1]), (points[:, 2], -points[:, 0])]
    settings = {"features": features, "feature_weights": [1, 1, 0], "compare_values": True, "masks": (counts, counts)}
    directions, report = sp.map_surface(first, second, **settings)
    assert report.agreement > 0.95
    goals = second[2] / np.linalg.norm(second[2], axis=1, keepdims=True)
    np.testing.assert_allclose(directions[counts], goals[counts], atol=0.1)
    for settings in (
        {"feature_weights": [1]},
        {"features": features, "feature_weights": [0, 0, 0]},
        {"features": features, "feature_weights": [1, 1, -1]},
        {"masks": (counts, counts[:5])},
        {"masks": (counts, np.zeros(len(points)))},
    ):
        refused(sp.ErrorCode.WRONG_PARAMETER, sp.map_surface, first, second, **settings)


def test_says_what_is_wrong_with_two_surfaces():
    first, second = map_of(4), map_of(5)
    n = len(first[0])
    landmark = sp.ErrorCode.INVALID_LANDMARK
    error = refused(landmark, sp.map_surface, first, second, landmarks=[[0, 0], [n, 1]])
    assert error.vertex == n and "row 1" in str(error) and "of surface1" in str(error)
    error = refused(landmark, sp.map_surface, first, second, landmarks=[[0, 7], [1, 7]])
    assert error.vertex == 7 and "as has row 0" in str(error)
    second_and_more = (np.r_[second[0], [[0, 0, 0]]], second[1], np.r_[second[2], [[0, 0, 0]]])
    error = refused(landmark, sp.map_surface, first, second_and_more, landmarks=[[0, len(second[0])]])
    assert error.vertex == len(second[0]) and "no face" in str(error)
    wrong = sp.ErrorCode.WRONG_PARAMETER
    values = np.zeros(n), np.zeros(len(second[0]))
    values[1][3] = np.inf
    refused(wrong, sp.align_spheres, first, second, features=[values])
    for settings in (
        {"landmarks": [0, 1]},
        {"landmark_weight": 0},
        {"landmark_weight": 1.0},
        {"features": [values]},
        {"feature_weight": -1},
        {"features": [values[::-1]]},
    ):
        refused(wrong, sp.map_surface, first, second, **settings)
    for settings in ({"landmarks": [[0.5, 1]]}, {"features": [1]}):
        with pytest.raises(TypeError):
            sp.map_surface(first, second, **settings)
    folded = (*second[:2], -second[2])
    for call in (sp.map_surface, sp.align_spheres, sp.overlay, sp.measure_distortion_between):
        assert str(refused(sp.ErrorCode.NO_1_TO_1_MAPPING, call, first, folded)).startswith("surface2: sphere is not")
        assert str(refused(wrong, call, (first[0][:, :2], *first[1:]), second)).startswith("surface1: vertices has")
        with pytest.raises(TypeError, match="surface2 has to be a tuple: .vertices, faces, sphere"):
            call(first, second[:2])
    error = refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.transfer, first, folded[1:], first[0])
    assert str(error).startswith("target: sphere is not")
    assert str(refused(wrong, sp.transfer, first, (second[1], second[2][:, :2]), first[0])).startswith("target: sphere has")


# Spherical harmonics


def random_coefficients(*shape):
    *functions, n = shape
    result = np.tril(np.random.default_rng(5).uniform(-1, 1, (*functions, 2, n, n)))
    result[..., 1, :, 0] = 0
    return result


def test_expands_and_reconstructs():
    vertices, faces, sphere = map_of(20)
    directions = sphere / np.linalg.norm(sphere, axis=1)[:, None]
    assert np.allclose(sp.reconstruct(ellipsoid(3, 2, 1, 1), sphere), directions * [3, 2, 1])
    coefficients, fit = sp.expand(vertices, faces, sphere, 20)
    assert coefficients.shape == (3, 2, 21, 21) and same(np.tril(coefficients), coefficients)
    assert 0 < fit.error_over_surface < 0.02 and fit.degree_of_vertices == int(len(vertices) ** 0.5) - 1
    again = sp.reconstruct(coefficients, (faces, sphere))
    assert np.sqrt(((again.vertices - vertices) ** 2).sum(axis=1).mean()) < 0.04
    assert np.allclose(again.vertices, sp.reconstruct(coefficients, 3 * sphere), rtol=0, atol=1e-12)
    even = sp.reconstruct(coefficients[..., :6, :6], ("icosahedron", 5))
    assert same(sp.reconstruct(coefficients[..., :6, :6], ["icosahedron", 5]).vertices, even.vertices)
    assert even.vertices.shape == (252, 3) and sp.find_defect(even.vertices, even.faces) is None
    for weights in ("surface", "sphere", "vertices"):
        errors = sp.expand(vertices, faces, sphere, 12, weights=weights)[1]
        assert (errors.number_of_iterations == 0) == (weights == "sphere")
    assert same(sp.expand(vertices, faces, sphere, 20, values=vertices)[0], coefficients)
    height, _ = sp.expand(vertices, faces, sphere, 20, values=vertices[:, 2] > 0)
    assert height.shape == (2, 21, 21) and sp.reconstruct(height, [[0, 0, 1], [0, 0, -1]]).shape == (2,)
    table, _ = sp.expand(vertices, faces, sphere, 3, values=np.ones((len(vertices), 2, 2)))
    assert table.shape == (2, 2, 2, 4, 4) and np.allclose(table[..., 0, 0, 0], 1)

    factors = {"4pi": np.ones(21), "ortho": np.full(21, np.sqrt(4 * np.pi)), "schmidt": np.sqrt(2 * np.arange(21) + 1)}
    for normalization, factor in factors.items():
        for csphase in (1, -1):
            settings = {"normalization": normalization, "csphase": csphase}
            other, _ = sp.expand(vertices, faces, sphere, 20, **settings)
            assert np.allclose(other, coefficients * factor[:, None] * (1.0 * csphase) ** np.arange(21))
            assert np.allclose(sp.spectrum(other, normalization=normalization), sp.spectrum(coefficients))
            assert np.allclose(sp.reconstruct(other, sphere, **settings), again.vertices)


def test_the_spectrum_is_the_mean_square():
    coefficients = random_coefficients(2, 8)
    sphere = sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("icosahedron", 60)).sphere
    u, v, w = np.moveaxis(sphere[sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("icosahedron", 60)).faces], 1, 0)
    values = sp.reconstruct(coefficients, u + v + w)
    weights = np.linalg.norm(np.cross(v - u, w - u), axis=1)
    assert np.isclose(sp.spectrum(coefficients).sum(), np.average((values**2).sum(axis=1), weights=weights), rtol=1e-2)
    assert sp.spectrum(coefficients).shape == (8,)


def test_moves_to_standard_position():
    coefficients = ellipsoid(1, 3, 2, 6) + 0.1 * random_coefficients(3, 7)
    moved, position = sp.standard_position(coefficients)
    assert position.axes_are_determined and list(position.semi_axes) == sorted(position.semi_axes, reverse=True)
    directions = np.random.default_rng(2).normal(size=(5, 3))
    points = sp.reconstruct(coefficients, directions) - position.center
    at_images = sp.reconstruct(moved, directions @ position.rotation_of_sphere.T)
    assert np.allclose(at_images, points @ position.rotation_of_surface.T)
    assert not sp.standard_position(ellipsoid(1, 3, 2, 1))[1].signs_are_determined
    assert not sp.standard_position(ellipsoid(1, 1, 2, 1))[1].axes_are_determined
    refused(sp.ErrorCode.UNDETERMINED_ROTATION, sp.standard_position, ellipsoid(1, 0, 0, 1))


def test_says_what_is_wrong_with_harmonics():
    wrong = sp.ErrorCode.WRONG_PARAMETER
    vertices, faces, sphere = first = map_of(4)
    for degree in (-1, 1001):
        assert "degree" in str(refused(wrong, sp.expand, *first, degree))
    with pytest.raises(TypeError):
        sp.expand(*first, 2.5)
    error = refused(sp.ErrorCode.TOO_HIGH_DEGREE, sp.expand, *first, 9, weights="vertices")
    assert "100 coefficients" in str(error) and "66 vertices" in str(error) and "at most 7" in str(error)
    refused(sp.ErrorCode.NO_1_TO_1_MAPPING, sp.expand, vertices, faces, -sphere, 3)
    refused(sp.ErrorCode.NON_CLOSED_MESH, sp.expand, vertices, faces[1:], sphere, 3)
    for setting, value in (("weights", "area"), ("normalization", "unnorm"), ("csphase", 0), ("values", [1, 2])):
        assert setting in str(refused(wrong, sp.expand, *first, 3, **{setting: value}))
    assert "vertex 1" in str(refused(wrong, sp.expand, *first, 3, values=np.where(np.arange(len(vertices)) == 1, np.nan, 0)))
    for coefficients in (np.zeros((2, 3)), np.zeros((3, 4, 4)), np.zeros((2, 3, 4)), np.full((2, 3, 3), np.inf)):
        assert "coefficients" in str(refused(wrong, sp.reconstruct, coefficients, sphere))
        assert "coefficients" in str(refused(wrong, sp.spectrum, coefficients))
    assert "coefficients" in str(refused(wrong, sp.reconstruct, np.zeros((2, 3, 3)), ("cube", 3)))
    assert "where[1]" in str(refused(wrong, sp.reconstruct, ellipsoid(3, 2, 1, 1), ("cube", 0)))
    refused(sp.ErrorCode.INVALID_DIRECTION, sp.reconstruct, ellipsoid(3, 2, 1, 1), [[0, 0, 0]])
    for coefficients in (np.zeros((2, 3, 3)), np.zeros((3, 2, 1, 1))):
        assert "coefficients" in str(refused(wrong, sp.standard_position, coefficients))


# Modes of shapes


def rotations(n, seed=3):
    q = np.linalg.qr(np.random.default_rng(seed).normal(size=(n, 3, 3)))[0]
    return q * np.linalg.det(q)[:, None, None]


def test_finds_modes_and_makes_shapes_of_them():
    random = np.random.default_rng(4)
    mean, (first, second) = random.normal(size=(2, 7)), np.linalg.qr(random.normal(size=(14, 2)))[0].T.reshape(2, 2, 7)
    scores = np.array([[1, 1, -1, -1], [1, -1, 1, -1]]) * np.sqrt(3) / 2
    shapes = [mean + 3 * a * first + 0.5 * b * second for a, b in scores.T]
    result = sp.shape_modes(shapes, align="none")
    assert np.allclose(result.mean, mean) and result.modes.shape == (2, 2, 7)
    assert np.allclose(result.deviations, [3, 0.5]) and np.allclose(result.shares, [9 / 9.25, 0.25 / 9.25])
    assert np.allclose(np.abs(result.scores.T), np.abs(scores))
    for mode, planted in zip(result.modes, (first, second)):
        assert np.allclose(mode, planted * np.sign(planted.ravel()[np.abs(planted).argmax()]))
    for shape, row in zip(shapes, result.scores):
        assert np.allclose(result.shape(row), shape)
    assert np.allclose(result.shape([2]) - result.shape([]), 6 * result.modes[0])
    assert sp.shape_modes([[1, 2], [1, 2]], align="none").modes.shape == (0, 2)


def test_finds_the_same_modes_in_any_unit():
    shapes = np.random.default_rng(3).normal(size=(5, 20, 3))
    for align in ("none", "rotation", "similarity"):
        expected = sp.shape_modes(shapes, align=align)
        for unit in (2.0**-1000, 2.0**660, 2.0**990):
            result = sp.shape_modes(unit * shapes, align=align)
            for name in ("modes", "scores", "shares"):
                assert (getattr(result, name) == getattr(expected, name)).all(), (align, unit, name)
            assert (result.mean == unit * expected.mean).all() and (result.deviations == unit * expected.deviations).all()


def test_aligns_shapes():
    random = np.random.default_rng(5)
    points = random.normal(size=(50, 3)) * [3, 2, 1]
    same = [s * points @ turn + random.normal(size=3) for s, turn in zip((1, 2, 3), rotations(3))]
    assert len(sp.shape_modes(same, align="similarity").modes) == 0
    result = sp.shape_modes(same)
    assert len(result.modes) == 1 and np.allclose(np.abs(result.scores[:, 0]), [1, 0, 1])
    assert np.allclose(result.mean.mean(axis=0), 0) and np.allclose(result.mean, 2 * (same[0] - same[0].mean(axis=0)))
    assert len(sp.shape_modes(same, align="none").modes) == 2
    assert len(sp.shape_modes([points, points * [1, 1, -1]]).modes) == 1  # a mirror image is no other position

    varied = [(points + 0.1 * random.normal(size=points.shape)) @ turn for turn in rotations(9)]
    turned = [x @ turn + 5 for x, turn in zip(varied, np.concatenate([[np.eye(3)], rotations(8, 6)]))]
    first, second = sp.shape_modes(varied), sp.shape_modes(turned)
    for name in ("mean", "modes", "deviations", "scores", "shares"):
        assert np.allclose(getattr(first, name), getattr(second, name)), name
    assert np.allclose(first.scores.T @ first.scores, 8 * np.eye(8)) and np.isclose(first.shares.sum(), 1)


def test_says_what_is_wrong_with_shapes():
    wrong = sp.ErrorCode.WRONG_PARAMETER
    shape = np.arange(12.0).reshape(4, 3) ** 2
    for shapes in ([], [shape]):
        assert "at least 2" in str(refused(wrong, sp.shape_modes, shapes))
    assert "shapes[1]" in str(refused(wrong, sp.shape_modes, [shape, shape[1:]]))
    assert "shapes[1]" in str(refused(wrong, sp.shape_modes, [shape, np.where(shape == 1, np.nan, shape)]))
    assert "1e+300" in str(refused(wrong, sp.shape_modes, [shape, 1e301 * shape]))
    assert "align" in str(refused(wrong, sp.shape_modes, [shape, shape], align="scale"))
    assert "none" in str(refused(wrong, sp.shape_modes, np.zeros((2, 3, 2, 4, 4))))
    assert "shapes[1]" in str(refused(wrong, sp.shape_modes, [shape, np.ones((4, 3))], align="similarity"))
    with pytest.raises(TypeError):
        sp.shape_modes([shape, shape.astype(str)])
    with pytest.raises(TypeError, match="give its vertices"):
        sp.shape_modes([sp.reconstruct(ellipsoid(3, 2, 1, 1), ("cube", 2))] * 2)
    assert "differ" in str(refused(wrong, sp.shape_modes, [shape, [[1, 2, 3], [4]]]))
    result = sp.shape_modes([shape, 2 * shape])
    for scores in ([1, 1], [np.inf], [[1]]):
        assert "scores" in str(refused(wrong, result.shape, scores))


# What users read


def test_every_name_is_documented_and_typed():
    for name in set(sp.__all__) - {"__version__"}:
        assert getattr(sp, name).__doc__, name
    stub = (Path(sp.__file__).parent / "_core.pyi").read_text()
    for name in dir(sp._core):
        assert name.startswith("_") or re.search(rf"(def|class) {name}\b", stub), name
    of_pybind11 = {"__entries", "__getstate__", "__setstate__"}
    for name in set(vars(sp.ErrorCode)) - set(dir(object)) - {"__module__"} - of_pybind11:
        assert re.search(rf"    (def )?{name}\b", stub), name


def test_the_citation_is_of_this_version():
    version = re.search(r"^version: (.*)$", (ROOT / "CITATION.cff").read_text(), re.MULTILINE).group(1)
    assert version == sp.__version__


def test_the_lines_of_the_readme_run(tmp_path, monkeypatch):
    lines = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL).group(1)
    folder = tmp_path / "build/data/meshes"
    folder.mkdir(parents=True)
    write_off(folder / re.search(r'"build/data/meshes/(.*?)"', lines).group(1), *surface(10))
    monkeypatch.chdir(tmp_path)
    exec(lines, {"print": lambda *arguments: None})


def test_the_example_draws_a_picture(tmp_path):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    write_off(tmp_path / "mesh.off", *surface(8))
    example = ROOT / "python/examples/distortion_picture.py"
    subprocess.run([sys.executable, example, "mesh.off", "picture.png"], cwd=tmp_path, check=True)
    assert len(np.unique(pyplot.imread(tmp_path / "picture.png").reshape(-1, 4), axis=0)) > 1000


def run_shape_modes(folder, *words, status=0):
    """Returns what the example prints."""
    command = [sys.executable, ROOT / "python/examples/shape_modes.py", *words]
    run = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert run.returncode == status and "Traceback" not in run.stdout, run.stdout
    return run.stdout


def test_the_example_finds_the_modes_of_cells(tmp_path):
    pyplot = pytest.importorskip("matplotlib.pyplot")

    def scores(path):
        return np.loadtxt(tmp_path / path, delimiter=",", skiprows=1, usecols=(1, 2))

    (tmp_path / "demo/cells").mkdir(parents=True)
    write_off(tmp_path / "demo/cells/other.off", TETRAHEDRON, FACES)  # which the demonstration has not made
    lines = run_shape_modes(tmp_path, "--demo", "demo", "--modes", "2")
    (tmp_path / "demo/cells/other.off").unlink()
    correlations = [abs(float(x)) for x in re.findall(r"correlation of mode \d (.*)", lines)]
    assert len(correlations) == 2 and min(correlations) >= 0.997
    table = (tmp_path / "demo/scores.csv").read_text().splitlines()
    assert len(table) == 101 and table[0].startswith("file,mode1,mode2,") and table[1].startswith("cell000.off,")
    shares = np.loadtxt(tmp_path / "demo/modes.csv", delimiter=",", skiprows=1)
    assert np.isclose(shares[:, 1].sum(), 1) and f"mode 2: {shares[1, 1]:.1%} of" in lines and f"deviation {shares[1, 2]:.3g}" in lines
    assert len(np.unique(pyplot.imread(tmp_path / "demo/modes.png").reshape(-1, 4), axis=0)) > 1000
    minus, plus, mean = (read_points(tmp_path / f"demo/{name}.off") for name in ("mode1_minus", "mode1_plus", "mean"))
    assert np.allclose((minus + plus) / 2, mean, atol=1e-6) and not np.allclose(minus, plus)

    folder = tmp_path / "demo/cells"
    for path in sorted(folder.iterdir())[6:]:
        path.unlink()
    lines = run_shape_modes(tmp_path, "demo/cells", "registered", "--template", "cell003.off", "--same-size", "--modes", "1")
    assert "6 surfaces" in lines and "cell003.off: is the template" in lines
    n = len(read_points(folder / "cell003.off"))
    assert len(read_points(tmp_path / "registered/mode1_plus.off")) == n
    for name in re.findall(r"(cell\d+).off: .*UNCERTAIN", lines):
        assert len(read_points(tmp_path / f"registered/uncertain_{name}.off")) == n

    assert "inside out" not in run_shape_modes(tmp_path, "demo/cells", "right", "--standard-position")
    vertices, faces = sp.read_mesh(folder / "cell005.off")
    write_off(folder / "cell005.off", vertices, faces[:, ::-1])
    assert "cell005.off: is inside out" in run_shape_modes(tmp_path, "demo/cells", "turned", "--standard-position", "--up", "z")
    assert np.allclose(scores("right/scores.csv"), scores("turned/scores.csv"), atol=0.02)


def test_the_example_says_what_is_wrong(tmp_path):
    pytest.importorskip("matplotlib.pyplot")
    folder = tmp_path / "shapes"
    folder.mkdir()
    (folder / "folder.off").mkdir()
    vertices, faces = surface(4)
    write_off(folder / "a.off", vertices, faces)
    assert "has 1 .off" in run_shape_modes(tmp_path, "shapes", "results", status=1)
    write_off(folder / "b.OFF", vertices, faces)
    assert "All surfaces are the same" in run_shape_modes(tmp_path, "shapes", "results", status=1)
    lines = run_shape_modes(tmp_path, "shapes", "results", "--standard-position", "--degree", "9", status=1)
    assert "66 vertices" in lines and "--degree 7 or less" in lines
    assert "another folder" in run_shape_modes(tmp_path, "shapes", "shapes/../shapes", status=2)
    assert "--degree needs" in run_shape_modes(tmp_path, "shapes", "results", "--degree", "9", status=2)
    assert "--template c.off is not one of" in run_shape_modes(tmp_path, "shapes", "results", "--template", "c.off", status=1)
    (folder / "c.off").write_text("hello")
    write_off(folder / "d.off", vertices, faces[1:])
    lines = run_shape_modes(tmp_path, "shapes", "results", status=1)
    assert "c.off: line 1" in lines and "d.off: the mesh has a border" in lines and "2 of 4 files" in lines
    assert not list((tmp_path / "results").iterdir())


def test_areas_are_as_wanted():
    vertices, faces = surface(12)
    assert sp.parameterize(vertices, faces)[1].areas is None
    area = lambda p: np.linalg.norm(np.cross(p[faces[:, 1]] - p[faces[:, 0]], p[faces[:, 2]] - p[faces[:, 0]]), axis=1)
    of_vertices = np.exp(vertices[:, 0])
    of_faces = np.arange(1, len(faces) + 1) % 3 + 1
    for density, expected in (("equal", 1), (of_vertices, of_vertices[faces].mean(axis=1)), (of_faces, of_faces)):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sphere, report = sp.parameterize(vertices, faces, density=density)
        assert sp.is_bijective(faces, sphere)
        areas = report.areas
        assert areas.is_reached and areas.deviation < 1e-3
        assert np.isclose(areas.deviation, areas.ratios.std() / areas.ratios.mean(), atol=1e-6)
        assert np.isclose(areas.largest_deviation, abs(areas.ratios - 1).max(), atol=1e-6)
        assert areas.number_of_off_vertices == (abs(areas.ratios - 1) > 0.01).sum()
        # the faces around each vertex, up to what the triangles are below the sphere
        found, wanted = (np.bincount(faces.ravel(), np.repeat(x / x.sum(), 3)) for x in (area(sphere), area(vertices) * expected))
        np.testing.assert_allclose(found, wanted, rtol=0.1)


def test_areas_that_cannot_be_had_are_told():
    sphere, report = sp.parameterize(TETRAHEDRON, FACES, density=np.array([1, 1, 1, 1]))
    assert report.areas.is_reached
    density = np.ones(len(FACES) + 2)
    vertices = np.vstack([TETRAHEDRON, [[0, 0, 0]] * 2])  # without a face
    faces = np.vstack([FACES[:3], [[1, 3, 4], [3, 2, 4], [2, 1, 4]]])
    vertices[4] = [-2, -2, -2]
    density[0] = 1e3  # more than half of the sphere
    with pytest.warns(RuntimeWarning, match="the prescribed areas are not reached"):
        sphere, report = sp.parameterize(vertices[:5], faces, density=density)
    assert not report.areas.is_reached and report.areas.number_of_off_vertices > 0
    assert sp.is_bijective(faces, sphere)
    with pytest.warns(RuntimeWarning, match='energy="conformal" works against them'):
        sp.parameterize(vertices[:5], faces, density=density, energy="conformal")


@pytest.mark.parametrize("bad", [-1.0, np.nan, np.inf])
def test_densities_that_are_none_are_refused(bad):
    vertices, faces = surface(4)
    for n, place in ((len(vertices), "vertex"), (len(faces), "face")):
        density = np.ones(n)
        density[7] = bad
        error = refused(sp.ErrorCode.INVALID_DENSITY, sp.parameterize, vertices, faces, density=density)
        assert f"the density of {place} 7 is {bad}" in str(error) and getattr(error, place) == 7
    for words, settings in (
        ("a number for each vertex", {"density": np.ones(5)}),
        ("a number for each vertex", {"density": np.ones((len(vertices), 1))}),
        ("is 0 everywhere", {"density": np.zeros(len(faces))}),
        ("'equal'", {"density": "even"}),
        ("density and initial", {"density": "equal", "initial": "schnyder"}),
    ):
        with pytest.raises(sp.Error, match=words):
            sp.parameterize(vertices, faces, **settings)
    with pytest.raises(TypeError, match="real numbers"):
        sp.parameterize(vertices, faces, density=["a"] * len(vertices))


class Trimesh:
    """A stand-in for a mesh of trimesh."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = np.array(vertices, float), np.array(faces)


class PolyData:
    """A stand-in for a mesh of PyVista, which has its faces in one row."""

    def __init__(self, vertices, faces):
        self.points = np.array(vertices, np.float32)
        self.faces = np.column_stack((np.full(len(faces), 3), faces)).ravel()


@pytest.mark.parametrize("Mesh", [Trimesh, PolyData])
def test_takes_meshes_of_other_libraries(Mesh):
    vertices, faces = surface(6)
    vertices = vertices.astype(np.float32)  # as PyVista has them
    mesh = Mesh(vertices, faces)
    sphere = sp.parameterize(vertices, faces)[0]
    for of_arrays, of_mesh in (
        (sp.parameterize(vertices, faces, prefer="worst")[0], sp.parameterize(mesh, prefer="worst")[0]),
        (sp.measure_distortion(vertices, faces, sphere).area.values, sp.measure_distortion(mesh, sphere).area.values),
        (sp.remesh(vertices, faces, sphere, ("cube", 5)).vertices, sp.remesh(mesh, sphere, ("cube", 5)).vertices),
        (sp.expand(vertices, faces, sphere, degree=3)[0], sp.expand(mesh, sphere, degree=3)[0]),
        (sp.compute_angles(vertices, faces), sp.compute_angles(mesh)),
        (sp.compute_sulcal_measures(vertices, faces).depth, sp.compute_sulcal_measures(mesh).depth),
        (sp.repair_surface(vertices, faces).vertices, sp.repair_surface(mesh).vertices),
        (
            sp.transfer((vertices, faces, sphere), (faces, sphere), vertices),
            sp.transfer((mesh, sphere), (faces, sphere), vertices),
        ),
        (
            sp.map_surface((vertices, faces, sphere), (vertices, faces, sphere))[0],
            sp.map_surface((mesh, sphere), (vertices, faces, sphere))[0],
        ),
    ):
        np.testing.assert_array_equal(of_arrays, of_mesh)
    assert sp.find_defect(mesh) is None and sp.fill_holes(mesh).vertices.shape == vertices.shape
    assert sp.find_handles(mesh) == [] and sp.measure_distance(mesh, (vertices, faces)).psnr > 300


def test_says_what_is_wrong_with_meshes():
    mesh = PolyData(TETRAHEDRON, FACES)
    mesh.faces = np.array([4, 0, 1, 2, 3])
    with pytest.raises(sp.Error, match="not triangles: triangulate"):
        sp.parameterize(mesh)
    with pytest.raises(TypeError):
        sp.parameterize(Trimesh(TETRAHEDRON, FACES), FACES)


def test_angles_and_directions():
    vertices, faces, sphere = map_of(8)
    angles = sp.compute_angles(vertices, faces)
    np.testing.assert_array_equal(angles, sp.compute_angles(vertices, faces, sphere=4 * sphere))
    assert angles.shape == (len(vertices), 2)
    assert 0 <= angles[:, 0].min() and angles[:, 0].max() <= np.pi
    assert 0 <= angles[:, 1].min() and angles[:, 1].max() < 2 * np.pi
    directions = sp.angles_to_directions(angles)
    np.testing.assert_allclose(directions, sphere / np.linalg.norm(sphere, axis=1)[:, None], atol=1e-15)
    assert sp.is_bijective(faces, directions)
    np.testing.assert_allclose(sp.angles_to_directions([(0, 1), (np.pi / 2, np.pi / 2)]), [(0, 0, 1), (0, 1, 0)], atol=1e-15)
    with pytest.raises(sp.Error, match="image of vertex 3"):
        sp.compute_angles(TETRAHEDRON, FACES, sphere=[*TETRAHEDRON[:3], (0, 0, 0)])
    with pytest.raises(sp.Error, match=re.escape("(4, 3); it has to be (n, 2)")):
        sp.angles_to_directions(TETRAHEDRON)


def test_runs_the_program(tmp_path):
    """Of an installation that has it; the build folder has it elsewhere, on the path."""
    environment = {**os.environ, "PATH": str(Path(PROGRAM).parent) + os.pathsep + os.environ["PATH"]}
    command = [sys.executable, "-m", "spherical_parameterization"]
    run = subprocess.run([*command, "--version"], env=environment, capture_output=True, text=True)
    assert run.returncode == 0 and run.stdout.startswith("spherical_parameterization " + sp.__version__)
    run = subprocess.run([*command, "check", str(tmp_path / "none.off")], env=environment, capture_output=True, text=True)
    assert run.returncode == 1 and "none.off" in run.stderr
    script = tmp_path / "spherical_parameterization"
    script.write_text("#!/bin/sh\nexit 7\n")
    script.chmod(0o755)
    run = subprocess.run([*command, "--version"], env={**environment, "PATH": str(tmp_path)}, capture_output=True, text=True)
    assert run.returncode == 1 and "neither installed with this module nor on the path" in run.stderr
