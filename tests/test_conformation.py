"""Polymer chains along and across a fibre: whole tensors by other means, closed forms, limits, audits and refusals."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.physics import polymer_chains
from softcat_sym.physics.constitutive_laws import law_of
from softcat_sym.physics.polymer_chains import ChainResponse, respond
from softcat_sym.physics.sections import CIRCLE, SHEET, Section
from softcat_sym.physics.symbols import E
from softcat_sym.scene.laws import LAWS
from tests.common.polymers import (
    LAMBDA,
    OWN,
    SOLVENT,
    STRING,
    Floats,
    G,
    bar,
    drawn_by_pieces,
    stress_of,
    whole_tensor,
)
from tests.marks import few

POLYMERS = [one.name for one in LAWS.values() if one.has_chains]


def law_numbers(law: str) -> dict[sp.Symbol, float]:
    """What the symbols of a law stand for."""
    own = {one.symbol: OWN[law][one.name] for one in law_of(law).constants if one.name in OWN[law]}
    return {E: 3 * G, polymer_chains.relaxation_time: LAMBDA, **own}


def chains_of(law: str, section: Section = CIRCLE) -> ChainResponse:
    chains = law_of(law).chains
    assert chains is not None
    return respond(section, chains)


def integrated(law: str, pace: float, times: Floats, section: Section = CIRCLE) -> list[Floats]:
    """Diagonal of A by the package's own rates, at a constant pace."""
    chains, numbers = chains_of(law, section), law_numbers(law)
    taken = [one.taken for one in chains.directions]
    given = (polymer_chains.strain, *taken)
    rates = sp.lambdify(given, [chains.of_states(rate).subs(numbers) for rate in chains.rates], "numpy")
    found = solve_ivp(
        lambda t, b: rates(pace * t, *b), (0, times[-1]), np.zeros(len(taken)), "LSODA", times, rtol=1e-11, atol=1e-12
    )
    extensions = sp.lambdify(given, list(chains.extensions), "numpy")
    return [np.array(extensions(pace * t, *b)) for t, b in zip(times, found.y.T, strict=True)]


@pytest.mark.parametrize("section", [CIRCLE, SHEET], ids=lambda one: one.name)
@pytest.mark.parametrize("law", POLYMERS)
def test_the_chains_are_those_of_the_whole_tensor(law: str, section: Section) -> None:
    """In drawing below and above the coil-stretch rate and in pushing together, of a round fibre and of a sheet."""
    times = np.linspace(0.2, 2.5, 8)
    for pace in (0.4, 1.1, -0.7):
        expected = whole_tensor(law, lambda _, pace=pace: pace, times, width=section is SHEET)
        for ours, A in zip(integrated(law, pace, times, section), expected, strict=True):
            # Along, across, and of a sheet the width.
            assert ours == pytest.approx(np.diag(A)[: len(ours)], rel=1e-8)


@pytest.mark.parametrize("wi", [0.2, 0.45, 0.75, 2.0])
def test_oldroyd_b_starts_up_as_its_closed_form(wi: float) -> None:
    """A_zz = (1 - 2 Wi e^(-(1 - 2 Wi) t))/(1 - 2 Wi), A_rr = (1 + Wi e^(-(1 + Wi) t))/(1 + Wi)."""
    times = np.linspace(0.1, 4.0, 9)
    along = (1 - 2 * wi * np.exp(-(1 - 2 * wi) * times)) / (1 - 2 * wi)
    across = (1 + wi * np.exp(-(1 + wi) * times)) / (1 + wi)
    found = np.array(integrated("oldroyd-b", wi / LAMBDA, times * LAMBDA))
    assert found == pytest.approx(np.transpose([along, across]), rel=1e-8)


def test_the_stress_is_the_derivative_of_the_energy_and_what_relaxes_is_lost() -> None:
    """dW = sigma d eps - dissipation dt: an identity in every strain and state."""
    for law in POLYMERS:
        for section in (CIRCLE, SHEET):
            chains, numbers = chains_of(law, section), law_numbers(law)
            at = {polymer_chains.strain: 0.4} | {one.taken: 0.1 * n - 0.2 for n, one in enumerate(chains.directions)}
            slope = sp.diff(chains.stored, polymer_chains.strain)
            lost = -sum(
                sp.diff(chains.stored, one.taken) * chains.of_states(rate)
                for one, rate in zip(chains.directions, chains.rates, strict=True)
            )
            for ours, stated in ((slope, chains.stress), (lost, chains.dissipation)):
                expected = float(chains.of_states(stated).subs(numbers).subs(at))
                assert float(ours.subs(numbers).subs(at)) == pytest.approx(expected, rel=1e-12)
            assert float(chains.of_states(chains.dissipation).subs(numbers).subs(at)) > 0


@pytest.mark.parametrize("law", few(POLYMERS, "fene-p"))
def test_a_bar_is_drawn_as_the_whole_tensor(law: str) -> None:
    """Along pieces of an exponential, then held: what is left besides is its inertia."""
    scene = bar(law, lambda t: np.exp(0.9 * np.minimum(t, 1.2)), 1.8, 12, **{"numerics.backend": "compiled"})
    run = sc.simulate(scene)
    tensors, data = drawn_by_pieces(law, run), run.data
    for name, place in (("conformation_along", (0, 0)), ("conformation_across", (1, 1))):
        expected = np.array([A[place] for A in tensors])
        assert data[name].values == pytest.approx(np.repeat(expected[:, None], 8, axis=1), rel=1e-6)
    area = np.pi / 4 * scene.filament.thickness**2
    held = data.time.values > 1.25
    stress = np.array([stress_of(law, A) for A in tensors])[held]
    # Held, the solvent has no stress.
    tension = (data.tension * data.stretch).values[held] / area
    assert tension == pytest.approx(np.repeat(stress[:, None], 8, axis=1), rel=1e-5)
    assert run.summary["energy_residual"] < 1e-6


HANGING: dict[str, Any] = {
    "filament": {"span": 0.05, "thickness": "2 mm", "section": "circle", "density": 1000.0},
    "material": {"law": "oldroyd-b", "youngs_modulus": 3000.0, "relaxation_time": 0.1, "solvent_viscosity": 30.0},
    "run": {"duration": 0.2, "frames": 21, "effects": [*STRING, "bending", "viscous-flow", "viscous-stress", "fibres"]},
    "numerics": {"cells": 5, "fibres": 4, "rtol": 1e-8, "estimate": False, "backend": "compiled"},
}


def hanging(law: str = "oldroyd-b", **changes: Any) -> sc.Scene:
    """A filament that hangs between clamps and bends."""
    own = {f"material.{name}": value for name, value in OWN.get(law, {}).items()}
    return sc.Scene.from_dict(spread({"material.law": law, **own, **changes}))


def spread(changes: dict[str, Any]) -> dict[str, Any]:
    """The tables of the hanging filament with some keys changed; None takes one out."""
    tables = {name: dict(table) for name, table in HANGING.items()}
    for path, value in changes.items():
        table, _, key = path.partition(".")
        tables.setdefault(table, {})[key] = value
        if value is None:
            del tables[table][key]
    return tables


@pytest.mark.parametrize(
    ("law", "section"), few(zip(POLYMERS, ("circle", "sheet", "circle", "sheet"), strict=True), ("giesekus", "circle"))
)
def test_bending_fibres_are_the_same_in_c_and_close_the_audit(law: str, section: str) -> None:
    changes = {"filament.section": section, "filament.width": "20 mm" if section == "sheet" else None}
    changes |= {} if section == "sheet" else {"filament.width": "2 mm"}
    runs = [sc.simulate(hanging(law, **changes, **{"numerics.backend": b})) for b in ("compiled", "interpreted")]
    heights = [run.data.midpoint.values for run in runs]
    assert heights[0][-1] < -0.01
    assert heights[0] == pytest.approx(heights[1], rel=1e-6, abs=1e-9)
    assert all(run.summary["energy_residual"] < 1e-7 for run in runs)


def weak(law: str, load: float) -> Floats:
    """Midpoint under a small weight, of chains and of the linear law beside the same solvent."""
    changes: dict[str, Any] = {"load.gravity": load, "numerics.rtol": 1e-10}
    if law == "maxwell":
        changes |= {"material.relaxation_time": None, "material.viscosity": 300.0, "material.solvent_viscosity": None}
        changes |= {"material.solid_viscosity": 30.0}
        effects = ["solid-damping" if name == "viscous-stress" else name for name in HANGING["run"]["effects"]]
        changes["run.effects"] = effects
    return np.asarray(sc.simulate(hanging(law, **changes)).data.midpoint.values)


def test_at_small_strain_all_are_maxwell_beside_a_solvent() -> None:
    """The sag goes as the load, and what differs from it as its square: the axial strain is of that order."""
    apart = []
    for load in (1e-2, 1e-3):
        expected = weak("maxwell", load)
        apart.append(np.max(np.abs(weak("giesekus", load) - expected)) / np.max(np.abs(expected)))
    assert apart[1] < 1e-6
    assert apart[0] / apart[1] > 8


def tension(law: str, **changes: Any) -> Floats:
    """Stress of a drawn bar at the end of it; of other laws the same bar."""
    scene = bar("oldroyd-b", lambda t: 1 + t, 0.5, 1, **{"numerics.backend": "compiled", "run.frames": 6})
    if law != "oldroyd-b":
        other = {"material.law": law, "material.relaxation_time": None, "material.solvent_viscosity": None}
        effects = [name for name in scene.run.effects if name != "viscous-flow"]
        scene = scene.replace(other | {"run.effects": effects} | changes)
    else:
        scene = scene.replace(changes)
    data = sc.simulate(scene).data
    return np.asarray((data.tension * data.stretch)[1:, 0]) / (np.pi / 4 * 0.05**2)


def test_without_memory_they_are_a_newtonian_fluid() -> None:
    """At first order in the relaxation time, the viscosity E lambda kept."""
    eta = 3.0
    expected = tension("newtonian", **{"material.youngs_modulus": None, "material.viscosity": f"{eta + SOLVENT} Pa*s"})
    apart = []
    for late in (4e-3, 2e-3):
        short = {"material.relaxation_time": f"{late} s", "material.youngs_modulus": f"{eta / late} Pa"}
        apart.append(np.max(np.abs(tension("oldroyd-b", **short) / expected - 1)))
    assert apart[1] < 0.01
    assert apart[0] / apart[1] == pytest.approx(2, rel=0.05)


def test_with_a_memory_for_ever_they_are_a_rubber() -> None:
    """G (s^2 - 1/s), which the bar is without flow, at first order in 1/lambda."""
    frames = np.linspace(0.1, 0.5, 5)
    s = 1 + frames
    solid = {"run.effects": [*STRING, "viscous-stress"]}
    rubber = G * (s**2 - 1 / s) + SOLVENT / s
    assert tension("oldroyd-b", **solid) == pytest.approx(rubber, rel=1e-6)
    apart = [
        np.max(np.abs(tension("oldroyd-b", **{"material.relaxation_time": f"{late} s"}) / rubber - 1))
        for late in (1e3, 2e3)
    ]
    assert apart[0] < 1e-3
    assert apart[0] / apart[1] == pytest.approx(2, rel=0.02)


def necked(law: str, moving: bool) -> sc.Run:
    """A bar of uneven thickness that is drawn, with the gradient term of its necks."""
    laws: dict[str, dict[str, Any]] = {
        "maxwell": {"law": "maxwell", "youngs_modulus": 3e4, "viscosity": 3e3},
        "oldroyd-b": {"law": "oldroyd-b", "youngs_modulus": 3e4, "relaxation_time": 0.1, "solvent_viscosity": 100.0},
    }
    resists = ["viscous-stress"] if law == "oldroyd-b" else []
    return sc.simulate(
        sc.Scene.from_dict(
            {
                "filament": HANGING["filament"] | {"profile": [1, 0.9, 1, 1, 0.95, 1.1]},
                "material": laws[law],
                "ends": {"left": "pinned", "right": "pinned"}
                | ({"motion": [[0.0, 0.0, 0.0], [0.2, 0.05, 0.0]]} if moving else {}),
                "run": {"duration": 0.2, "frames": 11}
                | {"effects": [*STRING, "viscous-flow", "necking-gradient", *resists]},
                "numerics": {"cells": 8, "rtol": 1e-8, "estimate": False, "backend": "compiled"},
            }
        )
    )


@pytest.mark.parametrize("law", ["maxwell", "oldroyd-b"])
def test_the_gradient_of_a_neck_takes_power_at_a_support_that_moves(law: str) -> None:
    run = necked(law, moving=True)
    assert float(np.abs(run.data.energy_gradient).max()) > 1e-9 * float(run.data.energy_elastic.max())
    assert run.summary["energy_residual"] < 1e-8


def test_auto_resolves_what_bends_and_a_list_must() -> None:
    chosen = sc.explain(hanging(**{"run.effects": "auto", "numerics.fibres": None})).in_force
    assert {"bending", "fibres", "viscous-flow"} <= set(chosen)
    assert "shear" not in chosen
    for effects in ("paper", [*STRING, "bending", "viscous-flow", "viscous-stress"]):
        with pytest.raises(sc.SceneError, match=r"run.effects: 'bending' without 'fibres'"):
            sc.explain(hanging(**{"run.effects": effects, "numerics.fibres": None}))


REFUSED: list[tuple[dict[str, Any], str, str]] = [
    ({"material.relaxation_time": None}, "material.relaxation_time", "missing: the law 'oldroyd-b' needs it"),
    ({"material.relaxation_time": "0 s"}, "material.relaxation_time", "zero"),
    ({"material.relaxation_time": "3 Pa"}, "material.relaxation_time", "is a stress, not a time"),
    ({"material.solvent_viscosity": None}, "material.solvent_viscosity", "missing: the law 'oldroyd-b' needs it"),
    ({"material.solvent_viscosity": "-1 Pa*s"}, "material.solvent_viscosity", "is negative"),
    ({"material.shear_solvent_viscosity": "1 Pa*s"}, "material.solvent_viscosity", "given twice"),
    ({"material.viscosity": "1 Pa*s"}, "material.viscosity", "does not flow"),
    ({"material.mobility": 0.2}, "material.mobility", "the law 'oldroyd-b' does not use it"),
    ({"material.law": "giesekus", "material.mobility": 1.0}, "material.mobility", "out of range"),
    ({"material.law": "fene-p", "material.finite_extensibility": 3}, "material.finite_extensibility", "out of range"),
    ({"material.law": "ptt", "material.ptt_epsilon": "a"}, "material.ptt_epsilon", "is not a number"),
    ({"material.law": "maxwell", "material.viscosity": "1 Pa*s"}, "material.relaxation_time", "does not use it"),
    ({"material.poisson": 0.3}, "material.poisson", "keep their volume"),
    ({"material.loss_tangent": 0.1}, "material.loss_tangent", "has this viscosity as material.solvent_viscosity"),
    ({"model": "small-deflection"}, "material.law", "with model 'small-deflection'"),
]


@pytest.mark.parametrize(("changes", "path", "found"), REFUSED)
def test_refused(changes: dict[str, Any], path: str, found: str) -> None:
    tables = spread({key: value for key, value in changes.items() if "." in key})
    tables |= {key: value for key, value in changes.items() if "." not in key}
    with pytest.raises(sc.SceneError) as error:
        sc.Scene.from_dict(tables)
    assert any(fault.path == path and found in fault.found for fault in error.value.faults), str(error.value)


def test_shear_and_the_printed_closure_are_refused() -> None:
    for changes, found in (
        ({"run.effects": [*HANGING["run"]["effects"], "shear"]}, "its law is one of polymer chains"),
        ({"run.closure": "printed", "run.effects": "auto", "numerics.fibres": None}, "which has no polymer chains"),
    ):
        with pytest.raises(sc.SceneError, match=found):
            sc.simulate(hanging(**changes))
