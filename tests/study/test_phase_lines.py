"""Lines of a phase plane against their limits, and boundaries read off a lattice that is known."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.forecast import overshoot, rebound
from softcat_sym.studies.phase import SETTINGS, PhaseLine, crossings, distances, phase_lines
from softcat_sym.studies.phase_runs import PLANES

LAPLACE = 0.6627434193491816
"""Laplace limit constant, max of u/cosh u; no catenary carries itself beyond G = 2 of it."""

SCENE = sc.load_scene("arrested-overdamped", list(SETTINGS))
THIN = PLANES["G-delta"]


def lines_of(scene: sc.Scene, plane: str = "G-delta") -> dict[str, PhaseLine]:
    return {line.name: line for line in phase_lines(scene, PLANES[plane], 9)}


def test_papers_lines_and_the_exact_threshold() -> None:
    lines = lines_of(SCENE)
    np.testing.assert_allclose(lines["first yield of a beam"].G, 2 * lines["first yield of a beam"].other)
    np.testing.assert_allclose(lines["arrest of a shallow catenary"].G, np.sqrt(2))
    np.testing.assert_allclose(lines["arrest of the exact catenary"].G, 2 * LAPLACE, rtol=1e-12)
    np.testing.assert_allclose(lines["sudden load, undamped beam"].G, lines["sudden load, undamped beam"].other)


def test_tension_matters_for_thin_and_soft_filaments_only() -> None:
    slow = "slow load, bending and tension"
    soft, stiff = (lines_of(SCENE.replace({"material.youngs_modulus": E}))[slow] for E in ("4 MPa", "4e5 MPa"))
    # A stiff filament yields before it sags: the linear beam's 2 delta.
    np.testing.assert_allclose(stiff.G[stiff.other > 0.02], 2 * stiff.other[stiff.other > 0.02], rtol=0.02)
    assert soft.G[0] > 1.5 * 2 * soft.other[0]
    # A taut string with sharply bent ends: G ~ eps_Y^(1/2) and eps_Y = 1/(G E*), so G ~ E*^(-1/3), whatever delta.
    softer = lines_of(SCENE.replace({"material.youngs_modulus": "4 MPa", "filament.thickness": "0.2 mm"}), "G-V")[slow]
    # Stress over rho g L of that string, (E*/24)^(1/3), and of its bent end, sqrt(3 E*/tension)/2, by hand.
    modulus = 4e6 / (1900 * 9.81 * 0.2)
    tension = (modulus / 24) ** (1 / 3)
    assert softer.G[0] == pytest.approx(1 / (tension + np.sqrt(3 * modulus / tension) / 2), rel=0.02)
    softest = lines_of(SCENE.replace({"material.youngs_modulus": "0.5 MPa", "filament.thickness": "0.2 mm"}), "G-V")
    assert softest[slow].G[0] / softer.G[0] == pytest.approx(2.0, rel=0.02)


def test_a_ramp_lies_between_sudden_and_slow() -> None:
    ramps = {ramp: SCENE.replace({"load.ramp": f"{ramp} s"}) for ramp in (1e-6, 1e3)}
    found = {ramp: lines_of(scene, "G-V") for ramp, scene in ramps.items()}
    ramped = "this ramp, first mode"
    assert found[1e-6][ramped].G[0] == pytest.approx(0.03, rel=1e-3)
    assert found[1e3][ramped].G[0] == pytest.approx(found[1e3]["slow load, bending and tension"].G[0], rel=1e-3)


def test_spring_back_is_the_share_that_counts_as_underdamped() -> None:
    line = lines_of(SCENE, "G-V")["spring-back of 5 %"]
    modulus, ramp = 4e6 / (1900 * 9.81 * 0.2), SCENE.load.ramp * np.sqrt(9.81 / 0.2)
    for V, G in zip(line.other, line.G, strict=True):
        past = overshoot(float(G), float(V), float(ramp))
        assert rebound(float(G), 1 / (modulus * float(G)), past) == pytest.approx(0.05, rel=0.01)


def test_crossings_and_distances_of_a_known_lattice() -> None:
    G, V = np.geomspace(0.01, 3, 41), np.geomspace(0.1, 100, 5)
    marks = np.empty((41, 5), dtype="<U24")
    for i, value in enumerate(G):
        below = "arrested-underdamped" if value < 0.3 else "arrested-overdamped"
        marks[i, :] = "no-yield" if value < 0.06 else below if value < 1 else "descending-at-clamps"
    marks[G > 2, :] = "descending"
    marks[(G > 0.9) & (G < 1.3), 0] = "localised"
    found = crossings(G, V, marks)
    rows = {kind: [one for one in found if one.kind == kind] for kind in ("first yield", "overdamping", "arrest")}
    assert [len(rows[kind]) for kind in rows] == [5, 5, 4]  # none beside a run that is no answer
    assert all(one.G_low < 0.06 <= one.G_high for one in rows["first yield"])
    assert all(one.G_low < 1 <= one.G_high for one in rows["arrest"])
    span = [one for one in found if one.kind == "arrest of the span"]
    assert len(span) == 5
    assert all(one.G_low <= 2 < one.G_high for one in span)
    line = PhaseLine("half as much", "first yield", "paper", "", V, np.full(5, 0.03))
    [distance] = distances([line], found)
    assert distance.rows == 5
    assert distance.median == pytest.approx(rows["first yield"][0].G / 0.03 - 1)
