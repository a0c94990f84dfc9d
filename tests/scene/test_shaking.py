"""load.shake and load.shake_frequency: a pair, in cycles a second; a scene without them is written without them."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from softcat_sym.errors import SceneError
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

PAIR = {"load.shake": 0.5, "load.shake_frequency": "9 Hz"}


def shaken(changes: dict[str, Any], name: str = "gelatin-strand") -> Scene:
    return load_scene(name, changes)


@pytest.mark.parametrize("missing", PAIR)
def test_one_without_the_other_is_one_fault(missing: str) -> None:
    (given,) = set(PAIR) - {missing}
    with pytest.raises(SceneError) as caught:
        shaken({given: PAIR[given]})
    (fault,) = caught.value.faults
    assert fault.path == missing
    assert given in fault.found
    assert given in fault.accepted


def test_a_wrong_value_is_named() -> None:
    for changes, says in [
        ({"load.shake": -0.5}, "out of range"),
        ({"load.shake": "50 %"}, "is not a number"),
        ({"load.shake_frequency": "-9 Hz"}, "is negative"),
        ({"load.shake_frequency": 9}, "has no unit"),
        ({"load.shake_frequency": "9 s"}, "'s' is a time, not a frequency"),
        ({"load.shake_frequency": "9 rad/s"}, "'rad/s' measures an angle, not cycles"),
        ({"load.shake_frequency": "540 rpm"}, "'rpm' measures an angle, not cycles"),
    ]:
        with pytest.raises(SceneError) as caught:
            shaken(PAIR | changes)
        (fault,) = caught.value.faults
        assert fault.path == next(iter(changes))
        assert says in fault.found


def test_a_frequency_counts_cycles() -> None:
    for text in ["9 Hz", "0.009 kHz", "9 1/s", "540 1/min"]:
        assert shaken(PAIR | {"load.shake_frequency": text}).load.shake_frequency == pytest.approx(9, rel=1e-15)


def test_a_shaken_scene_reads_back_as_it_was() -> None:
    scene = shaken(PAIR)
    text = scene.to_toml()
    assert "shake = 0.5\n" in text
    assert 'shake_frequency = "9.0 Hz"\n' in text
    assert Scene.model_validate(tomllib.loads(text)) == scene
    assert scene != shaken({})


def test_a_steady_scene_is_written_as_ever() -> None:
    for name in [name for name in bundled_names() if name != "shaken-strand"]:
        assert "shake" not in load_scene(name).to_toml()
