"""A folder of meshes by one command, which has a mesh on each core, and by a command for each mesh, on all cores."""

from __future__ import annotations

import statistics
import subprocess
import tempfile
import time

from measuring.mesh_files import MeshFile
from measuring.report import number

from .session import LARGE, Session


def cohort(session: Session) -> None:
    session.report.begin_section("A Folder of Meshes")
    meshes = [file for file in session.corpus if file.number_of_vertices < LARGE]
    if len(meshes) < 2:
        session.tell("cohort", "There are too few meshes.")
        return
    rounds = []
    for repetition in range(session.repetitions):
        seconds = {}
        for is_together in (True, False) if repetition % 2 == 0 else (False, True):
            seconds[is_together] = _seconds_for(session, [meshes] if is_together else [[mesh] for mesh in meshes])
        rounds.append({"together": seconds[True], "one after the other": seconds[False]})
    together = statistics.median(row["together"] for row in rounds)
    ratio = statistics.median(row["one after the other"] / row["together"] for row in rounds)
    vertices = [mesh.number_of_vertices for mesh in meshes]
    session.tell(
        "cohort",
        f"With {session.threads} threads, {len(meshes)} meshes of {min(vertices):,} to {max(vertices):,} vertices,"
        f" {sum(vertices):,} in all, take {number(together, 2)} seconds from file to file by one command, and"
        f" {number(ratio, 2)} times as long by a command for each, one after the other.",
    )
    session.report.csv("cohort.csv", rounds)


def _seconds_for(session: Session, commands: list[list[MeshFile]]) -> float:
    """How long the commands take one after the other; each is for a list of meshes."""
    with tempfile.TemporaryDirectory(dir=session.report.folder) as folder:
        start = time.monotonic()
        for meshes in commands:
            result = subprocess.run(
                [session.program.path, *(mesh.path for mesh in meshes), "--output-folder", folder]
                + ["--threads", str(session.threads), "--quiet"],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                check=False,
            )
            if result.returncode != 0:
                session.objections.append(f"{meshes[0].name}, --output-folder: {result.stderr.strip()}")
        return time.monotonic() - start
