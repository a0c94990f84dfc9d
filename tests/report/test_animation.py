"""Films: what is drawn has the thickness, the colour and the time that the trajectory says."""

from __future__ import annotations

import shutil
import subprocess
import sys
from importlib.util import find_spec
from io import BytesIO

import numpy as np
import pytest
import xarray as xr
from matplotlib import colormaps
from PIL import Image

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.animation import Animation, film_order, write_film

HAS_FFMPEG = shutil.which("ffmpeg") is not None or find_spec("imageio_ffmpeg") is not None
GIF = film_order("gif", 1.0)


def pulled(scene, stretch: float, stress: float = 5e3) -> xr.Dataset:
    """A straight filament that is pulled evenly, as wide as before: h = h0/stretch, axial stress growing with it."""
    span, thickness, cells = scene.filament.span, scene.filament.thickness, 20
    time = np.linspace(0, 1, 11)
    by = 1 + (stretch - 1) * time[:, None]
    X = np.linspace(-span / 2, span / 2, cells + 1)
    ones = np.ones((time.size, cells))
    per_cell = {"thickness": thickness / by * ones, "stress_mean": stress * time[:, None] * ones}
    per_cell |= {"stress_bending": 0 * ones, "yielded_fraction": 0 * ones, "plastic_rate": ones}
    return xr.Dataset(
        {
            "x": (("time", "node"), by * X),
            "y": (("time", "node"), 0 * by * X),
            "midpoint": ("time", -1e-3 * time),
            **{name: (("time", "cell"), values) for name, values in per_cell.items()},
        },
        coords={"time": time, "X_node": ("node", X), "X_cell": ("cell", 0.5 * (X[1:] + X[:-1]))},
    )


def column(animation: Animation, picture: np.ndarray, x: float) -> tuple[np.ndarray, int]:
    """Pixels of the picture from top to bottom at a place of the filament [mm], and the row of the axis y = 0."""
    across, up = animation.axes.transData.transform((x, 0.0))
    return picture[:, round(across)].astype(int), picture.shape[0] - 1 - round(up)


@pytest.mark.parametrize(("number", "stretch"), [(0, 1.0), (5, 1.5), (10, 2.0)])
def test_the_drawn_thickness_is_the_first_over_the_stretch_within_a_pixel(make_scene, summary, number, stretch):
    thick = make_scene(thickness=0.04)
    animation = Animation(pulled(thick, 2.0, stress=0.0), summary, thick, 11)
    pixels, axis = column(animation, animation.picture(number), 10.0)
    scale = np.diff(animation.axes.transData.transform([(0, 0), (0, 1)]), axis=0)[0, 1]  # pixel per mm
    # The edges are dark and 1.25 pixels wide: their centres of darkness. Farther out is the shape at the start.
    darkness = np.clip(130 - pixels.max(axis=1), 0, None).astype(float)
    rows = np.arange(len(pixels))
    reach = 0.7 * 40 / stretch * scale
    above, below = (rows < axis) & (rows > axis - reach), (rows > axis) & (rows < axis + reach)
    edges = [np.average(rows[side], weights=darkness[side]) for side in (above, below)]
    assert edges[1] - edges[0] == pytest.approx(40 / stretch * scale, abs=1.0)
    assert scale == pytest.approx(np.diff(animation.axes.transData.transform([(0, 0), (1, 0)]), axis=0)[0, 0])


def test_the_colour_is_the_stress_over_the_yield_stress(make_scene, summary):
    thick = make_scene(thickness=0.04, limit=1e4)
    animation = Animation(pulled(thick, 1.2), summary, thick, 11)
    for number, share in ((2, 0.2), (6, 0.6)):
        pixels, axis = column(animation, animation.picture(number), 13.0)
        wanted = 255 * np.array(colormaps["YlGnBu"](share)[:3])
        np.testing.assert_allclose(pixels[axis - 12], wanted, atol=3)


def test_what_yields_is_hatched_and_nothing_else_is(make_scene, summary):
    def reddish(limit: float) -> int:
        thick = make_scene(thickness=0.04, limit=limit)
        animation = Animation(pulled(thick, 1.2), summary, thick, 11)
        red, green, blue = np.moveaxis(animation.picture(10)[:250].astype(int), 2, 0)
        return int(np.sum((red > green + 60) & (red > blue + 60)))

    assert reddish(6e3) == 0
    assert reddish(4e3) > 1000


def test_the_core_of_a_bent_section_is_not_hatched(make_scene, summary):
    thick = make_scene(thickness=0.04, limit=1e4)
    run = pulled(thick, 1.0, stress=0.0)
    bent = run.assign(stress_bending=run.stress_bending + 2e4)  # beyond the yield stress where |zeta| > 1/2
    animation = Animation(bent, summary, thick, 3)
    picture = animation.picture(2).astype(int)
    corners = animation.axes.transData.transform([(-80, -20), (80, 20)]).round().astype(int)
    (left, low), (right, high) = corners
    rows = picture.shape[0] - 1 - np.array([high, low])
    body = picture[rows[0] : rows[1], left:right]
    red, green, blue = np.moveaxis(body, 2, 0)
    hatched = ((red > green + 60) & (red > blue + 60)).mean(axis=1)
    zeta = np.linspace(1, -1, len(hatched))
    assert np.all(hatched[np.abs(zeta) < 0.45] == 0)
    assert hatched[(zeta > 0.55) & (zeta < 0.95)].mean() > 0.02
    assert hatched[(zeta < -0.55) & (zeta > -0.95)].mean() > 0.02


def test_pictures_stand_at_equal_times_and_leave_no_trace(descent, summary, scene):
    animation = Animation(descent, summary, scene, 25, width=640)
    np.testing.assert_allclose(animation.times, np.linspace(0, 2, 25))
    first = animation.picture(0)
    last = animation.picture(24)
    assert np.any(first != last)
    np.testing.assert_array_equal(animation.picture(0), first)
    assert first.shape[1::-1] == animation.size
    assert first.shape[1] == 640
    assert first.shape[0] % 2 == 0


def test_between_frames_the_filament_is_between_them(descent, summary, scene):
    film = Animation(descent.isel(time=slice(0, 201, 100)), summary, scene, 5)._film
    middle = 0.5 * (descent.midpoint.values[0] + descent.midpoint.values[100])
    assert film.moment(1).midpoint == pytest.approx(middle)
    assert film.moment(4).midpoint == descent.midpoint.values[-1]


def test_the_curve_of_the_midpoint_has_every_frame_of_the_run(descent, summary, scene):
    """Twenty pictures of a run that rings 108 times: the curve is the run's, not the pictures'."""
    time = np.linspace(0, 2, 2001)
    ringing = descent.interp(time=time).assign(midpoint=("time", -0.02 + 0.01 * np.cos(2 * np.pi * 53.75 * time)))
    told = summary | {"frames_a_period": 1000 / 53.75}
    animation = Animation(ringing, told, scene, 20, width=640)
    (panel,) = (axes for axes in animation.figure.axes if axes.get_ylabel().startswith("midpoint"))
    np.testing.assert_allclose(panel.lines[0].get_xdata(), time)
    np.testing.assert_allclose(panel.lines[0].get_ydata(), 1e3 * ringing.midpoint.values)
    animation.picture(10)
    past = animation._past.get_xdata()
    assert len(past) > 1000
    assert past[-1] == pytest.approx(animation.times[10])


@pytest.mark.parametrize(
    ("per_period", "moments", "said"),
    [
        (1000 / 53.75, 100, "rings at 53.8 Hz: pictures 20.2 ms apart do not show that, the curve does; a film 4.3"),
        (1000 / 53.75, 500, ""),
        (3.0, 100, "rings at 333 Hz: the 2001 frames of the run are too few"),
        (None, 100, ""),
    ],
)
def test_a_film_that_cannot_show_the_ringing_says_so(descent, summary, scene, per_period, moments, said):
    run = descent.interp(time=np.linspace(0, 2, 2001))
    animation = Animation(run, summary | {"frames_a_period": per_period}, scene, moments, width=640)
    assert said in animation.note
    assert bool(said) == bool(animation.note)
    assert not said or animation.note in [text.get_text() for text in animation.figure.texts]


def test_a_flat_filament_is_drawn_steeper_and_says_so(make_run, scene, summary):
    times = np.linspace(0, 1, 11)
    flat = Animation(make_run(scene, 1e-4 * times, times), summary, scene, 3)
    assert "vertical scale × " in flat.axes.get_xlabel()
    deep = Animation(make_run(scene, 0.1 * times, times), summary, scene, 3)
    assert "scale" not in deep.axes.get_xlabel()


def test_a_gif_holds_every_picture_for_its_time(descent, summary, scene, tmp_path):
    told: list[str] = []
    path, note = write_film(film_order("ink.gif", 2.0), tmp_path, (descent, summary, scene), told.append, width=640)
    assert note == ""
    assert [entry.name for entry in tmp_path.iterdir()] == ["ink.gif"]
    assert told == [f"picture {k} of 25" for k in range(1, 26)]
    with Image.open(path) as film:
        assert film.n_frames == 25
        assert film.info["loop"] == 0
        assert film.size[0] == 640
        pauses = []
        for k in range(film.n_frames):
            film.seek(k)
            pauses.append(film.info["duration"])
        assert pauses[:-1] == [80] * 24
        last = np.asarray(film.convert("RGB")).astype(int)
    drawn = Animation(descent, summary, scene, 25, width=640).picture(24).astype(int)
    assert np.abs(last - drawn).mean() < 2  # 128 colours
    assert path.stat().st_size < 1_000_000


@pytest.mark.skipif(not HAS_FFMPEG, reason="needs ffmpeg, or the package imageio-ffmpeg")
def test_an_mp4_holds_every_picture(descent, summary, scene, tmp_path):
    order = film_order("mp4", 1.0)
    path, _ = write_film(order, tmp_path, (descent, summary, scene), width=320)
    wide, tall = Animation(descent, summary, scene, 2, width=320).size
    command = [order.ffmpeg, "-loglevel", "error", "-i", str(path), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    read = subprocess.run(command, capture_output=True, check=True).stdout
    pictures = np.frombuffer(read, dtype=np.uint8).reshape(-1, tall, wide, 3)
    assert len(pictures) == 25
    drawn = Animation(descent, summary, scene, 25, width=320).picture(12)
    assert np.abs(pictures[12].astype(int) - drawn).mean() < 4


@pytest.mark.parametrize(
    "kind", ["gif", pytest.param("mp4", marks=pytest.mark.skipif(not HAS_FFMPEG, reason="ffmpeg"))]
)
def test_interrupted_it_leaves_the_old_film_and_nothing_else(descent, summary, scene, tmp_path, kind):
    order = film_order(kind, 1.0)
    (tmp_path / order.name).write_bytes(b"old")

    def stop(what: str) -> None:
        if "picture 3 " in what:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_film(order, tmp_path, (descent, summary, scene), stop, width=320)
    assert [path.name for path in tmp_path.iterdir()] == [order.name]
    assert (tmp_path / order.name).read_bytes() == b"old"


@pytest.mark.skipif(not HAS_FFMPEG, reason="needs ffmpeg, or the package imageio-ffmpeg")
def test_an_ffmpeg_that_fails_is_quoted(descent, summary, scene, tmp_path):
    order = film_order("mp4", 1.0)
    failing = tmp_path / "ffmpeg"
    failing.write_text("#!/bin/sh\necho Unknown encoder libx264 >&2\nexit 1\n")
    failing.chmod(0o755)
    out = tmp_path / "out"
    out.mkdir()
    broken = type(order)(order.name, order.kind, order.seconds, str(failing))
    with pytest.raises(SoftcatError, match="Unknown encoder libx264"):
        write_film(broken, out, (descent, summary, scene), width=320)
    assert list(out.iterdir()) == []


@pytest.mark.parametrize("asked", ["avi", "film.webm", "a/b.gif", "../x.mp4", ".gif", "", "film.gif/"])
def test_what_is_no_film_is_refused(asked):
    with pytest.raises(SoftcatError, match="accepted: gif, mp4"):
        film_order(asked, 8.0)


@pytest.mark.parametrize("seconds", [0.0, -1.0, 1e9, float("nan"), float("inf")])
def test_lengths_that_make_no_sense_are_refused(seconds):
    with pytest.raises(SoftcatError, match="more than 0 and at most 120 s"):
        film_order("gif", seconds)


def test_without_ffmpeg_an_mp4_is_refused_and_a_gif_is_not(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(SoftcatError, match=r"apt install ffmpeg.*softcat_sym\[movies\]"):
        film_order("mp4", 8.0)
    assert film_order("gif", 8.0).pictures == 100


def test_a_single_frame_and_a_law_without_yield_stress_make_a_film(make_run, make_scene, summary, tmp_path):
    scene = make_scene(law="maxwell", limit=None)
    run = make_run(scene, np.array([0.02]), np.array([0.0]))
    path, _ = write_film(GIF, tmp_path, (run, summary, scene), width=320)
    assert Image.open(BytesIO(path.read_bytes())).format == "GIF"
