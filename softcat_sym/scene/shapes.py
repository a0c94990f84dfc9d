"""The key `filament.shape`: a word, or the points of a polyline, which may stand in a CSV file."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import POINTS, Kind, did_you_mean, shown

STRAIGHT, ARC, HELIX = "straight", "arc", "helix"
CSV = ".csv"
_WORDS = (STRAIGHT, ARC, HELIX)
COLUMNS = "the columns x_m, y_m and z_m, or in another unit, such as x [mm]"
_LEAST, _MOST = 4, 5000


class Shape(Kind):
    """A word, the path of a CSV file, or points."""

    si = True
    accepted = f"{', '.join(_WORDS)}, a CSV file with {COLUMNS}, or a list of points [x, y, z], {_LEAST} to {_MOST}"

    def read(self, value: object) -> str | tuple[tuple[float, ...], ...]:
        """Return the word, or the points; raises `refusal`."""
        if isinstance(value, str) and value in _WORDS:
            return value
        if isinstance(value, str) and value.lower().endswith(CSV):
            return self._long_enough(self._from_file(Path(value)))
        if isinstance(value, str):
            raise self.refuse(
                f"{shown(value)} is neither a shape known here nor a CSV file{did_you_mean(value, _WORDS)}"
            )
        return self._long_enough(POINTS.read(value))

    def write(self, value: str | tuple[tuple[float, ...], ...]) -> object:
        """Return what a scene file holds."""
        return value if isinstance(value, str) else POINTS.write(value)

    def _from_file(self, file: Path) -> tuple[tuple[float, ...], ...]:
        # Imported here, with NumPy: to complete a name on the command line takes none.
        from softcat_sym.scene.table_reader import points_in

        try:
            return points_in(file, COLUMNS)
        except SoftcatError as error:
            # The first fault says enough, and what is accepted is said below.
            first = str(error).splitlines()[1].partition("; accepted: ")[0].strip()
            raise self.refuse(f"{shown(file.name)}: {first}") from None

    def _long_enough(self, points: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
        if not _LEAST <= len(points) <= _MOST:
            raise self.refuse(f"a polyline of {len(points)} points")
        if any(a == b for a, b in pairwise(points)):
            raise self.refuse("a polyline with two neighbouring points in one place")
        return points
