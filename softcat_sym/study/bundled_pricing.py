"""The effects of many bundled scenes, priced one after another."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from softcat_sym.errors import SoftcatError
from softcat_sym.scene import load_scene
from softcat_sym.study.pricing import Listening, Pricing, price_effects

if TYPE_CHECKING:
    from softcat_sym.scene import Scene


@dataclass(frozen=True)
class Unpriced:
    """A scene whose own run could not be made.

    Attributes
    ----------
    name : str
        Of the scene.
    reason : str
        Why.
    """

    name: str
    reason: str


def price_bundled(
    names: Iterable[str],
    listening: Callable[[str, Scene], Listening] | None = None,
    changes: Iterable[str] = (),
) -> Iterator[Pricing | Unpriced]:
    """Price scenes by name, one at a time, so that each can be written before the next begins.

    Parameters
    ----------
    names : iterable of str
        As :func:`softcat_sym.load_scene` takes them.
    listening : callable, optional
        Given the name of a scene and the scene, what is told about its runs.
    changes : iterable of str
        ``KEY=VALUE`` for every scene.

    Yields
    ------
    Pricing or Unpriced
        A scene that fails does not keep the others from being priced.
    """
    overrides = list(changes)
    for name in names:
        try:
            scene = load_scene(name, overrides)
            yield price_effects(scene, listening and listening(name, scene), name)
        except SoftcatError as error:
            yield Unpriced(name, " ".join(str(error).split()))
        # CasADi's own: an integrator that cannot even begin.
        except RuntimeError as error:
            yield Unpriced(name, " ".join(str(error).split()))
