"""What a pricing says, in one sentence."""

from __future__ import annotations

from collections.abc import Sequence

from softcat_sym.study.pricing import Pricing, PricingRow

_NAMED = 4
"""So many effects are named with their change; the rest are counted."""

_DEAR = 1.5
"""Cost in time from which it is worth a word."""


_NAMELESS, _SMALLEST = 0.99e-6, "0.0001 %"
"""Changes below this are told as below this."""


def reading(pricing: Pricing) -> str:
    """Say what the table says: what moves the answer, what fails, what goes unnoticed, what was left out.

    "Unnoticed" is a change below the accuracy asked. Each effect speaks for its own share.

    Parameters
    ----------
    pricing : Pricing
        As from :func:`softcat_sym.study.pricing.price`.

    Returns
    -------
    str
        One sentence without a full stop.
    """
    accuracy = pricing.scene.run.accuracy
    inside, outside = ([row for row in pricing.rows if row.in_force is side] for side in (True, False))
    parts = [_movers(_beyond(inside, accuracy), "moves the midpoint"), *_failures(inside, "without")]
    quiet = [row.effect for row in inside if (share := row.share) is not None and share <= accuracy]
    if quiet:
        parts.append(f"{listed(quiet)} {'goes' if len(quiet) == 1 else 'go'} unnoticed")
    missed = _beyond(outside, accuracy)
    if missed:
        parts.append(f"left out, {_movers(missed, 'would move it')}")
    else:
        harmless = [share for row in outside if (share := row.share) is not None]
        if harmless:
            largest = max(harmless)
            bound = f"as much as {_SMALLEST}" if 0 < largest < _NAMELESS else f"more than {percent(largest)}"
            parts.append(f"nothing that was left out would move it by {bound}")
    parts += _failures(outside, "with")
    said = "; ".join(part for part in parts if part) or "no effect can be put in or left out"
    if pricing.base.outcome.is_success:
        return said
    return f"not to be trusted, since the run itself ends as {pricing.base.outcome.name}: {said}"


def percent(value: float) -> str:
    """A share as per cent with two digits; beyond tenfold as a factor."""
    if value >= 10:
        return f"{float(f'{value:.2g}'):.6g} times its largest value"
    share = 100 * value
    return f"{float(f'{share:.2g}'):g} %" if value >= _NAMELESS or value == 0 else f"less than {_SMALLEST}"


def listed(names: Sequence[str], word: str = "and") -> str:
    """``a, b and c``; beyond four the rest are counted."""
    if len(names) > _NAMED:
        return f"{', '.join(names[:_NAMED])} {word} {len(names) - _NAMED} more"
    return f" {word} ".join(filter(None, [", ".join(names[:-1]), names[-1]]))


def _beyond(rows: Sequence[PricingRow], accuracy: float) -> list[tuple[float, PricingRow]]:
    """Rows that change the answer by more than was asked for, the largest first."""
    changes = [(share, row) for row in rows if (share := row.share) is not None and share > accuracy]
    return sorted(changes, key=lambda pair: -pair[0])


def _movers(found: Sequence[tuple[float, PricingRow]], verb: str) -> str:
    """``inertia moves the midpoint by 12 %, shear by 1.4 % for 5 times the time``."""
    if not found:
        return ""
    (largest, first), *others = found[:_NAMED]
    shown = [f"{first.effect} {verb} by {percent(largest)}{_dear(first)}"]
    shown += [f"{row.effect} by {percent(share)}{_dear(row)}" for share, row in others]
    rest = len(found) - len(shown)
    if rest:
        shown.append(f"{rest} more by {percent(found[_NAMED][0])} or less")
    return ", ".join(shown)


def _dear(row: PricingRow) -> str:
    ratio = row.time_ratio
    return f" for {float(f'{ratio:.2g}'):g} times the time" if ratio is not None and ratio >= _DEAR else ""


def _failures(rows: Sequence[PricingRow], word: str) -> list[str]:
    """``without bending and yielding the run ends as no_convergence``, a part for each outcome."""
    ends: dict[str, list[str]] = {}
    for row in rows:
        if row.variant is not None and row.fails:
            ends.setdefault(row.variant.outcome.name, []).append(row.effect)
    return [f"{word} {listed(names, 'or')} the run ends as {outcome}" for outcome, names in ends.items()]
