"""Which law contains which: where the optimum of the narrower one lies among the constants of the wider.

With an index of one this is exact; other limits are met within a percent of the sag. A yield stress of zero is
Maxwell's law only as long as a filament does not ring: yielding has a closure of its own for what is unloaded.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.inverse.rough_constants import rough_constants
from softcat_sym.inverse.scene_of_law import scene_of_law
from softcat_sym.scene import Scene
from softcat_sym.scene.laws import kind_of_constant

# Factors on rough constants: a modulus so large that it stretches nothing, a stress or modulus so small that it holds
# nothing. A fit reaches a thousand times further either way, so that it may leave the limit again.
_STIFF, _STIFFER, _WEAK = 20.0, 100.0, 0.01


@dataclass(frozen=True)
class _Limit:
    """What a wider law needs to be a narrower one.

    Attributes
    ----------
    factors : mapping of str to float
        Of rough constants, for what only the wider has.
    renamed : mapping of str to str
        Constants of the wider that are another one of the narrower.
    """

    factors: Mapping[str, float]
    renamed: Mapping[str, str] = field(default_factory=dict)


# By the wider, then by the narrower; an index begins at one. What only holds, the elastic law, is left out: whatever
# flows needs a time to be told from it.
_LIMITS: dict[str, dict[str, _Limit]] = {
    "maxwell": {"newtonian": _Limit({"youngs_modulus": _STIFF})},
    "kelvin-voigt": {"newtonian": _Limit({"youngs_modulus": _WEAK})},
    "standard-linear": {
        "maxwell": _Limit({"youngs_modulus": _WEAK / 50}, {"second_modulus": "youngs_modulus"}),
        "kelvin-voigt": _Limit({"second_modulus": _STIFFER}),
    },
    "bingham": {
        "newtonian": _Limit({"youngs_modulus": _STIFF, "yield_stress": _WEAK}),
        "maxwell": _Limit({"yield_stress": _WEAK}),
    },
    "power-law": {"newtonian": _Limit({"youngs_modulus": _STIFF}), "maxwell": _Limit({})},
    "herschel-bulkley": {
        "newtonian": _Limit({"youngs_modulus": _STIFF, "yield_stress": _WEAK}),
        "maxwell": _Limit({"yield_stress": _WEAK}),
        "bingham": _Limit({}),
        "power-law": _Limit({"yield_stress": _WEAK}),
    },
}


def contained_in(law: str) -> tuple[str, ...]:
    """Laws that are a limit of this one."""
    return tuple(_LIMITS.get(law, {}))


def widened(fitted: Scene, law: str, films: Measurements) -> Scene:
    """Write a fitted filament in the constants of a law that contains its own.

    Parameters
    ----------
    fitted : Scene
        With the optimum of the narrower law.
    law : str
        The wider, one of those for which :func:`contained_in` names the scene's own.
    films : Measurements
        Tell the order of what is to be negligible.

    Returns
    -------
    Scene
        That falls as the fitted one, within what rough constants can promise.
    """
    narrower = fitted.material.law
    limit = _LIMITS[law][narrower]
    scene, rough = scene_of_law(fitted, law, films), rough_constants(fitted, films, law)
    values = {name: factor * rough[name] for name, factor in limit.factors.items()}
    values |= {name: float(getattr(fitted.material, own)) for name, own in limit.renamed.items()}
    index = scene.material.index
    return scene.replace(
        {f"material.{name}": kind_of_constant(name, law, index).write(value) for name, value in values.items()}
    )
