from typing import Any, Callable, ClassVar, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

_Points = NDArray[np.float64]
_Faces = NDArray[np.int64]

__version__: str

class ErrorCode:
    EMPTY_MESH: ClassVar[ErrorCode]
    TOO_FEW_VERTICES: ClassVar[ErrorCode]
    NON_TRIANGULAR_MESH: ClassVar[ErrorCode]
    NON_CLOSED_MESH: ClassVar[ErrorCode]
    SEVERAL_COMPONENTS: ClassVar[ErrorCode]
    NO_TOPOLOGICAL_SPHERE: ClassVar[ErrorCode]
    NO_SIMPLICIAL_COMPLEX: ClassVar[ErrorCode]
    NON_FINITE_COORDINATE: ClassVar[ErrorCode]
    INVALID_INITIAL_PARAMETERIZATION: ClassVar[ErrorCode]
    NO_1_TO_1_MAPPING: ClassVar[ErrorCode]
    INSUFFICIENT_PRECISION: ClassVar[ErrorCode]
    WRONG_PARAMETER: ClassVar[ErrorCode]
    TOO_LARGE_MESH: ClassVar[ErrorCode]
    TOO_LARGE_OVERLAY: ClassVar[ErrorCode]
    INVALID_DIRECTION: ClassVar[ErrorCode]
    INVALID_SURFACE_FILE: ClassVar[ErrorCode]
    INVALID_HARMONICS_FILE: ClassVar[ErrorCode]
    UNDETERMINED_ROTATION: ClassVar[ErrorCode]
    TOO_HIGH_DEGREE: ClassVar[ErrorCode]
    INVALID_DENSITY: ClassVar[ErrorCode]
    INVALID_LANDMARK: ClassVar[ErrorCode]
    STOPPED: ClassVar[ErrorCode]
    __members__: ClassVar[Dict[str, ErrorCode]]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class Locator:
    def __init__(self, faces: _Faces, sphere: _Points, threads: int) -> None: ...
    def locate(self, directions: _Points) -> Tuple[_Faces, _Points]: ...

def parameterize(
    vertices: _Points,
    faces: _Faces,
    prefer: str,
    energy: str,
    initial: Optional[_Points],
    starts_from_drawing: bool,
    density: Optional[NDArray[np.float64]],
    is_of_faces: bool,
    threads: int,
    time_limit: float,
    callback: Optional[Callable[[int, float, float], Any]],
    returns_on_interrupt: bool,
) -> Tuple[_Points, Dict[str, Any], Optional[Dict[str, Any]]]: ...
def fill_holes(
    vertices: _Points, faces: _Faces, max_edges: int
) -> Tuple[_Points, _Faces, Sequence[Tuple[int, int, float, int, float]]]: ...
def repair_surface(
    vertices: _Points,
    corners: NDArray[np.int64],
    first: NDArray[np.int64],
    maximum_hole: float,
    maximum_handle: float,
    maximum_added_area: float,
    refines_patches: bool,
) -> Tuple[
    _Points,
    _Faces,
    NDArray[np.int64],
    NDArray[np.int64],
    Sequence[int],
    int,
    List[NDArray[np.int64]],
    Sequence[Tuple[bool, int, int, float, float]],
    float,
]: ...
def find_handles(vertices: _Points, faces: _Faces, max_handles: int) -> Sequence[Tuple[NDArray[np.int64], float]]: ...
def find_defect(vertices: _Points, faces: _Faces) -> None: ...
def is_bijective(faces: _Faces, sphere: _Points, threads: int) -> bool: ...
def round_to_float(faces: _Faces, sphere: _Points, threads: int) -> NDArray[np.float32]: ...
def compute_sulcal_measures(
    vertices: _Points, faces: _Faces, threads: int
) -> Tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
def measure_distortion(vertices: _Points, faces: _Faces, sphere: _Points, threads: int) -> Dict[str, Any]: ...
def measure_distance(
    vertices1: _Points, faces1: _Faces, vertices2: _Points, faces2: _Faces, number_of_points: int, threads: int
) -> Tuple[Tuple[float, float], Tuple[float, float], float]: ...
def remesh(
    vertices: _Points, faces: _Faces, sphere: _Points, solid: str, subdivision: int, threads: int
) -> Tuple[_Points, _Faces, _Points]: ...
def remesh_with(
    vertices: _Points, faces: _Faces, sphere: _Points, domain_faces: _Faces, domain_sphere: _Points, threads: int
) -> Tuple[_Points, _Points]: ...
def transfer(
    values: NDArray[Any],
    is_of_faces: bool,
    vertices: _Points,
    faces: _Faces,
    sphere: _Points,
    target_faces: _Faces,
    target_sphere: _Points,
    threads: int,
) -> NDArray[Any]: ...
def resample(
    values: NDArray[Any],
    faces: _Faces,
    sphere: _Points,
    target_faces: _Faces,
    target_sphere: _Points,
    method: str,
    areas: NDArray[np.float64],
    target_areas: NDArray[np.float64],
    mask: NDArray[np.bool_],
    threads: int,
) -> Tuple[NDArray[Any], NDArray[np.bool_]]: ...
def resample_sphere(
    faces: _Faces, sphere: _Points, registered: _Points, target_faces: _Faces, target_sphere: _Points, threads: int
) -> _Points: ...
def expand(
    vertices: _Points,
    faces: _Faces,
    sphere: _Points,
    values: Optional[NDArray[np.float64]],
    degree: int,
    weights: str,
    normalization: str,
    has_phase: bool,
    threads: int,
) -> Tuple[NDArray[np.float64], Tuple[float, float, float, int, int]]: ...
def evaluate_harmonics(
    coefficients: NDArray[np.float64], normalization: str, has_phase: bool, directions: _Points, threads: int
) -> NDArray[np.float64]: ...
def make_domain(solid: str, subdivision: int) -> Tuple[_Faces, _Points]: ...
def standard_position(
    coefficients: NDArray[np.float64], normalization: str, has_phase: bool, threads: int
) -> Tuple[Any, ...]: ...
def read_mesh(path: bytes) -> Tuple[_Points, _Faces]: ...
def read_coefficients(
    content: bytes, is_table: bool, normalization: str, has_phase: bool
) -> NDArray[np.float64]: ...
def write_coefficients(
    coefficients: NDArray[np.float64], is_table: bool, normalization: str, has_phase: bool
) -> bytes: ...
def map_surface(
    vertices1: _Points,
    faces1: _Faces,
    sphere1: _Points,
    vertices2: _Points,
    faces2: _Faces,
    sphere2: _Points,
    landmarks: NDArray[np.int64],
    landmark_weight: Optional[float],
    features: Sequence[Tuple[NDArray[np.float64], NDArray[np.float64]]],
    feature_weight: float,
    feature_weights: Sequence[float],
    compare_values: bool,
    masks: Sequence[Tuple[NDArray[np.float64], NDArray[np.float64]]],
    threads: int,
    time_limit: float,
    callback: Optional[Callable[[int, float], Any]],
    returns_on_interrupt: bool,
) -> Tuple[_Points, Dict[str, Any]]: ...
def align_spheres(
    vertices1: _Points,
    faces1: _Faces,
    sphere1: _Points,
    vertices2: _Points,
    faces2: _Faces,
    sphere2: _Points,
    features: Sequence[Tuple[NDArray[np.float64], NDArray[np.float64]]],
    threads: int,
    time_limit: float,
    callback: Optional[Callable[[int, float], Any]],
    returns_on_interrupt: bool,
) -> Tuple[NDArray[np.float64], NDArray[np.float64], bool]: ...
def overlay(
    vertices1: _Points,
    faces1: _Faces,
    sphere1: _Points,
    vertices2: _Points,
    faces2: _Faces,
    sphere2: _Points,
    max_vertices: Optional[int],
    threads: int,
) -> Tuple[_Points, _Points, _Faces, _Faces, _Faces]: ...
def measure_distortion_between(
    vertices1: _Points,
    faces1: _Faces,
    sphere1: _Points,
    vertices2: _Points,
    faces2: _Faces,
    sphere2: _Points,
    smallest_area: float,
    max_vertices: Optional[int],
    threads: int,
) -> Dict[str, Any]: ...
