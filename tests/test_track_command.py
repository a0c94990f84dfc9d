"""``softcat track`` and films given to ``softcat fit``: files, exit statuses, and one clear line for bad input."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import av
import numpy as np
import pandas as pd
import pytest
from PIL import Image

import softcat_sym as sc
from softcat_sym.fitting.collapse_test import read_contour
from softcat_sym.fitting.measurements import read_measurements
from tests.common.in_process import Softcat
from tests.common.rendered_films import Picture, write_film
from tests.test_tracking import SMALL

PICTURE = replace(Picture(), **SMALL, times=np.arange(10) / 9)
SAMPLE = Path(sc.__file__).parent / "samples" / "film.mov"


@pytest.fixture(scope="module")
def film(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_film(tmp_path_factory.mktemp("films") / "good.mkv", PICTURE.frames(), PICTURE.times)


def test_files_of_a_tracked_film(film: Path, softcat: Softcat, tmp_path: Path) -> None:
    frames = list(PICTURE.frames())
    frames[6] = frames[5]
    path = write_film(tmp_path / "repeated.mkv", frames, PICTURE.times)
    done = softcat("track", str(path), "--scale", "span=50 mm", "-o", str(tmp_path / "out" / "ink.csv"), "--overlay")
    assert done.status == 0 and "9 read, 1 refused" in done.out
    folder = tmp_path / "out"
    pictures = {f"overlay-{name}.png" for name in ("first", "middle", "last", "worst")}
    assert {one.name for one in folder.iterdir()} == {
        "ink.csv",
        "refused.csv",
        "track.json",
        "track.png",
        "overlay.mp4",
        *pictures,
    }
    table = pd.read_csv(folder / "ink.csv", comment="#")
    assert [*table] == ["time_s", "midpoint_mm", "midpoint_std_mm", "thickness_mm", "thickness_std_mm", "frame_number"]
    assert table.frame_number.tolist() == [0, 1, 2, 3, 4, 5, 7, 8, 9]
    refused = pd.read_csv(folder / "refused.csv")
    assert refused.frame_number.tolist() == [6] and "repeats" in refused.reason[0]
    facts = json.loads((folder / "track.json").read_text())
    assert facts["is_trusted"] and facts["span_m"] == pytest.approx(0.05) and len(facts["midpoint_m"]) == 9
    with av.open(str(folder / "overlay.mp4")) as container:
        assert sum(1 for _ in container.decode(video=0)) == 10


def test_a_fit_tracks_films_and_wants_their_scale(softcat: Softcat, tmp_path: Path) -> None:
    scene = str(SAMPLE.with_name("my-ink.toml"))
    given = ["--film-scale", "span=10 mm"]
    done = softcat("fit", str(SAMPLE), "--scene", "cold-honey", "--features-only", *given, "-o", str(tmp_path))
    assert done.status == 0
    (film,) = read_measurements(tmp_path / "film.csv").series
    assert film.midpoint.min() == pytest.approx(-0.5e-3, rel=0.01)
    assert softcat("fit", str(SAMPLE), "--scene", scene, "--free", "viscosity", "-o", str(tmp_path)).status == 2
    done = softcat("fit", str(SAMPLE.with_suffix(".csv")), "--scene", scene, "--free", "viscosity", *given)
    assert done.status == 2 and "no film among DATA" in done.err


def strandless() -> list[np.ndarray]:
    noise = np.random.default_rng(0)
    return [(200 + noise.integers(0, 3, (120, 160))).astype(np.uint8) for _ in range(8)]


def empty(path: Path) -> Path:
    path.write_bytes(b"")
    return path


def written(frames: Callable[[], list[np.ndarray]]) -> Callable[[Path], Path]:
    def write(path: Path) -> Path:
        made = frames()
        return write_film(path, made, np.arange(len(made)) / 6)

    return write


PICTURES = list(PICTURE.frames())
BAD: dict[str, tuple[Callable[[Path], Path], str]] = {
    "empty": (empty, "cannot be read"),
    "absent": (lambda path: path, "no such film"),
    "one frame": (written(lambda: PICTURES[:1]), "one frame"),
    "three frames": (written(lambda: PICTURES[:3]), "3 of 3 frames read"),
    "no strand": (written(strandless), "no strand stands out"),
    "two strands": (written(lambda: list(replace(PICTURE, second=24.0).frames())), "two strands"),
    "rotated": (written(lambda: [np.rot90(one).copy() for one in PICTURES]), "--vertical"),
    "black": (written(lambda: [0 * one for one in PICTURES]), "no strand"),
    "tiny": (written(lambda: [one[:16, :16].copy() for one in PICTURES]), "at least 48"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_film_that_cannot_be_tracked_is_refused_in_one_line(name: str, softcat: Softcat, tmp_path: Path) -> None:
    write, message = BAD[name]
    done = softcat(
        "track", str(write(tmp_path / "film.mkv")), "--scale", "span=50 mm", "-o", str(tmp_path / "out"), "-q"
    )
    assert done.status == 2 and message in done.err and done.err.count("\n") == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ((), "Missing option '--scale'"),
        (("--scale", "50 mm"), "span=LENGTH"),
        (("--scale", "span=50"), "no unit"),
        (("--scale", "span=-5 mm"), "not positive"),
        (("--scale", "needle@500,600,1,5=1 mm"), "outside of the picture"),
        (("--scale", "needle@1,20,1,20=1 mm"), "no bar across the region"),
        (("--scale", "span=5 mm", "--supports", "-5,500"), "two columns"),
        (("--scale", "span=5 mm", "--supports", "5"), "35,285"),
        (("--scale", "span=5 mm", "--roi", "0,1000,0,50"), "outside of the picture"),
        (("--scale", "span=5 mm", "--roi", "40,120,0,120"), "--supports x0,x1"),
        (("--scale", "span=5 mm", "--light"), "no strand"),
        (("--scale", "span=5 mm", "--release", "soon"), "the number of a frame"),
        (("--scale", "span=5 mm", "--release", "77"), "not within the film"),
        (("--scale", "span=5 mm", "--fps", "0"), "fps = 0"),
    ],
)
def test_a_bad_option_is_refused(
    options: tuple[str, ...], message: str, film: Path, softcat: Softcat, tmp_path: Path
) -> None:
    done = softcat("track", str(film), *options, "-o", str(tmp_path / "out"), "-q")
    assert done.status == 2 and message in done.err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("codec", [("png", "rgb24", {}), ("png", "gray16be", {})], ids=["colour", "16 bit"])
def test_colour_is_read_by_its_brightness_and_sixteen_bits_in_full(
    codec: tuple[str, str, dict[str, str]], tmp_path: Path, film: Path
) -> None:
    path = write_film(tmp_path / "film.mov", PICTURES, PICTURE.times, codec)
    expected = sc.track(film, "span=50 mm").midpoint
    np.testing.assert_allclose(sc.track(path, "span=50 mm").midpoint, expected, atol=2e-6)


def test_the_contour_of_a_strand_over_pillars_is_what_a_collapse_test_reads(softcat: Softcat, tmp_path: Path) -> None:
    gaps, sags, pillars = (
        ((-125.0, -40.0), (-10.0, 60.0), (80.0, 125.0)),
        (12.0, 8.0, 3.0),
        ((-40.0, -10.0), (60.0, 80.0)),
    )

    def depth(time: float, x: np.ndarray) -> np.ndarray:
        places = [np.clip((2 * x - left - right) / (right - left), -1, 1) for left, right in gaps]
        return sum(sag * (1 - place**2) ** 2 for sag, place in zip(sags, places, strict=True))

    picture = replace(Picture(), depth=depth, supports="pillars", inner=pillars, thickness=9.0, times=np.zeros(1))
    Image.fromarray(next(picture.frames())).save(tmp_path / "photo.png")
    how = ["--contour", "--scale", "pixel=0.1 mm", "-o", str(tmp_path / "out")]
    assert softcat("track", str(tmp_path / "photo.png"), *how).status == 0
    assert {one.name for one in (tmp_path / "out").iterdir()} == {"contour.csv", "overlay-contour.png"}
    found = read_contour(tmp_path / "out" / "contour.csv")
    edges = np.array(found.gaps) / 1e-4 - picture.centre
    np.testing.assert_allclose(edges, gaps, atol=0.1)
    x, y = found.x / 1e-4 - picture.centre, picture.level + found.y / 1e-4
    assert np.sqrt(np.mean((y + depth(0.0, x)) ** 2)) < 0.1
    assert np.max(np.abs(y + depth(0.0, x))) < 0.5
    done = softcat(
        "track", str(tmp_path / "photo.png"), "--contour", "--scale", "span=10 mm", "-o", str(tmp_path / "no")
    )
    assert done.status == 2 and "3 gaps" in done.err
