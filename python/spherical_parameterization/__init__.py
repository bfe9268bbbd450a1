"""One-to-one maps of low distortion from closed triangle meshes without handles to the sphere.

A mesh is two arrays: ``vertices``, (n, 3) numbers, and ``faces``, (m, 3) integers, counterclockwise as seen from outside.
A map of it to the sphere is another one, ``sphere``, (n, 3): the image of each vertex, around the origin. Arrays may be
of any numeric type, contiguous or not; those that are returned are float64 and int64. What is wrong with them is told by
an `Error`.

>>> import spherical_parameterization as sp
>>> sphere, report = sp.parameterize(vertices, faces)
>>> sp.measure_distortion(vertices, faces, sphere).isometric.average
"""

from ._core import ErrorCode, __version__
from ._errors import Error
from ._parameterization import (
    Distortion,
    Measure,
    Report,
    find_defect,
    is_bijective,
    measure_distortion,
    parameterize,
)
from ._sampling import Locator, Remesh, remesh, transfer
from ._surfaces import Overlay, SurfaceMapReport, map_surface, overlay

__all__ = [
    "Distortion",
    "Error",
    "ErrorCode",
    "Locator",
    "Measure",
    "Overlay",
    "Remesh",
    "Report",
    "SurfaceMapReport",
    "__version__",
    "find_defect",
    "is_bijective",
    "map_surface",
    "measure_distortion",
    "overlay",
    "parameterize",
    "remesh",
    "transfer",
]
