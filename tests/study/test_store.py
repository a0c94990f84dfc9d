"""The store of finished runs: what decides a key, and what is there and what is not."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym import store
from softcat_sym.results.files import trajectory_form
from softcat_sym.simulate import identity_of, recalled


def test_a_run_is_recalled_to_the_last_bit_under_any_title(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = sc.load_scene("cold-honey", ["numerics.cells=4", "run.frames=4", "run.duration=0.02 s"])
    first = recalled(scene)
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "_with_all_that_matters", None)
    again = recalled(scene.replace({"title": "another"}))
    assert again.summary == first.summary | {"title": "another"}
    assert (again.data.attrs["title"], again.scene.title) == ("another", "another")
    assert again.data.identical(first.data.assign_attrs(again.data.attrs))
    assert trajectory_form(scene).write(first) == trajectory_form(scene).write(recalled(scene))
    with store.fresh(), pytest.raises(TypeError):
        recalled(scene)


def test_what_decides_a_run_decides_its_key() -> None:
    scene = sc.load_scene("cold-honey")
    keys = {store.key_of("run", identity_of(scene.replace(one))) for one in ({}, {"run.frames": 7}, {"title": "x"})}
    assert len(keys) == 2
    parts: tuple[object, ...] = (1, 1.5, "1", [1], b"1", np.ones(1), np.ones(1, int), np.ones((1, 1)), None)
    assert len({store.key_of("run", part) for part in parts}) == len(parts)
    assert store.key_of("run", 1) != store.key_of("sag", 1)
    with pytest.raises(TypeError, match="no part of a key: object"):
        store.key_of("run", object())


def test_what_is_harmed_or_in_another_place_is_not_there(results_of_studies: Path) -> None:
    key, other = store.key_of("one"), store.key_of("other")
    assert store.recall(key) is None
    store.keep(key, b"content" * 100)
    assert store.recall(key) == b"content" * 100
    path = results_of_studies / key
    path.rename(results_of_studies / other)
    assert store.recall(other) is None
    store.keep(key, b"content")
    for content in (b"", path.read_bytes()[:-1], bytes(100)):
        path.write_bytes(content)
        assert store.recall(key) is None
    assert store.clear() > 0 and store.entries() == []


def test_the_limit_is_kept(results_of_studies: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store, "LIMIT", 100)
    for number in range(5):
        store.keep(f"ff{number}", b"content")
        os.utime(results_of_studies / f"ff{number}", (number, number))
    store.keep("00", b"content")
    left = {path.name for path, _ in store.entries()}
    assert "00" in left and "ff4" in left and "ff0" not in left


def test_a_full_disk_ends_no_study(results_of_studies: Path) -> None:
    results_of_studies.write_text("no folder")
    store.keep("00", b"content")
    assert store.recall("00") is None
    results_of_studies.unlink()


def test_numbers_that_json_does_not_know_come_back() -> None:
    form = store.json_form(list, list)
    found = form.read(form.write([float("inf"), 0.1, None]))
    assert json.dumps(found) == json.dumps([float("inf"), 0.1, None])
