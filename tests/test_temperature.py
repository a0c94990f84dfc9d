"""Filaments with a temperature: cooling, conduction, heat of dissipation, and what temperature makes of a material."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.temperature import cooling_time, transfer_coefficient
from softcat_sym.errors import SceneError
from softcat_sym.physics import heat as sy
from softcat_sym.results.fields import heat_residual
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence, Start
from tests.common.warm_bars import BAR, CAPACITY, DIAMETER, FLOWING, RHO, SPAN, bar, run, without_gaps

pytestmark = pytest.mark.filterwarnings("ignore:the section is assumed to have one temperature")
AIR = {"ambient": 300.0, "heat_transfer": 80.0}
VFT = {"law": "vft", "B": 4236.1, "T_0": 265.5 + 273.15}
SOFTER = {"law": "arrhenius", "activation_energy": 40e3, "reference": 350.0}


def test_a_bar_cools_exponentially() -> None:
    """T = T_a + (T_i - T_a) exp(-4 h t/(rho c_p d)), in the interpreter and in C."""
    scene = bar(AIR)
    found = run(scene)
    tau = RHO * CAPACITY * DIAMETER / (4 * 80.0)
    assert cooling_time(scene) == pytest.approx(tau, rel=1e-12)
    expected = 300 + 50 * np.exp(-found.fields["time"] / tau)
    np.testing.assert_allclose(found.fields["temperature"], expected[:, None] * np.ones(13), rtol=0, atol=2e-6)
    in_c = run(scene, numerics__backend="compiled")
    np.testing.assert_allclose(in_c.fields["temperature"], found.fields["temperature"], rtol=0, atol=5e-6)


def test_what_a_relaxing_bar_dissipates_heats_it() -> None:
    """A Maxwell bar, held: rho c_p (T - T_i) = E eps^2/2 (1 - exp(-2 t/tau)); nothing is lost."""
    scene = bar({}, *FLOWING, initial={"stretch": 1.3, "relaxed": False})
    found = run(scene)
    time, strain = found.fields["time"], math.log(1.3)
    rise = 1e6 * strain**2 / 2 * (1 - np.exp(-2 * time)) / (RHO * CAPACITY)
    np.testing.assert_allclose(found.fields["temperature"][:, 4] - 350, rise, rtol=0, atol=1e-5 * rise[-1])
    assert heat_residual(found.fields) < 1e-9
    assert np.all(found.fields["heat_lost"] == 0)


def _mode(cells: int, mode: int) -> float:
    """Rate at which a cosine of the temperature decays by conduction [1/s]."""
    scene = bar({"conductivity": 200.0}, numerics={"cells": cells}, duration=0.4)
    prepared = build(scene, choose_effects(scene))
    graph = prepared.graph
    x = prepared.start.x.copy()
    warm = [k for k, kind in enumerate(graph.differential.kinds) if kind == "warming"]
    x[warm] = 1e-3 * np.cos(mode * np.pi * (graph.differential.where[warm] + (0 if graph.grid.is_half else 0.5)))
    solution = prepared.integration.run(
        Start(x, prepared.start.z), prepared.p, prepared.times[-1], prepared.scale, Silence()
    )
    return float(-np.log(solution.x[warm[0], -1] / x[warm[0]]) / 0.4)


def test_conduction_makes_a_cosine_decay() -> None:
    """At k (n pi)^2/(rho c_p L^2), with an error of the second order of the cells."""
    exact = 200.0 / (RHO * CAPACITY) * (2 * np.pi / SPAN) ** 2
    errors = [abs(_mode(cells, 2) / exact - 1) for cells in (4, 8)]
    # Half the filament, n = 2 of the whole: (2 - 2 cos(pi/cells))/(pi/cells)^2 of the difference scheme.
    assert errors[0] == pytest.approx((np.pi / 4) ** 2 / 12, rel=0.05)
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)


@pytest.mark.parametrize("stated", [
    {**VFT, "A": -1.626}, {**VFT, "reference": 900.0}, SOFTER,
    {"law": "wlf", "C1": 17.44, "C2": 51.6, "reference": 340.0}, {},
])  # fmt: skip
def test_laws_of_the_viscosity_are_those_of_the_equations(stated: dict[str, Any]) -> None:
    """As the scene is checked and forecast by, and as the graph has it."""
    hot = 1000.0 if stated.get("law") == "vft" else 360.0
    heat = bar({"initial": hot, **stated}, *FLOWING).temperature
    expression = sy.shift(heat.law, by_reference=heat.reference is not None)
    values = {
        sy.temperature: hot, sy.reference: heat.reference, sy.A_V: heat.A, sy.B_V: heat.B, sy.T_V: heat.T_0,
        sy.C_1: heat.C1, sy.C_2: heat.C2, sy.B_A: heat.activation_temperature,
    }  # fmt: skip
    given = {symbol: value for symbol, value in values.items() if value is not None}
    assert heat.viscosity_factor(hot) == pytest.approx(float(sp.sympify(expression).subs(given)), rel=1e-12)


@pytest.mark.parametrize("law", [SOFTER, {"law": "wlf", "C1": 3.0, "C2": 60.0, "reference": 350.0}])
def test_a_warm_bar_relaxes_as_its_viscosity_says(law: dict[str, Any]) -> None:
    """Stress ~ exp(-E t/(eta a_T)), stretched and bent alike."""
    scene = bar(
        {"initial": 370.0, "heat_capacity": 1e9, **law},
        *FLOWING,
        initial={"stretch": 1.05, "relaxed": False},
        duration=0.5,
    )
    factor = scene.temperature.viscosity_factor(370.0)
    assert factor < 0.6
    found = run(scene).fields
    expected = found["stress_mean"][0, 3] * np.exp(-found["time"] / factor)
    np.testing.assert_allclose(found["stress_mean"][:, 3], expected, rtol=3e-6)


FREEZING = {
    "wlf": {"law": "wlf", "C1": 3.4, "C2": 60.0, "reference": 373.0},
    "vft": {"law": "vft", "B": 500.0, "T_0": 313.0, "reference": 373.0},
}


@pytest.mark.parametrize("law", FREEZING)
def test_a_bar_that_cools_below_the_law_of_its_viscosity_freezes(law: str) -> None:
    """It relaxes by the integral of its fluidity 1/(eta a_T), T = T_a + (T_i - T_a) exp(-t/tau), and then no more."""
    cooling = {"initial": 373.0, "ambient": 300.0, "heat_transfer": 75.0}
    scene = bar(
        {**cooling, **FREEZING[law]},
        *FLOWING,
        initial={"stretch": 1.05, "relaxed": False},
        duration=60.0,
        numerics={"cells": 4, "rtol": 1e-6},
    )
    # What is stretched has more surface for its volume.
    tau = RHO * CAPACITY * DIAMETER / (4 * 75.0) / math.sqrt(1.05)

    def fluidity(time: float) -> float:
        T = 300 + 73 * math.exp(-time / tau)
        if law == "wlf":
            decades = -3.4 * (T - 373) / (T - 313) if T > 313 else math.inf
        else:
            decades = 500 / (T - 313) - 500 / 60 if T > 313 else math.inf
        return max(10**-decades, 1e6 / 1e15)

    found = run(scene).fields
    flown = [quad(fluidity, 0, time, points=[10.0], limit=200)[0] for time in found["time"]]
    stress = found["stress_mean"][:, 3] / found["stress_mean"][0, 3]
    np.testing.assert_allclose(stress, np.exp(-np.array(flown)), rtol=1e-4)
    assert stress[-1] == pytest.approx(stress[-3], rel=1e-6) and 0.3 < stress[-1] < 0.9
    if law == "wlf":
        in_c = run(scene, numerics__backend="compiled").fields
        np.testing.assert_allclose(in_c["stress_mean"], found["stress_mean"], rtol=1e-4)
    (note,) = (text for text in scene.notes if "frozen" in text)
    assert note.endswith("degC the strand is frozen: its viscosity is capped at 1e+15 Pa s")
    limit = 273.15 + float(note.split()[1])
    assert limit == pytest.approx(373 - 9 * 60 / (3.4 + 9) if law == "wlf" else 313 + 500 / (9 + 500 / 60), abs=0.01)


def test_a_modulus_that_falls_sets_energy_free_as_heat() -> None:
    """A stretched elastic bar that warms: W = m(T) W_0, and what it loses is found again in the audit."""
    table = {"350 K": 1.0, "400 K": 0.5}
    scene = bar(
        {"ambient": 400.0, "heat_transfer": 500.0, "modulus": table}, initial={"stretch": 1.2, "relaxed": False}
    )
    found = run(scene)
    T, fields = found.fields["temperature"][:, 5], found.fields
    whole = 1e6 * math.log(1.2) ** 2 / 2 * math.pi * DIAMETER**2 / 4 * SPAN / 1.2
    np.testing.assert_allclose(fields["energy_elastic"], whole * (1 - 0.5 * (T - 350) / 50), rtol=1e-7)
    np.testing.assert_allclose(fields["energy_softening"], whole * 0.5 * (T - 350) / 50, rtol=0, atol=1e-7 * whole)
    assert found.summary["energy_residual"] < 1e-7


def test_a_bar_between_clamps_is_pulled_as_it_cools() -> None:
    """sigma = -E alpha (T - T_i); the energy is found again in the audit, the heat of it in the temperature."""
    heat = {"ambient": 300.0, "heat_transfer": 500.0, "expansion": 1e-4, "heat_capacity": 1.0}
    scene = bar(heat, duration=0.5, material={"youngs_modulus": 1e7})
    found = run(scene)
    fields, strain = found.fields, 1e-4 * (found.fields["temperature"][:, 5] - 350)
    np.testing.assert_allclose(fields["stress_mean"][1:, 5], -1e7 * strain[1:], rtol=1e-8)
    whole = 1e7 * strain**2 / 2 * np.exp(3 * strain) * math.pi * DIAMETER**2 / 4 * SPAN
    np.testing.assert_allclose(fields["energy_elastic"], whole, rtol=0, atol=1e-7 * whole[-1])
    np.testing.assert_allclose(-fields["energy_softening"], whole, rtol=0, atol=1e-6 * whole[-1])
    assert found.summary["energy_residual"] < 1e-6
    sheared = run(scene.replace({"run.effects": [*BAR, "shear"]}))
    np.testing.assert_allclose(sheared.fields["energy_softening"], fields["energy_softening"], rtol=1e-6)
    in_c = run(scene, numerics__backend="compiled")
    np.testing.assert_allclose(
        in_c.fields["energy_softening"], fields["energy_softening"], rtol=0, atol=1e-6 * whole[-1]
    )


EVERYTHING = {
    **SOFTER, "ambient": {"0 s": "350 K", "0.05 s": "300 K", "0.2 s": "330 K"}, "heated": ["5 mm", "30 mm"],
    "outside": 310.0, "correlation": "cylinder-in-air", "conductivity": 5.0, "heat_capacity": 20.0,
    "modulus": {"300 K": 1.5, "330 K": 1.2, "360 K": 0.9}, "expansion": 2e-4,
}  # fmt: skip


def _hanging(*effects: str, **numerics: object) -> sc.Scene:
    """A bar that sags, flows and cools, its material as soft as makes all of it matter."""
    return bar(
        EVERYTHING, *(effects or FLOWING), duration=0.2, load={"gravity": 9.81},
        material={"youngs_modulus": 3e5, "viscosity": 1e4}, run={"frames": 5}, numerics=numerics,
    )  # fmt: skip


@pytest.mark.parametrize("effects", [
    FLOWING,
    pytest.param((*FLOWING, "shear", "rotary-inertia"), marks=pytest.mark.slow),
    pytest.param((*FLOWING, "shear", "fibres"), marks=pytest.mark.slow),
])  # fmt: skip
def test_c_computes_what_the_interpreter_does(effects: tuple[str, ...]) -> None:
    """Furnace, correlation, conduction, tables and dissipation at once; the audit of energy and heat closes."""
    scene = _hanging(*effects, rtol=1e-6, cells=4)
    ours, in_c = run(scene), run(scene, numerics__backend="compiled")
    assert ours.summary["backend"] == "interpreted"
    assert in_c.summary["backend"] == "compiled"
    for name, size in (("midpoint", 1e-6), ("temperature", 1e-6), ("stress_mean", 1e-4), ("heat_lost", 1e-5)):
        values = ours.fields[name]
        np.testing.assert_allclose(in_c.fields[name], values, rtol=0, atol=size * np.abs(values).max(), err_msg=name)
    assert ours.summary["energy_residual"] < 1e-6
    assert np.ptp(ours.fields["temperature"][-1]) > 0.5


def test_a_pipe_in_air() -> None:
    """Incropera's example 9.4: 0.1 m, 165 C in air of 23 C; Ra = 5.073e6, Nu = 23.3, h = 7.29 W/(m^2 K)."""
    scene = bar(
        {"initial": 438.15, "ambient": 296.15, "correlation": "cylinder-in-air"},
        filament={"diameter": 0.1, "span": 2.0}, load={"gravity": 9.81},
    )  # fmt: skip
    assert transfer_coefficient(scene) == pytest.approx(7.29, rel=0.015)


def test_air_is_that_of_tables() -> None:
    """Conductivity and kinematic viscosity at 300 and 1000 K (Incropera, table A.4)."""
    for kelvin, conductivity, viscosity in ((300, 26.3e-3, 15.89e-6), (1000, 66.7e-3, 121.9e-6)):
        found = [float(one) for one in sy.air(sp.Integer(kelvin))]
        assert found == pytest.approx([conductivity, viscosity], rel=0.04)


def test_it_is_taken_in_where_it_matters() -> None:
    """By the change of the viscosity at the temperatures that the run reaches."""
    warm = bar({**SOFTER, **AIR}, run={"effects": "auto"}, load={"gravity": 9.81}, material={
        "law": "maxwell", "viscosity": 1e4})  # fmt: skip
    assert "temperature" in choose_effects(warm).names
    # A thousandth of the heat transfer: nothing cools within the run.
    slow = warm.replace({"temperature.heat_transfer": "0.001 W/(m^2*K)"})
    assert choose_effects(slow).left_out["temperature"] < 1e-3


REFUSED: dict[str, tuple[dict[str, Any], str, str]] = {
    "below zero": ({"initial": "-300 degC"}, "temperature.initial", "not above absolute zero"),
    "no unit": ({"initial": "300"}, "temperature.initial", "no unit"),
    "another unit": ({"heat_capacity": "3 m"}, "temperature.heat_capacity", "is not a unit like"),
    "a scale": ({**VFT, "initial": 900.0, "A": 1.0, "B": "4236.1 degC"}, "temperature.B", "not of their differences"),
    "no capacity": ({"heat_capacity": ...}, "temperature.heat_capacity", "missing"),
    "no start": ({"initial": ...}, "temperature.initial", "missing"),
    "cold glass": ({**VFT, "reference": 500.0}, "temperature.T_0", "not below"),
    "coefficient and correlation": ({**AIR, "correlation": "cylinder-in-air"}, "temperature.heat_transfer", "twice"),
    "no surroundings": ({"heat_transfer": 3.0}, "temperature.ambient", "missing"),
    "deaf surroundings": ({"ambient": 300.0}, "temperature.ambient", "no heat passes"),
    "both sizes": ({**VFT, "initial": 900.0, "A": 1.0, "reference": 900.0}, "temperature.A", "each says"),
    "no size": ({**VFT, "initial": 900.0}, "temperature.A", "nothing says"),
    "constant of another law": ({"C1": 3.0}, "temperature.C1", "law of the viscosity is 'constant'"),
    "no constant": ({"law": "arrhenius", "reference": 300.0}, "temperature.activation_energy", "needs it"),
    "furnace beyond the end": (
        {**AIR, "heated": ["0 m", "1 m"], "outside": 300.0}, "temperature.heated", "is 0.05 m long"),
    "furnace backwards": ({**AIR, "heated": ["2 cm", "1 cm"], "outside": 300.0}, "temperature.heated", "not below"),
    "nothing outside": ({**AIR, "heated": ["0 m", "1 cm"]}, "temperature.outside", "missing"),
    "all inside": ({**AIR, "outside": 300.0}, "temperature.outside", "whole filament"),
    "row of the table": ({"modulus": {"300 K": -1.0, "350 K": 1.0}}, "temperature.modulus.300 K", "out of range"),
    "short table": ({"modulus": {"300 K": 1.0}}, "temperature.modulus", "a table of 1"),
    "time of the table": ({**AIR, "ambient": {"0 K": "3 K", "1 s": "4 K"}}, "temperature.ambient.0 K", "time"),
    "rate of a strain": ({"expansion": 1e-5}, "temperature.expansion", "viscous stress"),
    "unknown": ({"heat": 3.0}, "temperature.heat", "unknown key"),
}  # fmt: skip


@pytest.mark.parametrize("what", REFUSED)
def test_what_makes_no_sense_is_refused(what: str) -> None:
    """One fault at its dotted path."""
    heat, path, words = REFUSED[what]
    with pytest.raises(SceneError) as refused:
        loss = {"material": {"loss_tangent": 0.1}} if what == "rate of a strain" else {}
        bar(heat, *FLOWING, **loss)
    faults = {fault.path: fault.found for fault in refused.value.faults}
    assert words in faults.get(path, ""), faults


@pytest.mark.parametrize(("tables", "path"), [
    ({"filament": {"diameter": ..., "thickness": "1 mm", "section": "rectangle"}}, "temperature.correlation"),
    ({"load": {"gravity": "0 m/s^2"}}, "temperature.correlation"),
    ({"run": {"closure": "printed", "effects": "auto"}, "load": {"gravity": "9.81 m/s^2"}}, "temperature"),
    ({"model": "small-deflection", "run": {"effects": "auto"}, "load": {"gravity": "9.81 m/s^2"}}, "temperature"),
])  # fmt: skip
def test_what_it_does_not_go_with_is_refused(tables: dict[str, Any], path: str) -> None:
    """A correlation of round bars, without weight; the printed closure; small deflections."""
    table = bar({}).given()
    table["temperature"] = {**table["temperature"], "ambient": "300 K", "correlation": "cylinder-in-air"}
    for name, values in tables.items():
        table[name] = {**table.get(name, {}), **values} if isinstance(values, dict) else values
    with pytest.raises(SceneError) as refused:
        sc.Scene.model_validate(without_gaps(table))
    assert path in {fault.path for fault in refused.value.faults}
