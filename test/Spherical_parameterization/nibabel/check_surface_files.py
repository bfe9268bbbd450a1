#!/usr/bin/env python3
"""Usage: check_surface_files.py CONVERTER

Checks the readers and writers of files of cortical surfaces against nibabel, which shares no code with them: what nibabel
writes is read, and what is written, nibabel reads, to the last bit; and wb_command, where it is installed, says of written
files what they are. CONVERTER is the program convert_surface_file. Exit status 77 says that nibabel is missing."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import warnings

try:
    import nibabel
    import numpy as np
    from nibabel.gifti import GiftiCoordSystem, GiftiDataArray, GiftiImage, GiftiLabel, GiftiLabelTable, GiftiMetaData
except ImportError as error:
    print(f"nibabel is not installed: {error}. Nothing is checked.")
    sys.exit(77)

if len(sys.argv) != 2:
    sys.exit(__doc__)
warnings.simplefilter("ignore")  # of footers that are missing
converter = pathlib.Path(sys.argv[1]).resolve()
checks = 0


def convert(from_format, source, to_format, result):
    """returns the path of `source` in another format"""
    run = subprocess.run([converter, from_format, source, to_format, result], capture_output=True, text=True)
    if run.returncode != 0 or run.stdout:
        sys.exit(f"{source} to {result}: {run.stdout}{run.stderr}")
    return result


def expect_same(name, a, b):
    """compares arrays by their bits, as doubles"""
    global checks
    checks += 1
    a, b = (np.ascontiguousarray(x, dtype=np.float64) for x in (a, b))
    if a.shape != b.shape or a.tobytes() != b.tobytes():
        sys.exit(f"{name} differs: {a} {b}")


def expect_equal(name, a, b):
    global checks
    checks += 1
    if a != b:
        sys.exit(f"{name} differs: {a} {b}")


def make_surface(rng):
    """an octahedron, with coordinates of all sizes"""
    points = rng.normal(size=(6, 3)).astype(np.float32)
    points[0] = [0.1, -0.0, 1e-42]
    triangles = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], np.int32)
    return points, triangles


def check_freesurfer(folder, points, triangles, values):
    geometry = {"head": np.array([2, 0, 20], dtype=">i4"), "valid": "1  # volume info valid", "filename": "a.mgz",
                "volume": np.array([256, 256, 256]), "voxelsize": np.ones(3), "xras": np.array([-1.0, 0, 0]),
                "yras": np.array([0, 0, -1.0]), "zras": np.array([0, 1.0, 0]), "cras": np.array([1.5, 2, 3])}
    for footer in (None, geometry):
        source, result = folder / "lh.white", folder / "lh.result"
        nibabel.freesurfer.write_geometry(source, points, triangles, create_stamp="created by nibabel", volume_info=footer)
        convert("surface", source, "surface", result)
        expect_equal("surface", source.read_bytes(), result.read_bytes())
        found = nibabel.freesurfer.read_geometry(convert("surface", source, "surface", result))
        expect_same("points", found[0], points)
        expect_same("triangles", found[1], triangles)
        gifti = nibabel.load(convert("surface", source, "gifti", folder / "white.surf.gii"))
        expect_same("points", gifti.darrays[0].data, points)
        expect_same("triangles", gifti.darrays[1].data, triangles)

    source = folder / "lh.sulc"
    nibabel.freesurfer.write_morph_data(source, values)
    expect_same("curv", nibabel.freesurfer.read_morph_data(convert("curv", source, "curv", folder / "lh.r")), values)
    expect_same("curv", nibabel.load(convert("curv", source, "gifti", folder / "r.gii")).darrays[0].data, values)

    labels = np.array([0, 1, 2, 1, 0, 0])
    table = np.array([[25, 5, 25, 0, 0], [25, 100, 40, 0, 0], [125, 100, 160, 255, 0]])
    source = folder / "lh.annot"
    nibabel.freesurfer.write_annot(source, labels, table, ["unknown", "bankssts", "cingulate"], fill_ctab=True)
    found = nibabel.freesurfer.read_annot(convert("annot", source, "annot", folder / "lh.r.annot"))
    expect_same("labels", found[0], labels)
    expect_same("colours", found[1][:, :4], table[:, :4])
    expect_equal("names", found[2], [b"unknown", b"bankssts", b"cingulate"])
    gifti = nibabel.load(convert("annot", source, "gifti", folder / "r.label.gii"))
    expect_same("labels", gifti.darrays[0].data, labels)
    expect_equal("names", gifti.labeltable.get_labels_as_dict(), {0: "unknown", 1: "bankssts", 2: "cingulate"})
    expect_same("a colour", gifti.labeltable.labels[1].rgba, np.array([25, 100, 40, 255]) / 255)

    source = folder / "lh.cortex.label"
    source.write_text("#!ascii label  , from subject\n2\n4 1 2 3 0.5\n1 1 2 3 0.1\n")
    gifti = nibabel.load(convert("label", source, "gifti", folder / "cortex.gii"))
    found = nibabel.freesurfer.read_label(source, read_scalars=True)
    expect_same("vertices", gifti.darrays[0].data, found[0])
    expect_same("values", gifti.darrays[1].data, np.float32(found[1]))


def check_mgh(folder, rng):
    for dtype in (np.uint8, np.int16, np.int32, np.float32):
        for shape in ((6, 1, 1), (6, 1, 1, 3), (3, 1, 2, 2)):
            for extension in ("mgh", "mgz"):
                data = (100 * rng.random(shape)).astype(dtype)
                source = folder / f"values.{extension}"
                nibabel.save(nibabel.MGHImage(data, np.eye(4)), source)
                columns = data.reshape(6, -1, order="F")
                for to_format in ("mgh", "mgz"):
                    result = convert("mgh", source, to_format, folder / f"result.{to_format}")
                    expect_same("values", np.asanyarray(nibabel.load(result).dataobj).reshape(6, -1, order="F"), columns)
                gifti = nibabel.load(convert("mgh", source, "gifti", folder / "values.func.gii"))
                expect_same("values", np.array([a.data for a in gifti.darrays]).T, columns)


def check_gifti(folder, points, triangles, values):
    for encoding in ("ASCII", "B64BIN", "B64GZ"):
        for endian in ("big", "little"):
            for order in ("RowMajorOrder", "ColumnMajorOrder"):
                if encoding == "ASCII" and order == "ColumnMajorOrder":
                    continue  # nibabel writes the other order
                system = GiftiCoordSystem(1, 3, np.arange(16).reshape(4, 4) / 3)
                arrays = [GiftiDataArray(points, "NIFTI_INTENT_POINTSET", coordsys=system,
                                         meta=GiftiMetaData({"GeometricType": "Anatomical"})),
                          GiftiDataArray(triangles, "NIFTI_INTENT_TRIANGLE"),
                          GiftiDataArray(values, "NIFTI_INTENT_SHAPE", meta=GiftiMetaData({"Name": "sulc & \u00e9"})),
                          GiftiDataArray(np.arange(6, dtype=np.int32) - 3, "NIFTI_INTENT_LABEL"),
                          GiftiDataArray(np.arange(6, dtype=np.uint8) + 250, "NIFTI_INTENT_NONE")]
                for array in arrays:
                    array.encoding, array.ind_ord = encoding, order
                    if encoding != "ASCII" and endian != sys.byteorder:
                        array.data = array.data.byteswap()
                label = GiftiLabel(-3, 0.25, 0.5, 1 / 3, 1)
                label.label = "a < b"
                table = GiftiLabelTable()
                table.labels.append(label)
                image = GiftiImage(darrays=arrays, labeltable=table, meta=GiftiMetaData({"AnatomicalStructurePrimary": "CortexLeft"}))
                source = folder / "source.gii"
                # nibabel takes bytes as they are in memory, and says that they are of this machine
                native, wanted = (f'Endian="{word.capitalize()}Endian"'.encode() for word in (sys.byteorder, endian))
                source.write_bytes(image.to_xml().replace(native, wanted))
                before = nibabel.load(source)
                after = nibabel.load(convert("gifti", source, "gifti", folder / "result.gii"))
                expect_equal("metadata", dict(before.meta), dict(after.meta))
                for a, b in zip(before.darrays, after.darrays, strict=True):
                    expect_same(f"{encoding} {endian} {order}", a.data, b.data)
                    expect_equal("type", (a.intent, a.data.dtype.kind), (b.intent, b.data.dtype.kind))
                    expect_equal("metadata", dict(a.meta), dict(b.meta))
                if encoding != "ASCII":  # for which nibabel rounds
                    expect_same("points", after.darrays[0].data, points)
                    expect_same("triangles", after.darrays[1].data, triangles)
                a, b = before.darrays[0].coordsys, after.darrays[0].coordsys
                expect_equal("systems", (a.dataspace, a.xformspace), (b.dataspace, b.xformspace))
                expect_same("matrix", a.xform, b.xform)
                expect_equal("labels", [(l.key, l.label, l.rgba) for l in before.labeltable.labels],
                             [(l.key, l.label, l.rgba) for l in after.labeltable.labels])


def check_workbench(folder):
    """asks Connectome Workbench what written files are"""
    if shutil.which("wb_command") is None:
        print("wb_command is not installed: it is not asked.")
        return
    for name, words in {"white.surf.gii": ("Type: Surface", "Number of Vertices: 6", "Number of Triangles: 8"),
                        "r.label.gii": ("Type: Label", "Number of Vertices: 6", "bankssts"),
                        "values.func.gii": ("Type: Metric", "Number of Maps: 2")}.items():
        run = subprocess.run(["wb_command", "-file-information", folder / name], capture_output=True, text=True)
        text = " ".join(run.stdout.split())
        for word in words:
            expect_equal(f"{name}, of which wb_command says {text}{run.stderr}", word in text, True)


with tempfile.TemporaryDirectory() as name:
    generator = np.random.default_rng(1)
    surface = make_surface(generator)
    numbers = generator.normal(size=6).astype(np.float32)
    numbers[:2] = [np.nan, -np.inf]
    check_freesurfer(pathlib.Path(name), *surface, numbers)
    check_mgh(pathlib.Path(name), generator)
    check_gifti(pathlib.Path(name), *surface, numbers)
    check_workbench(pathlib.Path(name))
print(f"{checks} comparisons, none differs")
