"""The graph of the small-deflection model is printed from what the notebook proves."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.physics import small_deflection as small
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import CIRCLE, RECTANGLE


def test_the_section_is_the_one_that_was_proved() -> None:
    for shape in [RECTANGLE, CIRCLE]:
        for flows in [True, False]:
            changes: dict[str, object] = {"model": "small-deflection"}
            scene = sc.load_scene("maxwell-slow", changes)
            if not flows:
                scene = scene.replace({"material.law": "elastic", "material.viscosity": None})
            response = derive(choose_effects(scene).terms(), shape, "material").response
            proved = small.small_deflection(shape, flows=flows)
            renamed = {sy.s: 1 + small.e_mean, sy.theta_X: small.y_XX}
            for name in (
                "stress_mean",
                "stress_bending",
                "tension",
                "moment",
                "rate_mean",
                "rate_bending",
                "elastic_mean",
                "elastic_bending",
                "dissipation_mean",
                "dissipation_bending",
            ):
                part = response if hasattr(response, name) else response.branch
                assert sp.simplify(getattr(part, name).subs(renamed) - getattr(proved, name)) == 0, name
            equations = derive(choose_effects(scene).terms(), shape, "material")
            vertical = equations.force.vertical.subs(sy.Q, sy.T)
            assert sp.simplify(vertical - proved.vertical_force) == 0
            assert sp.simplify(equations.terms.centreline.stretch.subs(sy.x_X, 1) - 1 - proved.elongation) == 0


def test_a_yielding_law_is_refused() -> None:
    scene = sc.load_scene("arrested-overdamped", {"model": "small-deflection"})
    with pytest.raises(SceneError, match=r"material\.law"):
        sc.simulate(scene)


def test_energy_closes_and_supports_stay_where_they_are() -> None:
    run = sc.simulate(sc.load_scene("maxwell-fast", {"model": "small-deflection", "numerics.cells": 20}))
    assert run.outcome is sc.Outcome.solved
    assert run.summary["energy_residual"] < 1e-4
    x = run.data.x.values
    np.testing.assert_allclose(x[:, [0, -1]], np.array([[-0.1, 0.1]]).repeat(len(x), 0), atol=1e-15)
    assert np.ptp(run.data.tension.values, axis=1).max() == 0


def test_a_pinned_and_a_lopsided_filament_run_too() -> None:
    for ends in ({"ends.left": "pinned", "ends.right": "pinned"}, {"ends.right": "pinned"}):
        scene = sc.load_scene("maxwell-fast", {"model": "small-deflection", "numerics.cells": 10, **ends})
        full = sc.simulate(scene.replace({"model": "filament"}))
        reduced = sc.simulate(scene)
        assert reduced.outcome is sc.Outcome.solved
        final, other = (run.summary["midpoint_final_m"] for run in (full, reduced))
        assert abs(other / final - 1) < 0.02
