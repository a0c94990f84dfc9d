"""Limits: what an effect, or the choice of closure, is worth, falls as the square of the sag, with known prefactors."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest

from .closed_forms import elastic_catenary
from .scenes import GEOMETRY, run, sag, scene

WEIGHT = 1e4
"""rho g L [Pa] of every scene here."""

SAGS = np.array([0.02, 0.04, 0.08])
BEAM_SAGS = np.array([0.001, 0.002, 0.004])
THICKNESS = 0.04
"""... of the beams, whose sag is a tenth of it at most."""

FULL = ("finite-stretch", "thinning", "large-rotation")


def cable_moduli(sags: np.ndarray) -> np.ndarray:
    """E [Pa] of elastic cables with these sags: sag^3 = 3 rho g L^4/(64 E)."""
    return 3 * WEIGHT / (64 * sags**3)


def beam_moduli(sags: np.ndarray) -> np.ndarray:
    """E [Pa] of linear beams with these sags: sag = 12 rho g L^4/(384 E h^2)."""
    return 12 * WEIGHT / (384 * THICKNESS**2 * sags)


def slope(sags: np.ndarray, differences: np.ndarray) -> float:
    return float(np.polyfit(np.log(sags), np.log(np.abs(differences)), 1)[0])


@cache
def elastic_sag(E: float, thickness: float, effects: tuple[str, ...]) -> float:
    return sag(run(scene(thickness=thickness, E=E, effects=effects, cells=10)))


def worth(effect: str, bending: tuple[str, ...], thickness: float, moduli: np.ndarray) -> np.ndarray:
    """Relative loss of sag when an effect is left out, for each modulus."""
    losses = []
    for E in moduli:
        with_it, without_it = (
            elastic_sag(E, thickness, (*bending, *effects))
            for effects in (FULL, tuple(name for name in FULL if name != effect))
        )
        losses.append(with_it / without_it - 1)
    return np.array(losses)


def large_rotation_prefactor() -> float:
    """Elastic catenary over its shallow limit, per sag^2."""
    E_star = 1e6
    depth = -float(elastic_catenary(E_star, np.array([0.0]))[1][0])
    shallow = (3 / (64 * E_star)) ** (1 / 3)
    return (depth / shallow - 1) / shallow**2


@pytest.mark.parametrize("effect", FULL)
def test_effects_of_finite_sag_on_a_string(effect: str) -> None:
    """A softening of the string by a relative c lifts its sag by c/3; the strain is e = (8/3) sag^2.

    log s instead of s - 1 softens by e/2, thinning by e; for large rotation the catenary itself says.
    """
    prefactor = {"finite-stretch": 4 / 9, "thinning": 8 / 9, "large-rotation": large_rotation_prefactor()}[effect]
    losses = worth(effect, (), 0.01, cable_moduli(SAGS))
    order = slope(SAGS, losses)
    print(f"{effect}: order {order:.2f}, prefactor {losses[0] / SAGS[0] ** 2:.3f}, expected {prefactor:.3f}")
    assert 1.7 < order < 2.3
    assert losses[0] / SAGS[0] ** 2 == pytest.approx(prefactor, rel=0.02)


@pytest.mark.parametrize("effect", FULL)
def test_effects_of_finite_sag_on_a_beam(effect: str) -> None:
    """Where bending carries the weight, too, they go as the square of the sag."""
    losses = worth(effect, ("bending",), THICKNESS, beam_moduli(BEAM_SAGS))
    order = slope(BEAM_SAGS, losses)
    print(f"{effect}, beam: {losses}, order {order:.2f}")
    assert 1.7 < order < 2.3


def closures(**asked: Any) -> tuple[float, float]:
    """Sag in the material closure, and by how much the printed one differs, relatively."""
    material, printed = (sag(run(scene(closure=closure, cells=10, **asked))) for closure in ("material", "printed"))
    return material, printed / material - 1


def elastic_beam(final: float) -> dict[str, Any]:
    return {"thickness": THICKNESS, "E": beam_moduli(np.array([final]))[0], "effects": GEOMETRY}


def maxwell_string(final: float) -> dict[str, Any]:
    eta = 1e6
    creep = {"eta": eta, "duration": final**3 * 128 * eta / (9 * WEIGHT), "rtol": 1e-7}
    return {"thickness": 0.01, "E": 1e6 * WEIGHT, "effects": ("viscous-flow", *FULL), **creep}


def bingham_string(final: float) -> dict[str, Any]:
    """It yields at 0.3 of the stress rho g L^2/8H that it ends with."""
    changes = {"yield_stress": 0.3 * WEIGHT / (8 * final), "effects": ("viscous-flow", "yielding", *FULL)}
    return maxwell_string(final) | changes


@pytest.mark.parametrize("asked", [elastic_beam, maxwell_string, bingham_string])
def test_closures_agree_in_the_limit_of_small_strain(asked: Callable[[float], dict[str, Any]]) -> None:
    targets = (BEAM_SAGS if asked is elastic_beam else SAGS)[::2]
    sags, differences = np.array([closures(**asked(float(target))) for target in targets]).T
    order = slope(sags, differences)
    print(f"{asked.__name__}: sags {sags}, differences {differences}, order {order:.2f}")
    assert 1.7 < order < 2.3


def test_printed_closure_on_a_creeping_string() -> None:
    """Tension eta A s_t/s (1 - log s) instead of eta A s_t/s: sag_printed/sag_material = 1 + (8/15) H^2.

    From H e_t (1 - e) = const with e = (8/3) H^2.
    """
    depth, difference = closures(**maxwell_string(0.03))
    print(f"prefactor {difference / depth**2:.4f}, 8/15 = {8 / 15:.4f}")
    assert difference / depth**2 == pytest.approx(8 / 15, rel=0.03)
