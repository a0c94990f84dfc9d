"""The page of a sweep: its numbers are the dataset's, its words are safe, and its sliders choose members."""

from __future__ import annotations

import base64
import json
import re
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from softcat_sym.plotting.sliders import sliders_page
from tests.common.browser import CHROMIUM, browser

WORD = '</script><script>alert("x")</script> & <b>'


def sweep(sizes: tuple[int, int] = (5, 4), frames: int = 9, nodes: int = 11, failed: int = 3) -> xr.Dataset:
    """Parabolas whose depth is the product of both parameters; one member failed."""
    G, V = np.geomspace(0.1, 10.0, sizes[0]), np.linspace(2.0, 8.0, sizes[1])
    table = np.array([(g, v) for g in G for v in V])
    members = len(table)
    depth = 0.01 * table[:, 0] * table[:, 1]
    share, X = np.linspace(0, 1, frames), np.linspace(-0.5, 0.5, nodes)
    midpoint = -depth[:, None] * share
    y = midpoint[:, :, None] * (1 - 4 * X**2)
    x = np.broadcast_to(X, y.shape).copy()
    stretch = 1 + 0.1 * depth[:, None, None] * share[None, :, None] * np.abs(X)
    results = {"sag_over_span": depth, "time_to_90": 0.9 * table[:, 1], "largest_stretch": stretch.max(axis=(1, 2))}
    regime = np.where(depth > 0.2, "descending", "no-yield").astype(object)
    outcome, message = np.full(members, "solved", dtype=object), np.full(members, "", dtype=object)
    if failed >= 0:
        for values in (midpoint, x, y, stretch, *results.values()):
            values[failed] = np.nan
        regime[failed], outcome[failed], message[failed] = "", "diverged", f"why: {WORD}"
    marks = {"units": "1", "varied": 1}
    shape = ("member", "shape_frame", "shape_node")
    return xr.Dataset(
        {
            "groups.G": ("member", table[:, 0], marks | {"scale": "log"}),
            "groups.V": ("member", table[:, 1], marks | {"scale": "lin"}),
            "regime": ("member", regime),
            "outcome": ("member", outcome),
            "message": ("member", message),
            "span": ("member", np.ones(members)),
            "duration": ("member", np.full(members, 3.0)),
            "thickness": ("member", np.full(members, 0.03)),
            **{name: ("member", values) for name, values in results.items()},
            "midpoint": (("member", "frame"), midpoint),
            **{name: (shape, values.astype(np.float32)) for name, values in (("x", x), ("y", y), ("stretch", stretch))},
        },
        coords={"frame": share},
    )


def held(page: str) -> dict[str, Any]:
    """The data of a page, found as a browser finds them."""
    found = re.findall(r'<script type="application/json" id="data">(.*?)</script>', page, flags=re.S)
    assert len(found) == 1
    return json.loads(found[0])


def unpacked(block: dict[str, Any], shape: tuple[int, ...]) -> np.ndarray:
    codes = np.frombuffer(base64.b64decode(block["codes"]), dtype="<i2").reshape(shape[0], -1).astype(float)
    codes[codes == -32768] = np.nan
    return (np.array(block["low"])[:, None] + np.array(block["step"])[:, None] * (codes + 32767)).reshape(shape)


def test_what_the_page_holds_is_the_dataset_within_its_rounding():
    data = sweep()
    page = held(sliders_page(data, "a sweep"))
    for name, block in [(name, page["shapes"][name]) for name in ("x", "y", "stretch")] + [
        ("midpoint", page["midpoint"])
    ]:
        values = data[name].values.astype(float)
        read = unpacked(block, values.shape)
        np.testing.assert_array_equal(np.isnan(read), np.isnan(values))
        flat, error = values.reshape(len(values), -1), np.abs(read - values).reshape(len(values), -1)
        sound = ~np.isnan(flat).any(axis=1)
        half = 0.5 * np.ptp(flat[sound], axis=1) / 65534
        assert np.all(error[sound].max(axis=1) <= half * (1 + 1e-6) + 1e-15), name
    axes = {axis["key"]: axis for axis in page["axes"]}
    assert list(axes) == ["groups.G", "groups.V", "sag_over_span", "time_to_90", "largest_stretch"]
    assert (axes["groups.G"]["scale"], axes["groups.V"]["scale"]) == ("log", "lin")
    for key, axis in axes.items():
        np.testing.assert_allclose([np.nan if v is None else v for v in axis["values"]], data[key].values, rtol=1e-6)
    assert page["regime"][3] == ""
    assert page["outcome"][3] == "diverged"


def test_no_word_leaves_its_place_and_nothing_is_asked_of_the_net():
    page = sliders_page(sweep(), f"@DATA@ @SCRIPT@ {WORD}")
    assert page.count("<script") == page.count("</script>") == 2
    assert "alert(" in held(page)["message"][3]
    title = re.search(r"<h1>(.*?)</h1>", page)
    assert title is not None
    assert unescape(title[1]) == f"@DATA@ @SCRIPT@ {WORD}"
    assert not re.search(r"https?://|src=|@import|url\(", page)


@pytest.mark.slow
@pytest.mark.skipif(not CHROMIUM, reason="needs Chromium, such as Debian's package chromium")
def test_a_handle_that_is_dragged_shows_the_numbers_of_its_member(tmp_path: Path):
    data = sweep()
    page = tmp_path / "sliders.html"
    page.write_text(sliders_page(data, "a sweep"), encoding="utf-8")
    G, V = data["groups.G"].values, data["groups.V"].values
    with browser(tmp_path / "profile") as chromium:

        def shown() -> int:
            """The member shown, whose numbers are the dataset's."""
            member = int(chromium.ask("document.getElementById('which').dataset.member"))
            for key in ("groups.G", "groups.V", "sag_over_span", "time_to_90", "largest_stretch"):
                text = chromium.ask(f"document.querySelector('#numbers dd[data-key=\"{key}\"]').dataset.value")
                value = float(data[key].values[member])
                assert float(text) == pytest.approx(value, rel=1e-6) if text else np.isnan(value)
            return member

        def handle(key: str) -> dict[str, float]:
            find = f"document.querySelector('input[data-key=\"{key}\"]')"
            return chromium.ask(
                f"(() => {{ const b = {find}.getBoundingClientRect();"
                f"return {{y: b.y + b.height / 2, left: b.left, width: b.width, at: Number({find}.value)}} }})()"
            )

        chromium.open(page, "#groups.G=1&groups.V=4")
        assert (G[shown()], V[shown()]) == pytest.approx((1.0, 4.0))
        before = chromium.ask("document.getElementById('filament').toDataURL()")
        slider = handle("groups.G")
        middle = slider["left"] + slider["at"] * slider["width"]
        chromium.drag((middle, slider["y"]), (slider["left"] + 0.99 * slider["width"], slider["y"]))
        assert (G[shown()], V[shown()]) == pytest.approx((10.0, 4.0)), "dragged to its end"
        assert chromium.ask("document.getElementById('filament').toDataURL()") != before
        chromium.ask("document.querySelector('input[data-key=\"groups.V\"]').focus()")
        chromium.press("ArrowUp")
        assert (G[shown()], V[shown()]) == pytest.approx((10.0, 6.0)), "a key is a step of the grid"
        chromium.ask("location.hash = '#groups.G=0.1&groups.V=8'")
        chromium.until("document.getElementById('which').dataset.member === '3'")
        assert shown() == 3
        assert "diverged" in chromium.ask("document.getElementById('which').textContent")
        chromium.ask("document.getElementById('time').value = 0; document.getElementById('play').click()")
        chromium.until("Number(document.getElementById('time').value) > 0.05")
        assert chromium.messages == []
        assert [address for address in chromium.requests if not address.startswith(("file:", "about:"))] == []
