"""Runs programs: any command with limits, and any program that reads a mesh and writes a map of it, which is judged."""

from __future__ import annotations

import json
import re
import shlex
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from .maps import SphericalMap, map_between
from .meshes import FORMATS, MeshError, MeshFile, read_mesh, write_mesh


@dataclass(frozen=True)
class Outcome:
    """How a command has ended, and what it has used."""

    status: int  # negative: the signal that has ended it
    is_timed_out: bool
    process_seconds: float
    cpu_seconds: float  # of all its processes, in user mode and for system calls
    peak_bytes: float  # the physical memory of the largest of them
    output: str
    message: str  # the first words that it said, among its errors if there are any


def run_command(command: list, max_seconds: float = 0.0, max_bytes: float = 0.0) -> Outcome:
    """Runs a command until it ends or a limit is reached; 0 is no limit."""
    launcher = [sys.executable, "-I", "-S", str(Path(__file__).with_name("limited.py"))]
    limits = [str(max_seconds), str(max_bytes)]
    answer = subprocess.run([*launcher, *limits, *map(str, command)], capture_output=True, text=True, errors="replace")
    if answer.returncode != 0:
        raise SystemExit(f"{command[0]} cannot be run: {answer.stderr.strip().splitlines()[-1]}")
    output, outcome = answer.stdout.rsplit("\n", 2)[:2]
    outcome = json.loads(outcome)
    message = " ".join((answer.stderr.strip() or output.strip()).split())[:300]
    if outcome["is_timed_out"]:
        message = f"did not end within {max_seconds:g} seconds"
    elif outcome["status"] < 0:
        message = f"ended by {signal.Signals(-outcome['status']).name}"
    return Outcome(output=output, message=message, **outcome)


class MappingProgram:
    """A program that reads a mesh and writes a map of it, as a command line of the shell.

    {input} and {output} stand in it for the two files, or {input.obj}, say, for a program that asks for a format. The
    mesh is converted beforehand; the map is to have its vertices in their order, and the same faces in any order.
    """

    def __init__(self, name: str, command: str, folder: Path, max_seconds: float, max_bytes: float):
        self.name, self._command, self._folder, self._limits = name, command, folder, (max_seconds, max_bytes)
        places = re.findall(r"\{(input|output)(\.\w+)?\}", command)
        self._formats = dict(places)
        if set(self._formats) != {"input", "output"} or len(set(places)) != 2:
            raise SystemExit(f"{{input}} and {{output}}, each in one format, have to be in the command: {command}")
        if not set(self._formats.values()) <= {"", *FORMATS}:
            raise SystemExit(f"The formats are {', '.join(FORMATS)}, other than in: {command}")

    def run(self, file: MeshFile, max_deviation: float = 1e-6) -> "Mapping":
        """Maps the mesh, and judges the map, whose radii may differ by `max_deviation`."""
        output = self._folder / f"map{self._formats['output'] or '.off'}"
        output.unlink(missing_ok=True)
        source = file.path.resolve()
        if self._formats["input"]:
            source = self._folder / f"{file.name}{self._formats['input']}"
            try:
                write_mesh(source, file.mesh)
            except MeshError as error:
                return Mapping("not run", str(error))
        paths = {"input": source, "output": output}
        command = re.sub(r"\{(input|output)(\.\w+)?\}", lambda m: shlex.quote(str(paths[m.group(1)])), self._command)
        outcome = run_command(["/bin/sh", "-c", command], *self._limits)
        if outcome.is_timed_out:
            return Mapping("timed out", outcome.message, outcome)
        if outcome.status < 0 or outcome.status > 128:  # so a shell reports that a signal has ended its command
            return Mapping("broke down", outcome.message, outcome)
        if outcome.status in (126, 127):  # of the shell
            return Mapping("not run", f"the command cannot be run: {outcome.message}", outcome)
        if outcome.status != 0:
            return Mapping("refused", outcome.message.replace(f"{source}: ", "") or "without a word", outcome)
        if not output.exists():
            return Mapping("no map", "succeeded, but wrote no map", outcome)
        try:
            spherical_map = map_between(file.mesh, read_mesh(output), may_be_mirrored=True)
        except MeshError as error:
            return Mapping("no map", str(error), outcome)
        reason = spherical_map.objection(max_deviation)
        verdict = "not bijective" if spherical_map.number_inverted else "no map" if reason else "certified"
        return Mapping(verdict, reason, outcome, spherical_map)


@dataclass(frozen=True)
class Mapping:
    """How a program did on a mesh: certified, if its map is one-to-one by exact arithmetic."""

    verdict: str
    reason: str  # unless certified
    outcome: Outcome | None = None
    map: SphericalMap | None = None  # if there are images of all vertices
