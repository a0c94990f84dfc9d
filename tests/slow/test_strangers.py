"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.free_vibration import first_vibration, ringing
from softcat_sym.results.motion import swing_period
from softcat_sym.studies.explanation import explain
from tests.common.table import rows_of

pytestmark = pytest.mark.slow

Says = Callable[..., None]


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


# --- B1: the regime does not depend on the frames


# --- B2: a creep is not a swing


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


def hung(span: float, length: float, diameter: float, **tables: dict[str, object]) -> sc.Scene:
    """A slack elastic rope between clamps."""
    filament = {"span": span, "rest_length": length, "diameter": diameter, "density": 1000.0}
    return sc.Scene.from_dict({"filament": filament, "run": {"duration": 1.0}, **tables})


def pitch(run: sc.Run, near: float) -> float:
    """Frequency [Hz] of the highest peak of the spectrum of the midpoint, sideways and up, within 30 % of one."""
    about = near * np.linspace(0.7, 1.3, 1201)
    time, spectrum = run.data.time.values, 0.0
    for axis in ("x", "y"):
        way = run.fields[axis][:, run.fields[axis].shape[1] // 2]
        drift = np.polyval(np.polyfit(time, way, 2), time)
        spectrum = spectrum + np.abs(
            np.exp(-2j * np.pi * np.outer(about, time)) @ ((way - drift) * np.hanning(len(time)))
        )
    return float(about[np.argmax(spectrum)])


def test_a_slack_chain_has_its_own_first_frequency(says: Says) -> None:
    """0.1614 Hz is that of stiff links that only weight holds (tests/test_free_vibration.py)."""
    steel = {"law": "elastic", "youngs_modulus": 200e9, "loss_tangent": 0.01}
    said = explain(hung(120.0, 140.0, 0.002, material=steel)).damping
    says("B4", "12.8 Hz printed for a chain of 140 m over 120 m, which has 0.161 Hz", said)
    found = re.search(r"frequency (\S+) Hz; loss tangent 0.01 -> solid viscosity (\S+) Pa s", said)
    assert found
    assert float(found[1]) == pytest.approx(0.1614, rel=3e-3)
    assert float(found[2]) == pytest.approx(0.01 * 200e9 / (2 * np.pi * 0.1614), rel=3e-3)


def test_a_slack_rope_rings_in_a_run_as_was_foreseen(says: Says) -> None:
    """Its right support is moved by a quarter of a per cent of the span, and the rope is left to itself."""
    scene = hung(
        0.2, 0.24, 0.001, material={"law": "elastic", "youngs_modulus": 10e6},
        ends={"motion": [["0 s", "0 m", "0 m"], ["10 ms", "0.5 mm", "0.3 mm"]]},
        run={"duration": 3.0, "frames": 601}, numerics={"estimate": False},
    )  # fmt: skip
    vibration = first_vibration(scene)
    assert vibration is not None
    foreseen = vibration.frequency / (2 * np.pi)
    rings = pitch(sc.simulate(scene), foreseen)
    says("B4", "a slack rope in a run", f"rings at {rings:.4g} Hz, foreseen {foreseen:.4g} Hz")
    assert rings == pytest.approx(foreseen, rel=0.01)


@pytest.mark.parametrize(
    ("name", "before", "within"),
    [
        # Hertz that closed forms gave for its ringing, and how far the swing by the whole sag may be from a small one.
        ("rubber-strand", 4.58, 0.06),
        ("printed-lintel", 75.0, 0.03),
        ("embedded-strand", 6.22, 0.03),
        ("cooked-spaghetti", 6.46, 0.05),
    ],
)
def test_bundled_scenes_ring_as_was_foreseen(says: Says, name: str, before: float, within: float) -> None:
    scene = sc.load_scene(name)
    foreseen = ringing(scene).frequency / (2 * np.pi)
    length = {"run.duration": f"{scene.load.ramp + 6 / foreseen} s", "run.frames": 401, "numerics.estimate": False}
    data = sc.simulate(scene.replace(length)).data
    period = swing_period(data.time.values, data.midpoint.values)
    assert period is not None
    says("B4", f"{name}: {before:g} Hz by a closed form", f"rings at {1 / period:.3g} Hz, foreseen {foreseen:.3g} Hz")
    assert 1 / period == pytest.approx(foreseen, rel=within)
    assert abs(before * period - 1) > 2 * within


# --- B5: polymer threads


# --- B6: the time of breaking


# --- B7: what a fit calls identified


# --- B8: what explain says an effect is worth


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


# --- C2: a run that falls for ever ends


# --- C3: time limits and interrupts


# --- C4: helices and histories are bounded when a scene is read


# --- C5: time limits of fits


# --- D1: clearing the cache leaves the user's files alone


# --- D2: nobody else's code or results are loaded


# --- D3: a full disk is no crash
