"""What several reports say in the same words."""

from __future__ import annotations

REGIMES = {
    "no-yield": "it holds: no fibre yields",
    "arrested-overdamped": "it yields, sags and stops",
    "arrested-underdamped": "it yields, overshoots, swings back and stops",
    "descending": "it does not stop within this run",
    "viscous": "it flows for as long as it is loaded",
    "shaken": "it has yielded, is shaken, and flows no further",
    "elastic": "it is elastic and sags no further than its modulus lets it",
}
"""Regimes by name."""


def regime_words(name: str) -> str:
    """A regime in words, and its name."""
    return f"{REGIMES[name]} ({name})" if name in REGIMES else name


def error_percent(share: float) -> str:
    """An error in per cent with one digit, two if the first is a one: ``0.09 %``, ``1.1 %``."""
    rough = f"{100 * share:.1e}"
    digits = 2 if rough.startswith("1") else 1
    return f"{float(f'{100 * share:.{digits}g}'):g} %"
