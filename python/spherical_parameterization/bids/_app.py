"""The command line of the app."""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, NoReturn, Optional, Sequence

from .._core import __version__
from .._program import find_program
from ._inputs import Failure, find_atlas, find_subjects
from ._work import Run, process, programs, write_text

NAME = "spherical_parameterization_bids"

EPILOG = """\
For each hemisphere there are written, as smriprep calls them: the sphere; its registration to each atlas, by the depth of folds;
the surfaces and metrics at the vertices of the atlas; and for each subject a page, SUB.html, and a table with what is told of
their quality. All maps are certified to be one-to-one by exact arithmetic.

examples:
  spherical_parameterization_bids $SUBJECTS_DIR out participant --atlas fsaverage=$SUBJECTS_DIR/fsaverage
  spherical_parameterization_bids study/derivatives/smriprep out participant --participant-label 01 \\
    --atlas fsLR=templateflow/tpl-fsLR --resume --n-cpus 2

exit status:
  0  everything is there
  1  something has failed, of which there is a line on the standard error stream and in the page of the subject; the rest is there
  2  the arguments are wrong, or there is nothing to do: nothing was written
  128 + N  signal N has ended it; a subject that was at work is as it was before
"""


def _read_arguments(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog=NAME,
        description="Maps cortical surfaces to the sphere, registers them to atlases and resamples them, for many subjects.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("study", type=Path, metavar="BIDS_OR_DERIVATIVES", help="a subjects folder of FreeSurfer, derivatives of smriprep or fMRIPrep, or a dataset with either")
    add("output", type=Path, metavar="OUT", help="the folder of the results, a dataset of its own; made if it is not there")
    add("level", choices=["participant"], help="the only level of analysis")
    add("--participant-label", "--participant_label", nargs="+", metavar="LABEL", help="the subjects, with or without sub-; all by default")
    add("--hemi", nargs="+", choices=["L", "R"], default=["L", "R"], help="the hemispheres; both by default")
    add("--atlas", action="append", default=[], metavar="NAME=FOLDER", help="an atlas: a folder with sphere and sulcal depth of each hemisphere, as FreeSurfer, TemplateFlow or the HCP name them; NAME is its space, such as fsaverage or fsLR; any number of times")
    add("--metrics", nargs="*", default=["thickness", "curv", "sulc"], metavar="NAME", help="values that are resampled, as far as a subject has them; by default thickness, curv and sulc")
    add("--fslr-desc", choices=["reg", "msmsulc"], default="reg", help="how the registration to fsLR is called; msmsulc is for programs that look for a result of MSM, which it is not")
    add("--resume", action="store_true", help="leave out subjects whose results are there, of these inputs, options and this version")
    add("--n-cpus", "--n_cpus", type=int, default=os.cpu_count() or 1, metavar="N", help="the number of threads; all cores by default")
    add("--version", action="version", version=f"{NAME} {__version__}")
    result = parser.parse_args(arguments)
    if result.n_cpus < 1:
        parser.error(f"--n-cpus has to be 1 or more, not {result.n_cpus}")
    for text in result.atlas:
        if "=" not in text:
            parser.error(f"--atlas has to be NAME=FOLDER, not '{text}'")
    return result


def _describe(output: Path, study: Path, version: str) -> None:
    """Writes the description of the dataset, or checks that the one that is there is of this version."""
    path = output / "dataset_description.json"
    generator: Dict[str, Any] = {"Name": NAME, "Version": __version__, "Description": version}
    if "SPHERICAL_PARAMETERIZATION_IMAGE" in os.environ:  # which the container sets
        generator["Container"] = {"Type": "docker", "Tag": os.environ["SPHERICAL_PARAMETERIZATION_IMAGE"]}
    description = {
        "Name": "Spheres, registrations and resampled surfaces of cortical hemispheres",
        "BIDSVersion": "1.9.0",
        "DatasetType": "derivative",
        "GeneratedBy": [generator],
        "SourceDatasets": [{"URL": study.resolve().as_uri()}],
    }
    if path.exists():
        try:
            generators: List[Any] = json.loads(path.read_text(encoding="utf-8")).get("GeneratedBy", [])
        except (ValueError, AttributeError):
            raise Failure(f"{path} is damaged: choose another output folder") from None
        own = [g for g in generators if isinstance(g, dict) and g.get("Name") == NAME]
        if not own:
            raise Failure(f"{output} is a dataset of another program, as {path.name} says: choose another output folder")
        if own[0].get("Description") != version:
            raise Failure(f"{output} is of another version, {own[0].get('Description')}; this is {version}: choose another output folder")
        return
    write_text(path, json.dumps(description, indent=2) + "\n")


def _end_programs_by(number: int, frame: Any) -> NoReturn:
    """What a signal does: the programs at work end, and this one without their results."""
    signal.signal(number, signal.SIG_IGN)
    for process in list(programs):
        process.terminate()
    raise SystemExit(128 + number)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the app, and returns the exit status."""
    options = _read_arguments(arguments)
    program = find_program()
    version = subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout.strip()
    try:
        hemispheres = sorted(set(options.hemi))
        pairs = [text.split("=", 1) for text in options.atlas]
        if len({name for name, _ in pairs}) < len(pairs):
            raise Failure("two atlases have the same name")
        atlases = [find_atlas(name, Path(folder), hemispheres) for name, folder in pairs]
        subjects = find_subjects(options.study, options.participant_label)
        try:
            options.output.mkdir(parents=True, exist_ok=True)
            _describe(options.output, options.study, version)
        except OSError as error:
            raise Failure(f"{error.filename or options.output}: {error.strerror}") from error
    except Failure as failure:
        print(f"{NAME}: {failure}", file=sys.stderr)
        return 2
    run = Run(program, version, options.output, hemispheres, atlases, options.metrics, options.fslr_desc, options.n_cpus)
    n_failed = n_left_out = 0
    for k, subject in enumerate(subjects, 1):
        is_new, failures = process(subject, run, options.resume)
        state = "failed" if failures else "done" if is_new else "left out, as its results are there"
        print(f"[{k}/{len(subjects)}] {subject.stem}: {state}", flush=True)
        for failure in failures:
            print(f"{NAME}: {subject.stem}: {failure}", file=sys.stderr, flush=True)
        n_failed += bool(failures)
        n_left_out += not is_new
    print(f"Done {len(subjects) - n_failed - n_left_out}, left out {n_left_out}, failed {n_failed}")
    return 1 if n_failed else 0


def run() -> NoReturn:
    """What the command calls."""

    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        signal.signal(number, _end_programs_by)
    sys.exit(main())
