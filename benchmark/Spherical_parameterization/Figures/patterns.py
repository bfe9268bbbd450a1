"""Patterns on the sphere: functions from its points to colors."""

from __future__ import annotations

import numpy as np

SQUARES_AROUND = 32  # at the equator
SQUARE_COLORS = np.array([[0.95, 0.93, 0.86], [0.16, 0.36, 0.50]])

SEA = np.array([[0.13, 0.30, 0.52], [0.33, 0.58, 0.74]])
LAND = np.array([[0.45, 0.62, 0.33], [0.86, 0.80, 0.55], [0.62, 0.45, 0.31], [0.97, 0.97, 0.97]])
COAST, GRATICULE = np.array([0.10, 0.18, 0.28]), np.array([1.0, 1.0, 1.0])
WAVES, LEAST_FREQUENCY, SEED = 60, 1.8, 7


class Globe:
    """A hue for each longitude, lighter to the north, under a grid of meridians and parallels."""

    def __init__(self, step: float, width: float):
        self._step, self._width = np.radians(step), np.radians(width)

    def __call__(self, points: np.ndarray) -> np.ndarray:
        longitude, latitude = _angles_of(points)
        colors = _oklab(0.76 + 0.13 * latitude / (0.5 * np.pi), 0.13 * np.cos(latitude) ** 0.5, longitude)
        return np.where(_is_on_grid(longitude, latitude, self._step, self._width)[..., None], 0.35 * colors, colors)


def squares(points: np.ndarray) -> np.ndarray:
    """Squares of alternate colors in Mercator's projection. It keeps angles: on the sphere they are squares, too.

    Where they have shrunk to half of their size, the next ones are twice as wide.
    """
    longitude, latitude = _angles_of(points)
    height = np.abs(np.arctanh(np.sin(np.clip(latitude, -1.57, 1.57))))
    x, y, width = longitude + np.pi, height, 2.0 * np.pi / SQUARES_AROUND
    column, row = np.floor(x / width), np.floor(y / width)
    parity = column + row
    begin, number = 0.0, SQUARES_AROUND
    while number > 8:
        # the first row that is half as large as those at the beginning of the section
        rows = np.ceil((np.arccosh(2.0 * np.cosh(begin)) - begin) / width)
        begin, number, width = begin + rows * width, number // 2, 2.0 * width
        is_beyond = height >= begin
        parity = np.where(is_beyond, np.floor(x / width) + np.floor((height - begin) / width), parity)
    return SQUARE_COLORS[np.mod(parity + (latitude < 0.0), 2).astype(int)]


def planet(points: np.ndarray) -> np.ndarray:
    """Land and sea of a planet that is none: waves in random directions, from long to short."""
    unit = points / np.linalg.norm(points, axis=-1, keepdims=True)
    random = np.random.default_rng(SEED)
    frequencies = LEAST_FREQUENCY * 1.07 ** np.arange(WAVES)
    height, variance = np.full(unit.shape[:-1], -0.1), 0.5 * np.sum(frequencies**-2)
    for frequency in frequencies:
        wave = random.normal(size=3)
        wave *= frequency / np.linalg.norm(wave)
        height += np.cos(unit @ wave + random.uniform(0.0, 2.0 * np.pi)) / (frequency * np.sqrt(variance))
    colors = np.where((height > 0.0)[..., None], _ramp(LAND, height / 2.0), _ramp(SEA, 1.0 + height / 1.5))
    colors = np.where((np.abs(height) < 0.012)[..., None], COAST, colors)
    is_line = _is_on_grid(*_angles_of(unit), np.radians(30.0), np.radians(0.7))
    return np.where(is_line[..., None], 0.3 * colors + 0.7 * GRATICULE, colors)


def _is_on_grid(longitude: np.ndarray, latitude: np.ndarray, step: float, width: float) -> np.ndarray:
    """Lines are as wide on the meridians as on the parallels, and there are fewer meridians near the poles."""
    is_polar = np.abs(latitude) > np.radians(60.0) + 0.5 * width
    distance = np.minimum(
        _distance_to_grid(longitude, np.where(is_polar, 2.0 * step, step)) * np.cos(latitude),
        _distance_to_grid(latitude, step),
    )
    return (distance < 0.5 * width) & (np.abs(latitude) < 0.5 * np.pi - 0.5 * step)


def _distance_to_grid(angle: np.ndarray, step) -> np.ndarray:
    return np.abs(angle - step * np.round(angle / step))


def _ramp(colors: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Colours between those of a list, for t in [0, 1]."""
    places = np.linspace(0.0, 1.0, len(colors))
    return np.stack([np.interp(t, places, colors[:, i]) for i in range(3)], axis=-1)


def _oklab(lightness: np.ndarray, chroma: np.ndarray, hue: np.ndarray) -> np.ndarray:
    """Red, green and blue from Ottosson's perceptually uniform space."""
    a, b = chroma * np.cos(hue), chroma * np.sin(hue)
    cubes = (
        np.stack(
            [
                lightness + 0.3963377774 * a + 0.2158037573 * b,
                lightness - 0.1055613458 * a - 0.0638541728 * b,
                lightness - 0.0894841775 * a - 1.2914855480 * b,
            ],
            axis=-1,
        )
        ** 3
    )
    linear = cubes @ np.array(
        [
            [4.0767416621, -1.2684380046, -0.0041960863],
            [-3.3077115913, 2.6097574011, -0.7034186147],
            [0.2309699292, -0.3413193965, 1.7076147010],
        ]
    )
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


def _angles_of(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Longitude and latitude; the poles are on the second axis."""
    unit = points / np.linalg.norm(points, axis=-1, keepdims=True)
    return np.arctan2(unit[..., 0], unit[..., 2]), np.arcsin(np.clip(unit[..., 1], -1.0, 1.0))
