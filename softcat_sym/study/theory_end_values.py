"""The values that one variable of a scene takes in a study, as written on the command line."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.errors import Fault, SceneError

if TYPE_CHECKING:
    from softcat_sym.scene import Scene

_FORM = "one variable, such as groups.delta=0.01,0.02,0.03 or groups.V=2.6:260:5:log"
_RANGE = re.compile(r"([^:,]+):([^:,]+):(\d{1,4})(:log)?")
_MOST = 1000


@dataclass(frozen=True)
class Variation:
    """A variable and the values it takes.

    Attributes
    ----------
    path : str
        Dotted path in the scene file.
    texts : tuple of str
        Values as ``--set`` takes them, each once.
    """

    path: str
    texts: tuple[str, ...]

    def changes(self) -> list[tuple[str, str]]:
        """Each value, and the change of the scene that sets it."""
        return [(text, f"{self.path}={text}") for text in self.texts]


def read_variation(text: str) -> Variation:
    """Read ``path=value,value,...`` or ``path=first:last:number`` with or without ``:log``.

    Parameters
    ----------
    text : str
        Values may carry units in a list; those of a range are plain numbers.

    Raises
    ------
    SceneError
        If it is no such thing, or names fewer than two different values.
    """
    path, equals, values = (part.strip() for part in text.partition("="))
    if not equals or not path or not values:
        raise _refuse(f"{text!r} varies nothing")
    texts = _range(values) if ":" in values else tuple(part.strip() for part in values.split(","))
    if not all(texts):
        raise _refuse(f"{text!r} has an empty value")
    different = tuple(dict.fromkeys(texts))
    if len(different) < 2:
        raise _refuse(f"{text!r} has one value")
    return Variation(path, different)


def number_at(scene: Scene, path: str, text: str) -> float:
    """The value as a number for the axis of a chart: a group as it is, anything else in SI units.

    Parameters
    ----------
    scene : Scene
        With the value.
    path : str
        Dotted path of the variable.
    text : str
        The value as written.

    Raises
    ------
    SceneError
        If the variable is no number.
    """
    if path.startswith("groups."):
        value: object = _plain(text)
    else:
        value = scene
        for name in path.split("."):
            value = getattr(value, name, None)
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise SceneError([Fault(path, f"{text!r} is no number", "a variable that has one, " + _FORM)])
    return float(value)


def _range(values: str) -> tuple[str, ...]:
    found = _RANGE.fullmatch(values)
    if found is None:
        raise _refuse(f"{values!r} is no range")
    first, last, count = _plain(found[1]), _plain(found[2]), int(found[3])
    if first is None or last is None or not 2 <= count <= _MOST:
        raise _refuse(f"{values!r} is no range")
    if found[4] and not (first > 0 and last > 0):
        raise _refuse(f"{values!r} is logarithmic and not positive")
    numbers = np.geomspace(first, last, count) if found[4] else np.linspace(first, last, count)
    # Twelve digits: what rounding adds would end up in file names and tables.
    return tuple(f"{number:.12g}" for number in numbers)


def _plain(text: str) -> float | None:
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def _refuse(found: str) -> SceneError:
    return SceneError([Fault("--vary", found, _FORM)])
