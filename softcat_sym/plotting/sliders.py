"""A sweep as one page with sliders: it needs no server, no network and no other file."""

from __future__ import annotations

import base64
import math
from html import escape
from importlib import resources
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np
from matplotlib import colormaps
from numpy.typing import NDArray

from softcat_sym.plotting.units import typeset
from softcat_sym.web.page import filled, inlined

if TYPE_CHECKING:
    import xarray as xr

Floats: TypeAlias = NDArray[np.float64]

LARGEST: Final = 12_000_000
"""Bytes of packed curves or of shapes in one page; what is longer keeps every second frame, fourth, ... or is left out.

400 members of 21 frames and 41 nodes take 2.1 MB, as text a third more.
"""

MISSING: Final = -32768
"""Stands for a number that there is not."""

_STEPS: Final = 65534

_BRIGHTEST: Final = 0.995
"""Share of all stretches that the colours tell apart: a few hinges would leave the rest in one colour."""

RESULTS: Final = (
    ("sag_over_span", "largest sag / span", ""),
    ("time_to_90", "time to 90 %", "s"),
    ("largest_stretch", "largest stretch", ""),
)
"""Results that get an axis: variable, name, unit."""


def packed(dataset: xr.Dataset) -> dict[str, Any]:
    """Bring a sweep into a form that JSON can hold."""
    members = dataset.sizes.get("member", 0)
    keys = [str(name) for name, values in dataset.data_vars.items() if values.attrs.get("varied")]
    if not members or not keys:
        raise ValueError("a page of sliders needs a sweep of at least one member in which something was varied")
    texts = {name: _texts(dataset, name) for name in ("regime", "outcome", "message")}
    # Members whose answer has a regime, whose scales the page has; all where none has. What ruptures is far longer.
    sound = np.array([bool(regime) for regime in texts["regime"]])
    sound |= not sound.any()
    axes = [_axis(key, key, str(dataset[key].attrs.get("units", "")), dataset[key]) for key in keys]
    axes += [_axis(*result, dataset[result[0]], sound) for result in RESULTS]
    return {
        "members": members,
        "axes": [axis for axis in axes if axis is not None],
        **texts,
        **{name: _listed(dataset[name].values) for name in ("span", "duration", "thickness")},
        "sheet": dataset.attrs.get("section") == "sheet",
        "midpoint": _fields(dataset, "midpoint"),
        "shapes": _fields(dataset, "x", "y", "stretch", sound=sound),
        "colours": np.rint(255 * colormaps["cividis"](np.linspace(0.0, 1.0, 17))[:, :3]).astype(int).tolist(),
    }


def quantised(values: Floats) -> dict[str, Any]:
    """Round numbers to 65534 steps of each member's own range and write them as base64 of little-endian int16."""
    flat = np.asarray(values, dtype=np.float64).reshape(len(values), -1)
    finite = np.isfinite(flat)
    low = np.where(finite, flat, np.inf).min(axis=1, initial=np.inf)
    high = np.where(finite, flat, -np.inf).max(axis=1, initial=-np.inf)
    low, high = np.where(np.isfinite(low), low, 0.0), np.where(np.isfinite(high), high, 0.0)
    step = np.where(high > low, (high - low) / _STEPS, 1.0)
    codes = np.where(finite, np.rint((np.where(finite, flat, 0.0) - low[:, None]) / step[:, None]) - 32767, MISSING)
    text = base64.b64encode(codes.astype("<i2").tobytes()).decode("ascii")
    # In full: rounded, the bounds would shift a member whose range is small beside its values.
    return {"low": low.tolist(), "step": step.tolist(), "codes": text}


def _axis(
    key: str, name: str, unit: str, values: xr.DataArray, sound: NDArray[np.bool_] | None = None
) -> dict[str, Any] | None:
    """One axis; words, such as the name of a law, stand at equal distances. None where there is nothing to show.

    Of a result, which is not varied, the members that are `sound` say how far it goes.
    """
    varied = sound is None
    axis: dict[str, Any] = {"key": key, "name": name, "unit": "" if unit == "1" else typeset(unit), "varied": varied}
    if values.dtype.kind not in "fiub":
        known, places = np.unique(values.values.astype(np.str_), return_inverse=True)
        return axis | {"scale": "lin", "words": known.tolist(), "values": places.tolist()}
    numbers = np.asarray(values.values, dtype=np.float64)
    finite = numbers[np.isfinite(numbers) & (True if sound is None else sound)]
    if not finite.size:
        return None
    wide = values.attrs.get("scale") == "log" if varied else bool(finite.max() > 100 * finite.min())
    return axis | {"scale": "log" if wide and finite.min() > 0 else "lin", "values": _listed(numbers)}


def _fields(dataset: xr.Dataset, *names: str, sound: NDArray[np.bool_] | None = None) -> dict[str, Any] | None:
    """Fields over shares of the duration; every second frame, fourth, ... of large ones.

    Of shapes the stretches that colours tell apart, and the number of nodes, too. None where not even two frames fit.
    """
    fields = {name: np.asarray(dataset[name].values, dtype=np.float64) for name in names}
    frames, size, every = fields[names[0]].shape[1], sum(2 * values.size for values in fields.values()), 1
    while size / frames * math.ceil(frames / every) > LARGEST:
        every *= 2
        if every > max(1, frames - 1):
            return None
    at = {"at": np.linspace(0.0, 1.0, frames)[::every].tolist()}
    kept = {name: values[:, ::every] for name, values in fields.items()}
    if sound is None:
        return at | quantised(kept[names[0]])
    stretch = kept["stretch"][sound]
    stretch = stretch[np.isfinite(stretch)]
    ends = np.quantile(stretch, (0.0, _BRIGHTEST)).tolist() if stretch.size else [1.0, 1.0]
    packs = {name: quantised(field) for name, field in kept.items()}
    return {**at, "nodes": kept["x"].shape[2], "stretches": ends, **packs}


def _texts(dataset: xr.Dataset, name: str) -> list[str]:
    texts = [str(value) for value in dataset[name].values]
    return ["" if text in ("nan", "None") else text for text in texts]


def _listed(values: Floats) -> list[float | None]:
    """Numbers to seven digits, null for what is none."""
    return [float(f"{value:.7g}") if math.isfinite(value) else None for value in values.tolist()]


_STYLES = ("common.css", "sliders.css")
_SCRIPTS = ("drawing.js", "sliders_data.js", "sliders_filament.js", "sliders.js")
"""In the order in which they need one another."""


def sliders_page(dataset: xr.Dataset, title: str) -> str:
    """Write the page of a sweep: a slider for each varied parameter.

    Dragging one chooses the member that is nearest; its filament, its midpoint and its numbers are shown below.
    """
    folders = [resources.files(f"softcat_sym.{package}") / "templates" for package in ("plotting", "web")]

    def read(*names: str) -> str:
        files = [next(file for folder in folders if (file := folder / name).is_file()) for name in names]
        return "\n".join(file.read_text(encoding="utf-8") for file in files)

    parts = {
        "TITLE": escape(" ".join(title.split()) or "Sweep"),
        "STYLE": read(*_STYLES),
        "SCRIPT": read(*_SCRIPTS),
        "DATA": inlined(packed(dataset)),
    }
    return filled(read("sliders.html"), parts)
