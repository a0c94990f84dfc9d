"""Forty inks as users have them: gels, bioinks, ceramics, chocolate and toothpaste, strands of which span a gap.

Numbers are drawn once and for all (the seed is fixed), evenly in the logarithm between limits that the literature of
direct ink writing, food and rheology gives for each kind; E is three times G'. Nothing is ramped, and nobody says how
accurate the answer is to be.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import softcat_sym as sc

SEED, NUMBER = 20261122, 40


@dataclass(frozen=True)
class Kind:
    """Limits of a kind of ink, in SI units.

    Attributes
    ----------
    name : str
        What it is.
    modulus, shear_yield_stress : (float, float)
        Young's modulus and yield stress in shear [Pa].
    consistency, index : (float, float)
        Of Herschel and Bulkley, in shear [Pa s^n]; Bingham's where the index is one.
    density, tension, diameter, span : (float, float)
        [kg/m^3], [N/m], [m], [m].
    """

    name: str
    modulus: tuple[float, float]
    shear_yield_stress: tuple[float, float]
    consistency: tuple[float, float]
    index: tuple[float, float]
    density: tuple[float, float]
    tension: tuple[float, float]
    diameter: tuple[float, float]
    span: tuple[float, float]


KINDS = (
    Kind(
        "gel", (6e3, 6e4), (50, 400), (5, 80), (0.3, 0.6), (1000, 1100), (0.03, 0.045), (0.2e-3, 0.8e-3), (1e-3, 5e-3)
    ),
    Kind(
        "bioink",
        (3e3, 3e4),
        (30, 200),
        (5, 60),
        (0.3, 0.7),
        (1000, 1080),
        (0.045, 0.072),
        (0.2e-3, 0.6e-3),
        (1e-3, 4e-3),
    ),
    Kind(
        "ceramic",
        (1e5, 3e6),
        (100, 2000),
        (5, 100),
        (1.0, 1.0),
        (1800, 3000),
        (0.05, 0.072),
        (0.2e-3, 1.2e-3),
        (1e-3, 10e-3),
    ),
    Kind(
        "silicone",
        (3e4, 5e5),
        (100, 1000),
        (20, 300),
        (0.4, 0.8),
        (1000, 1300),
        (0.03, 0.04),
        (0.25e-3, 1.5e-3),
        (2e-3, 12e-3),
    ),
    Kind(
        "chocolate",
        (5e4, 1e6),
        (30, 300),
        (2, 40),
        (1.0, 1.0),
        (1200, 1300),
        (0.03, 0.04),
        (0.5e-3, 1.5e-3),
        (3e-3, 20e-3),
    ),
    Kind(
        "toothpaste",
        (3e3, 3e4),
        (60, 300),
        (10, 100),
        (0.35, 0.6),
        (1200, 1600),
        (0.035, 0.06),
        (0.8e-3, 1.5e-3),
        (3e-3, 20e-3),
    ),
)


def users_inks() -> list[tuple[str, sc.Scene]]:
    """Names and scenes, always the same."""
    generator = np.random.default_rng(SEED)
    kinds = [KINDS[number % len(KINDS)] for number in range(NUMBER)]
    return [(f"{number} {kind.name}", _ink(kind, generator)) for number, kind in enumerate(kinds, start=1)]


def _ink(kind: Kind, generator: np.random.Generator) -> sc.Scene:
    def drawn(limits: tuple[float, float]) -> float:
        value = float(np.exp(generator.uniform(*np.log(limits))))
        return float(f"{value:.2g}")

    filament = {
        "thickness": f"{(diameter := drawn(kind.diameter))!r} m",
        # A strand bridges three of its diameters or more.
        "span": f"{max(drawn(kind.span), 3 * diameter):.2g} m",
        "section": "circle",
        "density": f"{drawn(kind.density):g} kg/m^3",
    }
    material: dict[str, object] = {
        "youngs_modulus": f"{drawn(kind.modulus):g} Pa",
        "shear_yield_stress": f"{drawn(kind.shear_yield_stress):g} Pa",
    }
    consistency, index = drawn(kind.consistency), drawn(kind.index)
    if math.isclose(index, 1.0):
        material |= {"law": "bingham", "shear_viscosity": f"{consistency:g} Pa*s"}
    else:
        material |= {"law": "herschel-bulkley", "shear_consistency": f"{consistency:g} Pa*s^{index:g}", "index": index}
    return sc.Scene.model_validate(
        {
            "filament": filament,
            "material": material,
            "surroundings": {"surface_tension": f"{drawn(kind.tension):g} N/m"},
            "run": {"duration": f"{drawn((0.5, 5.0)):g} s"},
        }
    )
