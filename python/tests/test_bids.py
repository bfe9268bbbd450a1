"""Tests the BIDS App on subjects with few vertices, which make_subjects.py generates."""

import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp

nb = pytest.importorskip("nibabel")
ROOT = Path(__file__).resolve().parents[2]
N = 16
PROGRAM = Path(os.environ["PROGRAM"])
if not (PROGRAM.parent.parent / "page/page.stamp").exists():
    pytest.skip("the program has been built without its page", allow_module_level=True)
# The derivative files that smriprep queries
PATTERN = re.compile(
    r"sub-[A-Za-z0-9]+(_ses-[A-Za-z0-9]+)?_hemi-[LR](_space-[A-Za-z0-9]+)?(_den-[0-9]+k)?(_desc-[A-Za-z0-9]+)?"
    r"_(white|pial|midthickness|sphere|thickness|sulc|curv)\.(surf|shape)\.gii"
)


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    folder = tmp_path_factory.mktemp("data")
    script = ROOT / "test/Spherical_parameterization/make_subjects.py"
    subprocess.run([sys.executable, str(script), str(folder), str(N)], check=True)
    return folder


def environment():
    return {**os.environ, "PATH": str(PROGRAM.parent) + os.pathsep + os.environ["PATH"]}


def run(*arguments, status=0, **settings):
    command = [sys.executable, "-m", "spherical_parameterization.bids", *map(str, arguments)]
    result = subprocess.run(command, env=environment(), capture_output=True, text=True, **settings)
    assert result.returncode == status, result.stderr
    assert "Traceback" not in result.stderr
    return result


def hidden(folder):
    return sorted(path.name for path in folder.glob(".*"))


def atlases(data):
    return ("--atlas", f"fsaverage={data / 'freesurfer/fsaverage'}", "--atlas", f"fsLR={data / 'tpl-fsLR'}")


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("tree", ["freesurfer", "derivatives"])
def test_writes_files_that_smriprep_reads(data, tmp_path, tree):
    before = contents(data / tree)
    result = run(data / tree, tmp_path / "out", "participant", *atlases(data), "--n-cpus", 2)
    assert result.stdout.splitlines() == ["[1/2] sub-01: done", "[2/2] sub-02: done", "Done 2, skipped 0, failed 0"]
    assert contents(data / tree) == before
    out = tmp_path / "out"
    assert hidden(out) == [".bidsignore"], "temporary files are removed"
    description = json.loads((out / "dataset_description.json").read_text())
    assert description["DatasetType"] == "derivative" and description["GeneratedBy"][0]["Version"] == sp.__version__
    anat = out / "sub-02/anat"
    found = sorted(path.name for path in anat.glob("*.gii"))
    assert all(PATTERN.fullmatch(name) for name in found)
    kinds = ["white", "pial"] + (["midthickness"] if tree == "derivatives" else [])
    n = 10 * N * N + 2
    coarse = 10 * round(0.4454 * N) ** 2 + 2
    for hemi in "LR":
        stem = f"sub-02_hemi-{hemi}"
        structure = {"L": "CortexLeft", "R": "CortexRight"}[hemi]
        image = nb.load(anat / f"{stem}_sphere.surf.gii")
        points, faces = image.agg_data()
        assert image.darrays[0].meta["AnatomicalStructurePrimary"] == structure
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 100, atol=0.05)
        assert sp.is_bijective(faces, points) and points.shape == (n, 3)
        for space, size in (("fsaverage", n), ("fsLR", coarse)):
            registered, same = nb.load(anat / f"{stem}_space-{space}_desc-reg_sphere.surf.gii").agg_data()
            assert (same == faces).all() and sp.is_bijective(faces, registered)
            resampled = f"{stem}_space-{space}_den-{round(size / 1000)}k"
            for kind in kinds:
                image = nb.load(anat / f"{resampled}_{kind}.surf.gii")
                assert image.agg_data()[0].shape == (size, 3)
                assert image.darrays[0].meta["AnatomicalStructurePrimary"] == structure
            for metric in ("thickness", "curv", "sulc"):
                assert nb.load(anat / f"{resampled}_{metric}.shape.gii").agg_data().shape == (size,)
    assert len(found) == 2 * (1 + 2 * (1 + len(kinds) + 3))
    report = json.loads((anat / "sub-02_hemi-L_space-fsLR_desc-reg_sphere.json").read_text())
    assert report["match"]["agreement"] > 0.7 and not {"files", "input_stamp", "start_stamp"} & set(report)
    assert "start from sub-02_hemi-L_sphere.surf.gii, symmetric-dirichlet energy" in report["method"]
    assert not any(".work" in path.read_text() for path in anat.glob("*.json")), "temporary paths"
    head, *rows = (anat / "sub-02_desc-quality_surfaces.tsv").read_text().splitlines()
    assert head.split("\t")[:3] == ["hemisphere", "map", "vertices"] and len(rows) == 6
    page = (out / "sub-02.html").read_text()
    for link in re.findall(r'href="(.*?)"', page):
        assert (out / link).is_file()
    assert page.count("<tr>") == 7 and "Failures" not in page


def test_registration_aligns_sulci(data, tmp_path):
    run(data / "freesurfer", tmp_path, "participant", "--participant-label", "01", "--hemi", "L", *atlases(data)[:2])
    sulc = nb.load(tmp_path / "sub-01/anat/sub-01_hemi-L_space-fsaverage_den-3k_sulc.shape.gii").agg_data()
    of_atlas = nb.freesurfer.read_morph_data(data / "freesurfer/fsaverage/surf/lh.sulc")
    own = nb.freesurfer.read_morph_data(data / "freesurfer/sub-01/surf/lh.sulc")
    mask = sulc != 0
    assert np.corrcoef(own, of_atlas)[0, 1] < 0.75 and np.corrcoef(sulc[mask], of_atlas[mask])[0, 1] > 0.9


def test_resumes(data, tmp_path):
    arguments = (data / "freesurfer", tmp_path / "out", "participant", "--hemi", "L", "--resume")
    run(*arguments)
    before = contents(tmp_path / "out")
    assert run(*arguments).stdout.count("skipped, its results are up to date") == 2
    assert contents(tmp_path / "out") == before
    sphere = tmp_path / "out/sub-01/anat/sub-01_hemi-L_sphere.surf.gii"
    sphere.unlink()
    (tmp_path / "out/sub-02/anat/sub-02_desc-provenance_surfaces.json").write_text("{")
    # The record of its own files is lost.
    result = run(*arguments, status=1)
    assert "sub-01: done" in result.stdout and "was not written by this program, or is damaged" in result.stderr
    assert sphere.read_bytes() == before["sub-01/anat/sub-01_hemi-L_sphere.surf.gii"]
    assert "sub-01: done" in run(*arguments, "--metrics", "curv", status=1).stdout, "the options have changed"


def test_many_processes_share_an_output(data, tmp_path):
    command = [sys.executable, "-m", "spherical_parameterization.bids", str(data / "freesurfer"), str(tmp_path), "participant"]
    running = [
        subprocess.Popen([*command, "--participant-label", label], env=environment(), stdout=subprocess.DEVNULL)
        for label in ("01", "sub-02")
    ]
    assert [process.wait() for process in running] == [0, 0]
    assert {path.name for path in tmp_path.glob("sub-*.html")} == {"sub-01.html", "sub-02.html"}
    with open(tmp_path / ".sub-01.lock", "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        result = run(*command[3:], "--participant-label", "01", status=1)
    assert "sub-01: another process is working on it" in result.stderr


def test_a_damaged_subject_does_not_affect_others(data, tmp_path):
    study = tmp_path / "study"
    shutil.copytree(data / "freesurfer/sub-01", study / "sub-01")
    for name in ("half", "empty", "damaged"):
        shutil.copytree(data / "freesurfer/sub-02", study / name)
    (study / "half/surf/rh.white").unlink()
    shutil.rmtree(study / "empty/surf")
    (study / "empty/mri").mkdir()
    white = study / "damaged/surf/lh.white"
    white.write_bytes(white.read_bytes()[:5000])
    result = run(study, tmp_path / "out", "participant", "--participant-label", "01", "half", "empty", "damaged", status=1)
    assert result.stdout.splitlines()[-1] == "Done 1, skipped 0, failed 3"
    lines = result.stderr.splitlines()
    assert [line.split(": ")[1] for line in lines] == ["sub-half", *["sub-empty"] * 2, "sub-damaged"]
    assert "hemisphere R: " in lines[0] and "has no white surface" in lines[0] and "damaged/surf/lh.white" in lines[3]
    out = tmp_path / "out"
    assert (out / "sub-half/anat/sub-half_hemi-L_sphere.surf.gii").is_file()
    assert (out / "sub-damaged/anat/sub-damaged_hemi-R_sphere.surf.gii").is_file()
    assert not list(out.rglob("sub-damaged_hemi-L*"))
    for name in ("half", "empty", "damaged"):
        assert "Failures" in (out / f"sub-{name}.html").read_text()


def test_never_replaces_files_of_other_programs(data, tmp_path):
    foreign = tmp_path / "out/sub-01/anat/sub-01_hemi-R_sphere.surf.gii"
    foreign.parent.mkdir(parents=True)
    foreign.write_text("of another program")
    arguments = (data / "freesurfer", tmp_path / "out", "participant", "--participant-label", "01")
    assert "was not written by this program" in run(*arguments, status=1).stderr
    assert [path for path in (tmp_path / "out").rglob("*.gii")] == [foreign] and foreign.read_text() == "of another program"
    foreign.unlink()
    run(*arguments)
    foreign.write_text("changed by hand")
    assert run(*arguments, status=1).returncode == 1 and foreign.read_text() == "changed by hand"


def test_an_output_of_another_version_or_program_is_refused(data, tmp_path):
    arguments = (data / "freesurfer", tmp_path, "participant", "--hemi", "L")
    path = tmp_path / "dataset_description.json"
    for text, message in (
        ('{"GeneratedBy": [{"Name": "fMRIPrep"}]}', "of another program"),
        ('{"GeneratedBy": [{"Name": "spherical_parameterization_bids", "Description": "0.2"}]}', "by another version, 0.2"),
        ("{", "damaged"),
    ):
        path.write_text(text)
        assert message in run(*arguments, status=2).stderr
        assert contents(tmp_path) == {path.name: text.encode()}


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["NONE", "OUT", "participant"], "is not a folder"),
        (["DATA", "DATA", "participant"], "another folder for the results"),
        (["", "OUT", "participant"], "BIDS_OR_DERIVATIVES is empty"),
        (["DATA", "OUT", "participant", "--participant-label", "01", "99"], "no subject '99'; it has 01, 02"),
        (["DATA", "OUT", "participant", "--participant-label", "../01"], "no subject '../01'"),
        (["DATA", "OUT", "participant", "--session-label", "a"], "no subject with the session a"),
        (["DATA", "OUT", "group"], "invalid choice"),
        (["DATA", "OUT", "participant", "--atlas", "fsaverage"], "NAME=FOLDER"),
        (["DATA", "OUT", "participant", "--atlas", "fsaverage=NONE"], "is not an atlas"),
        (["DATA", "OUT", "participant", "--atlas", "fs-LR=DATA"], "letters and digits"),
        (["DATA", "OUT", "participant", "--n-cpus", "0"], "1 or more"),
    ],
)
def test_wrong_arguments(data, tmp_path, arguments, message):
    paths = {"NONE": tmp_path / "none", "OUT": tmp_path / "out", "DATA": data / "freesurfer"}
    words = [re.sub("NONE|OUT|DATA", lambda match: str(paths[match.group()]), word) for word in arguments]
    assert message in run(*words, status=2).stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.skipif(os.geteuid() != 0 or not shutil.which("mount"), reason="a small disk is mounted by root")
def test_a_full_disk_is_an_error(data, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "none", str(disk)], capture_output=True).returncode:
        pytest.skip("no disk can be mounted here")
    try:
        result = run(data / "freesurfer", disk / "out", "participant", "--participant-label", "01", status=1)
        assert "sub-01: failed" in result.stdout and result.stderr
        assert not list(disk.rglob("*.gii")) and hidden(disk / "out") == [".bidsignore"]
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_a_signal_ends_the_app_without_results(data, tmp_path):
    command = [sys.executable, "-m", "spherical_parameterization.bids", str(data / "freesurfer"), str(tmp_path), "participant"]
    process = subprocess.Popen(command, env=environment(), stderr=subprocess.PIPE, text=True)
    while not list(tmp_path.glob(".sub-01.work/*")):
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGTERM)
    assert "Traceback" not in process.communicate(timeout=60)[1]
    assert process.returncode == 128 + signal.SIGTERM
    assert not list(tmp_path.rglob("*.gii")) and hidden(tmp_path) == [".bidsignore"]


def test_sessions_and_datasets_of_images(data, tmp_path):
    study = tmp_path / "study"
    for session in ("a", "b"):
        shutil.copytree(data / "derivatives/sub-01/anat", study / f"derivatives/smriprep/sub-01/ses-{session}/anat")
        for path in (study / f"derivatives/smriprep/sub-01/ses-{session}/anat").iterdir():
            path.rename(path.with_name(path.name.replace("sub-01_", f"sub-01_ses-{session}_")))
    (study / "sub-01/anat").mkdir(parents=True)
    result = run(study, tmp_path / "out", "participant", "--hemi", "R", "--fslr-desc", "msmsulc", *atlases(data)[2:])
    assert "sub-01_ses-a: done" in result.stdout and "sub-01_ses-b: done" in result.stdout
    anat = tmp_path / "out/sub-01/ses-b/anat"
    assert (anat / "sub-01_ses-b_hemi-R_space-fsLR_desc-msmsulc_sphere.surf.gii").is_file()
    shutil.copytree(data / "freesurfer/sub-01", study / "derivatives/freesurfer/sub-01")
    assert "give one of" in run(study, tmp_path / "other", "participant", status=2).stderr


def test_resuming_detects_changes(data, tmp_path):
    fsaverage, fslr = data / "freesurfer/fsaverage", data / "tpl-fsLR"
    arguments = (data / "freesurfer", tmp_path, "participant", "--participant-label", "01", "--hemi", "L", "--resume")
    run(*arguments, "--atlas", f"a={fsaverage}", "--atlas", f"b={fslr}")
    assert "done" in run(*arguments, "--atlas", f"b={fsaverage}", "--atlas", f"a={fslr}").stdout
    relative = os.path.relpath(data / "freesurfer", tmp_path.parent)
    same = (relative, *arguments[1:], "--atlas", f"b={fsaverage}", "--atlas", f"a={fslr}")
    assert "skipped" in run(*same, cwd=tmp_path.parent).stdout
    # Processing one hemisphere keeps the other one, and removes outdated results.
    other = [word if word != "L" else "R" for word in arguments]
    run(*other, "--atlas", f"a={fsaverage}")
    for _ in range(2):
        assert "skipped" in run(*other, "--atlas", f"a={fsaverage}").stdout
    assert (tmp_path / "sub-01/anat/sub-01_hemi-L_sphere.surf.gii").is_file()
    run(*other, "--atlas", f"b={fsaverage}")
    assert not list(tmp_path.rglob("*hemi-R_space-a_*")) and list(tmp_path.rglob("*hemi-L_space-a_*"))


def test_results_of_another_input_are_removed(data, tmp_path):
    shutil.copytree(data / "freesurfer/sub-01", tmp_path / "study/sub-01")
    arguments = (tmp_path / "study", tmp_path / "out", "participant")
    run(*arguments)
    (tmp_path / "study/sub-01/surf/lh.white").write_text("damaged")
    run(*arguments, status=1)
    assert not list((tmp_path / "out").rglob("*hemi-L*")) and list((tmp_path / "out").rglob("*hemi-R*"))


def test_an_invalid_metric_does_not_affect_other_results(data, tmp_path):
    study = tmp_path / "study"
    shutil.copytree(data / "freesurfer/sub-01", study / "sub-01")
    nb.freesurfer.write_morph_data(study / "sub-01/surf/lh.thickness", np.zeros(5, np.float32))
    (study / "sub-01/surf/rh.pial").unlink()
    (study / "sub-01/surf/rh.pial").symlink_to("nowhere")
    result = run(study, tmp_path / "out", "participant", *atlases(data)[:2], "--metrics", "thickness", "curv", "volume", status=1)
    assert "no subject has the metric volume" in result.stderr and "thickness" in result.stderr
    left = {path.name for path in (tmp_path / "out").rglob("*_den-3k_*")}
    assert "sub-01_hemi-L_space-fsaverage_den-3k_curv.shape.gii" in left
    assert "sub-01_hemi-L_space-fsaverage_den-3k_thickness.shape.gii" not in left
    assert "sub-01_hemi-R_space-fsaverage_den-3k_thickness.shape.gii" in left


def test_sessions_without_surfaces_are_ignored(data, tmp_path):
    study = tmp_path / "study"
    shutil.copytree(data / "derivatives", study)
    (study / "sub-01/ses-1/func").mkdir(parents=True)
    assert "Done 2" in run(study, tmp_path / "out", "participant", "--hemi", "L").stdout


def test_subjects_are_named_by_label_or_folder(data, tmp_path):
    study = tmp_path / "study"
    for session in ("1", "2"):
        shutil.copytree(data / "freesurfer/sub-01", study / f"sub-01_ses-{session}")
    arguments = (study, tmp_path / "out", "participant", "--hemi", "L")
    for name in ("sub-01_ses-1", "01_ses-1"):
        assert run(*arguments, "--participant-label", name).stdout.startswith("[1/1] sub-01_ses-1: done")
    assert "[2/2] sub-01_ses-2: done" in run(*arguments, "--participant-label", "01").stdout
    assert "[1/1] sub-01_ses-2" in run(*arguments, "--participant-label", "01", "--session-label", "2").stdout


def test_an_atlas_of_several_densities(data, tmp_path):
    folder = tmp_path / "tpl-fsLR"
    folder.mkdir()
    for path in (data / "tpl-fsLR").iterdir():
        shutil.copy(path, folder)
        shutil.copy(path, folder / path.name.replace("den-32k", "den-59k"))
        (folder / path.name.replace("den-32k", "den-164k")).touch()
    arguments = (data / "freesurfer", tmp_path / "out", "participant", "--participant-label", "01", "--hemi", "L")
    assert "give a density, as in fsLR:" in run(*arguments, "--atlas", f"fsLR={folder}", status=2).stderr
    assert "empty" in run(*arguments, "--atlas", f"fsLR:164k={folder}", status=2).stderr
    run(*arguments, "--atlas", f"fsLR:32k={folder}")


@pytest.mark.parametrize("step", ["map", "register"])
def test_a_program_that_is_interrupted_has_no_result(data, tmp_path, step):
    """After a signal, the program writes an incomplete result, and its report states this."""
    from spherical_parameterization.bids import _inputs, _work

    program = tmp_path / "program"
    program.write_text(
        f'#!/bin/sh\n"{PROGRAM}" "$@" || exit\n[ $1 = {step} ] || exit 0\n'
        'for word; do case $word in *.json) sed -i "s/\\"converged\\"/\\"interrupted\\"/" "$word" ;; esac; done\n'
    )
    program.chmod(0o755)
    out = tmp_path / "out"
    out.mkdir()
    atlas = _inputs.find_atlas("fsaverage", None, data / "freesurfer/fsaverage", ["L"])
    subject = _inputs.find_subjects(data / "freesurfer", ["01"], None, [])[0]
    is_new, result = _work.process(subject, _work.Run(str(program), "0", out, ["L"], [atlas], [], "reg", 1), False)
    assert is_new and result.failures == ["hemisphere L: the program was interrupted by a signal"]
    assert not list(out.rglob("*_desc-reg_*")) and len(list(out.rglob("*_sphere.surf.gii"))) == (step == "register")


def test_invalid_provenance_files_are_not_replaced(data, tmp_path):
    provenance = tmp_path / "sub-01/anat/sub-01_desc-provenance_surfaces.json"
    provenance.parent.mkdir(parents=True)
    for text in ("mine", "{}", '{"files": {"sub-01.html": null}, "program": "spherical_parameterization_bids"}'):
        provenance.write_text(text)
        result = run(data / "freesurfer", tmp_path, "participant", "--participant-label", "01", "--hemi", "L", status=1)
        assert "was not written by this program" in result.stderr and provenance.read_text() == text


def test_a_closed_standard_output(data, tmp_path):
    command = f'"{sys.executable}" -m spherical_parameterization.bids "{data / "freesurfer"}" out participant --hemi L'
    subprocess.run(["sh", "-c", f"{command} | true"], env=environment(), cwd=tmp_path, check=True)
    assert len(list((tmp_path / "out").glob("sub-*.html"))) == 2
    # nohup stays in force
    subprocess.run(
        ["sh", "-c", f"trap '' HUP; {command} --metrics curv & sleep 0.5; kill -HUP $!; wait $!"], env=environment(), cwd=tmp_path, check=True
    )
