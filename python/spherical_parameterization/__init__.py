"""Bijective maps of low distortion from closed triangle meshes of genus 0 to the sphere.

A mesh consists of two arrays: ``vertices``, (n, 3) coordinates, and ``faces``, (m, 3) vertex indices from 0. Faces are
counterclockwise as seen from outside. A map to the sphere is a third array, ``sphere``, (n, 3): the image of each
vertex, a point around the origin. Input arrays may have any numeric type and any memory layout. Returned coordinates
are float64, returned indices int64, unless stated otherwise. Invalid input raises `Error`, which names the vertex or face.
An argument of a wrong type raises TypeError.

Functions take these arrays in the order ``vertices, faces, sphere`` and omit those that they do not need. Functions of
one surface take them as arguments. Functions of two surfaces take a tuple ``(vertices, faces, sphere)`` for each. A mesh
object may replace ``vertices, faces``: any object that has `faces` and either `vertices`, as in trimesh, or `points`, as
in PyVista. Settings are keyword arguments. `threads` is the maximum number of threads, which never exceeds the number of
cores; results have the same bits for any number of threads. Functions that can be stopped early take `time_limit`,
`callback` and `on_interrupt`.

By task:

- read and repair a surface: `read_mesh`, `find_defect`, `repair_surface`, `fill_holes`, `find_handles`
- map a surface to the sphere: `parameterize`, `measure_distortion`, `is_bijective`, `round_to_float`
- apply the inverse map: `Locator`, `remesh`, `transfer`, `measure_distance`
- use existing spheres, such as those of FreeSurfer: `resample`, `resample_sphere`, `compute_sulcal_measures`
- map a surface to another one: `map_surface`, `align_spheres`, `overlay`, `measure_distortion_between`
- expand shapes into spherical harmonics: `expand`, `reconstruct`, `spectrum`, `standard_position`,
  `write_coefficients`, `read_coefficients`
- use other libraries of spherical harmonics: `compute_angles`, `angles_to_directions`
- compute the mean and the modes of many shapes: `shape_modes`

Examples
--------
All examples of this reference use the following surface, a tetrahedron with 258 vertices:

>>> import numpy as np
>>> import spherical_parameterization as sp
>>> corners = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
>>> triangles = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
>>> vertices, faces = sp.remesh(corners, triangles, corners, ("octahedron", 8))[:2]
>>> sphere, report = sp.parameterize(vertices, faces)
"""

from ._angles import angles_to_directions, compute_angles
from ._core import ErrorCode, __version__
from ._errors import Error
from ._files import read_coefficients, read_mesh, write_coefficients
from ._harmonics import HarmonicFit, StandardPosition, expand, reconstruct, spectrum, standard_position
from ._measuring import (
    Distortion,
    SulcalMeasures,
    Measure,
    OneWayDistance,
    SurfaceDistance,
    find_defect,
    is_bijective,
    measure_distance,
    measure_distortion,
    compute_sulcal_measures,
    round_to_float,
)
from ._modes import ShapeModes, shape_modes
from ._parameterization import Areas, Report, parameterize
from ._repair import (
    FilledSurface,
    Handle,
    Hole,
    RepairedSurface,
    RepairPatch,
    RepairReport,
    fill_holes,
    find_handles,
    repair_surface,
)
from ._resampling import resample, resample_sphere
from ._sampling import Locator, Remesh, remesh, transfer
from ._surfaces import (
    DistortionBetween,
    MeasureBetween,
    Overlay,
    SphereAlignment,
    SurfaceMapReport,
    align_spheres,
    map_surface,
    measure_distortion_between,
    overlay,
)

__all__ = [
    "Areas",
    "Distortion",
    "DistortionBetween",
    "Error",
    "ErrorCode",
    "FilledSurface",
    "SulcalMeasures",
    "Handle",
    "HarmonicFit",
    "Hole",
    "Locator",
    "Measure",
    "MeasureBetween",
    "OneWayDistance",
    "Overlay",
    "Remesh",
    "RepairPatch",
    "RepairReport",
    "RepairedSurface",
    "Report",
    "ShapeModes",
    "SphereAlignment",
    "StandardPosition",
    "SurfaceDistance",
    "SurfaceMapReport",
    "__version__",
    "angles_to_directions",
    "compute_angles",
    "align_spheres",
    "expand",
    "fill_holes",
    "find_defect",
    "find_handles",
    "is_bijective",
    "map_surface",
    "measure_distance",
    "measure_distortion",
    "measure_distortion_between",
    "compute_sulcal_measures",
    "overlay",
    "parameterize",
    "read_coefficients",
    "read_mesh",
    "reconstruct",
    "remesh",
    "repair_surface",
    "resample",
    "resample_sphere",
    "round_to_float",
    "shape_modes",
    "spectrum",
    "standard_position",
    "transfer",
    "write_coefficients",
]
