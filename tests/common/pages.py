"""Descriptions of pages, made quickly: without notes and a preview, which take a hundred choices."""

from __future__ import annotations

from functools import cache
from typing import Any
from unittest import mock

import numpy as np

from softcat_sym.scene.scene import Scene
from softcat_sym.web import description
from softcat_sym.web.description import describe_page
from softcat_sym.web.sliders import Sliders

SLOW: dict[str, Any] = {"_notes": lambda *_: [], "_preview": lambda *_: None}


@cache
def quick_page(scene: Scene, *sliders: str, only_numbers: bool = False) -> dict[str, Any]:
    """The data of a page, on request without any slider."""
    changed = SLOW | ({"choose_sliders": lambda *_: Sliders()} if only_numbers else {})
    with mock.patch.multiple(description, **changed):
        return describe_page(scene, sliders).data


def random_states(data: dict[str, Any], count: int, share: float = 1.0) -> list[dict[str, Any]]:
    """States of a page within its ranges, or within such a share amid them."""
    random = np.random.default_rng(7)
    values = [
        {
            one["key"]: float(
                one["si"] * one["low"] * (one["high"] / one["low"]) ** (0.5 + share * (random.random() - 0.5))
            )
            for one in data["sliders"]
        }
        for _ in range(count)
    ]
    return [{"values": one} for one in values]
