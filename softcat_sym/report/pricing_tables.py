"""The price of every effect as a table (CSV), one JSON document, and a Markdown table over many scenes."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from softcat_sym.study.bundled_pricing import KeptPricing, Unpriced
from softcat_sym.study.pricing import DEFINITION, Pricing
from softcat_sym.study.reading import percent, reading

if TYPE_CHECKING:
    from softcat_sym.study.priced_run import PricedRun
    from softcat_sym.study.pricing import PricingRow

_LARGEST = 3
_HEAD = ("scene", "effects in force", "what moves the answer most", "time of everything", "in one sentence")


def rows_csv(pricing: Pricing) -> bytes:
    """A line for each effect and for everything at once; what is not there is empty, every number reads back."""
    stream = io.StringIO()
    lines = [_flat(row) for row in (*pricing.rows, pricing.everything)]
    writer = csv.DictWriter(stream, list(lines[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(lines)
    return stream.getvalue().encode()


def document(pricing: Pricing) -> dict[str, Any]:
    """What ``effects.json`` holds; every number finite or null."""
    return {
        "scene": pricing.name,
        "title": pricing.scene.title,
        "accuracy": pricing.scene.run.accuracy,
        "reading": reading(pricing),
        "definition": DEFINITION,
        "cells": pricing.cells,
        "grading": pricing.grading,
        "base": {"effects": list(pricing.base.effects), "midpoint_largest_m": pricing.scale, **_cost(pricing.base)},
        "effects": [_nested(row) for row in pricing.rows],
        "everything": _nested(pricing.everything),
    }


def pricing_table(pricings: Iterable[Pricing | KeptPricing | Unpriced]) -> str:
    """Lay many scenes out as Markdown, a line for each.

    Parameters
    ----------
    pricings : iterable of Pricing, KeptPricing or Unpriced
        As from :func:`softcat_sym.study.bundled_pricing.price_bundled`.

    Returns
    -------
    str
        Name, effects in force, the largest changes, solve time of everything over that of the scene, the sentence.
    """
    lines = [_HEAD, ("---",) * len(_HEAD), *map(table_line, pricings)]
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


def table_line(one: Pricing | KeptPricing | Unpriced) -> tuple[str, ...]:
    """The line of one scene in the table over many."""
    if isinstance(one, Unpriced):
        return (one.name, "", "", "", f"not priced: {one.reason}")
    if isinstance(one, KeptPricing):
        return one.line
    ratio = None if one.everything.fails else one.everything.time_ratio
    time = "–" if ratio is None else f"× {ratio:.2g}"
    return (one.name or one.scene.title, in_short(one), _largest(one), time, reading(one))


def in_short(pricing: Pricing) -> str:
    """The effects in force, or those left out of what the scene can have, whichever is shorter."""
    # Without a run nothing is known of an effect but that it cannot be had, or cannot be left out.
    absent = [row.effect for row in pricing.rows if not row.in_force and row.variant is not None]
    if len(absent) >= len(pricing.base.effects):
        return ", ".join(pricing.base.effects) or "none"
    return f"all but {', '.join(absent)}" if absent else "all it can have"


def _largest(pricing: Pricing) -> str:
    rows = [row for row in pricing.rows if row.in_force]
    found = sorted(((share, row.effect) for row in rows if (share := row.share)), reverse=True)
    return ", ".join(f"{effect} {percent(share)}" for share, effect in found[:_LARGEST]) or "–"


def _nested(row: PricingRow) -> dict[str, Any]:
    """One effect, with its run."""
    return {
        "effect": row.effect,
        "in_force": row.in_force,
        "also": list(row.also),
        "change": row.change,
        "change_final": row.change_final,
        "own_change": row.own_change,
        "share": row.share,
        "estimate": row.estimate,
        "estimate_is": row.meaning,
        "states_ratio": row.states_ratio,
        "instructions_ratio": row.instructions_ratio,
        "time_ratio": row.time_ratio,
        "run": None if row.variant is None else _cost(row.variant),
        "reason": row.reason,
    }


def _flat(row: PricingRow) -> dict[str, str]:
    nested = _nested(row)
    run = nested.pop("run") or {}
    names = ("states", "algebraic", "instructions", "solve_s", "solver", "outcome", "complaint")
    return {name: _cell(value) for name, value in (nested | {name: run.get(name) for name in names}).items()}


def _cost(run: PricedRun) -> dict[str, Any]:
    return {
        "states": run.states,
        "algebraic": run.algebraic,
        "instructions": run.instructions,
        "solve_s": run.solve,
        "solver": run.solver,
        "outcome": run.outcome.name,
        "complaint": run.complaint,
    }


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, Sequence) and not isinstance(value, str):
        return " ".join(map(str, value))
    return repr(value) if isinstance(value, float) else str(value)
