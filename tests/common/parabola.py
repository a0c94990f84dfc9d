"""A live page whose model is a parabola: the page is tested without a solver."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from softcat_sym.web.page import page_of

EMPTY = b"\0asm\1\0\0\0"
"""The smallest module of WebAssembly."""

MODEL = Path(__file__).with_suffix(".js").read_text(encoding="utf-8")


def described(title: str = "A strand across a gap") -> dict[str, Any]:
    """What a page is told of a scene."""

    def slider(key: str, name: str, unit: str, si: float, low: float, high: float, scale: str) -> dict[str, Any]:
        return {"key": key, "name": name, "unit": unit, "si": si, "low": low, "high": high, "scale": scale}

    keys = {"filament.span": 0.005, "load.gravity": 9.81, "run.duration": 0.5}
    full = {"cells": 40, "frames": 201}
    return {
        "title": title,
        "name": "strand",
        "effects": {"bending": "the strand is thick", "yielding": "the material has a yield stress"},
        "half": True,
        "axes": 2,
        "ends": ["clamped", "pinned"],
        "resolution": full,
        "preview": full | {"cells": 12, "frames": 51},
        "accuracy": "Of the scene's own values softcat run says: solved; error about 1.7 % of the sag, 2 % were asked.",
        "toml": "",
        "keys": keys,
        "duration": 0.5,
        "sliders": [
            slider("filament.span", "span", "mm", 1e-3, 2, 20, "log"),
            slider("load.gravity", "gravity", "m/s^2", 1.0, 0, 50, "linear"),
            slider("run.duration", "duration", "s", 1.0, 0.1, 100, "log"),
        ],
        "notes": [{"key": "load.gravity", "above": 20, "below": None, "words": "softcat run would take in more"}],
        "words": {"outcomes": {"non_finite": "the state became infinite; shorten run.duration"}},
    }


def page(title: str = "A strand across a gap") -> str:
    """The page of it."""
    return page_of(described(title), EMPTY, MODEL)
