"""Any bytes, and valid files with slips of the pen, given to the readers: read, or refused by name; never a hang."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, seed, settings
from hypothesis import strategies as st

from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.flow_curve import read_flow_curve
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.scene.bundled import bundled_names, bundled_text
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.common.time_limit import within

SEED = 20261121
LIMIT = 10.0  # s, of one file
FEW, MANY = 100, 3000

FILM = "# filament.span = 80 mm\ntime_s,midpoint_mm,midpoint_std_mm\n" + "".join(
    f"{0.1 * k:.1f},{-3.5 * k**0.5:.4f},0.02\n" for k in range(8)
)
SPREADSHEET = "sep=;\nTime [ms];Sag [mm];T\n" + "".join(f"{100 * k};{3 * k},5;20\n" for k in range(8))
SHAPES = "time_s\tx_mm\ty_mm\n" + "".join(
    f"{t}\t{10 * x}\t{t * (x * x - 16) / 8}\n" for t in (1, 2) for x in range(-4, 5)
)
CURVE = "shear_rate_1_s,shear_stress_Pa\n" + "".join(f"{10**k / 100},{200 + 30 * 10 ** (k / 2)}\n" for k in range(7))

FRAGMENTS = (
    *("nan", "inf", "-", "1e999", "1_0", "0", "1e-400", ",", ";", "\t", "\n", "\r", '"', "'", "#", "=", *"[]{}"),
    *("\0", "\ufeff", "\u2028", "\x85", "\x0b", "\U0001f600"),
    *("9" * 400, "é", "µ", "**", "(", ")", "/", "pi", "deg", "Pa", "m", "s", ".", "..", "\\", "\\u", "a" * 70, "true"),
)
"""What is put in: pieces that mean something to one reader or another."""


@st.composite
def slips(draw: st.DrawFn, text: str) -> bytes:
    """A text with one to four pieces deleted, doubled, put elsewhere, or overwritten; perhaps with one byte garbled."""
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(0, 12) | st.integers(0, 300)))
        piece, how = text[start:end], draw(st.integers(0, 4))
        if how == 0:
            text = text[:start] + text[end:]
        elif how == 1:
            text = text[:end] + piece + text[end:]
        elif how == 2:
            elsewhere = draw(st.integers(0, len(text)))
            text = text[:elsewhere] + piece + text[elsewhere:]
        else:
            put = draw(st.sampled_from(FRAGMENTS) | st.text(max_size=6))
            text = text[:start] + put + (text[end:] if how == 3 else text[start:])
    data = text.encode("utf-8", "surrogatepass")
    if data and draw(st.integers(0, 9)) == 9:
        at = draw(st.integers(0, len(data) - 1))
        data = data[:at] + draw(st.binary(max_size=3)) + data[at + 1 :]
    return data


def is_read_or_refused(read: Callable[[Path], object], file: Path, data: bytes) -> object:
    """Read, and look at the refusal: it names the file and says what would be accepted."""
    file.write_bytes(data)
    try:
        with within(LIMIT):
            return read(file)
    except SoftcatError as error:
        text = str(error)
        assert str(file) in text
        assert len(text) < 20_000
        if isinstance(error, SceneError):
            assert error.faults
            assert all(fault.found for fault in error.faults)
        else:
            assert "accepted: " in text
        return None


def there_and_back(file: Path) -> Scene:
    """What is read is written, and read again as the same."""
    scene = load_scene(file)
    file.write_text(scene.to_toml(), encoding="utf-8")
    assert load_scene(file) == scene
    return scene


READERS: dict[str, tuple[Callable[[Path], object], st.SearchStrategy[bytes]]] = {
    "scene": (there_and_back, st.sampled_from(bundled_names()).flatmap(lambda name: slips(bundled_text(name)))),
    "film": (read_measurements, st.sampled_from((FILM, SPREADSHEET, SHAPES)).flatmap(slips)),
    "flow curve": (read_flow_curve, slips(CURVE)),
}


def look(read: Callable[[Path], object], files: st.SearchStrategy[bytes], number: int, file: Path) -> tuple[int, int]:
    """Give a reader so many files; how many were read, of how many."""
    answers = []

    @seed(SEED)
    @settings(max_examples=number, database=None, deadline=None, suppress_health_check=list(HealthCheck))
    @given(files)
    def one(data: bytes) -> None:
        answers.append(is_read_or_refused(read, file, data) is not None)

    one()
    return sum(answers), len(answers)


@pytest.mark.parametrize("number", [FEW, pytest.param(MANY, marks=pytest.mark.slow)])
def test_slips_of_the_pen_are_read_or_refused(number: int, tmp_path: Path) -> None:
    for name, (read, files) in READERS.items():
        done, tried = look(read, files, number, tmp_path / "file")
        print(f"{name}: {done} of {tried} files with slips are still read")
        assert 0 < done < tried, name


def test_bytes_are_refused(tmp_path: Path) -> None:
    pieces = st.sampled_from([piece.encode() for piece in FRAGMENTS]) | st.binary(max_size=8)
    for name, (read, _) in READERS.items():
        done, tried = look(read, st.lists(pieces, max_size=30).map(b"".join), FEW, tmp_path / "file")
        assert done == 0 and tried >= FEW, name


def test_files_are_valid_without_slips(tmp_path: Path) -> None:
    file = tmp_path / "file.csv"
    for text in (FILM, SPREADSHEET, SHAPES):
        file.write_text(text, encoding="utf-8")
        assert len(read_measurements(file).series) == 1
    file.write_text(CURVE, encoding="utf-8")
    assert read_flow_curve(file).shear_rate.size == 7
    assert is_read_or_refused(read_measurements, file, FILM.replace("time_s", "time_-").encode()) is None
