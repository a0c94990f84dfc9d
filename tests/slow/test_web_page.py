"""The live page in a browser, opened from a file: sliders, clock, keyboard, links, errors, phones, darkness."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.common.browser import CHROMIUM, Browser, browser
from tests.common.parabola import page

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="needs Chromium, such as Debian's package chromium"),
]

FULL = "document.querySelector('main')?.dataset.shown === 'resolution'"


@pytest.fixture(scope="module")
def chromium(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    with browser(tmp_path_factory.mktemp("profile")) as found:
        yield found


@pytest.fixture
def strand(chromium: Browser, tmp_path: Path) -> Iterator[Browser]:
    """The page of a parabola; no test leaves an error on the console or a request behind."""
    chromium.messages.clear()
    chromium.requests.clear()
    opened(chromium, tmp_path / "strand.html")
    yield chromium
    assert chromium.messages == []
    assert [address for address in chromium.requests if not address.startswith(("file:", "about:", "blob:"))] == []


def opened(chromium: Browser, file: Path, link: str = "", **window: Any) -> None:
    if not file.exists():
        file.write_text(page(), encoding="utf-8")
    chromium.open(file, link, **window)
    chromium.until(FULL)


def text(chromium: Browser, name: str) -> str:
    return chromium.ask(f"document.getElementById('{name}').textContent")


def move(chromium: Browser, key: str, share: float) -> None:
    """Move a slider as a hand does."""
    chromium.ask(
        f"(() => {{ const handle = document.querySelector('input[type=range][data-key=\"{key}\"]');"
        f"handle.value = {share}; handle.dispatchEvent(new Event('input', {{bubbles: true}})); }})()"
    )


def typed(chromium: Browser, key: str, what: str) -> None:
    chromium.ask(
        f"(() => {{ const field = document.querySelector('input[type=text][data-key=\"{key}\"]');"
        f"field.value = {json.dumps(what)}; field.dispatchEvent(new Event('change', {{bubbles: true}})); }})()"
    )


def test_a_slider_gives_another_filament_first_coarse_and_then_in_full(strand: Browser):
    before = text(strand, "numbers")
    assert "computed" in before
    strand.ask(
        "window.seen = []; new MutationObserver(() => seen.push(document.querySelector('main').dataset.shown))"
        ".observe(document.querySelector('main'), {attributes: true, attributeFilter: ['data-shown']})"
    )
    move(strand, "filament.span", 0.6)
    strand.until(FULL)
    assert strand.ask("[...new Set(seen.filter(Boolean))]") == ["preview", "resolution"]
    assert text(strand, "numbers") != before
    assert "40 cells a half span, 201 frames" in text(strand, "resolution")
    assert (
        strand.ask("document.querySelector('[data-key=\"filament.span\"]').getAttribute('aria-valuetext')") == "7.96 mm"
    )
    strand.ask("document.getElementById('reset').click()")
    strand.until(FULL)
    assert text(strand, "numbers") == before


def test_fields_take_numbers_and_say_why_they_take_no_others(strand: Browser):
    typed(strand, "filament.span", "8")
    strand.until(FULL)
    eight = text(strand, "numbers")
    for what, why in (("abc", "“abc” is no number"), ("", "“” is no number"), ("25", "25 mm is beyond the slider")):
        typed(strand, "filament.span", what)
        told = strand.ask("document.getElementById('wrong-0').textContent")
        assert told == f"{why}: span goes from 2 to 20 mm, and stays at 8 mm."
    assert text(strand, "numbers") == eight
    typed(strand, "filament.span", "5")
    assert strand.ask("document.getElementById('wrong-0').textContent") == ""


def test_what_fails_is_told_and_what_does_not_end_is_stopped(strand: Browser):
    typed(strand, "load.gravity", "40")
    strand.until(FULL)
    told = text(strand, "problem")
    assert told.startswith("NOT TO BE TRUSTED (non_finite)because: why: A strand")
    assert told.endswith("advice: the state became infinite; shorten run.duration")
    assert "no answer" in text(strand, "numbers")
    assert text(strand, "warnings") == "gravity 40 m/s²: softcat run would take in more"
    typed(strand, "load.gravity", "9.81")
    strand.until(FULL)
    assert text(strand, "problem") == ""
    begun = time.monotonic()
    typed(strand, "filament.span", "17")
    strand.until("document.getElementById('problem').textContent")
    assert 4.5 < time.monotonic() - begun < 8
    assert text(strand, "problem").startswith("The run was stopped after 5 s without an end: move a slider back")
    assert text(strand, "numbers") == "", "nothing old is shown"
    typed(strand, "filament.span", "19")
    strand.until("document.getElementById('problem').textContent.includes('memory access')")
    typed(strand, "filament.span", "6")
    strand.until(FULL)
    assert text(strand, "problem") == ""


def test_pictures_fit_desks_and_phones_by_day_and_night(strand: Browser, tmp_path: Path):
    strand.call("Emulation.setScrollbarsHidden", hidden=True)
    for name, width, height in (("desk", 1280, 900), ("phone", 360, 800)):
        for dark in (False, True):
            opened(strand, tmp_path / "strand.html", width=width, height=height, dark=dark)
            assert strand.ask("document.documentElement.scrollWidth") <= width
            (tmp_path / f"{name}-{'dark' if dark else 'light'}.png").write_bytes(strand.picture())
