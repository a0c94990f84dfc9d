"""Filaments with one effect more: shaking, solid damping, surface tension; and without stretch."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson, quad
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym import simulate
from softcat_sym.estimates.free_vibration import first_vibration, solid_decay
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import without_estimate
from tests.common.closed_forms import BEAM_CONSTANT, FIRST_EIGENVALUE, GYRATION
from tests.common.filaments import GEOMETRY, Array, extrapolated, paper_scene, run, sag, scene, upward_crossings
from tests.common.truths import beam_shaken
from tests.marks import few

# Gravity that oscillates: modes of a beam, statics of a slow shake, energy over many periods, ratcheting.
GRAVITY, DENSITY = 10.0, 1000.0
THICKNESS, MODULUS = 0.03, 1e12
FLOW = ("viscous-flow", "yielding")
FIRST = 22.373285 * THICKNESS * np.sqrt(MODULUS / (12 * DENSITY)) / (2 * np.pi)
"""First frequency of the linear clamped beam of span 1 m [Hz]."""


def shaken(asked: Scene, a: float, frequency: float) -> Scene:
    """The scene under g (1 + a sin(2 pi f t)), on its own grid alone."""
    effects = asked.run.effects
    listed = effects if isinstance(effects, str) else [*effects, "gravity-shaking"]
    made = {"load.shake": a, "load.shake_frequency": f"{float(frequency)!r} Hz", "run.effects": listed}
    return without_estimate(asked.replace(made))


def beam(periods: float, frames: int, **more: object) -> Scene:
    names = ("inertia", "bending", *(("gravity-ramp",) if "ramp" in more else ()))
    return scene(
        thickness=THICKNESS, E=MODULUS, effects=names, duration=periods / FIRST, frames=frames, **{"cells": 40} | more
    )  # type: ignore[arg-type]


@pytest.mark.parametrize(("a", "ratio"), few([(0.5, 0.8), (2.0, 3.7)], (0.5, 0.8)))
def test_a_beam_follows_duhamel(a: float, ratio: float) -> None:
    """Near and above the first frequency."""
    coarse, fine = (run(shaken(beam(3, 101, rtol=1e-6, cells=cells), a, ratio * FIRST)).data for cells in (32, 64))
    midpoint = extrapolated(np.asarray(coarse["midpoint"]), np.asarray(fine["midpoint"]))
    unit = np.sqrt(1.0 / GRAVITY)
    stiffness = MODULUS / (DENSITY * GRAVITY)
    truth = beam_shaken(np.asarray(fine["time"]) / unit, stiffness, THICKNESS, a, ratio * FIRST * unit)
    error = float(np.max(np.abs(midpoint - truth)) / np.max(np.abs(truth)))
    assert error < 1e-3


def work_of_gravity(done_time: Array, y: Array, masses: Array, asked: Scene) -> Array:
    """What the change of the weight does to the potential energy, int dg/dt sum m y dt, from stored frames [J]."""
    angular = 2 * np.pi * asked.load.shake_frequency
    rate = GRAVITY * asked.load.shake * angular * np.cos(angular * done_time)
    return np.asarray(cumulative_simpson(rate * (y @ masses), x=done_time, initial=0))


def test_energy_is_kept_while_gravity_is_turned_round_fifty_times() -> None:
    """An elastic cable; the work is integrated from the stored shapes, not by the package."""
    asked = shaken(
        scene(thickness=0.03, E=5e7, effects=("inertia", *GEOMETRY), duration=2.5, frames=2501, cells=12, rtol=1e-8),
        2.0, 20.0,
    )  # fmt: skip
    done = run(asked)
    data = done.data
    lengths = np.diff(data["X_node"])
    masses = DENSITY * THICKNESS**2 * (np.r_[lengths, 0] + np.r_[0, lengths]) / 2
    work = work_of_gravity(np.asarray(data["time"]), np.asarray(data["y"]), masses, asked)
    total = sum(np.asarray(data[f"energy_{kind}"]) for kind in ("kinetic", "elastic", "potential"))
    assert float(np.max(np.abs(total - work))) < 2e-3 * float(np.max(data["energy_elastic"]))
    assert done.summary["energy_residual"] < 1e-6
    assert float(np.max(data["midpoint"])) > 0


@pytest.fixture(scope="module")
def strand() -> Scene:
    """The paper's strand at G = 0.03: below first yield under a steady weight."""
    return paper_scene(
        0.03, 30.0, 900.0, effects=("inertia", *GEOMETRY, *FLOW, "gravity-ramp"), frames=181,
        cells=24, ramp=100.0,
    )  # fmt: skip


def test_a_strand_shaken_beyond_its_yield_ratchets(strand: Scene) -> None:
    """After the ramp, in every one of eight periods."""
    period = strand.run.duration / 10
    done = run(shaken(strand, 2.0, 1 / period))
    assert run(without_estimate(strand)).summary["regime"] == "no-yield"
    assert done.summary["regime"] in ("descending", "shaken")
    lost = np.asarray(done.data["energy_dissipated"])
    assert np.min(np.diff(lost)) > -done.summary["rtol"] * lost[-1]
    by_period = np.diff(lost[20::18])
    assert np.all(by_period > 0.01 * lost[-1])
    means = np.asarray(done.data["midpoint"])[20:164].reshape(-1, 18).mean(axis=1)
    # It sinks by a tenth; from one period to the next its ringing may hide that.
    assert means[-1] < 1.1 * means[0] < 0


# A loss below yield: closed forms of its decay, no trace in what has settled, every law, theory and backend.
KIRCHHOFF = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "solid-damping")
BACKENDS = ("interpreted", "compiled")
LAWS: dict[str, dict[str, Any]] = {
    "elastic": {"youngs_modulus": "90 kPa"},
    "maxwell": {"youngs_modulus": "90 kPa", "viscosity": "90 kPa*s"},
    "bingham": {"youngs_modulus": "90 kPa", "viscosity": "200 Pa*s", "yield_stress": "100 Pa"},
    "herschel-bulkley": {
        "youngs_modulus": "90 kPa", "consistency": "60 Pa*s^0.4", "index": 0.4, "shear_yield_stress": "60 Pa",
    },
    "power-law": {"youngs_modulus": "90 kPa", "consistency": "600 Pa*s^0.4", "index": 0.4},
    "custom": {"youngs_modulus": "90 kPa", "flow": "sigma/s0/t0", "parameters": {"s0": "100 Pa", "t0": "1 s"}},
    "standard-linear": {"youngs_modulus": "60 kPa", "second_modulus": "30 kPa", "viscosity": "30 kPa*s"},
    "multimode-maxwell": {
        "modes": [
            {"youngs_modulus": "50 kPa", "viscosity": "50 kPa*s"}, {"youngs_modulus": "40 kPa", "viscosity": "4 kPa*s"},
        ],
    },
}  # fmt: skip


def strand_solid_damping(law: str = "elastic", **tables: dict[str, Any]) -> Scene:
    table: dict[str, Any] = {
        "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
        "material": {"law": law, "loss_tangent": 0.1, **LAWS[law]},
        "run": {"duration": "0.1 s", "frames": 401, "effects": list(KIRCHHOFF)},
        "numerics": {"estimate": False, "cells": 16},
    }
    for name, values in tables.items():
        table.setdefault(name, {}).update(values)
    return Scene.model_validate(table)


def decay_and_frequency(run: Run, last: float = 0.6) -> tuple[float, float]:
    """Of the first mode: the peak of the spectrum near its frequency, and how much lower it is in a later window."""
    time, height = run.data.time.values, run.data.midpoint.values
    first = int((1 - last) * len(time))
    half = (len(time) - first) // 2
    vibration = first_vibration(run.scene)
    assert vibration is not None
    near = vibration.frequency * np.linspace(0.85, 1.15, 1201)

    def spectrum(begin: int) -> Any:
        part = slice(begin, begin + half)
        swing = (height[part] - np.average(height[part], weights=np.hanning(half))) * np.hanning(half)
        return np.abs(np.exp(-1j * np.outer(near, time[part])) @ swing)

    early, late = spectrum(first), spectrum(first + half)
    peak = int(np.argmax(early))
    return math.log(early[peak] / late[peak]) / (time[half] - time[0]), float(near[peak])


@cache
def ringing(backend: str, tangent: float) -> tuple[Run, float]:
    """A beam so stiff that it hardly sags, let go; and its static sag."""
    scene = strand_solid_damping(
        material={"youngs_modulus": "9 MPa", "loss_tangent": tangent},
        run={"duration": "0.06 s", "frames": 1201, "accuracy": 1e-3},
        numerics={"backend": backend, "cells": 40},
    )
    still = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation")
    rest = simulate(scene.replace({"run.effects": list(still), "run.frames": 2, "numerics.backend": None}))
    return simulate(scene), float(rest.data.midpoint[-1])


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_beam_rings_down_by_half_its_loss_tangent(backend: str) -> None:
    run, _ = ringing(backend, 0.1)
    assert run.outcome.is_success
    decay, frequency = decay_and_frequency(run)
    vibration = first_vibration(run.scene)
    assert vibration is not None
    assert decay / vibration.frequency == pytest.approx(0.1 / 2, rel=0.01)
    assert frequency == pytest.approx(vibration.frequency, rel=0.005)
    assert run.summary["backend"] == backend


def test_a_string_that_hangs_loses_only_what_its_stretching_does() -> None:
    """Tension that is there anyway stores energy and loses none (Irvine 1981): a share of half the loss tangent."""
    scene = strand_solid_damping(
        filament={"diameter": "0.05 mm"},
        material={"youngs_modulus": "9 MPa"},
        ends={"left": "pinned", "right": "pinned"},
        # Let go slowly: the first mode swings little, and the higher ones, which lose less, hardly at all.
        load={"ramp": "40 ms"},
        run={
            "duration": "0.3 s",
            "frames": 1201,
            "effects": [*(n for n in KIRCHHOFF if n != "bending"), "gravity-ramp"],
        },
        numerics={"backend": "compiled", "cells": 24},
    )
    run = simulate(scene)
    assert run.outcome.is_success
    decay, frequency = decay_and_frequency(run)
    vibration = first_vibration(scene)
    assert vibration is not None
    assert 0.6 < vibration.material_share < 0.65
    assert frequency == pytest.approx(vibration.frequency, rel=0.01)
    # Small vibrations of a small sag; this one has a hundredth of the span.
    assert decay == pytest.approx(solid_decay(scene), rel=0.04)
    assert decay < 0.7 * 0.1 / 2 * frequency


def test_what_has_settled_shows_nothing_of_it() -> None:
    run, rest = ringing("compiled", 0.1)
    longer = simulate(run.scene.replace({"run.duration": "0.2 s", "run.frames": 201}))
    assert float(longer.data.midpoint[-1]) == pytest.approx(rest, rel=2e-5)
    lost = float(longer.data.energy_dissipated[-1])
    # Half of the work of a weight put on at once is stored, the other half lost.
    assert lost == pytest.approx(float(longer.data.energy_elastic[-1]), rel=1e-3)


# Surface tension against quadratures, closed forms and energy: nothing here shares a formula with the package.
WEIGHT = 1000.0 * 10.0
THICKNESS_TENSION = 0.01
STRING = ("finite-stretch", "thinning", "large-rotation", "surface-tension")


def pulled(asked: Scene, pull: float, **changes: Any) -> Scene:
    """With the surface tension whose axial force is `pull` [Pa] times the undeformed area."""
    h = float(asked.filament.thickness)
    side = {"circle": h / 2, "rectangle": 1 / (1 / h + 1 / asked.filament.width), "sheet": h / 2}
    gamma = float(pull) * side[asked.filament.section]
    return asked.replace({"surroundings.surface_tension": f"{gamma!r} N/m", **changes})


def string_sag(E: float, pull: float, power: float) -> float:
    """Sag/L of a string with Q = A0 (E log(s)/s + pull s^-power), over rho g L: exact, by quadrature."""

    def stretch(force: float) -> float:
        return float(brentq(lambda s: E * np.log(s) / s + pull * s**-power - force, 0.3, 2.0, xtol=1e-15))

    def across(H: float) -> float:
        return quad(lambda X: H * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]

    H = brentq(lambda H: across(H) - 0.5, 0.1 * (pull + 1), 2 * pull + E / 4, xtol=1e-14)
    return quad(lambda X: X * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]


@pytest.mark.parametrize("section", ["circle", "rectangle", "sheet"])
def test_string_with_the_pull_of_its_surface_is_exact_in_the_second_order(section: str) -> None:
    """Gam = 0.5 rho g L, E = 50 rho g L."""
    E, pull = 50.0, 0.5
    # A sheet is in plane strain across its width, which it keeps: so does the force of its surface.
    modulus = E / (1 - 0.45**2) if section == "sheet" else E
    expected = string_sag(modulus, pull, 0.0 if section == "sheet" else 0.5)
    found = []
    for cells in (20, 40, 80):
        asked = scene(thickness=THICKNESS_TENSION, E=E * WEIGHT, section=section, effects=STRING, cells=cells)
        found.append(sag(run(pulled(asked, pull * WEIGHT))))
    errors = [abs(one / expected - 1) for one in found]
    assert errors[2] < 2e-5
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.05)


@pytest.mark.parametrize(
    ("number", "shear"), few([(4.4, False), (71.0, False), (18.0, True)], (4.4, False), (71.0, False))
)
def test_clamped_beam_with_the_pull_of_its_surface(number: float, shear: bool) -> None:
    """Sag (q L^2/8F) (1 - (2/u) tanh(u/2)), u = (L/2) sqrt(F/EI), F L^2/(EI) = `number`; second order in the cells."""
    h, E = 0.01, 1e8
    stiffness = GYRATION["circle"] * h**2 * E
    pull, tiny = number * stiffness, 1e-7
    u = np.sqrt(number) / 2
    expected = (1 - 2 / u * np.tanh(u / 2)) / (8 * number)
    effects = (*GEOMETRY, "surface-tension", *(("shear",) if shear else ()))
    errors = []
    for cells in (20, 40, 80):
        asked = scene(thickness=h, E=E, section="circle", effects=effects, gravity=10 * tiny, cells=cells)
        found = sag(run(pulled(asked, pull)))
        errors.append(found / (expected * 1000 * 10 * tiny / stiffness) - 1)
    # Shear, of the order (h/L)^2, is no error of the grid.
    left = errors[2] + (errors[2] - errors[1]) / 3
    assert abs(left) < (3e-3 if shear else 1e-4)
    assert (errors[0] - errors[1]) / (errors[1] - errors[2]) == pytest.approx(4, rel=0.1)


def test_the_small_deflection_model_takes_it_as_one_tension() -> None:
    h, E, number = 0.01, 1e8, 18.0
    stiffness = GYRATION["circle"] * h**2 * E
    u = np.sqrt(number) / 2
    expected = (1 - 2 / u * np.tanh(u / 2)) / (8 * number) * 1e-3 / stiffness
    asked = scene(thickness=h, E=E, section="circle", effects="auto", gravity=1e-6, cells=80)
    small = pulled(asked, number * stiffness, **{"model": "small-deflection"}).replace({"load.ramp": "20 s"})
    done = run(small.replace({"run.duration": "40 s"}))
    assert "surface-tension" in done.summary["effects"]
    assert sag(done) == pytest.approx(expected, rel=1e-3)


def energy_closes(asked: Scene) -> sc.Run:
    done = sc.simulate(asked)
    assert done.outcome.is_success, done.summary["message"]
    assert done.summary["energy_residual"] < 1e-5
    return done


@pytest.mark.parametrize(
    ("shear", "backend"),
    few([(False, "compiled"), (True, "compiled"), (True, "interpreted")], (False, "compiled"), (True, "compiled")),
)
def test_energy_is_conserved(shear: bool, backend: str) -> None:
    """A heavy, soft filament with a profile swings: the energy of its surface is a tenth of what it trades."""
    effects = ["inertia", *GEOMETRY, "extensibility", "surface-tension", *(["shear"] if shear else [])]
    asked = scene(thickness=0.05, E=3e5, effects=tuple(effects), section="circle", cells=10, rtol=1e-8, frames=21)
    done = energy_closes(
        pulled(
            asked, 1e5, **{"filament.profile": [1.2, 0.8, 1.2], "numerics.backend": backend, "run.duration": "1.5 s"}
        )
    )
    energy = done.data["energy_surface"].values
    assert energy[0] == 0
    assert np.max(np.abs(energy)) > 0.1 * np.max(np.abs(done.data["energy_elastic"].values))


def test_the_energy_is_surface_tension_times_the_growth_of_the_area() -> None:
    """Lateral area, 2 pi R sqrt(s^2 + R_X^2) dX: of each cell with its own R, of each joint with the slope there."""
    asked = scene(thickness=0.05, E=3e5, effects=("inertia", *GEOMETRY, "surface-tension"), section="circle", cells=10)
    pinched = pulled(asked, 5e4, **{"filament.profile": [1.2, 0.8, 1.2], "numerics.rtol": 1e-6})
    done = sc.simulate(pinched)
    length, stretch = np.diff(done.data["X_node"].values), done.data["stretch"].values
    R, apart = done.data["thickness"].values / 2, (length[1:] + length[:-1]) / 2
    cylinders = np.sum(2 * np.pi * R * stretch * length, axis=1)
    R_n, s_n, slope = (R[:, 1:] + R[:, :-1]) / 2, (stretch[:, 1:] + stretch[:, :-1]) / 2, np.diff(R) / apart
    area = cylinders + np.sum(2 * np.pi * R_n * (np.hypot(s_n, slope) - s_n) * apart, axis=1)
    grown = pinched.surroundings.surface_tension * (area - area[0])
    far = np.max(np.abs(grown))
    np.testing.assert_allclose(done.data["energy_surface"].values, grown, atol=1e-3 * far)
    without = pinched.surroundings.surface_tension * (cylinders - cylinders[0])
    assert np.max(np.abs(done.data["energy_surface"].values - without)) > 5e-3 * far


@cache
def free_strand(gam: float) -> Run:
    """A weightless Bingham strand with a free end, Gam = `gam` sigma_Y, after a minute."""
    effects = (*GEOMETRY, "viscous-flow", "yielding", "surface-tension")
    round_end = {"section": "circle", "gravity": 0.0, "ends": ("clamped", "free"), "duration": 60.0, "frames": 7}
    asked = scene(thickness=0.02, E=1e6, eta=1e4, yield_stress=1e4, effects=effects, cells=10, **round_end)  # type: ignore[arg-type]
    done = sc.simulate(pulled(asked, gam * 1e4))
    assert done.outcome.is_success, done.summary["message"]
    return done


@pytest.mark.parametrize("gam", [1.25, 2.0])
def test_a_free_end_of_a_bingham_strand_is_pulled_in_until_it_holds(gam: float) -> None:
    """A sigma = - pi gamma R at the free end: it thickens until R = gamma/sigma_Y, beyond the elastic strain."""
    done = free_strand(gam)
    thicker = done.data["thickness"].values[-1] / 0.02
    np.testing.assert_allclose(thicker, gam, rtol=1e-3)
    np.testing.assert_allclose(done.data["tension"].values[-1], -np.pi * gam * 1e4 * 0.01**2 * thicker, rtol=1e-3)


@pytest.mark.parametrize("inertia", [True, False], ids=["inertia", "without inertia"])
def test_a_viscous_thread_with_a_free_end_thickens_at_gam_over_two_eta(inertia: bool) -> None:
    """R/R0 = 1 + Gam t/(2 eta) of a Newtonian thread."""
    asked = scene(thickness=0.02, E=1.0, section="circle", gravity=0.0, ends=("clamped", "free"), cells=10, frames=4)
    effects = ["extensibility", "bending", "finite-stretch", "thinning", "large-rotation", "viscous-stress"]
    thread = pulled(asked, 1e3).replace(
        {
            "material": {"law": "newtonian", "viscosity": "10 kPa*s"},
            "run.effects": [*effects, "surface-tension", *(["inertia"] if inertia else [])],
            "filament.density": "1 kg/m^3",
            "run.duration": "6 s",
            # There is no sag whose error could be estimated.
            "numerics.estimate": False,
        }
    )
    done = sc.simulate(thread)
    assert done.outcome.is_success, done.summary["message"]
    thicker = done.data["thickness"].values.mean(axis=1) / 0.02
    np.testing.assert_allclose(thicker, [1.0, 1.1, 1.2, 1.3], rtol=2e-3)


# The beam that bends and does not stretch: what the filament is without extensibility.
THICKNESS_STIFF, WEIGHT_STIFF, TINY = 0.02, 1e4, 2e-5
"""Thickness, weight per volume and sag of most beams here, span 1 m: H/h0 is a thousandth."""

CONSTANT = {**BEAM_CONSTANT, ("pinned", "clamped"): 192.0, ("clamped", "free"): 384 / 17, ("free", "clamped"): 384 / 17}
"""C in: midpoint sag = w L^4/(C E I), cantilevers included (17/384 at half their length)."""

LOST_TO_TENSION = {
    ("clamped", "clamped"): 32 / 525,
    ("pinned", "pinned"): 16592 / 65625,
    ("clamped", "pinned"): 23 / 175,
}
"""Share of the sag H that tension takes, over A H^2/I: derivations/02_section_and_closures.py."""


def modulus(ends: tuple[str, str], section: str = "rectangle", height: float = TINY) -> float:
    """Young's modulus at which the linear stiff_beam sags by this height."""
    return WEIGHT_STIFF / (CONSTANT[ends] * GYRATION[section] * THICKNESS_STIFF**2 * height)


def stiff_beam(ends: tuple[str, str] = ("clamped", "clamped"), section: str = "rectangle", **changes: Any) -> Scene:
    """An elastic stiff_beam of tiny sag at rest, unless changed."""
    given = {"effects": ("bending",), "E": modulus(ends, section)} | changes
    return scene(thickness=THICKNESS_STIFF, section=section, ends=ends, **given)


def test_the_tip_of_a_cantilever_sags_by_an_eighth() -> None:
    done = run(stiff_beam(("clamped", "free"), cells=40))
    tip = -float(done.data["y"][-1, -1]) / TINY
    assert tip == pytest.approx(384 / 17 / 8, rel=1e-3)


@pytest.mark.parametrize("ends", list(FIRST_EIGENVALUE), ids="-".join)
def test_first_frequency(ends: tuple[str, str]) -> None:
    """(beta L)^2 sqrt(E I/(rho A L^4)), with beta L = 4.730 between clamps."""
    rigidity = modulus(ends) * GYRATION["rectangle"] * THICKNESS_STIFF**2 / 1000.0
    period = 2 * np.pi / (FIRST_EIGENVALUE[ends] ** 2 * np.sqrt(rigidity))
    done = run(stiff_beam(ends, effects=("inertia", "bending"), duration=10.5 * period, frames=801, rtol=3e-4))
    assert done.outcome.is_success
    assert done.summary["energy_residual"] < 1e-3
    t, y = done.data["time"].values, done.data["midpoint"].values
    crossings = upward_crossings(t, y + TINY)
    assert len(crossings) == 10
    assert (crossings[-1] - crossings[0]) / 9 == pytest.approx(period, rel=2e-3)
    assert -np.mean(y[t < 10 * period]) == pytest.approx(TINY, rel=5e-3)


@pytest.mark.parametrize("ends", list(LOST_TO_TENSION), ids="-".join)
def test_tension_takes_a_share_that_falls_with_the_square_of_the_sag(ends: tuple[str, str]) -> None:
    """(H/h0)^2 times 0.73 between clamps and 3.03 between pins, for a rectangle."""
    sizes, lost = np.array([0.005, 0.01, 0.02]), []
    for size in sizes.tolist():
        asked = stiff_beam(ends, E=modulus(ends, height=size * THICKNESS_STIFF))
        plain, stretching = sag(run(asked)), sag(run(asked.replace({"run.effects": ["bending", "extensibility"]})))
        lost.append((plain - stretching) / plain)
    orders = np.diff(np.log2(lost))
    prefactor = float(lost[0] / sizes[0] ** 2)
    assert np.all(np.abs(orders - 2) < 0.01)
    assert prefactor == pytest.approx(LOST_TO_TENSION[ends] / GYRATION["rectangle"], rel=5e-3)
