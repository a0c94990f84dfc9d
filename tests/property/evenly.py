"""Strategies that draw evenly: those of Hypothesis gather at small and simple values."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeVar

from hypothesis import strategies as st

T = TypeVar("T")

# Bytes are drawn evenly.
_fraction = st.binary(min_size=3, max_size=3).map(lambda some: int.from_bytes(some, "big") / 2**24)


def even(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers from `low` to `high`, evenly."""
    return _fraction.map(lambda share: low + (high - low) * share)


def log(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers from `low` to `high`, evenly in the logarithm."""
    return even(math.log(low), math.log(high)).map(math.exp)


def whole(least: int, most: int) -> st.SearchStrategy[int]:
    """Whole numbers from `least` to `most`, each equally often."""
    return _fraction.map(lambda share: least + int((most - least + 1) * share))


def choice(values: Sequence[T]) -> st.SearchStrategy[T]:
    """One of several values, each equally often."""
    return whole(0, len(values) - 1).map(lambda k: values[k])


def one_in(number: int) -> st.SearchStrategy[bool]:
    """True once in so many draws."""
    return whole(1, number).map(lambda k: k == number)
