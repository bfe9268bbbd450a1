from typing import Any, Callable, ClassVar, Dict, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

_Points = NDArray[np.float64]
_Faces = NDArray[np.int64]

__version__: str

class ErrorCode:
    EMPTY_MESH: ClassVar[ErrorCode]
    TOO_FEW_VERTICES: ClassVar[ErrorCode]
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
    INVALID_DIRECTION: ClassVar[ErrorCode]
    INVALID_LANDMARK: ClassVar[ErrorCode]
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...

class Locator:
    def __init__(self, sphere: _Points, faces: _Faces) -> None: ...
    def locate(self, directions: _Points) -> Tuple[_Faces, _Points]: ...

def parameterize(
    vertices: _Points,
    faces: _Faces,
    prefer: str,
    energy: str,
    threads: int,
    time_limit: float,
    callback: Optional[Callable[[int, float, float], Any]],
    initial: Optional[_Points],
    returns_on_interrupt: bool,
) -> Tuple[_Points, Dict[str, Any]]: ...
def find_defect(vertices: _Points, faces: _Faces) -> None: ...
def is_bijective(sphere: _Points, faces: _Faces) -> bool: ...
def measure_distortion(vertices: _Points, faces: _Faces, sphere: _Points) -> Dict[str, Any]: ...
def remesh(
    vertices: _Points, faces: _Faces, sphere: _Points, solid: str, subdivision: int
) -> Tuple[_Points, _Faces, _Points]: ...
def remesh_with(
    vertices: _Points, faces: _Faces, sphere: _Points, domain_sphere: _Points, domain_faces: _Faces
) -> Tuple[_Points, _Points]: ...
def transfer(
    values: NDArray[Any],
    is_of_faces: bool,
    vertices: _Points,
    faces: _Faces,
    sphere: _Points,
    target_sphere: _Points,
    target_faces: _Faces,
) -> NDArray[Any]: ...
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
    returns_on_interrupt: bool,
) -> Tuple[_Points, Dict[str, Any]]: ...
def overlay(
    vertices1: _Points,
    faces1: _Faces,
    sphere1: _Points,
    vertices2: _Points,
    faces2: _Faces,
    sphere2: _Points,
) -> Tuple[_Points, _Points, _Faces, _Faces, _Faces]: ...
