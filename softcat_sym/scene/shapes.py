"""The key `filament.shape`: a word, or the points of a polyline, which may stand in a CSV file."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import POINTS, Kind, NotAQuantity, did_you_mean, shown

STRAIGHT, ARC, HELIX = "straight", "arc", "helix"
CSV = ".csv"
_WORDS = (STRAIGHT, ARC, HELIX)
COLUMNS = "the columns x_m, y_m and z_m, or in another unit, such as x [mm]"
_LEAST, _MOST = 4, 5000


class _Shape(Kind):
    """A word, the path of a CSV file, or points."""

    si = True

    def check(self, value: Any) -> str | tuple[tuple[float, ...], ...]:
        if isinstance(value, str) and value in _WORDS:
            return value
        if not isinstance(value, str):
            points: tuple[tuple[float, ...], ...] = POINTS.read(value)
        elif not value.lower().endswith(CSV):
            raise NotAQuantity(
                f"{shown(value)} is neither a shape known here nor a CSV file{did_you_mean(value, _WORDS)}"
            )
        else:
            # Imported here, with NumPy: to complete a name on the command line takes none.
            from softcat_sym.scene.table_reader import points_in

            try:
                points = points_in(Path(value), COLUMNS)
            except SoftcatError as error:
                # The first fault says enough, and what is accepted is said below.
                first = str(error).splitlines()[1].partition("; accepted: ")[0].strip()
                raise NotAQuantity(f"{shown(Path(value).name)}: {first}") from None
        if not _LEAST <= len(points) <= _MOST:
            raise NotAQuantity(f"a polyline of {len(points)} points")
        if any(a == b for a, b in pairwise(points)):
            raise NotAQuantity("a polyline with two neighbouring points in one place")
        return points

    def write(self, value: str | tuple[tuple[float, ...], ...]) -> object:
        return value if isinstance(value, str) else POINTS.write(value)


SHAPE = _Shape(f"{', '.join(_WORDS)}, a CSV file with {COLUMNS}, or a list of points [x, y, z], {_LEAST} to {_MOST}")
