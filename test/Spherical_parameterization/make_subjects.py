#!/usr/bin/env python3
"""Usage: make_subjects.py FOLDER [N]

Makes what the tests of cohorts read, as no subject can be shipped: in FOLDER/freesurfer a tree of two subjects and an atlas, as
FreeSurfer has them; in FOLDER/derivatives the same subjects as smriprep writes them; and in FOLDER/tpl-fsLR the atlas with a fifth
of the vertices, as TemplateFlow has it. Hemispheres are icosahedra whose edges are divided into N, 128 by default (163,842
vertices), with folds: those of the atlas, moved and bent by each subject. Needs the Python module and nibabel.
"""

import sys
from pathlib import Path

import nibabel as nb
import numpy as np

import spherical_parameterization as sp

TETRAHEDRON = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
FACES = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])


def waves(points, frequency, n, seed):
    """A sum of plane waves of this frequency, of the deviation 1."""
    random = np.random.default_rng(seed)
    directions = random.normal(size=(n, 3))
    directions *= frequency / np.linalg.norm(directions, axis=1)[:, None]
    return np.sqrt(2 / n) * np.sin(points @ directions.T + random.uniform(0, 2 * np.pi, n)).sum(axis=1)


def hemisphere(sphere, hemi, seed):
    """The points of white and pial surface, the depth of folds and the thickness; the seed 0 is that of the atlas."""
    at = sphere.copy()
    if seed:  # the folds are elsewhere
        for axis in range(3):
            at[:, axis] += 0.06 * waves(sphere, 2.5, 6, 100 * seed + axis)
        at /= np.linalg.norm(at, axis=1)[:, None]
    folds = np.tanh(1.5 * waves(at, 13, 40, 7 + (hemi == "R")))
    radius = 45 + 4 * folds + 1.5 * waves(sphere, 4, 10, 50 * seed + 3)
    white = sphere * radius[:, None] * (0.7, 1.25, 0.9)
    thickness = 2.5 + 0.4 * waves(at, 6, 20, 11)
    outward = sphere * (1 / np.array((0.7, 1.25, 0.9)))
    pial = white + thickness[:, None] * outward / np.linalg.norm(outward, axis=1)[:, None]
    return white, pial, -folds, thickness.astype(np.float32)


def write_gifti(path, *arrays):
    intents = {2: "NIFTI_INTENT_POINTSET", 1: "NIFTI_INTENT_NONE"}
    images = [
        nb.gifti.GiftiDataArray(
            np.asarray(a, np.int32 if a.dtype.kind == "i" else np.float32),
            "NIFTI_INTENT_TRIANGLE" if a.dtype.kind == "i" and a.ndim == 2 else intents[a.ndim],
        )
        for a in arrays
    ]
    nb.save(nb.gifti.GiftiImage(darrays=images), path)


def main(folder, n=128):
    solid = sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("icosahedron", n))
    sphere, faces = solid.sphere / np.linalg.norm(solid.sphere, axis=1)[:, None], solid.faces
    for seed, name in enumerate(("fsaverage", "sub-01", "sub-02")):
        surf, label = folder / "freesurfer" / name / "surf", folder / "freesurfer" / name / "label"
        anat = folder / "derivatives" / name / "anat"
        for made in (surf, label, anat)[: 3 if seed else 2]:
            made.mkdir(parents=True, exist_ok=True)
        for hemi in "LR":
            white, pial, sulc, thickness = hemisphere(sphere, hemi, seed)
            h = hemi.lower() + "h"
            curvature = sulc - sulc.mean()
            cortex = np.flatnonzero(sphere[:, 0] * (1 if hemi == "L" else -1) < 0.9)
            if seed == 0:
                nb.freesurfer.write_geometry(surf / f"{h}.sphere", 100 * sphere, faces)
                nb.freesurfer.write_geometry(surf / f"{h}.sphere.reg", 100 * sphere, faces)
            nb.freesurfer.write_geometry(surf / f"{h}.white", white, faces)
            nb.freesurfer.write_geometry(surf / f"{h}.pial", pial, faces)
            for values, metric in ((sulc, "sulc"), (thickness, "thickness"), (curvature, "curv")):
                nb.freesurfer.write_morph_data(surf / f"{h}.{metric}", values.astype(np.float32))
            rows = "".join(f"{v} 0 0 0 0\n" for v in cortex)
            (label / f"{h}.cortex.label").write_text(f"#!ascii label\n{len(cortex)}\n{rows}")
            if seed:
                stem = f"{name}_hemi-{hemi}"
                write_gifti(anat / f"{stem}_white.surf.gii", white, faces)
                write_gifti(anat / f"{stem}_pial.surf.gii", pial, faces)
                write_gifti(anat / f"{stem}_midthickness.surf.gii", (white + pial) / 2, faces)
                # smriprep has them with the other sign
                for values, metric in ((-sulc, "sulc"), (thickness, "thickness"), (-curvature, "curv")):
                    write_gifti(anat / f"{stem}_{metric}.shape.gii", values)


    # 32,492 vertices for N = 128
    coarse = sp.remesh(TETRAHEDRON, FACES, TETRAHEDRON, ("icosahedron", round(0.4454 * n)))
    sphere, faces = coarse.sphere / np.linalg.norm(coarse.sphere, axis=1)[:, None], coarse.faces
    template = folder / "tpl-fsLR"
    template.mkdir(exist_ok=True)
    for hemi in "LR":
        sulc = hemisphere(sphere, hemi, 0)[2]
        write_gifti(template / f"tpl-fsLR_hemi-{hemi}_den-32k_sphere.surf.gii", 100 * sphere, faces)
        write_gifti(template / f"tpl-fsLR_hemi-{hemi}_den-32k_sulc.shape.gii", -sulc)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(Path(sys.argv[1]), *map(int, sys.argv[2:]))
