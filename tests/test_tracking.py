"""Tracking against films rendered from exact geometry: bias, scatter and stated errors, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import softcat_sym as sc
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.tracking.result import Track
from tests.common.draws import draws
from tests.common.rendered_films import LOSSLESS, MJPEG, Picture, falling, film, h264, write_film

SMALL: dict[str, Any] = {
    "rows": 120, "columns": 160, "span": 124.0, "centre": 80.2, "level": 35.3, "thickness": 8.0,
    "depth": falling(30.0, 124.0, 1.1),
}  # fmt: skip


def tracked(
    folder: Path, codec: Any = LOSSLESS, how: dict[str, Any] | None = None, **changes: Any
) -> tuple[Track, Picture]:
    path = folder / ("film.mp4" if codec[0] == "libx264" else "film.mkv")
    picture = film(path, codec, **changes)
    return sc.track(path, "span=50 mm", **(how or {})), picture


def errors(track: Track, picture: Picture) -> np.ndarray:
    """Errors of the midpoint [px]."""
    return track.midpoint / track.pixel - picture.midpoint(picture.times)[track.number]


def shape_errors(track: Track, picture: Picture) -> np.ndarray:
    x = track.place / track.pixel
    true = np.array([picture.midline(picture.times[number], x) for number in track.number])
    return np.asarray(track.shapes / track.pixel - true)


@pytest.mark.parametrize("blur", [0.5, 1.0, 3.0])
def test_a_lossless_film_gives_midpoint_thickness_and_shape_to_a_fiftieth_of_a_pixel(
    blur: float, tmp_path: Path
) -> None:
    track, picture = tracked(tmp_path, blur=blur)
    off, thick = errors(track, picture), track.thickness / track.pixel - picture.thickness
    assert track.number.size == picture.times.size and not track.refused
    assert abs(off.mean()) < 0.02 and off.std() < 0.02
    assert abs(thick.mean()) < 0.03
    assert np.sqrt(np.mean(shape_errors(track, picture) ** 2)) < 0.02
    # A pixel averages over its width: the blur is that of the lens and of a box.
    assert track.camera.width == pytest.approx(np.sqrt(blur**2 + 1 / 12), abs=0.04)


def test_thickness_has_no_bias_down_to_three_pixels_and_is_left_out_below_two_and_a_half_blur_widths(
    tmp_path: Path,
) -> None:
    track, picture = tracked(tmp_path, thickness=5.0, times=np.arange(6) / 4.5)
    assert abs(np.mean(track.thickness / track.pixel) - 5.0) < 0.04
    three, _ = tracked(tmp_path, **SMALL | {"thickness": 3.0, "fine": 6}, times=np.arange(6) / 4.5)
    assert np.abs(three.thickness / three.pixel - 3.0).max() < 0.05
    thin, picture = tracked(tmp_path, **SMALL | {"thickness": 3.0}, blur=2.0)
    assert np.isnan(thin.thickness).all() and "no thickness" in thin.warnings[0]
    assert np.abs(errors(thin, picture)).max() < 0.1


@pytest.mark.parametrize("degrees", [2.0, -3.0])
def test_a_tilted_camera_is_found_from_the_strand_at_rest(degrees: float, tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, tilt=np.radians(degrees), times=np.arange(6) / 4.5)
    assert np.degrees(track.camera.tilt) == pytest.approx(degrees, abs=0.02)
    assert track.span / track.pixel == pytest.approx(picture.span, rel=3e-4)
    assert np.abs(errors(track, picture)).max() < 0.03


def test_uneven_light_moves_no_support(tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, gradient=0.3, vignette=0.4, times=np.arange(6) / 4.5)
    assert track.span / track.pixel == pytest.approx(picture.span, rel=3e-4)
    assert np.abs(errors(track, picture)).max() < 0.03


@pytest.mark.parametrize("inside", [{"glare": 0.6}, {"core": 0.4}])
def test_light_in_the_strand_is_no_edge(inside: dict[str, float], tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, thickness=20.0, times=np.arange(6) / 4.5, **inside)
    assert abs(np.mean(track.thickness / track.pixel) - 20.0) < 0.04
    assert np.abs(errors(track, picture)).max() < 0.03


@pytest.mark.statistical
@pytest.mark.parametrize("codec", [LOSSLESS, MJPEG], ids=["lossless", "mjpeg"])
def test_stated_errors_are_the_true_ones(codec: Any, tmp_path: Path) -> None:
    """About the mean of each film, as the frames at rest share the error of its zero.

    Of 60 errors with 54 degrees of freedom their standard deviation is off by half or twice with 1e-7.
    """
    off, std = [], []
    for seed in range(6):
        track, picture = tracked(tmp_path, codec, **SMALL, seed=seed, noise=2.0, times=np.arange(10) / 9)
        off.append(errors(track, picture))
        std.append(track.midpoint_std / track.pixel)
    scatter = np.sqrt(np.mean([np.var(one, ddof=1) for one in off]))
    assert 0.7 < np.median(np.concatenate(std)) / scatter < 2.0


@pytest.mark.statistical
def test_stated_errors_of_the_thickness_are_the_true_ones_of_a_bent_strand_out_of_focus(tmp_path: Path) -> None:
    """Of 40 errors their rms is off by half or twice with 1e-6; unless the blur is taken out, it is twice as large."""
    changes = SMALL | {"thickness": 9.0, "blur": 3.0, "times": np.arange(10) / 9}
    films = [tracked(tmp_path, **changes, seed=seed)[0] for seed in range(4)]
    off = np.concatenate([one.thickness / one.pixel - 9.0 for one in films])
    std = np.concatenate([one.thickness_std / one.pixel for one in films])
    assert 0.7 < np.median(std) / np.sqrt(np.mean(off**2)) < 2.0


@pytest.mark.parametrize("codec", [LOSSLESS, h264(20)], ids=["lossless", "h264"])
def test_exactly_the_repeated_frames_are_refused(codec: Any, tmp_path: Path) -> None:
    picture = replace(Picture(), **SMALL, times=np.arange(14) / 10.0)
    repeated = (5, 8, 11)
    frames = list(picture.frames())
    for number in repeated:
        frames[number] = frames[number - 1]
    track = sc.track(write_film(tmp_path / "film.mkv", frames, picture.times, codec), "span=50 mm")
    assert [one.number for one in track.refused if "repeats" in one.reason] == list(repeated)
    assert track.is_trusted


def test_a_middle_outside_of_the_picture_is_refused_and_the_shape_kept(tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, depth=falling(190.0, 250.0, 1.1))
    unseen = [one.number for one in track.refused if one.reason == "middle not seen"]
    lowest = picture.level - picture.midpoint(picture.times) + picture.thickness / 2
    assert unseen and all(lowest[number] > picture.rows - 8 for number in unseen)
    part = np.isin(track.number, unseen)
    assert np.isnan(track.midpoint[part]).all() and np.isfinite(track.shapes[part]).sum(axis=1).min() >= 6
    # Next to what is not seen a curve is less certain, and says so.
    assert np.nanmax(np.abs(shape_errors(track, picture)[part]) - 5 * track.shapes_std[part] / track.pixel) < 0.0


def test_times_are_those_of_the_file(tmp_path: Path) -> None:
    times = np.round(np.cumsum(0.05 + 0.09 * draws(3).random(12)), 3)
    track, picture = tracked(tmp_path, times=times, **SMALL)
    np.testing.assert_allclose(track.time + track.release, picture.times[track.number], atol=1e-6)


def test_mjpeg_is_as_good_as_lossless_and_starved_h264_is_warned_of(tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, MJPEG)
    assert errors(track, picture).std() < 0.02 and not track.warnings
    starved, picture = tracked(tmp_path, h264(36))
    assert starved.bits_per_pixel < 0.02 and "MJPEG" in starved.warnings[0]
    assert np.all(starved.midpoint_std / starved.pixel >= 0.3)


@pytest.mark.parametrize("degrees", [0.0, 2.0])
def test_a_needle_is_as_wide_as_it_was_drawn(degrees: float, tmp_path: Path) -> None:
    """The strand of the first frame is the needle: 41.3 px from edge to edge, along the normal."""
    changes = {"thickness": 41.3, "level": 90.0, "tilt": np.radians(degrees), "times": np.arange(5) / 20}
    track, _ = tracked(tmp_path, **changes, depth=falling(20.0, 250.0, 0.5))
    scaled = sc.track(tmp_path / "film.mkv", "needle@120,200,40,140=2 mm")
    assert 2e-3 / scaled.pixel == pytest.approx(41.3, abs=0.05)
    assert 2e-3 / scaled.pixel**2 * scaled.pixel_std < 0.05
    assert track.span == pytest.approx(0.05)


def test_a_light_strand_is_a_dark_one_upside_down(tmp_path: Path) -> None:
    dark, _ = tracked(tmp_path, **SMALL)
    light, _ = tracked(tmp_path, **SMALL, light_strand=True)
    assert dark.camera.light.is_dark and not light.camera.light.is_dark
    np.testing.assert_allclose(light.midpoint / light.pixel, dark.midpoint / dark.pixel, atol=0.02)


def test_a_steep_strand(tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, depth=falling(125.0, 250.0, 1.1))
    assert np.sqrt(np.mean(shape_errors(track, picture) ** 2)) < 0.02
    assert not track.refused


def test_pillars_and_dust(tmp_path: Path) -> None:
    track, picture = tracked(tmp_path, supports="pillars", dust=((150, 60, 4), (40, 200, 3), (80, 165, 2)))
    assert track.span / track.pixel == pytest.approx(picture.span, rel=4e-4)
    assert np.abs(errors(track, picture)).max() < 0.05


def test_a_hanging_strand_is_a_level_one_turned(tmp_path: Path) -> None:
    picture = replace(Picture(), **SMALL, times=np.arange(6) / 4.5)
    frames = list(picture.frames())
    level = sc.track(write_film(tmp_path / "level.mkv", frames, picture.times), "span=50 mm")
    turned = write_film(tmp_path / "turned.mkv", [np.rot90(one, -1).copy() for one in frames], picture.times)
    np.testing.assert_array_equal(sc.track(turned, "span=50 mm", vertical=True).midpoint, level.midpoint)


@pytest.mark.parametrize("depth", [8, 16])
def test_pictures_of_a_folder_and_of_a_stack_are_a_film(depth: int, tmp_path: Path) -> None:
    """In the order of their numbers, of eight bits or sixteen."""
    picture = replace(Picture(), **SMALL, times=np.arange(11) / 8)
    frames = [one if depth == 8 else one.astype(np.uint16) * 257 for one in picture.frames()]
    pictures = [Image.fromarray(one) for one in frames]
    for number, one in enumerate(pictures):
        one.save(tmp_path / f"frame-{number}.png")
    folder = sc.track(tmp_path, "span=50 mm", fps=8.0)
    assert np.abs(errors(folder, picture)).max() < 0.03
    pictures = [Image.fromarray(one) for one in frames]
    pictures[0].save(tmp_path / "film.tif", save_all=True, compression="tiff_deflate", append_images=pictures[1:])
    stack = sc.track(tmp_path / "film.tif", "span=50 mm", fps=8.0)
    np.testing.assert_array_equal(stack.midpoint, folder.midpoint)


def test_the_table_is_read_by_a_fit(tmp_path: Path) -> None:
    track, _ = tracked(tmp_path, **SMALL)
    (series,) = read_measurements(track.save(tmp_path / "film.csv")).series
    assert series.overrides == {"filament.span": "50 mm"} and series.std is not None
    later = track.time >= 0
    np.testing.assert_allclose(series.midpoint, track.midpoint[later], rtol=1e-5)
    np.testing.assert_allclose(series.std, track.midpoint_std[later], rtol=1e-5)
    (series,) = read_measurements(track.save(tmp_path / "shapes.csv", points=7)).series
    assert series.shapes is not None and series.shapes.x.size == 7 * later.sum()
    assert series.shapes.std is not None


def test_the_release_is_found_to_half_a_frame_or_taken_as_given(tmp_path: Path) -> None:
    track, _ = tracked(tmp_path, **SMALL, times=np.arange(20) / 20)
    assert track.release == pytest.approx(0.25, abs=0.05) and track.release_std > 0.024
    assert sc.track(tmp_path / "film.mkv", "span=50 mm", release="4").release == pytest.approx(0.2)
    assert sc.track(tmp_path / "film.mkv", "span=50 mm", release="0.21 s").release == pytest.approx(0.21)
