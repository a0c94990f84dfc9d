"""Prior distributions of free parameters: those of scipy.stats, written with units."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from inspect import Parameter, Signature
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError
from scipy import stats

from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.units import did_you_mean, refusal, shown

FORM = "NAME=DISTRIBUTION, such as 'viscosity=lognorm(s=0.5, scale=30 Pa*s)'"
"""How a prior is written."""

_CALL = re.compile(r"\s*([A-Za-z]\w*)\s*\((.*)\)\s*", re.DOTALL)
_KEYWORD = re.compile(r"\s*([A-Za-z]\w*)\s*=(.*)", re.DOTALL)
# Commas outside of parentheses, as units may contain some.
_COMMA = re.compile(r",(?![^(]*\))")
# Step of a two-sided difference in q, which is of order one.
_STEP = 1e-5
# Distributions whose shape arguments are values of the parameter and replace a scale.
_ENDS = {"loguniform": ("a", "b"), "reciprocal": ("a", "b")}


@dataclass(frozen=True, eq=False)
class Prior:
    """The prior of one unknown, between its bounds."""

    free: FreeParameter
    law: Any  # Frozen distribution of scipy.stats of the value in SI; None is flat in q
    text: str  # The prior as the user wrote it
    lower: float  # Bounds of q, restricted to where the density is not zero
    upper: float

    def log_density(self, q: float) -> float:
        """Logarithm of the density in q, up to a constant: the density is not normalised between the bounds."""
        if self.law is None:
            return 0.0
        return float(self.law.logpdf(self.free.value(q))) + math.log(abs(self.free.slope(q)))

    def slope(self, q: float) -> float:
        """Derivative of :meth:`log_density` by q, from a two-sided difference within the bounds."""
        if self.law is None:
            return 0.0
        low, high = max(q - _STEP, self.lower), min(q + _STEP, self.upper)
        return (self.log_density(high) - self.log_density(low)) / (high - low)

    def draw(self, random: np.random.Generator, size: int) -> Floats:
        """Draw values of q."""
        share = random.uniform(size=size)
        if self.law is None:
            return np.asarray(self.lower + share * (self.upper - self.lower))
        ends = [float(self.law.cdf(self.free.value(q))) for q in (self.lower, self.upper)]
        values = self.law.ppf(ends[0] + share * (ends[1] - ends[0]))
        q = np.array([self.free.scaled(float(value)) for value in values])
        return np.asarray(np.clip(q, self.lower, self.upper))


def read_priors(texts: Mapping[str, str], free: Sequence[FreeParameter]) -> tuple[Prior, ...]:
    """Read the priors of all unknowns; an unknown without one has a flat prior in q between its bounds.

    `texts` has, for a parameter's name, a continuous distribution of :mod:`scipy.stats` of its value, such as
    ``"lognorm(s=0.5, scale=30 Pa*s)"``, ``"loguniform(1 kPa, 1 MPa)"`` or ``"norm(0 ms, 2 ms)"``. The order of the
    arguments is SciPy's: shapes, `loc`, `scale`. Arguments of the parameter's dimension have a unit, others none.
    """
    names = [one.name for one in free]
    faults = [
        Fault(f"prior of {name}", f"not free{did_you_mean(name, names)}", ", ".join(names))
        for name in texts
        if name not in names
    ]
    found = []
    for one in free:
        if one.name not in texts:
            found.append(Prior(one, None, "flat" if not one.logarithmic else "flat in log", one.lower, one.upper))
            continue
        try:
            found.append(_read(one, texts[one.name]))
        except PydanticCustomError as error:
            context = error.context or {}
            faults.append(Fault(f"prior of {one.name}", str(context["found"]), str(context["accepted"])))
    if faults:
        raise SceneError(faults)
    return tuple(found)


def refuse_excluded(priors: Sequence[Prior], q: Floats) -> None:
    """Refuse priors that exclude the best fit, as the chains would start where the density is zero."""
    faults = [
        Fault(
            f"prior of {one.free.name}",
            f"{one.text} has no finite density at the best fit, {one.free.value(float(x)):.6g} {one.free.unit}",
            "a prior that allows it, or another bound of the parameter",
        )
        for one, x in zip(priors, q, strict=True)
        if not (one.lower <= x <= one.upper and math.isfinite(one.log_density(float(x))))
    ]
    if faults:
        raise SceneError(faults)


@cache
def _known() -> dict[str, Any]:
    """Continuous distributions of SciPy by name."""
    return {name: one for name, one in vars(stats).items() if isinstance(one, stats.rv_continuous)}


def _read(free: FreeParameter, text: str) -> Prior:
    call = _CALL.fullmatch(text)
    if call is None:
        raise refusal(f"{shown(text)} is not a distribution with arguments", FORM)
    name, inside = call.groups()
    if name not in _known():
        raise refusal(
            f"no distribution '{name}'{did_you_mean(name, _known())}", "a continuous distribution of scipy.stats"
        )
    law = _known()[name]
    given = _arguments(free, name, law, inside)
    frozen = law(**given)
    low, high = frozen.support()
    if math.isnan(low):
        numbers = ", ".join(f"{key} = {value:g}" for key, value in given.items())
        raise refusal(f"{name} is not defined for {numbers}", f"arguments that scipy.stats.{name} allows")
    ends = [-math.inf if free.logarithmic and x <= 0 else free.scaled(x) for x in (low, high)]
    lower, upper = max(free.lower, ends[0]), min(free.upper, ends[1])
    if not lower < upper:
        raise refusal(
            f"{text.strip()} lies from {low:g} to {high:g} {free.unit}, outside of the bounds",
            f"a prior that overlaps {free.bounds[0]:g} to {free.bounds[1]:g} {free.unit}, or other bounds",
        )
    return Prior(free, frozen, text.strip(), lower, upper)


def _arguments(free: FreeParameter, name: str, law: Any, inside: str) -> dict[str, float]:
    """Arguments by name, in SI."""
    shapes = [shape.strip() for shape in law.shapes.split(",")] if law.shapes else []
    order = shapes if name in _ENDS else [*shapes, "loc", "scale"]
    dimensional = () if free.unit == "1" else _ENDS.get(name, ("loc", "scale"))
    accepted = f"{name}({', '.join(order)})" + (f"; {' and '.join(dimensional)} in {free.unit}" if dimensional else "")
    texts = [part.strip() for part in _COMMA.split(inside) if part.strip()]
    named = {str(pair[1]): str(pair[2]) for pair in map(_KEYWORD.fullmatch, texts) if pair}
    signature = Signature([Parameter(key, Parameter.POSITIONAL_OR_KEYWORD, default=None) for key in order])
    try:
        given = signature.bind(*(text for text in texts if not _KEYWORD.fullmatch(text)), **named).arguments
    except TypeError as error:
        raise refusal(f"{error} in {shown(inside)}", accepted) from None
    if missing := {*shapes, *({"scale"} & {*dimensional})} - {*given}:
        raise refusal(f"{name} without {' and '.join(key for key in order if key in missing)}", accepted)
    return {key: _number(free, text.strip(), accepted, is_pure=key not in dimensional) for key, text in given.items()}


def _number(free: FreeParameter, text: str, accepted: str, *, is_pure: bool) -> float:
    if not is_pure:
        number = free.read(text)
    else:
        try:
            number = float(text)
        except ValueError:
            raise refusal(f"{shown(text)} is not a number without a unit", accepted) from None
    if not math.isfinite(number):
        raise refusal(f"{shown(text)} is not finite", accepted)
    return number
