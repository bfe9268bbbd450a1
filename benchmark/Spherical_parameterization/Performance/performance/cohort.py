"""A folder of meshes by one command, which has a mesh on each core, and by a command for each mesh, on all cores."""

from __future__ import annotations

import statistics
import tempfile
import time
from pathlib import Path

from measuring.mesh_files import MeshFile
from measuring.report import listed, number

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
        if None in seconds.values():
            session.tell("cohort", "Not all meshes were mapped.")
            return
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


def _seconds_for(session: Session, commands: list[list[MeshFile]]) -> float | None:
    """How long the commands, each for a list of meshes, take one after the other; None if one of them fails."""
    with tempfile.TemporaryDirectory(dir=session.report.folder) as folder:
        start = time.monotonic()
        for meshes in commands:
            message = session.program.map_all(meshes, Path(folder))
            if message:
                session.objections.append(f"`--output-folder` with {listed([mesh.name for mesh in meshes])}: {message}")
                return None
        return time.monotonic() - start
