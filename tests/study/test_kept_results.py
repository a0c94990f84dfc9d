"""Results that outlive an interruption: found again to the last bit, and no file more than is needed."""

from __future__ import annotations

import errno
import signal
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.ensemble.block_store import KeptBlocks, KeptResults
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.results.files import trajectory_form
from softcat_sym.solvers.checkpoint import Form, json_form, kept, kept_by, packed, unpacked

PLAIN: Form[Any] = json_form(lambda value: value, lambda value: value)


def results(folder: Path, every: float = 0.0) -> KeptResults:
    return KeptResults(KeptBlocks(folder, "mine", {}, resume=True), every)


def of(key: str, compute: Callable[[], Any]) -> Any:
    return kept(lambda: (key,), compute, PLAIN)


def never() -> Any:
    raise AssertionError("it was computed again")


def parts(folder: Path) -> list[str]:
    return sorted(path.name for path in (folder / "parts").glob("part-*"))


@pytest.mark.parametrize("every", [0.0, 1e3])
def test_what_was_kept_is_not_computed_again(tmp_path: Path, every: float) -> None:
    first = results(tmp_path, every)
    with kept_by(first):
        assert of("a", lambda: [1.5, float("inf"), "text"]) == [1.5, float("inf"), "text"]
        assert of("b", lambda: 2) == 2
        assert of("a", never)[0] == 1.5
    first.flush()
    assert len(parts(tmp_path)) == (2 if every == 0 else 1)
    again = results(tmp_path)
    with kept_by(again):
        assert (of("a", never), of("b", never)) == ([1.5, float("inf"), "text"], 2)
        assert of("c", lambda: 3) == 3
    assert again.found == 2
    again.clear()
    assert not (tmp_path / "parts").exists()
    # Outside nothing is kept.
    assert [of("a", lambda: 4), of("a", lambda: 5)] == [4, 5]


def test_parts_of_a_finished_result_are_dropped(tmp_path: Path) -> None:
    found = results(tmp_path)
    with kept_by(found):
        of("before", lambda: 0)
        assert of("all", lambda: of("one", lambda: 1) + of("two", lambda: 2)) == 3
        assert parts(tmp_path) == ["part-000000.bin", "part-000003.bin"]
        with suppress(KeyboardInterrupt):
            of("cut", lambda: of("three", lambda: 3) + of("four", lambda: signal.raise_signal(signal.SIGINT)))
    again = results(tmp_path)
    with kept_by(again):
        assert [of(name, never) for name in ("before", "all", "three")] == [0, 3, 3]
        assert of("cut", lambda: of("three", never) + of("four", lambda: 4)) == 7


def test_what_an_interruption_has_spoilt_is_not_kept(tmp_path: Path) -> None:
    def swallowed() -> int:
        with suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        return 13

    found = results(tmp_path)
    with kept_by(found), pytest.raises(KeyboardInterrupt):
        of("spoilt", swallowed)
    with kept_by(found):
        assert of("spoilt", lambda: 1) == 1


def test_a_harmed_file_is_computed_again(tmp_path: Path) -> None:
    with kept_by(results(tmp_path)):
        of("a", lambda: 1)
        of("b", lambda: 2)
    path = tmp_path / "parts" / "part-000000.bin"
    path.write_bytes(path.read_bytes()[:-1] + b"?")
    with kept_by(results(tmp_path)):
        assert (of("a", lambda: 10), of("b", never)) == (10, 2)


def test_a_full_disk_ends_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(KeptBlocks, "keep", full)
    found = results(tmp_path)
    with kept_by(found):
        assert (of("a", lambda: 1), of("b", lambda: 2)) == (1, 2)
    assert "No space left" in found.trouble


def test_a_run_is_read_back_to_the_last_bit() -> None:
    scene = sc.load_scene("cold-honey", ["numerics.cells=4", "run.frames=4", "run.duration=0.02 s"])
    run, form = sc.simulate(scene), trajectory_form(scene)
    again = form.read(form.write(run))
    xr.testing.assert_identical(run.data, again.data)
    assert (again.summary, again.outcome, again.missing_effect) == (run.summary, run.outcome, run.missing_effect)


def test_a_model_goes_on_from_where_its_last_evaluation_began(tmp_path: Path) -> None:
    """A slack filament starts in a shape that is followed from the one before."""
    settings = [
        "filament.rest_length=0.22 m",
        "load.ramp=0 s",
        "numerics.cells=6",
        "run.effects=paper",
        "numerics.backend=interpreted",
    ]
    scene = sc.load_scene("continual-descent", settings)
    free, times = free_parameters(scene, ["viscosity", "rest_length"]), np.linspace(0.0, 0.05, 4)
    points = [np.array([0.01 * k, 0.02 * k]) for k in range(3)]
    with kept_by(results(tmp_path)):
        model = ForwardModel(scene, free, times)
        for q in points[:2]:
            model.with_derivatives(q)
    with kept_by(results(tmp_path)):
        resumed = ForwardModel(scene, free, times)
        for q in points[:2]:
            resumed.with_derivatives(q)
    # Outside nothing is kept: both evaluate.
    for own, found in zip(model.with_derivatives(points[2]), resumed.with_derivatives(points[2]), strict=True):
        assert np.array_equal(own, found)


def test_arrays_are_read_back_as_they_were() -> None:
    arrays = {"numbers": np.array([1.0, np.nan, -0.0]), "text": np.array("µ")}
    found = unpacked(packed(arrays))
    assert found["numbers"].tobytes() == arrays["numbers"].tobytes() and str(found["text"]) == "µ"
