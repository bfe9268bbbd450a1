#!/usr/bin/env python3
"""Usage: check_chapter.py PROGRAM MODULE CHAPTER

Runs the commands and the lines of Python that the manual's chapter on cortical surfaces, the file CHAPTER, prints, with the command
line program PROGRAM and the Python module in the folder MODULE, on a made-up subject and atlas: folded balls, whose
thickness and labels are known at every vertex. Exit status 77 says that nibabel or the module is missing."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import nibabel
    import numpy as np
except ImportError as error:
    print(f"nibabel is not installed: {error}. The chapter is not run.")
    sys.exit(77)
if len(sys.argv) != 4:
    sys.exit(__doc__)
program, module, chapter = (pathlib.Path(word).resolve() for word in sys.argv[1:])
sys.path.insert(0, str(module))
try:
    import spherical_parameterization as sp
except ImportError as error:
    print(f"The Python module is not built: {error}. The chapter is not run.")
    sys.exit(77)

write_surface, write_values = nibabel.freesurfer.write_geometry, nibabel.freesurfer.write_morph_data
OCTAHEDRON = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]], float)
FACES = np.array([[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]])


def ball(n):
    p = sp.remesh(OCTAHEDRON, FACES, OCTAHEDRON, ("octahedron", n))
    return p.sphere / np.linalg.norm(p.sphere, axis=1)[:, None], p.faces


def folds(p):
    x, y, z = p.T
    return 0.08 * np.sin(7 * x + 1) * np.sin(6 * y + 2) * np.cos(5 * z) + 0.15 * x + 0.1 * y * z


def thickness(p):
    return 2.5 + p[:, 2]


def codes(language):
    return re.findall(rf"\\code\{{\.{language}\}}\n(.*?)\\endcode", chapter.read_text(), re.DOTALL)


def make_subject(name, n):
    """A folder of FreeSurfer with the same surface as both hemispheres; returns the directions of its vertices and its faces."""
    os.makedirs(f"{name}/surf")
    os.mkdir(f"{name}/label")
    p, faces = ball(n)
    white = 60 * p * (1 + folds(p))[:, None]
    inside = np.flatnonzero(p[:, 0] > -0.9)
    rows = "".join(f"{v} 0 0 0 0\n" for v in inside)
    for half in "lr":
        write_surface(f"{name}/surf/{half}h.white", white, faces)
        write_surface(f"{name}/surf/{half}h.pial", white * (1 + thickness(p) / 60)[:, None], faces)
        write_values(f"{name}/surf/{half}h.thickness", thickness(p))
        write_values(f"{name}/surf/{half}h.sulc", sp.compute_sulcal_measures(white, faces).depth)
        pathlib.Path(f"{name}/label/{half}h.cortex.label").write_text(f"#!ascii label\n{len(inside)}\n{rows}")
    return p, faces


def make_atlas():
    p, faces = make_subject("fsaverage", 20)
    for half in "lr":
        write_surface(f"fsaverage/surf/{half}h.sphere", 100 * p, faces)
    table = np.array([[25, 5, 25, 0], [220, 20, 20, 0]])
    labels = (p[:, 2] > 0).astype(int)
    nibabel.freesurfer.write_annot("fsaverage/label/lh.aparc.annot", labels, table, ["unknown", "up"], fill_ctab=True)
    return p, faces


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    own, (atlas, atlas_faces) = make_subject("sub-01", 24)[0], make_atlas()
    make_subject("sub-02", 8)
    commands = "".join(codes("sh"))
    has_pages = (program.parent.parent / "page" / "page.stamp").exists()
    if not has_pages:
        commands = re.sub(r" --page \S+|spherical_parameterization_bids .*", "", commands)
    app = pathlib.Path("bin/spherical_parameterization_bids")
    app.parent.mkdir()
    app.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m spherical_parameterization.bids "$@"\n')
    app.chmod(0o755)
    path = f"{app.parent.resolve()}:{program.parent}:{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "PYTHONPATH": str(module), "SUBJECTS_DIR": folder}
    subprocess.run(["sh", "-e", "-c", commands], env=environment, check=True, stdout=subprocess.DEVNULL)

    registered, faces = nibabel.freesurfer.read_geometry("lh.sphere.reg")
    assert sp.is_bijective(faces, registered)
    off = np.degrees(np.arccos(np.clip((registered / 100 * own).sum(axis=1), -1, 1)))
    print(f"registered to {off.mean():.2f} degrees in the mean")
    assert off.mean() < 3, off.mean()
    resampled = np.asarray(nibabel.load("lh.thickness.fsaverage.mgh").dataobj).ravel()
    inside = atlas[:, 0] > -0.8
    assert np.abs(resampled - thickness(atlas))[inside].mean() < 0.1
    labels = nibabel.freesurfer.read_annot("lh.aparc.annot")[0]
    assert ((labels == 1) == (own[:, 2] > 0)).mean() > 0.95
    assert len(nibabel.freesurfer.read_geometry("lh.pial.fsaverage")[0]) == len(atlas)
    for subject in ("sub-01", "sub-02") if has_pages else ():
        for hemi in "LR":
            for name in ("sphere", "space-fsaverage_desc-reg_sphere"):
                file = nibabel.load(f"spheres/{subject}/anat/{subject}_hemi-{hemi}_{name}.surf.gii")
                sphere, faces = file.agg_data()
                assert sp.is_bijective(faces, sphere)

    (code,) = codes("py")
    found = {}
    exec(code, found)
    assert sp.is_bijective(found["faces"], nibabel.freesurfer.read_geometry("lh.sphere.reg")[0])
    written = nibabel.freesurfer.read_morph_data("lh.thickness.fsaverage")
    assert np.abs(written - thickness(atlas))[inside].mean() < 0.1
    assert (written[atlas[:, 0] < -0.98] == 0).all(), "the medial wall has no thickness"
