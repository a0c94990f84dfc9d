"""A strand that comes out of a nozzle: what becomes of the mean of a state, of momentum, and of what guides a node.

For numbers and for the expressions of SymPy and CasADi; notebook 25_laying derives them.
"""

from __future__ import annotations

from typing import Any


def dilution(mean: Any, growth: Any) -> Any:
    """Rate of a mean over a length to which nothing of it is added; `growth` is that of the logarithm of the length."""
    return -growth * mean


def handed_over(share: Any) -> Any:
    """Smooth step of the share of a switch that has passed, from 0 to 1."""
    return share**2 * (3 - 2 * share)


def arriving_momentum(fed: Any, nozzle_speed: Any, speed: Any) -> Any:
    """Force of a mass fed per time that comes with the nozzle's speed."""
    return fed * (nozzle_speed - speed)


def guide_energy(reaction: Any, off: Any) -> Any:
    """Energy of a spring by its force and the distance from its rest."""
    return reaction * off / 2


def guide_loss(handing_over: Any, stiffness: Any, share: Any) -> Any:
    """Power that the spring k (1 - w)/w loses as it softens; `share` is k off/w, which in balance is F/(1 - w)."""
    return handing_over * share**2 / (2 * stiffness)
