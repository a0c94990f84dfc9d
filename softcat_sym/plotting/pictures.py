"""One picture after another of a figure, as a film takes them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


class Pictures(ABC):
    """Moments of a run, drawn in one figure."""

    figure: Figure
    note: str  # What they cannot show

    @abstractmethod
    def __len__(self) -> int: ...

    @abstractmethod
    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [pixel], both even, as video wants them."""
        width, height = self.figure.canvas.get_width_height()
        return width - width % 2, height - height % 2

    def pictures(self) -> Iterator[NDArray[np.uint8]]:
        """Draw the moments."""
        return map(self.picture, range(len(self)))

    def pixels(self) -> NDArray[np.uint8]:
        """What is drawn, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        width, height = self.size
        drawn: NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[:height, :width, :3].copy()
        return drawn
