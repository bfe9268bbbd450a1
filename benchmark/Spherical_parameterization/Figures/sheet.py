"""What a figure is drawn on: pictures to the pixel, text, a color bar and diagrams, from the top left on."""

from __future__ import annotations

import io
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from measuring.pictures import Scale
from PIL import Image

# Pixels. The manual shows figures at half their size, so that they are sharp on screens of twice the density.
TEXT = 30
SMALL_TEXT = 26
JPEG_QUALITY = 80
COLORS_OF_PNG = 256
DOTS_PER_INCH = 72  # makes a point a pixel, for the sizes of fonts and lines
TEXT_COLOR = "#222222"


class Sheet:
    """All lengths are pixels of the figure at its full size; with another `scale`, everything is larger or smaller."""

    def __init__(self, width: float, height: float, scale: float):
        self._width, self._height, self._scale = width, height, scale
        size = (self.pixels(width) / DOTS_PER_INCH, self.pixels(height) / DOTS_PER_INCH)
        self._figure = plt.figure(figsize=size, dpi=DOTS_PER_INCH, facecolor="white")

    def pixels(self, length: float) -> int:
        """A length in pixels of the file."""
        return round(length * self._scale)

    def length(self, pixels: float) -> float:
        """The width of a line, or the size of a marker, for matplotlib."""
        return pixels * self._scale

    def place(self, picture: np.ndarray, x: float, y: float) -> None:
        """Puts the top left corner of a picture, whose pixels stay as they are, at a place."""
        bottom = self.pixels(self._height) - self.pixels(y) - picture.shape[0]
        self._figure.figimage(picture, self.pixels(x), bottom)

    def text(self, x: float, y: float, text: str, align: str = "center", family: str = "sans-serif") -> None:
        """Writes text whose middle is at y."""
        style = {"fontsize": TEXT * self._scale, "family": family, "color": TEXT_COLOR, "linespacing": 1.3}
        self._figure.text(x / self._width, 1.0 - y / self._height, text, ha=align, va="center", **style)

    def axes(self, x: float, y: float, width: float, height: float):
        """A diagram of matplotlib; its labels are outside of this box."""
        box = (x / self._width, 1.0 - (y + height) / self._height, width / self._width, height / self._height)
        axes = self._figure.add_axes(box)
        axes.tick_params(labelsize=SMALL_TEXT * self._scale, length=8 * self._scale, width=1.5 * self._scale)
        axes.tick_params(which="minor", length=0)
        axes.xaxis.label.set_size(TEXT * self._scale)
        axes.yaxis.label.set_size(TEXT * self._scale)
        for spine in axes.spines.values():
            spine.set_linewidth(1.5 * self._scale)
        return axes

    def color_bar(self, x: float, y: float, width: float, scale: Scale, label: str) -> None:
        """A horizontal bar; the label is on its left."""
        axes = self.axes(x, y, width, 26)
        bar = scale.add_bar(self._figure, cax=axes, orientation="horizontal", extendfrac=0.04)
        bar.outline.set_linewidth(0.0)
        self.text(x - 18, y + 13, label, align="right")

    def save(self, path: Path) -> None:
        """JPEG for pictures, PNG with a palette for diagrams, by the ending. Same figure, same bytes."""
        buffer = io.BytesIO()
        self._figure.savefig(buffer, format="png", dpi=DOTS_PER_INCH)
        plt.close(self._figure)
        with Image.open(buffer) as figure:
            image = figure.convert("RGB")
        if path.suffix == ".jpg":
            image.save(path, quality=JPEG_QUALITY, subsampling=0, optimize=True, progressive=True)
        else:
            palette = image.quantize(COLORS_OF_PNG, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
            palette.save(path, optimize=True)
