"""The regime and the natural frequency that a scene should show, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.expected_regime import ExpectedRegime, expected_regime
from softcat_sym.effects.forecast import damping, overshoot
from softcat_sym.effects.free_vibration import (
    damping_note,
    first_vibration,
    solid_decay,
    solid_retardation,
    solid_viscosity,
)
from softcat_sym.effects.theory_limits import theory_limits
from softcat_sym.scene.scene import Scene

# The regime and the warnings foretold: numbers against independent roots, names against what runs have shown.
PAPER = "arrested-overdamped"
PUBLISHED = ("inertia", "bending", "viscous-flow", "yielding", "gravity-ramp")


def of(name: str, *changes: str) -> ExpectedRegime:
    scene = sc.load_scene(name, list(changes))
    return expected_regime(scene, choose_effects(scene).names)


def grouped(G: float, V: float) -> tuple[str, str]:
    return f"groups.G={G}", f"groups.V={V}"


def test_depths_end_where_no_catenary_is_held() -> None:
    for G, paper, exact in [(1.32, True, True), (1.33, True, False), (1.41, True, False), (1.42, False, False)]:
        found = expected_regime(sc.load_scene(PAPER, [f"groups.G={G}"]), PUBLISHED)
        assert (found.stopping_depth_paper is not None, found.stopping_depth_exact is not None) == (paper, exact)
        assert found.name == "descending"  # below the threshold by its hinges, beyond it for ever


# What runs have shown: the bundled scenes at their own accuracy, the others on 16 cells a half span.
BUNDLED = {
    "arrested-overdamped": "arrested-overdamped", "arrested-underdamped": "arrested-underdamped",
    "continual-descent": "descending", "no-yield": "no-yield",
    "ink-bridge": "arrested-overdamped", "toothpaste": "arrested-underdamped", "maxwell-slow": "viscous",
    "cold-honey": "viscous", "bread-dough": "viscous", "transient-gel": "viscous", "rubber-strand": "elastic",
    "cooked-spaghetti": "elastic", "stretched-rubber-band": "elastic",
}  # fmt: skip
SHOWN = {
    (0.03, 26): "no-yield", (0.04, 26): "arrested-underdamped", (0.08, 26): "arrested-underdamped",
    (0.08, 1): "arrested-underdamped", (0.15, 26): "arrested-underdamped", (0.15, 3): "arrested-underdamped",
    (0.25, 26): "arrested-underdamped", (0.25, 10): "arrested-underdamped", (0.25, 3): "arrested-underdamped",
    (0.3, 0.4): "arrested-underdamped", (0.4, 10): "arrested-overdamped", (0.4, 3): "arrested-overdamped",
    (0.8, 26): "descending", (1.2, 26): "descending", (1.37, 26): "descending", (1.5, 26): "descending",
}  # fmt: skip


def test_bundled_scenes_are_foretold() -> None:
    for name in list(BUNDLED):
        assert of(name, "run.effects=paper").name == BUNDLED[name]


def test_the_paper_s_filament_is_foretold() -> None:
    for G, V in list(SHOWN):
        scene = sc.load_scene(PAPER, list(grouped(G, V)))
        assert expected_regime(scene, PUBLISHED).name == SHOWN[G, V]


@pytest.mark.parametrize("D", [0.0, 0.005, 0.05, 0.4, 0.85, 1.45, 2.2, 3.5, 6.0])
def test_overshoot_is_where_the_falling_parabola_stops(D: float) -> None:
    G = 0.4
    V = D / damping(G, 1.0)

    def still(time: float, state: np.ndarray) -> float:
        return state[1] if time > 1e-3 else 1.0

    still.terminal, still.direction = True, -1  # type: ignore[attr-defined]
    # In sags over span and sqrt(L/g), as the balance of the parabola is first written.
    fall = solve_ivp(
        lambda _, s: [s[1], 5 / 4 - 10 * s[0] * (1 / G + 16 / 3 * V * s[0] * s[1])],
        (0, 60),
        [0.0, 0.0],
        events=still,
        rtol=1e-8,
        atol=1e-12,
        method="LSODA",
    )
    assert overshoot(G, V, 0.0) == pytest.approx(fall.y[0].max() / (G / 8), abs=0.01)


def test_a_slow_ramp_leaves_nothing_to_ring() -> None:
    assert overshoot(0.25, 0.4, 100.0) == pytest.approx(1, abs=1e-3)
    slow = expected_regime(sc.load_scene("arrested-underdamped", ["groups.ramp=400"]), PUBLISHED)
    assert slow.name == "arrested-overdamped"
    # With nothing that rings the threshold is the static one; at once, or nearly so, it is half of it.
    sudden = expected_regime(sc.load_scene(PAPER, ["groups.ramp=0"]), PUBLISHED)
    assert slow.first_yield is not None
    assert sudden.first_yield == pytest.approx(0.03)
    assert slow.first_yield == pytest.approx(0.06, rel=0.2)


def test_without_inertia_it_neither_overshoots_nor_rebounds() -> None:
    scene = sc.load_scene("arrested-underdamped")
    found = expected_regime(scene, [name for name in PUBLISHED if name != "inertia"])
    assert (found.overshoot, found.rebound, found.name) == (1.0, 0.0, "arrested-overdamped")


def test_a_cantilever_of_a_paste_stops_where_it_can_hang() -> None:
    free = ['ends.right="free"', "run.effects=paper"]
    assert of("toothpaste", *free, "filament.thickness=1 mm").stopping_depth_exact is None
    held = expected_regime(sc.load_scene(PAPER, [*grouped(0.9, 0.4), 'ends.right="free"']), PUBLISHED)
    lost = expected_regime(sc.load_scene(PAPER, [*grouped(1.1, 0.4), 'ends.right="free"']), PUBLISHED)
    assert held.name != "no-yield"
    assert "hangs" in held.reason
    assert (lost.name, lost.arrest_exact) == ("descending", 1.0)


def warned(name: str, *changes: str) -> str:
    scene = sc.load_scene(name, list(changes))
    return " | ".join(theory_limits(scene, expected_regime(scene, choose_effects(scene).names)))


def test_rupture_is_foretold_where_runs_have_shown_it() -> None:
    for G, V, ruptures in [
        (0.25, 0.4, False),
        (0.4, 0.4, True),
        (0.4, 1, False),
        (0.4, 26, False),
        (1.2, 2, True),
        (0.8, 3, True),
        (0.8, 26, False),
    ]:
        scene = sc.load_scene(PAPER, list(grouped(G, V)))
        told = " ".join(theory_limits(scene, expected_regime(scene, PUBLISHED)))
        assert ("near rupture" in told) == ruptures


def test_warnings_of_bundled_scenes() -> None:
    assert "near rupture" in warned("edge-of-rupture")
    assert "never stops" in warned("continual-descent")
    assert warned("ink-bridge") == ""
    assert "too thick" in warned("toothpaste")
    for sound in ("arrested-overdamped", "arrested-underdamped", "no-yield", "maxwell-slow", "cold-honey", "glass-rod"):
        assert warned(sound) == ""


def test_surface_tension_left_out_by_name_is_told_with_its_worth() -> None:
    assert "surface tension is left out by run.effects, but would take about" in warned(
        "ink-bridge", "run.effects=paper"
    )
    assert "by run.closure = 'printed'" in warned("ink-bridge", "run.closure=printed")
    assert warned("ink-bridge", "run.effects=paper", "surroundings.surface_tension=0.1 mN/m") == ""


def test_surface_tension_adds_to_the_yield_stress_where_tension_holds() -> None:
    """G = rho g L/(sigma_Y + gamma/R) of a circle, and no number of bending feels it."""
    pulled, bare = of("ink-bridge"), of("ink-bridge", "surroundings.surface_tension=0 N/m")
    number, limit, added = bare.gravity_number, 3**0.5 * 200, 0.072 / 0.2e-3
    assert number is not None
    assert bare.collapse is not None
    assert pulled.gravity_number == pytest.approx(number * limit / (limit + added))
    assert pulled.collapse == pytest.approx(bare.collapse * limit / (limit + added))
    assert pulled.stopping_depth_paper == pytest.approx(pulled.gravity_number / 8, rel=0.01)
    assert "gamma" in pulled.reason


def test_a_free_end_that_its_surface_makes_yield_is_told() -> None:
    free = ("run.effects=auto", 'ends.right="free"', "load.gravity=0.01 m/s^2")
    assert "its surface alone makes it yield" in of("ink-bridge", *free).reason
    assert of("ink-bridge", *free, "material.shear_yield_stress=1 kPa").name == "no-yield"


# The first natural frequency of a strand as it is held, and the viscosity that a loss tangent means at it.
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
