"""A bad list of effects is one error that names every fault in it."""

from __future__ import annotations

import pytest

from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import Fault, SceneError

from .scenes import scene_of


def faults(effects: list[str], law: str = "bingham", ramp: str = "0.1 s") -> tuple[Fault, ...]:
    with pytest.raises(SceneError) as caught:
        choose_effects(scene_of(law, ramp, run={"effects": effects}))
    assert all(fault.path == "run.effects" for fault in caught.value.faults)
    return caught.value.faults


def test_a_misspelt_effect_is_told_its_nearest_name() -> None:
    (fault,) = faults(["inertia", "bendign"])
    assert "'bendign'" in fault.found
    assert "did you mean 'bending'?" in fault.found
    assert "large-rotation" in fault.accepted


def test_an_unknown_effect_is_told_all_names() -> None:
    (fault,) = faults(["quux"])
    assert "'quux'" in fault.found
    assert "did you mean" not in fault.found
    assert "viscous-flow" in fault.accepted


@pytest.mark.parametrize("times", [2, 3])
def test_a_repeated_effect_is_named_once(times: int) -> None:
    (fault,) = faults(["inertia"] + ["bending"] * times)
    assert "bending" in fault.found


def test_yielding_needs_viscous_flow() -> None:
    (fault,) = faults(["inertia", "yielding"])
    assert fault.found == "'yielding' without 'viscous-flow'"
    assert "add 'viscous-flow'" in fault.accepted


def test_a_maxwell_fluid_cannot_yield() -> None:
    (fault,) = faults(["viscous-flow", "yielding"], "maxwell")
    assert "'yielding' cannot be had: the law has no yield stress" in fault.found


def test_an_elastic_filament_cannot_flow() -> None:
    (fault,) = faults(["viscous-flow"], "elastic")
    assert "'viscous-flow' cannot be had" in fault.found
    assert "elastic" in fault.found


def test_a_ramp_needs_a_ramp() -> None:
    (fault,) = faults(["gravity-ramp"], ramp="0 s")
    assert "'gravity-ramp' cannot be had: load.ramp is zero" in fault.found


def test_all_faults_stand_in_one_error() -> None:
    asked = ["inertia", "bendign", "yielding", "gravity-ramp"]
    found = " | ".join(str(fault) for fault in faults(asked, "maxwell", "0 s"))
    for part in ("'bendign'", "'yielding' cannot", "'gravity-ramp' cannot"):
        assert part in found
    assert len(faults(asked, "maxwell", "0 s")) == 3
