"""The command line of the app."""

from __future__ import annotations

import argparse
import json
import os
import re
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any, Dict, List, NoReturn, Optional, Sequence, TextIO

from .._core import __version__
from .._program import find_program
from ._inputs import Failure, find_atlas, find_subjects
from ._work import NAME, SIGNALS, Run, process, programs, write_text

EPILOG = """\
The app writes for each hemisphere, with the file names of smriprep: the sphere; its registration to each atlas, by sulcal depth; and
the surfaces and metrics resampled to the vertices of the atlas. For each subject it writes a page, SUB.html, and a table with the
quality of all maps. All maps are certified bijective by exact arithmetic.

examples:
  spherical_parameterization_bids $SUBJECTS_DIR out participant --atlas fsaverage=$SUBJECTS_DIR/fsaverage
  spherical_parameterization_bids study/derivatives/smriprep out participant --participant-label 01 \\
    --atlas fsLR:32k=templateflow/tpl-fsLR --resume --n-cpus 2

exit status:
  0  all results were written
  1  a step failed: the standard error stream and the page of the subject report it; all other results were written
  2  the arguments are wrong, a subject does not exist, or OUT belongs to another program or version: nothing was written
  128 + N  signal N ended the app; the subject in progress is unchanged
"""


def _read_arguments(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog=NAME,
        description="Maps cortical surfaces to the sphere, registers them to atlases and resamples them, for many subjects.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("study", metavar="BIDS_OR_DERIVATIVES", help="a subjects directory of FreeSurfer, derivatives of smriprep or fMRIPrep, or a dataset that contains either")
    add("output", metavar="OUT", help="the output folder, a separate dataset; created if it does not exist")
    add("level", choices=["participant"], help="the only level of analysis")
    add("--participant-label", "--participant_label", nargs="+", metavar="LABEL", help="the subjects, with or without sub-; all by default")
    add("--session-label", "--session_label", nargs="+", metavar="LABEL", help="the sessions, with or without ses-; all by default")
    add("--hemi", nargs="+", choices=["L", "R"], default=["L", "R"], help="the hemispheres; both by default")
    add("--atlas", action="append", default=[], metavar="NAME[:DENSITY]=FOLDER", help="an atlas: a folder with the sphere and the sulcal depth of each hemisphere, with the file names of FreeSurfer, TemplateFlow or the HCP; NAME, such as fsaverage or fsLR, becomes space-NAME in file names, and DENSITY, such as 32k, selects one of several; may be repeated")
    add("--metrics", nargs="*", default=["thickness", "curv", "sulc"], metavar="NAME", help="metrics to resample, if the subject has them; by default thickness, curv and sulc")
    add("--fslr-desc", choices=["reg", "msmsulc"], default="reg", help="name of the registration to fsLR. The app does not run MSM; choose msmsulc for programs that find only registrations of this name")
    add("--resume", action="store_true", help="skip subjects whose results exist and were computed from the same inputs with the same options and version")
    add("--skip-bids-validation", "--skip_bids_validation", action="store_true", help="has no effect, as nothing is validated; accepted for launchers that always pass it")
    add("--n-cpus", "--n_cpus", "--nthreads", type=int, default=os.cpu_count() or 1, metavar="N", help="the number of threads; all cores by default")
    add("--version", action="version", version=f"{NAME} {__version__}")
    result = parser.parse_args(arguments)
    if result.n_cpus < 1:
        parser.error(f"--n-cpus must be 1 or more, not {result.n_cpus}")
    for text in result.atlas:
        if not re.fullmatch(r"[^=:]+(:[^=:]+)?=.+", text, re.DOTALL):
            parser.error(f"--atlas must be NAME=FOLDER or NAME:DENSITY=FOLDER, not '{text}'")
    for name in ("study", "output"):
        if not getattr(result, name):
            parser.error(f"{'BIDS_OR_DERIVATIVES' if name == 'study' else 'OUT'} is empty")
        setattr(result, name, Path(getattr(result, name)))
    if os.path.realpath(result.study) == os.path.realpath(result.output):
        parser.error("OUT is the folder of the surfaces: choose another folder for the results")
    return result


def _describe(output: Path, study: Path, version: str) -> None:
    """Writes the description of the dataset, or checks that an existing one is of this version."""
    path = output / "dataset_description.json"
    generator: Dict[str, Any] = {"Name": NAME, "Version": __version__, "Description": version}
    if "SPHERICAL_PARAMETERIZATION_IMAGE" in os.environ:  # set by the container
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
            own = [g for g in generators if isinstance(g, dict) and g.get("Name") == NAME]
        except (ValueError, AttributeError, TypeError):
            raise Failure(f"{path} is damaged: choose another output folder") from None
        if not own:
            raise Failure(f"{output} is a dataset of another program according to {path.name}: choose another output folder")
        if own[0].get("Description") != version:
            raise Failure(f"{output} was written by another version, {own[0].get('Description')}; this is {version}: choose another output folder")
        return
    # Files that validators do not know
    if not (output / ".bidsignore").exists():
        write_text(output / ".bidsignore", "*.html\n**/figures/\n*_surfaces.json\n*_surfaces.tsv\n")
    write_text(path, json.dumps(description, indent=2) + "\n")


def _say(text: str, stream: TextIO) -> None:
    """Prints a line. A closed stream does not end the run."""
    try:
        print(text.encode(errors="backslashreplace").decode(), file=stream, flush=True)
    except OSError:
        with suppress(OSError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _end_programs_by(number: int, frame: Any) -> NoReturn:
    """Handles a signal: ends the running programs, and this one without their results."""
    for other in SIGNALS:
        signal.signal(other, signal.SIG_IGN)
    programs.end()
    raise SystemExit(128 + number)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the app, and returns the exit status."""
    options = _read_arguments(arguments)
    program = find_program()
    version = subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout.strip()
    try:
        hemispheres = sorted(set(options.hemi))
        pairs = [(*text.split("=", 1)[0].partition(":")[::2], Path(text.split("=", 1)[1])) for text in options.atlas]
        if len({name for name, _, _ in pairs}) < len(pairs):
            raise Failure("two atlases have the same name")
        atlases = [find_atlas(name, density or None, folder, hemispheres) for name, density, folder in pairs]
        folders = [folder for _, _, folder in pairs]
        subjects = find_subjects(options.study, options.participant_label, options.session_label, folders)
        absent = [m for m in options.metrics if not any(m in h.metrics for s in subjects for h in s.hemispheres.values())]
        try:
            options.output.mkdir(parents=True, exist_ok=True)
            _describe(options.output, options.study, version)
        except OSError as error:
            raise Failure(f"{error.filename or options.output}: {error.strerror}") from error
    except Failure as failure:
        print(f"{NAME}: {failure}", file=sys.stderr)
        return 2
    run = Run(program, version, options.output, hemispheres, atlases, options.metrics, options.fslr_desc, options.n_cpus)
    for metric in absent:
        _say(f"{NAME}: no subject has the metric {metric}", sys.stderr)
    n_failed = n_skipped = 0
    for k, subject in enumerate(subjects, 1):
        is_new, result = process(subject, run, options.resume)
        state = "failed" if result.failures else "done" if is_new else "skipped, its results are up to date"
        _say(f"[{k}/{len(subjects)}] {subject.stem}: {state}", sys.stdout)
        for text in result.failures:
            _say(f"{NAME}: {subject.stem}: {text}", sys.stderr)
        for row in result.rows:
            if row.get("certain") is False:
                registration = f"hemisphere {row['hemisphere']}: the registration to {row['map']}"
                _say(f"{NAME}: {subject.stem}: {registration} is uncertain: inspect it", sys.stderr)
        n_failed += bool(result.failures)
        n_skipped += not is_new
    _say(f"Done {len(subjects) - n_failed - n_skipped}, skipped {n_skipped}, failed {n_failed}", sys.stdout)
    return 1 if n_failed else 0


def run() -> NoReturn:
    """Entry point of the command."""

    for number in SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # set by nohup
            signal.signal(number, _end_programs_by)
    sys.exit(main())
