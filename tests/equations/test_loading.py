"""The smooth step and its rate."""

from __future__ import annotations

import pytest
import sympy as sp

from softcat_sym.physics.filament import Terms
from softcat_sym.physics.loads import quintic_step, ramp_rate, ramped_gravity, shaking, shaking_rate
from softcat_sym.physics.symbols import a_g, f_g, g, g_on, t

u = sp.Symbol("u", real=True)
inside = sp.Symbol("v", positive=True)


def open_step() -> sp.Expr:
    """The step between its ends, where neither Min nor Max acts."""
    return quintic_step(u).replace(sp.Min, lambda *_: u)


def test_it_is_the_quintic() -> None:
    assert sp.expand(open_step() - (10 * u**3 - 15 * u**4 + 6 * u**5)) == 0


def test_it_goes_from_zero_to_one() -> None:
    for at, wanted in [(-3, 0), (0, 0), (sp.Rational(1, 2), sp.Rational(1, 2)), (1, 1), (7, 1)]:
        assert quintic_step(u).subs(u, at) == wanted


def test_two_derivatives_vanish_at_either_end() -> None:
    for order in [1, 2]:
        for end in [0, 1]:
            assert sp.diff(open_step(), u, order).subs(u, end) == 0


def test_the_rate_is_the_derivative_of_the_load() -> None:
    """During, before and after the ramp."""
    between = {t: g_on * u}
    load = ramped_gravity().subs(between).replace(sp.Min, lambda *_: u)
    rate = ramp_rate().subs(between).replace(sp.Min, lambda *_: u)
    assert sp.simplify(sp.diff(load, u) / g_on - rate) == 0
    for at in (-1, 0, 1, 3):
        assert ramp_rate().subs(t, at * g_on) == 0
    assert ramp_rate().subs(t, g_on / 2) == g * sp.Rational(15, 8) / g_on


def test_the_whole_rate_adds_up_to_the_whole_load() -> None:
    rate = sp.lambdify(t, ramp_rate().subs({g: 9.81, g_on: 0.3}), "math")
    from scipy.integrate import quad

    total, _ = quad(rate, 0, 0.3)
    assert total == pytest.approx(9.81, rel=1e-12)


def test_the_rate_of_shaken_gravity_is_its_slope() -> None:
    """On the ramp, at its end and beyond, against a difference of 1e-6 s."""
    for at in [0.0, 0.07, 0.11, 0.3, 1.9]:
        terms = Terms(
            gravity=ramped_gravity(), gravity_rate=ramp_rate(), shaking=shaking(), shaking_rate=shaking_rate()
        )
        numbers = {g: 9.81, g_on: 0.3, a_g: 2.5, f_g: 1.7}
        load, rate = (sp.lambdify(t, part.subs(numbers), "math") for part in (terms.load, terms.load_rate))
        assert rate(at) == pytest.approx((load(at + 1e-6) - load(at - 1e-6)) / 2e-6, rel=1e-6, abs=1e-6)
        assert shaking().subs({t: 0}) == 1


def test_an_amplitude_of_two_turns_gravity_round() -> None:
    """Three quarters of a period on it is -g, and its mean over a period is g."""
    load = (g * shaking()).subs(a_g, 2)
    assert load.subs(t, sp.Rational(3, 4) / f_g) == -g
    assert sp.simplify(sp.integrate(load, (t, 0, 1 / f_g)) * f_g) == g
