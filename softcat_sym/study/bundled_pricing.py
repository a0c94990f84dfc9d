"""The effects of many bundled scenes, priced one after another."""

from __future__ import annotations

import hashlib
import importlib.metadata
from collections.abc import Callable, Iterable, Iterator, Mapping
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


@dataclass(frozen=True)
class KeptPricing:
    """A scene that was priced before, of which the files are there.

    Attributes
    ----------
    name : str
        Of the scene.
    identity : str
        As from :func:`pricing_identity`.
    line : tuple of str
        Of the table over all scenes.
    """

    name: str
    identity: str
    line: tuple[str, ...]


def pricing_identity(scene: Scene) -> str:
    """Tell one pricing from another: the same scene, priced by the same program.

    Parameters
    ----------
    scene : Scene
        What is priced.
    """
    version = importlib.metadata.version("softcat_sym")
    return hashlib.sha256(f"{version}\n{scene.to_toml()}".encode()).hexdigest()[:16]


def price_bundled(
    names: Iterable[str],
    listening: Callable[[str, Scene], Listening] | None = None,
    changes: Iterable[str] = (),
    kept: Mapping[str, KeptPricing] | None = None,
) -> Iterator[Pricing | KeptPricing | Unpriced]:
    """Price scenes by name, one at a time, so that each can be written before the next begins.

    Parameters
    ----------
    names : iterable of str
        As :func:`softcat_sym.load_scene` takes them.
    listening : callable, optional
        Given the name of a scene and the scene, what is told about its runs.
    changes : iterable of str
        ``KEY=VALUE`` for every scene.
    kept : mapping of str to KeptPricing, optional
        What was priced before, by name; scenes that are still the same are not priced again.

    Yields
    ------
    Pricing, KeptPricing or Unpriced
        A scene that fails does not keep the others from being priced.
    """
    overrides = list(changes)
    for name in names:
        try:
            scene = load_scene(name, overrides)
            before = (kept or {}).get(name)
            if before is not None and before.identity == pricing_identity(scene):
                yield before
            else:
                yield price_effects(scene, listening and listening(name, scene), name)
        except SoftcatError as error:
            yield Unpriced(name, " ".join(str(error).split()))
        # CasADi's own: an integrator that cannot even begin.
        except RuntimeError as error:
            yield Unpriced(name, " ".join(str(error).split()))
