"""Films and the gallery: what is drawn is what the trajectory says, what a lesson says is what the run shows."""

from __future__ import annotations

import re
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from matplotlib import colormaps
from PIL import Image

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.plotting import animation
from softcat_sym.plotting.animation import Animation, film_order, write_film
from softcat_sym.plotting.section import Floats
from softcat_sym.results.run import Run
from softcat_sym.scene.bundled import bundled_lesson, bundled_text
from tests.common.catenary import descent, make_run, make_scene, scene, summary
from tests.common.in_process import Softcat

__all__ = ["descent", "make_run", "make_scene", "scene", "summary"]


def pulled(scene, stretch: float, stress: float = 5e3) -> dict[str, Floats]:
    """A straight filament that is pulled evenly, as wide as before: h = h0/stretch, axial stress growing with it."""
    span, thickness, cells = scene.filament.span, scene.filament.thickness, 20
    time = np.linspace(0, 1, 11)
    by = 1 + (stretch - 1) * time[:, None]
    X = np.linspace(-span / 2, span / 2, cells + 1)
    ones = np.ones((time.size, cells))
    places = {"time": time, "X_node": X, "X_cell": 0.5 * (X[1:] + X[:-1]), "x": by * X, "y": 0 * by * X}
    cell = {"thickness": thickness / by * ones, "stress_mean": stress * time[:, None] * ones, "plastic_rate": ones}
    return {**places, "midpoint": -1e-3 * time, **cell, "stress_bending": 0 * ones, "yielded_fraction": 0 * ones}


def column(animation: Animation, picture: np.ndarray, x: float) -> tuple[np.ndarray, int]:
    """Pixels of the picture from top to bottom at a place of the filament [mm], and the row of the axis y = 0."""
    across, up = animation.axes.transData.transform((x, 0.0))
    return picture[:, round(across)].astype(int), picture.shape[0] - 1 - round(up)


def reddish(picture: np.ndarray) -> np.ndarray:
    red, green, blue = np.moveaxis(picture.astype(int), 2, 0)
    return (red > green + 60) & (red > blue + 60)


def test_the_drawn_thickness_is_the_first_over_the_stretch_within_a_pixel(make_scene, summary):
    thick = make_scene(thickness=0.04)
    animation = Animation(pulled(thick, 2.0, stress=0.0), summary, thick, 11)
    across, up = (
        np.diff(animation.axes.transData.transform([(0, 0), end]), axis=0)[0, k]
        for k, end in enumerate([(1, 0), (0, 1)])
    )
    assert across == pytest.approx(up)  # pixel per mm
    for number, stretch in ((0, 1.0), (5, 1.5), (10, 2.0)):
        pixels, axis = column(animation, animation.picture(number), 10.0)
        # The edges are dark and 1.25 pixels wide: their centres of darkness. Farther out is the shape at the start.
        darkness = np.clip(130 - pixels.max(axis=1), 0, None).astype(float)
        rows, reach = np.arange(len(pixels)), 0.7 * 40 / stretch * up
        above, below = (rows < axis) & (rows > axis - reach), (rows > axis) & (rows < axis + reach)
        edges = [np.average(rows[side], weights=darkness[side]) for side in (above, below)]
        assert edges[1] - edges[0] == pytest.approx(40 / stretch * up, abs=1.0)


def test_the_colour_is_the_stress_and_what_yields_is_hatched(make_scene, summary):
    thick = make_scene(thickness=0.04, limit=1e4)
    animation = Animation(pulled(thick, 1.2), summary, thick, 11)
    for number, share in ((2, 0.2), (6, 0.6)):
        pixels, axis = column(animation, animation.picture(number), 13.0)
        np.testing.assert_allclose(pixels[axis - 12], 255 * np.array(colormaps["YlGnBu"](share)[:3]), atol=3)
    for limit, hatched in ((6e3, False), (4e3, True)):
        strong = make_scene(thickness=0.04, limit=limit)
        count = int(reddish(Animation(pulled(strong, 1.2), summary, strong, 11).picture(10)[:250]).sum())
        assert count > 1000 if hatched else count == 0


@pytest.mark.slow
def test_a_gif_holds_every_picture_for_its_time(descent, summary, scene, make_run, make_scene, tmp_path):
    steps: list[str] = []
    path, note = write_film(film_order("ink.gif", 2.0), tmp_path, (descent, summary, scene), steps.append, width=640)
    assert note == "" and [entry.name for entry in tmp_path.iterdir()] == ["ink.gif"]
    assert steps == [f"picture {k} of 25" for k in range(1, 26)]
    with Image.open(path) as film:
        assert (film.n_frames, film.info["loop"], film.size[0]) == (25, 0, 640)
        pauses = []
        for k in range(film.n_frames):
            film.seek(k)
            pauses.append(film.info["duration"])
        assert pauses[:-1] == [80] * 24
        last = np.asarray(film.convert("RGB")).astype(int)
    drawn = Animation(descent, summary, scene, 25, width=640).picture(24).astype(int)
    assert np.abs(last - drawn).mean() < 2  # 128 colours
    assert path.stat().st_size < 1_000_000
    # A single frame and a law without yield stress make a film, too.
    plain = make_scene(law="maxwell", limit=None)
    run = make_run(plain, np.array([0.02]), np.array([0.0]))
    path, _ = write_film(film_order("gif", 0.5), tmp_path, (run, summary, plain), width=320)
    assert Image.open(BytesIO(path.read_bytes())).format == "GIF"


def test_what_is_no_film_is_refused(monkeypatch):
    for asked in ("avi", "film.webm", "a/b.gif", "../x.mp4", ".gif", "", "film.gif/"):
        with pytest.raises(SoftcatError, match="accepted: gif, mp4"):
            film_order(asked, 8.0)
    for seconds in (0.0, -1.0, 1e9, float("nan"), float("inf")):
        with pytest.raises(SoftcatError, match="more than 0 and at most 120 s"):
            film_order("gif", seconds)
    monkeypatch.setattr(animation, "find_spec", lambda name: None)
    with pytest.raises(SoftcatError, match=r"PyAV, which is not installed: pip install 'softcat_sym\[movies\]'"):
        film_order("mp4", 8.0)
    assert film_order("gif", 8.0).pictures == 100


def test_a_film_in_space_shows_the_tube_where_it_is(tmp_path: Path) -> None:
    """A curl that falls: its first and its last picture differ where it moves, and nowhere else."""
    scene = sc.load_scene("hanging-curl", ["numerics.cells=4", "run.frames=21", "numerics.estimate=false"])
    scene = scene.replace({"run.duration": "0.3 s", "numerics.backend": "interpreted"})
    run = sc.simulate(scene)
    order = film_order("gif", 1.0)
    path, note = write_film(order, tmp_path, (run.fields, run.summary, scene), width=320)
    with Image.open(path) as film:
        assert film.n_frames == order.pictures == 12
        assert film.size == (320, 200)
        shown = []
        for number in (0, 11):
            film.seek(number)
            shown.append(np.asarray(film.convert("RGB"), dtype=int))
    moved = np.abs(shown[0] - shown[1]).max(axis=2) > 60
    assert 20 < moved.sum() < 0.2 * moved.size
    assert note == ""


UNITS = {"um": 1e-6, "mm": 1e-3, "": 1.0, "%": 0.01, "s": 1.0}
# What a lesson may state as a number, and where it is read in the run.
STATED: dict[str, Callable[[Run], float]] = {
    r"largest sag (NUMBER) (um|mm)": lambda run: -run.fields["midpoint"].min(),
    r"(?:sag of|and sags|board it sags) (NUMBER) (um|mm)": lambda run: -run.fields["midpoint"][-1],
    r"after (NUMBER) (s)\b": lambda run: run.scene.run.duration,
    r"(NUMBER) (%) of its span deep": lambda run: -run.fields["midpoint"][-1] / run.scene.filament.span,
    r"hang (NUMBER) (mm) deep": lambda run: -run.fields["midpoint"][-1],
    r"(NUMBER) (mm) deep": lambda run: -run.fields["midpoint"][0],
    r"goes down to (NUMBER) (mm)": lambda run: -run.fields["y"].min(),
    r"holds? it (NUMBER) (mm) above": lambda run: run.fields["midpoint"][0],
    r"rises (NUMBER) (mm)": lambda run: run.fields["y"][0, -1],
    r"stretched (NUMBER)() times": lambda run: run.fields["stretch"][-1].max(),
    r"in (NUMBER) (s)": lambda run: run.scene.run.duration,
    r"Index (NUMBER)()": lambda run: run.scene.material.index,
    r"G = (NUMBER)()": lambda run: (
        run.scene.filament.density * run.scene.load.gravity * run.scene.filament.span / run.scene.material.yield_stress
    ),
    r"(NUMBER) (um) down": lambda run: -run.fields["midpoint"][-1],
    r"(NUMBER) (um|mm) to the side": lambda run: float(abs(run.fields["z"][-1]).max()),
    r"(NUMBER) (mm) high": lambda run: height(run, 0),
    r"creeps to (NUMBER) (mm)": lambda run: height(run, -1),
    r"10 ms to (NUMBER) (s)": lambda run: (
        run.scene.material.modes[-1].viscosity / run.scene.material.modes[-1].youngs_modulus
    ),
}


def height(run: Run, frame: int) -> float:
    """How far the last node of a filament lies below the first one, along its weight [m]."""
    nodes, down = np.array([run.fields[name][frame] for name in "xyz"]), np.array(run.scene.load.direction)
    return float((nodes[:, -1] - nodes[:, 0]) @ down / np.linalg.norm(down))


# Names and formulas that hold digits, and are no measurement; the shaken strand's two are held by tests of shaking.
COMPARISONS = (
    *("if it stayed as it is laid it would sag 9.3 mm", "let go at once, 3.7 mm", "makes the swings 1.4 times as long"),
    *("Drawn 7 times as long", "6 % less than the solvent alone", "after 40 swings"),
    "It grows by 1 mm/min at 711 C, 10^7.9 dPa s: 13 K below",
)
"""Numbers of other runs than the scene's own, or that its frames do not show: nothing here checks them. The last are
held by tests/slow/test_softening_point.py."""
FORMULAS = ("3/4 of its first frequency", "sqrt 2", "1/3 law", "4/3", "ASTM C598", "w L^3/(E I)", "c/(2 L)")
REGIMES = {
    r"\bstops\b": ("arrested-overdamped", "arrested-underdamped"),
    r"for ever": ("descending",),
    r"no fibre ever yields": ("no-yield",),
}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def check_lesson(lesson: str, run: Run) -> int:
    """Hold every number and regime of a lesson against the run; how many numbers there were."""
    left, count = lesson, 0
    for name in (*FORMULAS, *COMPARISONS):
        left = left.replace(name, "")
    for pattern, measured in STATED.items():
        found = re.search(pattern.replace("NUMBER", r"[\d.]*\d"), left)
        if found is None:
            continue
        text, unit = found[1], UNITS[found[2]]
        # Rounded, from a run whose error is not estimated: half a digit and two per cent.
        allowed = 0.5 * 10.0 ** -len(text.partition(".")[2]) * unit + 0.02 * float(text) * unit
        assert abs(measured(run) - float(text) * unit) <= allowed, f"{found[0]}: {measured(run)}"
        left, count = left.replace(found[0], ""), count + 1
    for pattern, regimes in REGIMES.items():
        assert not re.search(pattern, lesson) or run.summary["regime"] in regimes, (pattern, run.summary["regime"])
    bad = not run.outcome.is_success
    assert bad == lesson.startswith("Refused as "), run.outcome
    assert not bad or lesson.startswith(f"Refused as {run.outcome.name}:")
    left = left.replace("10 ms", "") if count else left
    assert not re.search(r"\d", left), f"a number that nothing checks: {left}"
    return count


def test_every_scene_teaches_something_of_its_own_in_a_line(softcat: Softcat) -> None:
    lessons = [bundled_lesson(name) for name in sc.bundled_names()]
    assert len(set(lessons)) == len(lessons)
    for name, lesson in zip(sc.bundled_names(), lessons, strict=True):
        assert 30 <= len(lesson) <= 100 and lesson.endswith("."), name
        assert lesson not in bundled_text(name).replace(f"# Lesson: {lesson}", ""), name
    done = softcat("scenes")
    assert (done.status, done.err) == (0, "")
    lines = done.out.splitlines()
    assert [line.split()[0] for line in lines[::2]] == list(sc.bundled_names())
    assert [line.strip() for line in lines[1::2]] == lessons
