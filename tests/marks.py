"""Which cases of a table run every time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def few(cases: Iterable[Any], *quick: Any) -> list[Any]:
    """All cases, those that are not named marked slow."""
    table = list(cases)
    assert set(quick) <= set(table), "a case that is not in the table"
    return [
        case if case in quick else pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.slow)
        for case in table
    ]
