"""The first natural frequency of a strand as it is held, and the viscosity that a loss tangent means at it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym.effects.free_vibration import (
    damping_note,
    first_vibration,
    solid_decay,
    solid_retardation,
    solid_viscosity,
)
from softcat_sym.scene.scene import Scene

# Roots of the frequency equations (Rayleigh 1877, sections 172 to 177).
BETA = {
    ("clamped", "clamped"): 4.730040744862704,
    ("clamped", "pinned"): 3.926602312047919,
    ("pinned", "pinned"): math.pi,
    ("clamped", "free"): 1.875104068711961,
    ("free", "clamped"): 1.875104068711961,
}


def strand(diameter: str = "1 mm", modulus: str = "45 GPa", **changes: object) -> Scene:
    table = {
        "filament": {"span": "20 mm", "diameter": diameter, "density": "1050 kg/m^3"},
        "material": {"law": "elastic", "youngs_modulus": modulus, "loss_tangent": 0.1},
        "run": {"duration": "1 s"},
    }
    return Scene.model_validate(table).replace({key.replace("__", "."): value for key, value in changes.items()})


def frequency(scene: Scene) -> float:
    found = first_vibration(scene)
    assert found is not None
    return found.frequency


def test_a_beam_has_the_frequency_of_its_ends() -> None:
    for ends, beta in BETA.items():
        scene = strand(ends__left=ends[0], ends__right=ends[1])
        wanted = beta**2 / 0.02**2 * math.sqrt(45e9 * (1e-3) ** 2 / 16 / 1050)
        assert frequency(scene) == pytest.approx(wanted, rel=2e-6)
        assert first_vibration(scene).material_share == pytest.approx(1.0, abs=1e-6)  # type: ignore[union-attr]


def test_a_taut_string_sings_by_its_tension_which_loses_nothing() -> None:
    scene = strand(
        "0.05 mm", "45 kPa", ends__left="pinned", ends__right="pinned", filament__rest_length="10 mm",
        load__gravity="0 m/s^2",
    )  # fmt: skip
    # Drawn to twice its length it is half as thick, and as heavy along its rest length.
    wanted = math.pi / 0.02 * math.sqrt(45e3 * math.log(2) / 2 / (1050 / 2))
    assert frequency(scene) == pytest.approx(wanted, rel=1e-4)
    assert first_vibration(scene).material_share < 1e-3  # type: ignore[union-attr]


def test_a_string_that_hangs_in_its_weight_has_irvine_s_frequency() -> None:
    """lambda^2 = 24 of a string that its own weight has stretched: tan u = u - u^3/6, omega^2 = 4 u^2 N/(m L^2)."""
    scene = strand("0.02 mm", "45 kPa", ends__left="pinned", ends__right="pinned")
    u = 2.67
    for _ in range(50):
        u -= (math.tan(u) - u + u**3 / 6) / (1 / math.cos(u) ** 2 - 1 + u**2 / 2)
    sag = (3 * 1050 * 9.81 * 0.02**4 / (64 * 45e3)) ** (1 / 3)
    assert frequency(scene) ** 2 == pytest.approx(4 * u**2 / 8 * 9.81 / sag, rel=2e-3)


def test_a_mass_at_midspan_and_a_profile_count() -> None:
    beam = 192 * 45e9 * math.pi * 1e-12 / 64 / 0.02**3
    heavy = frequency(strand(load__point_mass="1 kg", load__gravity="0 m/s^2"))
    assert heavy == pytest.approx(math.sqrt(beam), rel=1e-3)
    thin = frequency(strand(filament__profile=[0.5, 0.5]))
    assert thin == pytest.approx(frequency(strand()) / 2, rel=1e-6)


def test_a_loss_tangent_is_the_viscosity_of_the_first_mode() -> None:
    scene = strand()
    assert solid_viscosity(scene) == pytest.approx(0.1 * 45e9 / frequency(scene))
    assert solid_decay(scene) == pytest.approx(0.05 * frequency(scene), rel=1e-6)
    given = scene.replace({"material.solid_viscosity": "2 Pa*s"})
    assert solid_viscosity(given) == 2
    assert "loss tangent" in damping_note(given)
    assert solid_viscosity(scene.replace({"material.loss_tangent": 0.0})) == 0
    assert damping_note(scene.replace({"material.loss_tangent": 0.0})) == ""


def test_of_a_sheet_it_is_the_loss_tangent_of_its_fibres() -> None:
    """4/3 eta over E/(1 - nu^2) there (THEORY 3), and the same ratio to lose."""
    scene = Scene.model_validate(
        {
            "filament": {"span": "20 mm", "thickness": "1 mm", "section": "sheet", "density": "1050 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "45 GPa", "loss_tangent": 0.1},
            "run": {"duration": "1 s"},
        }
    )
    ratio = 4 / 3 * solid_viscosity(scene) / (45e9 / (1 - 0.45**2))
    assert ratio * frequency(scene) == pytest.approx(0.1)
    assert solid_retardation(scene) == pytest.approx(ratio)


@pytest.mark.parametrize("law", ["newtonian", "elastic"])
def test_where_nothing_springs_back_there_is_none(law: str) -> None:
    if law == "newtonian":
        material = {"law": law, "viscosity": "1 Pa*s"}
        scene = Scene.model_validate({**strand().given(), "material": material})
    else:
        scene = strand(material__loss_tangent=0.0, ends__left="pinned", ends__right="free")
    assert first_vibration(scene) is None


def test_bent_and_pulled_it_is_between_beam_and_string() -> None:
    both = [frequency(strand("1 mm", "45 kPa", load__gravity="0 m/s^2", filament__rest_length=f"{length} mm"))
            for length in (20, 19.9, 19, 15)]  # fmt: skip
    assert np.all(np.diff(both) > 0)
