"""What a user's own flow rule phi(sigma) must be: odd, finite, nowhere decreasing; and the stress where it sets in.

A rule with sigma phi(sigma) < 0 would create energy; one that decreases has no unique answer (Drucker, 1951).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from functools import lru_cache

from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.kinds import refusal

# Below and above the stress scales of the scene.
_LOWEST, _HIGHEST = 1e-6, 30.0
_PER_DECADE = 40
# Faster than this nothing is worth looking at [1/s].
_FASTEST = 1e30
_ROUNDING = 1e-9
# A rate below this is the underflow of a rule that never quite vanishes, not a yield stress.
_VANISHING = 1e-250


def check_rule(formula: Formula, values: dict[str, float], scales: Iterable[float]) -> None:
    """Refuse a rule that is not odd, not finite, decreases or creates energy, at many stresses.

    Parameters
    ----------
    formula : Formula
        phi(sigma) [1/s].
    values : dict of str to float
        SI values of its parameters.
    scales : iterable of float
        Stresses of the scene, positive [Pa]; looked at from a millionth of the smallest to 30 times the largest.

    Raises
    ------
    PydanticCustomError
        A `refusal` that names the stress.
    """
    stresses = _stresses(scales)
    at_rest = formula.value(0.0, values)
    rates = _rates(lambda sigma: formula.value(sigma, values), stresses)
    if not rates or not any(rates):
        raise refusal(f"nothing flows at any stress up to {stresses[-1]:.4g} Pa", "a rate that grows with stress")
    tiny = 1e-12 * next(rate for rate in map(abs, rates) if rate)
    if not abs(at_rest) <= tiny:
        raise refusal(f"the rate without stress is {at_rest:.4g} 1/s", "a rate that is 0 at sigma = 0")
    for sigma, rate in zip(stresses, rates, strict=False):
        mirror = formula.value(-sigma, values)
        if not abs(rate + mirror) <= _ROUNDING * abs(rate) + tiny:
            found = f"not odd: {rate:.4g} 1/s at {sigma:.4g} Pa, but {mirror:.4g} 1/s at {-sigma:.4g} Pa"
            raise refusal(found, "phi(-sigma) = -phi(sigma), such as sign(sigma)*abs(sigma)**2")
    _check_dissipation(stresses, rates, tiny)


def _check_dissipation(stresses: list[float], rates: list[float], tiny: float) -> None:
    accepted = "a rate that has the sign of the stress and never decreases"
    last = 0.0
    for sigma, rate in zip(stresses, rates, strict=False):
        if rate < -tiny:
            raise refusal(f"negative dissipation: the rate is {rate:.4g} 1/s at sigma = {sigma:.4g} Pa", accepted)
        if rate < last - _ROUNDING * last - tiny:
            found = f"decreases from {last:.4g} to {rate:.4g} 1/s at sigma = {sigma:.4g} Pa (negative dissipation)"
            raise refusal(found, accepted)
        last = rate


@lru_cache(maxsize=256)
def threshold(text: str, values: tuple[tuple[str, float], ...], scales: tuple[float, ...]) -> float:
    """Find the stress below which a rule is exactly 0, by bisection.

    Parameters
    ----------
    text : str
        phi(sigma).
    values : tuple of (str, float)
        SI values of its parameters.
    scales : tuple of float
        As for `check_rule`.

    Returns
    -------
    float
        [Pa]; 0 if the rule flows at every stress.
    """
    formula, known = parse_formula(text), dict(values)
    stresses = _stresses(scales)
    beyond = next((i for i, sigma in enumerate(stresses) if formula.value(sigma, known) != 0), 0)
    if beyond == 0:
        return 0.0
    closed, flowing = stresses[beyond - 1], stresses[beyond]
    if abs(formula.value(flowing * (1 + 1e-3), known)) < _VANISHING:
        return 0.0
    while (middle := (closed + flowing) / 2) not in (closed, flowing):
        if formula.value(middle, known) == 0:
            closed = middle
        else:
            flowing = middle
    # The last stress at which nothing flows, rid of the rounding of the bisection.
    short = float(f"{closed:.13g}")
    return short if formula.value(short, known) == 0 else closed


def _rates(rule: Callable[[float], float], stresses: list[float]) -> list[float]:
    """Rates up to where they are too fast to matter."""
    rates: list[float] = []
    for sigma in stresses:
        rate = rule(sigma)
        if math.isnan(rate):
            raise refusal(f"not a number at sigma = {sigma:.4g} Pa", "a rate that is finite at every stress")
        if abs(rate) > _FASTEST:
            if not rates:
                raise refusal(f"{rate:.4g} 1/s at sigma = {sigma:.4g} Pa", "a rate that is small at small stresses")
            break
        rates.append(rate)
    return rates


def _stresses(scales: Iterable[float]) -> list[float]:
    """Evenly over the decades, and on both sides of each scale, where a rule may have a corner."""
    given = sorted(scales)
    low, high = _LOWEST * given[0], _HIGHEST * given[-1]
    count = math.ceil(_PER_DECADE * math.log10(high / low))
    sampled = [low * (high / low) ** (i / count) for i in range(count + 1)]
    near = [scale * factor for scale in given for factor in (1 - 1e-9, 1.0, 1 + 1e-9)]
    return sorted({*sampled, *near})
