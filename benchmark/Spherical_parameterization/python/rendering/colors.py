"""The colours of distortions."""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, LogNorm, to_rgb

# Perceptually uniform. The darkest part is left out, in which the shape would not be seen.
COLORS = ListedColormap(matplotlib.colormaps["viridis"](np.linspace(0.12, 1.0, 256)))
FOLDED_COLOR = to_rgb("#e4006e")  # a hue that the scale does not have


@dataclass(frozen=True)
class Scale:
    """Colours for a distortion: equal ratios look alike, and the order is visible on a grey print."""

    least: float
    largest: float  # what is above has the last colour

    def of_faces(self, values: np.ndarray, is_folded: np.ndarray) -> np.ndarray:
        """Red, green and blue in [0, 1]; what is not finite counts as large."""
        finite = np.nan_to_num(values, nan=self.largest, posinf=self.largest)
        clipped = np.clip(finite, self.least, self.largest)
        colors = COLORS(LogNorm(self.least, self.largest)(clipped))[:, :3]
        colors[is_folded] = FOLDED_COLOR
        return colors

    @property
    def mappable(self) -> ScalarMappable:
        """For the colour bar."""
        return ScalarMappable(LogNorm(self.least, self.largest), COLORS)

    @property
    def ticks(self) -> np.ndarray:
        """Doublings, and the end."""
        doublings = self.least * 2.0 ** np.arange(np.ceil(np.log2(self.largest / self.least)))
        return np.append(doublings, self.largest)
