"""What surrounds a filament: buoyancy and drag against closed forms, in the interpreter and in C."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq, curve_fit

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects

L, H, RHO, G = 0.2, 2e-3, 1000.0, 9.81
BACKENDS = ("interpreted", "compiled")


def strand(bath: dict[str, str], **tables: Any) -> sc.Scene:
    """A round strand in a bath."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": f"{L} m", "diameter": f"{H} m", "density": f"{RHO} kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "10 MPa"},
            "surroundings": bath,
            "run": {"duration": "1 s", "frames": 11},
            **tables,
        }
    )


def slender(viscosity: float, thickness: float = H) -> tuple[float, float]:
    """Force per length and velocity of a slender body, along and across (Cox 1970)."""
    log = math.log(2 * L / thickness)
    return 2 * math.pi * viscosity / (log + math.log(2) - 1.5), 4 * math.pi * viscosity / (log + math.log(2) - 0.5)


def test_buoyancy_takes_its_share_of_the_weight() -> None:
    """A beam sags by q L^4/(384 E I) of what is left of its weight; in a bath of its own density it stays straight."""
    area, inertia = math.pi * H**2 / 4, math.pi * H**4 / 64
    for density in (0.0, 400.0, 1000.0, 1500.0):
        listed = ["bending", *(["buoyancy"] if density else [])]
        scene = strand({"density": f"{density} kg/m^3"}).replace({"run.effects": listed, "load.gravity": "0.1 m/s^2"})
        run = sc.simulate(scene)
        sag = (RHO - density) * area * 0.1 * L**4 / (384 * 10e6 * inertia)
        assert -run.summary["midpoint_final_m"] == pytest.approx(sag, rel=2e-3, abs=1e-12), density


def test_a_slender_strand_falls_at_its_terminal_velocity() -> None:
    """Across: rho A g/zeta_n, from the first instant where nothing has inertia."""
    viscosity = 1.0
    listed = ["bending", "extensibility", "viscous-stress", "drag"]
    scene = strand(
        {"viscosity": f"{viscosity} Pa*s"},
        material={"law": "newtonian", "viscosity": "1e-3 Pa*s"},
        run={"duration": "1e-4 s", "frames": 11, "effects": listed},
        numerics={"rtol": 1e-8, "estimate": False},
    )
    for backend in BACKENDS:
        run = sc.simulate(scene.replace({"numerics.backend": backend}))
        speed = -np.gradient(run.data.midpoint.values, run.data.time.values)[5]
        expected = RHO * math.pi * H**2 / 4 * G / slender(viscosity)[1]
        assert speed == pytest.approx(expected, rel=1e-6), backend


def test_a_fast_strand_falls_at_the_terminal_velocity_of_a_cylinder() -> None:
    """C_d = 1 + 10 Re^(-2/3) (White): the weight is what it resists by; energy is accounted for on the way."""
    bath, viscosity = 1.2, 2e-5
    scene = strand(
        {"viscosity": f"{viscosity} Pa*s", "density": f"{bath} kg/m^3"},
        filament={"span": "10 km", "diameter": f"{H} m", "density": f"{RHO} kg/m^3"},
        material={"law": "newtonian", "viscosity": "1e-6 Pa*s"},
        run={
            "duration": "10 s",
            "frames": 201,
            "effects": ["inertia", "bending", "extensibility", "viscous-stress", "buoyancy", "drag"],
        },
        numerics={"rtol": 1e-8, "estimate": False, "cells": 4},
    )
    weight = (RHO - bath) * math.pi * H**2 / 4 * G

    def excess(speed: float) -> float:
        viscous = 10 * (viscosity / (bath * H)) ** (2 / 3) * speed ** (4 / 3)
        return bath * H / 2 * (speed**2 + viscous) - weight

    expected = brentq(excess, 1.0, 1000.0)
    for backend in BACKENDS:
        run = sc.simulate(scene.replace({"numerics.backend": backend}))
        speed = -np.gradient(run.data.midpoint.values, run.data.time.values)[-5:]
        np.testing.assert_allclose(speed, expected, rtol=2e-3)
        assert run.summary["energy_residual"] < 1e-5


def ringing(time: Floats, rest: float, swing: float, rate: float, frequency: float, phase: float) -> Floats:
    return rest * (1 + swing * np.exp(-rate * time) * np.cos(frequency * time + phase))


def rings(viscosity: float, density: float, effects: tuple[str, ...], cells: int, backend: str) -> tuple[float, ...]:
    """Decay and frequency of a clamped beam over those of theory, and what is missing in the energy.

    First mode: w_0^2 = (22.3733/L^2)^2 E I/((rho + rho_b) A), decay zeta_n/(2 (rho + rho_b) A). Added to it are the
    third and its like, which have died out, or hold little: they fall off as the fourth power of the wave number.
    """
    area, inertia = math.pi * H**2 / 4, math.pi * H**4 / 64
    mass = (RHO + density) * area
    natural = 22.37329 / L**2 * math.sqrt(10e6 * inertia / mass)
    decay = slender(viscosity)[1] / (2 * mass) if viscosity else 0.0
    expected = math.sqrt(natural**2 - decay**2)
    scene = strand(
        {"viscosity": f"{viscosity} Pa*s", "density": f"{density} kg/m^3"},
        load={"gravity": "1e-4 m/s^2"},  # So slow that White's law is a slender body
        run={"duration": f"{4 * 2 * math.pi / natural} s", "frames": 401, "effects": ["inertia", "bending", *effects]},
        numerics={"rtol": 1e-6, "estimate": False, "cells": cells, "backend": backend},
    )
    run = sc.simulate(scene)
    time, sag = run.data.time.values, -run.data.midpoint.values
    late = time > 0.2 * time[-1]
    begin = (sag.mean(), 1.0, decay, expected, math.pi)
    found = curve_fit(ringing, time[late], sag[late], begin)[0]
    return found[2] / decay if decay else found[2] / natural, found[3] / expected, run.summary["energy_residual"]


@pytest.mark.slow
def test_a_beam_rings_down_in_its_bath() -> None:
    decay, frequency, residual = rings(0.005, 0.0, ("extensibility", "drag"), 16, "compiled")
    assert decay == pytest.approx(1, abs=5e-3)
    assert frequency == pytest.approx(1, abs=5e-3)
    assert residual < 1e-4
    slower = rings(0.005, 800.0, ("drag", "added-mass"), 16, "compiled")
    assert slower[:2] == pytest.approx((1, 1), abs=5e-3)


def test_energy_closes_however_a_strand_moves_in_its_bath() -> None:
    """Far from straight, from a tilted chord: tangents turn, nodes are pushed along and across, and stretch."""
    effects = ["inertia", "bending", "extensibility", "large-rotation", "finite-stretch", "thinning", "viscous-stress"]
    residuals, midpoints = [], []
    for backend in BACKENDS:
        scene = strand(
            {"density": "500 kg/m^3", "viscosity": "0.05 Pa*s"},
            material={"law": "kelvin-voigt", "youngs_modulus": "30 kPa", "viscosity": "100 Pa*s"},
            ends={"drop": "0.05 m"},
            run={"duration": "0.4 s", "frames": 41, "effects": [*effects, "buoyancy", "drag", "added-mass"]},
            numerics={"rtol": 1e-8, "estimate": False, "cells": 8, "backend": backend},
        )
        run = sc.simulate(scene)
        assert run.data.midpoint.values.min() < -0.1 * L
        residuals.append(run.summary["energy_residual"])
        midpoints.append(run.data.midpoint.values)
    assert max(residuals) < 1e-6, residuals
    np.testing.assert_allclose(midpoints[0], midpoints[1], rtol=0, atol=1e-5 * L)


def test_auto_takes_them_in_where_they_matter() -> None:
    """By rho_b/rho, and by what the bath resists; air matters to neither for a short strand that does not ring on.

    One that rings on without loss is another matter: a thousandth of the weight changes its phase, air its amplitude.
    """
    creeping = {"law": "maxwell", "youngs_modulus": "10 MPa", "viscosity": "100 kPa*s"}
    air = {"density": "1.2 kg/m^3", "viscosity": "18 uPa*s"}
    for bath, law, expected in (
        (air, creeping, set()),
        (air, {"law": "elastic", "youngs_modulus": "10 MPa"}, {"buoyancy", "drag"}),
        ({"density": "900 kg/m^3"}, creeping, {"buoyancy"}),
        ({"density": "900 kg/m^3", "viscosity": "10 Pa*s"}, creeping, {"buoyancy", "drag"}),
    ):
        chosen = set(choose_effects(strand(bath, material=law)).names)
        assert chosen & {"buoyancy", "drag"} == expected, (bath, law)


@pytest.mark.parametrize(
    ("bath", "words"),
    [
        ({"density": "-1 kg/m^3"}, "surroundings.density"),
        ({"density": "1 m"}, "surroundings.density"),
        ({"density": "1e9 kg/m^3"}, "surroundings.density"),
        ({"viscosity": "-1 Pa*s"}, "surroundings.viscosity"),
        ({"viscocity": "1 Pa*s"}, "viscosity"),
    ],
)
def test_bad_baths_are_one_clear_error(bath: dict[str, str], words: str) -> None:
    with pytest.raises(sc.SceneError, match=words):
        choose_effects(strand(bath))
