"""The price of the next digit that a run tells is what the next digit then takes, in seconds of the processor."""

from __future__ import annotations

import time
import warnings
from types import SimpleNamespace
from typing import Any

import pytest

from softcat_sym import load_scene, simulate
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.errors import SoftcatWarning
from tests.common.table import show

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

SCENES = (
    "continual-descent",
    "maxwell-slow",
    "cold-honey",
    "glass-rod",
    "no-yield",
    "beam-viscometer",
    "bread-dough",
    "gelatin-strand",
    "silicone-thread",
    "polymer-thread",
)
"""Ten laws and regimes, of accuracies a thousandth and a hundredth."""


def warm(name: str, accuracy: float | None) -> tuple[dict[str, Any], float]:
    """The summary of a second run, for which everything is compiled and imported, and its seconds of the processor."""
    scene = load_scene(name, {} if accuracy is None else {"run.accuracy": accuracy})
    simulate(scene)
    began = time.process_time()
    return simulate(scene).summary, time.process_time() - began


def test_the_price_of_the_next_digit_is_right_within_a_factor_of_two(monkeypatch: pytest.MonkeyPatch) -> None:
    # Others use the machine: the clock of a run counts what it does itself. Compilers are counted apart.
    monkeypatch.setattr(
        "softcat_sym.progress.time", SimpleNamespace(**vars(time) | {"perf_counter": time.process_time})
    )
    rows, ratios = [], {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SoftcatWarning)
        for name in SCENES:
            first, seconds = warm(name, None)
            price = first["next_digit"]
            then, taken = warm(name, price["accuracy"])
            ratios[name] = price["seconds"] / taken
            accuracy = (f"{first['accuracy']:g}", f"{price['accuracy']:g}")
            reached = (f"{first['error_estimate']['total']:.1e}", f"{then['error_estimate']['total']:.1e}")
            cost = (f"{seconds:.2f}", f"{price['seconds']:.2f}", f"{taken:.2f}", f"{ratios[name]:.2f}")
            rows.append([name, *accuracy, *reached, *cost])
    header = ("scene", "accuracy", "next", "error", "then", "s", "foretold s", "taken s", "ratio")
    show("the price of the next digit, warm runs", header, rows)
    assert all(0.5 <= ratio <= 2 for ratio in ratios.values()), ratios
