"""Modulus and viscosity from what a film shows: against eigenvalues on a grid, weights by errors, and a film."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.closed_form import ClosedForm, constants_of
from softcat_sym.fitting.features import Features, LateLaw, unread
from softcat_sym.fitting.measurements import Series
from tests.common.known_features import DENSITY, GRAVITY, SPAN, UNIT, features_of

PRESSURE = DENSITY * GRAVITY * SPAN
VISCOUS = PRESSURE * UNIT


def strand(thickness: float = 1e-3, **changes: object) -> sc.Scene:
    scene: dict[str, dict[str, object]] = {
        "filament": {"span": f"{SPAN} m", "thickness": f"{thickness} m", "density": f"{DENSITY} kg/m^3"},
        "material": {"law": "maxwell", "youngs_modulus": "1 MPa", "viscosity": "100 kPa*s"},
        "load": {"gravity": f"{GRAVITY} m/s^2"},
        "run": {"duration": "1 s"},
    }
    for path, value in changes.items():
        table, _, key = path.partition(".")
        scene.setdefault(table, {})[key] = value
    return sc.Scene.model_validate(scene)


def of(features: Features, thickness: float = 1e-3) -> ClosedForm:
    time = np.linspace(0.0, 1.0, 9)
    return constants_of(Series(time, -0.01 * time), features, strand(thickness))


def shape_at_rest(radius: float, sag: float, nodes: np.ndarray) -> tuple[float, np.ndarray]:
    """Tension, and slopes of an elastic beam between clamps that rests at a sag under its weight."""

    def pull(r: float) -> float:
        return (0.125 - math.tanh(r / 4) / (2 * r)) / sag

    def slope(r: float) -> np.ndarray:
        layer = np.exp(r * (nodes - 0.5)) * (1 - np.exp(-2 * r * nodes)) / (1 - math.exp(-r))
        return np.asarray((nodes - layer / 2) / pull(r))

    def excess(log_r: float) -> float:
        r = math.exp(log_r)
        return float(np.trapezoid(slope(r) ** 2, nodes)) - (r * radius) ** 2

    r = math.exp(brentq(excess, math.log(0.3), math.log(1e3)))
    return pull(r), slope(r)


def eigenvalue(modulus: float, tau: float, sag: float, radius: float, cells: int = 160) -> complex:
    """Lowest oscillation of a Maxwell beam about its shape at rest, by finite differences on half its span.

    y_tt = T y_xx - M_xx + h Y_xx with M_t = E k^2 y_xxt - M/tau and h_t = 2 E int Y_x y_xt dx - h/tau.
    """
    step = 0.5 / cells
    x = np.linspace(0, 0.5, cells + 1)
    tension, slopes = shape_at_rest(radius, sag, x)
    second = (np.diag(np.full(cells + 1, -2.0)) + np.eye(cells + 1, k=1) + np.eye(cells + 1, k=-1)) / step**2
    second[0, 1] = second[-1, -2] = 2 / step**2  # Symmetry at midspan; a level end at the clamp
    moving = np.arange(cells)
    bent = np.gradient(slopes, x, edge_order=2)[:, None]
    weight = np.full(cells + 1, step)
    weight[[0, -1]] /= 2
    stretch = -2 * weight * bent[:, 0]  # int Y_x y_x dx by parts: y vanishes at the clamp
    size = cells
    state = np.zeros((2 * size + cells + 2, 2 * size + cells + 2))
    y, v, m, h = slice(0, size), slice(size, 2 * size), slice(2 * size, -1), -1
    state[y, v] = np.eye(size)
    state[v, y] = tension * second[np.ix_(moving, moving)]
    state[v, m] = -second[moving]
    state[v, h] = bent[moving, 0]
    state[m, v] = modulus * radius**2 * second[:, moving]
    state[m, m] = -np.eye(cells + 1) / tau
    state[h, v] = modulus * stretch[moving]
    state[h, h] = -1 / tau
    values = np.linalg.eigvals(state)
    return complex(min((value for value in values if value.imag > 1), key=lambda value: value.imag))


@pytest.mark.parametrize(
    ("modulus", "tau", "sag", "thickness"),
    [(4e4, 0.35, 0.01, 1e-4), (4e4, 0.35, 0.01, 1e-3), (2e5, 0.5, 0.004, 2e-3), (2e4, 1.0, 0.03, 1e-3)],
)
def test_a_ringing_beam_gives_back_its_constants(modulus: float, tau: float, sag: float, thickness: float) -> None:
    seen = eigenvalue(modulus, tau, sag, thickness / SPAN / math.sqrt(12))
    # So small an amplitude that nothing is nonlinear, and what a deep sag adds is taken off again.
    read = seen.imag * (1 - 1.5 * sag**2)
    found = of(features_of(read, -seen.real, sag, None, errors=(1e-3, 1e-3, 1e-4, 1)), thickness)
    assert found.youngs_modulus.value == pytest.approx(modulus * PRESSURE, rel=0.02)
    # The elastic share of the stiffness relaxes: of a mode, to first order in 1/(R tau).
    assert found.viscosity.value == pytest.approx(modulus * tau * VISCOUS, rel=0.06)


def without_ringing(load: float, sag: float) -> Features:
    law = LateLaw((sag * SPAN) ** 3, 0.0, 0.0, 0.9, 1.1)
    silent = unread("no oscillation is seen above the noise")
    seen = features_of(1.0, None, sag, load)
    return replace(seen, late=law, ringing=None, frequency=silent, decay=silent, sag=silent)


def test_without_an_oscillation_the_third_law_gives_the_viscosity_alone() -> None:
    found = of(without_ringing(3.3e-5, 0.02), 2e-6)
    # A string of that sag is longer and thinner: 1 + (52/5) H^2.
    assert found.viscosity.value == pytest.approx((1 + 52 / 5 * 0.02**2) / (2 * 3.3e-5) * VISCOUS, rel=1e-3)
    assert found.youngs_modulus.value is None
    assert found.youngs_modulus.interval is None
    assert "no oscillation is seen" in found.youngs_modulus.reason


def test_what_disagrees_is_weighed_by_its_errors() -> None:
    """The logarithms of the viscosity from d and from B, over their variances."""
    errors = (1e-3, 0.05, 1e-4, 0.04)
    law = LateLaw((0.02 * SPAN) ** 3, 0.0, 0.0, 0.9, 1.1)
    both = replace(features_of(60.0, 1.4, 0.02, 3.3e-5, errors=errors), late=law)
    by_decay, by_law = of(replace(both, prefactor=unread(""))), of(replace(both, decay=unread("")))
    pairs = [(math.log(one.viscosity.value or 0), one.viscosity.log_error or 0) for one in (by_decay, by_law)]
    total = sum(error**-2 for _, error in pairs)
    together = of(both)
    assert abs(pairs[0][0] - pairs[1][0]) > 0.1
    mean = sum(value / error**2 for value, error in pairs) / total
    assert math.log(together.viscosity.value or 0) == pytest.approx(mean, abs=0.01)
    assert together.viscosity.log_error == pytest.approx(total**-0.5, rel=0.02)
    assert together.misfit > by_law.misfit


def test_a_film_that_shows_nothing_and_a_filament_of_another_theory_are_refused() -> None:
    seen = without_ringing(3.3e-5, 0.02)
    with pytest.raises(SoftcatError, match=r"closed form: no oscillation is seen.*not late enough"):
        of(replace(seen, prefactor=unread("not late enough")))
    time = np.linspace(0.0, 1.0, 9)
    for changes in ({"material.law": "kelvin-voigt"}, {"ends.left": "pinned"}):
        with pytest.raises(SoftcatError, match="closed form: accepted: a Maxwell or Newtonian filament"):
            constants_of(Series(time, -0.01 * time), seen, strand(**changes))


def test_a_strand_too_stiff_to_show_its_tension_is_refused_and_nothing_else_escapes() -> None:
    with pytest.raises(SoftcatError, match=r"closed form: a sag of 0\.022 radii of gyration.*accepted: 0\.07 or more"):
        of(features_of(90.0, 0.03, 5e-5, 0.013), 1.6e-3)
    random = np.random.default_rng(0)
    for _ in range(10):
        frequency, decay, sag, load = np.exp(random.uniform((0, -4, -10, -18), (7, 5, -0.5, -3))).tolist()
        seen = features_of(frequency, decay, sag, load, t_high=0.1)
        law = LateLaw((sag * SPAN) ** 3, 0.0, 0.0, 0.9, 1.1)
        with suppress(SoftcatError):
            for one in (of(replace(seen, late=law)).youngs_modulus, of(replace(seen, late=law)).viscosity):
                assert one.value is None or 0 < one.value < math.inf


def test_a_film_gives_its_material_without_a_fit(tmp_path: Path) -> None:
    scene = strand(
        **{
            "run.duration": "3 s",
            "run.frames": 401,
            "numerics.cells": 16,
            "numerics.rtol": 1e-5,
            "numerics.estimate": False,
        }
    )
    data = sc.simulate(scene).data
    path = tmp_path / "film.csv"
    rows = zip(data.time.values[1:], data.midpoint.values[1:], strict=True)
    path.write_text("time_s,midpoint_m\n" + "".join(f"{t:.9g},{y:.9g}\n" for t, y in rows))
    found = sc.closed_form(path, scene)
    for one, true in ((found.youngs_modulus, 1e6), (found.viscosity, 1e5)):
        assert one.value == pytest.approx(true, rel=0.1)
        low, high = one.interval or (math.inf, -math.inf)
        assert low < true < high
    assert "youngs_modulus" in repr(found)
    other = path.with_name("other.csv")
    other.write_text(path.read_text())
    with pytest.raises(SoftcatError, match="2 films; accepted: one"):
        sc.closed_form([path, other], scene)
