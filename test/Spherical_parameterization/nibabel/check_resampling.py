#!/usr/bin/env python3
"""Usage: check_resampling.py PROGRAM

Compares what the program PROGRAM resamples between spheres with what wb_command of Connectome Workbench makes of the same
files: values, labels, masks, surfaces, and spheres that are carried through a registration. Prints the largest differences.
Exit status 77 says that nibabel or wb_command is missing."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import nibabel
    import numpy as np
    from nibabel.gifti import GiftiDataArray, GiftiImage, GiftiLabel, GiftiLabelTable, GiftiMetaData
except ImportError as error:
    print(f"nibabel is not installed: {error}. Nothing is compared.")
    sys.exit(77)
if shutil.which("wb_command") is None:
    print("wb_command is not installed. Nothing is compared.")
    sys.exit(77)
if len(sys.argv) != 2:
    sys.exit(__doc__)
program = pathlib.Path(sys.argv[1]).resolve()
left = {"AnatomicalStructurePrimary": "CortexLeft"}


def ball(n):
    """an icosahedron, its edges divided into n parts, on the unit sphere, as the program samples an octahedron"""
    pathlib.Path("octahedron.off").write_text(
        "OFF 6 8 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
        "3 0 1 2\n3 1 3 2\n3 3 4 2\n3 4 0 2\n3 1 0 5\n3 3 1 5\n3 4 3 5\n3 0 4 5\n"
    )
    run(program, "remesh", "octahedron.off", f"icosahedron={n}", "-o", "ball.surf.gii")
    points, faces = (array.data for array in read("ball.surf.gii"))
    points = points.astype(float)
    return points / np.linalg.norm(points, axis=1)[:, None], faces


def deformed(points, amount):
    """turned, and moved along the sphere"""
    x, y, z = points.T
    p = np.stack([z + amount * np.sin(3 * y), x + amount * np.cos(2 * z), y - amount * np.sin(2 * x)], axis=1)
    return p / np.linalg.norm(p, axis=1)[:, None]


def write_surface(name, points, faces, kind="Spherical"):
    arrays = [
        GiftiDataArray(points.astype(np.float32), "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32"),
        GiftiDataArray(faces.astype(np.int32), "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32"),
    ]
    arrays[0].meta = GiftiMetaData({**left, "GeometricType": kind})
    nibabel.save(GiftiImage(darrays=arrays), name)


def write_values(name, *columns):
    arrays = [GiftiDataArray(c.astype(np.float32), "NIFTI_INTENT_SHAPE", "NIFTI_TYPE_FLOAT32") for c in columns]
    for k, array in enumerate(arrays):
        array.meta = GiftiMetaData({"Name": f"column {k}"})
    nibabel.save(GiftiImage(meta=GiftiMetaData(left), darrays=arrays), name)


def write_labels(name, keys):
    table = GiftiLabelTable()
    for key in range(keys.max() + 1):
        label = GiftiLabel(key, 0.5, key / 20, 0.25, 1.0 if key else 0.0)
        label.label = f"area {key}" if key else "???"
        table.labels.append(label)
    array = GiftiDataArray(keys.astype(np.int32), "NIFTI_INTENT_LABEL", "NIFTI_TYPE_INT32")
    nibabel.save(GiftiImage(meta=GiftiMetaData(left), labeltable=table, darrays=[array]), name)


def read(name):
    return nibabel.load(name).darrays


def run(*words):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: {result.stdout}{result.stderr}")


def expect(what, passes, figures):
    print(f"{what}: {figures}")
    if not passes:
        sys.exit(f"{what} differs from what wb_command writes")


def compare(pair, sizes, bound):
    """compares all methods between two spheres; `bound` is that of values, over their range"""
    spheres, areas = [f"{name}.surf.gii" for name in pair], [f"{name}.mid.surf.gii" for name in pair]
    n, of = sizes, f"{pair[0]} to {pair[1]}"
    for method, word in (("barycentric", "BARYCENTRIC"), ("adaptive", "ADAP_BARY_AREA")):
        is_adaptive = method == "adaptive"
        ours = [*spheres, *(["--areas", *areas] if is_adaptive else [])]
        theirs = [*spheres, word]
        extra = ["-area-surfs", *areas] if is_adaptive else []
        values, labels = f"{pair[0]}.shape.gii", f"{pair[0]}.label.gii"
        for mask in (False, True):
            masked = ["--mask", f"{pair[0]}.mask.gii", "--valid", "valid.shape.gii"] if mask else []
            roi = ["-current-roi", f"{pair[0]}.mask.gii", "-valid-roi-out", "wb_valid.shape.gii"] if mask else []
            run(program, "resample", values, *ours, *masked, "-o", "o.shape.gii")
            run("wb_command", "-metric-resample", values, *theirs, "wb.shape.gii", *extra, *roi)
            for k, (a, b) in enumerate(zip(read("o.shape.gii"), read("wb.shape.gii"))):
                assert a.data.shape == b.data.shape == (n[1],) and a.meta["Name"] == f"column {k}"
                differences = np.sort(np.abs(a.data - b.data)) / np.ptp(b.data)
                # next to the rim of a mask, a vertex on an edge may be in either of two faces
                difference = differences[-3 if mask else -1]
                expect(f"{of}, {method}{', masked' if mask else ''}, column {k}", difference < bound, difference)
            if mask:
                a, b = read("valid.shape.gii")[0].data, read("wb_valid.shape.gii")[0].data
                expect(f"{of}, {method}, valid", (a != b).sum() <= 2, f"{(a == 0).sum()} of {n[1]} get nothing")
            run(program, "resample", labels, *ours, *masked, "-o", "o.label.gii")
            run("wb_command", "-label-resample", labels, *theirs, "wb.label.gii", *extra, *roi)
            n_other = (read("o.label.gii")[0].data != read("wb.label.gii")[0].data).sum()
            expect(f"{of}, {method}{', masked' if mask else ''}, labels", n_other <= 2, f"{n_other} of {n[1]}")
        largest = ["--method", "largest" if is_adaptive else "nearest"]
        run(program, "resample", values, *ours, *largest, "-o", "o.shape.gii")
        run("wb_command", "-metric-resample", values, *theirs, "wb.shape.gii", *extra, "-largest")
        n_other = (read("o.shape.gii")[0].data != read("wb.shape.gii")[0].data).sum()
        expect(f"{of}, {largest[1]}", n_other <= 2, f"{n_other} of {n[1]}")
        run(program, "resample", areas[0], *ours, "-o", "o.surf.gii")
        run("wb_command", "-surface-resample", areas[0], *theirs, "wb.surf.gii", *extra)
        (a, a_faces), (b, b_faces) = ([array.data for array in read(name)] for name in ("o.surf.gii", "wb.surf.gii"))
        difference = np.abs(a - b).max() / np.ptp(b)
        expect(f"{of}, {method}, surface", difference < bound and np.array_equal(a_faces, b_faces), difference)


def main():
    sizes = {}
    for name, n, amount in (("fine", 64, 0.0), ("coarse", 32, 0.05), ("other", 32, 0.12)):
        points, faces = ball(n)
        sphere = deformed(points, amount) if amount else points
        x, y, z = sphere.T
        sizes[name] = len(points)
        write_surface(f"{name}.surf.gii", 100 * sphere, faces)
        shape = sphere * (40 + 6 * np.sin(4 * x) * np.cos(5 * y) + 3 * z)[:, None]
        write_surface(f"{name}.mid.surf.gii", shape, faces, "Anatomical")
        write_values(f"{name}.shape.gii", np.sin(5 * x) + y * z, np.exp(3 * x) * np.cos(6 * z), 2 + x * y)
        write_labels(f"{name}.label.gii", (2.5 + 2.4 * np.sin(4 * x + 1) * np.cos(3 * y + 2)).astype(int))
        write_values(f"{name}.mask.gii", z < 0.7)
    for pair in (("fine", "coarse"), ("coarse", "fine"), ("fine", "other")):
        compare(pair, [sizes[name] for name in pair], 1e-5)

    # the coarse sphere through a registration of the fine one
    points, faces = ball(64)
    write_surface("registered.surf.gii", 100 * deformed(points, 0.08), faces)
    words = ["coarse.surf.gii", "fine.surf.gii", "registered.surf.gii"]
    run(program, "resample", *words, "--through", "-o", "o.surf.gii")
    run("wb_command", "-surface-sphere-project-unproject", *words, "wb.surf.gii")
    a, b = (read(name)[0].data for name in ("o.surf.gii", "wb.surf.gii"))
    expect("through a registration", np.abs(a - b).max() < 1e-3, np.abs(a - b).max() / 100)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
