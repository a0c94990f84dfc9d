"""Combinations of unknowns that data determine where they do not determine the single ones."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from softcat_sym.inverse.estimation.least_squares import Floats

# A combination is worth a name if it is known this well, in standard errors of a logarithm.
_KNOWN = 0.5
# How much worse a combination of rounded exponents may be known than the best one: by half.
_ROUNDED = 1.5
# Exponents that occur in formulas of mechanics.
_DENOMINATORS = (1, 2, 3, 4)
_DIGITS = 3


@dataclass(frozen=True, eq=False)
class Combination:
    """A weighted sum of unknowns; of logarithmic ones, the logarithm of a product of powers.

    Attributes
    ----------
    names : tuple of str
        The unknowns that take part.
    exponents : tuple of float
        Their weights, the largest in magnitude being one.
    text : str
        ``"youngs_modulus^1 * viscosity^-1"``, or ``"1 * log(youngs_modulus) - 2 * offset"`` where an unknown is none of
        a logarithm.
    value : float
        The sum of exponent times q: the logarithm of the product over that of the typical values.
    standard_error : float
        Of `value`: the relative one of the product, where it is small.
    interval : (float, float)
        95 % interval of `value`.
    """

    names: tuple[str, ...]
    exponents: tuple[float, ...]
    text: str
    value: float
    standard_error: float
    interval: tuple[float, float]

    def product(self, typical: Sequence[float]) -> tuple[float, float, float]:
        """Value and 95 % interval of the product of powers, in the parameters' own units.

        Parameters
        ----------
        typical : sequence of float
            Typical value of each unknown in `names`.
        """
        unit = math.prod(value**exponent for value, exponent in zip(typical, self.exponents, strict=True))
        low, high = self.interval
        return unit * math.exp(self.value), unit * math.exp(low), unit * math.exp(high)


def combinations(
    names: Sequence[str],
    q: Floats,
    root: Floats,
    determined: Floats,
    quantile: float,
    logarithmic: Sequence[bool],
) -> tuple[Combination, ...]:
    """Write the determined directions as combinations of few unknowns with simple exponents.

    The directions' span is brought to reduced echelon form, which gives as many combinations as there are directions,
    each with an unknown of its own; exponents are then rounded as far as their errors allow.

    Parameters
    ----------
    names : sequence of str
        The k unknowns.
    q : ndarray, shape (k,)
        The optimum.
    root : ndarray, shape (k, k)
        Root of the covariance of q, R R^T, which keeps a small error of a combination of large ones.
    determined : ndarray, shape (k, directions)
        Orthonormal columns.
    quantile : float
        Standard errors in half an interval.
    logarithmic : sequence of bool, length k
        Which unknowns are logarithms.

    Returns
    -------
    tuple of Combination
        Those of two unknowns or more, the best known first.
    """
    found = []
    for row in _echelon(determined.T):
        weights = _simplified(row / row[np.argmax(np.abs(row))], root)
        part = np.flatnonzero(weights).tolist()
        weights *= np.sign(weights[part[0]])
        error = float(np.linalg.norm(weights @ root))
        if len(part) < 2 or error > _KNOWN:
            continue
        value, half = float(weights @ q), quantile * error
        chosen = tuple(names[k] for k in part)
        exponents = tuple(weights[part].tolist())
        powers = all(logarithmic[k] for k in part)
        text = (
            _product_text(chosen, exponents) if powers else _sum_text(chosen, exponents, [logarithmic[k] for k in part])
        )
        found.append(Combination(chosen, exponents, text, value, error, (value - half, value + half)))
    return tuple(sorted(found, key=lambda one: one.standard_error))


def _echelon(rows: Floats) -> Floats:
    """Reduced row echelon form, each pivot the largest entry that is left."""
    rows = rows.copy()
    pivots: list[int] = []
    for k in range(len(rows)):
        left = np.abs(rows[k:]).copy()
        left[:, pivots] = 0
        below, column = np.unravel_index(int(np.argmax(left)), left.shape)
        rows[[k, k + int(below)]] = rows[[k + int(below), k]]
        rows[k] /= rows[k, column]
        others = np.arange(len(rows)) != k
        rows[others] -= np.outer(rows[others, column], rows[k])
        pivots.append(int(column))
    return rows


def _simplified(weights: Floats, root: Floats) -> Floats:
    """Round every weight to the simplest number with which the combination is known nearly as well."""
    allowed = _ROUNDED * float(np.linalg.norm(weights @ root)) + 1e-6
    # All at once first: rounding one of two exponents alone would spoil their ratio.
    for denominator in _DENOMINATORS:
        rounded = np.round(weights * denominator) / denominator
        if rounded.any() and float(np.linalg.norm(rounded @ root)) <= allowed:
            return rounded
    result = weights.copy()
    for k in np.argsort(np.abs(weights)):
        for candidate in (*(np.round(weights[k] * d) / d for d in _DENOMINATORS), np.round(weights[k], _DIGITS)):
            trial = result.copy()
            trial[k] = candidate
            if trial.any() and float(np.linalg.norm(trial @ root)) <= allowed:
                result = trial
                break
    return result


def _number(weight: float) -> str:
    fraction = Fraction(weight).limit_denominator(_DENOMINATORS[-1])
    return str(fraction) if abs(float(fraction) - weight) < 1e-9 else f"{weight:.{_DIGITS}g}"


def _product_text(names: Sequence[str], exponents: Sequence[float]) -> str:
    written = (_number(exponent) for exponent in exponents)
    return " * ".join(
        f"{name}^({power})" if "/" in power else f"{name}^{power}" for name, power in zip(names, written, strict=True)
    )


def _sum_text(names: Sequence[str], exponents: Sequence[float], logarithmic: Sequence[bool]) -> str:
    terms = [f"log({name})" if flag else name for name, flag in zip(names, logarithmic, strict=True)]
    text = ""
    for term, exponent in zip(terms, exponents, strict=True):
        sign = " - " if exponent < 0 else " + "
        text += f"{sign if text else sign.strip(' +')}{_number(abs(exponent))} * {term}"
    return text
