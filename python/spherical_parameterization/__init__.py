"""One-to-one maps of low distortion from closed triangle meshes without handles to the sphere.

A mesh is two arrays: ``vertices``, (n, 3) numbers, and ``faces``, (m, 3) integers, counterclockwise as seen from outside.
A map of it to the sphere is another one, ``sphere``, (n, 3): the image of each vertex, around the origin. Arrays may be
of any numeric type, contiguous or not; those that are returned are float64 and int64. What is wrong with them is told by
an `Error`.

Functions take the three arrays in this order, without those that they do not need: as arguments where there is one surface,
as a tuple ``(vertices, faces, sphere)`` for each where there are two. In the place of ``vertices, faces`` there may be a mesh: any
object that has `faces`, and `vertices`, as those of trimesh, or `points`, as those of PyVista. Settings are given by name. Functions that may take
long have `threads`, the largest number of them, of which there are never more than cores; and those that can be stopped
`time_limit`, `callback` and `on_interrupt`.

>>> import spherical_parameterization as sp
>>> vertices, faces = sp.read_mesh("bunny.off")
>>> sphere, report = sp.parameterize(vertices, faces)
>>> sp.measure_distortion(vertices, faces, sphere).isometric.average
>>> directions, report = sp.map_surface((vertices, faces, sphere), (other_vertices, other_faces, other_sphere))

What there is, by task:

- read and repair: `read_mesh`, `find_defect`, `repair_surface`, `fill_holes`, `find_handles`
- a surface to the sphere: `parameterize`, `measure_distortion`, `is_bijective`, `round_to_float`
- back from the sphere: `Locator`, `remesh`, `transfer`, `measure_distance`
- spheres that exist, such as those of FreeSurfer: `resample`, `resample_sphere`
- a surface to another one: `map_surface`, `align_spheres`, `compute_sulcal_measures`, `overlay`, `measure_distortion_between`
- shapes as numbers: `expand`, `reconstruct`, `spectrum`, `standard_position`, `write_coefficients`, `read_coefficients`
- for other libraries of harmonics: `compute_angles`, `angles_to_directions`
- the mean and the modes of many shapes: `shape_modes`
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
