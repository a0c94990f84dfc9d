"""A stage outside what is elastic is a step too long, not the end of a run."""

from __future__ import annotations

import softcat_sym as sc

from .dimensionless import asked

_HELD = {
    "model": "filament",
    "filament": {
        "span": "1.11190141824571 mm",
        "thickness": "28.079849475522107 um",
        "section": "rectangle",
        "density": "1078.8636207580566 kg/m^3",
    },
    "material": {
        "law": "herschel-bulkley",
        "youngs_modulus": "12.13043358084902 Pa",
        "yield_stress": "58.35638266760707 Pa",
        "viscosity": "6.521413200232844 Pa*s**0.5526208877563477",
        "index": 0.5526208877563477,
        "poisson": 0.41681327819824215,
    },
    "ends": {"left": "pinned", "right": "pinned", "drop": "-0.26118214130795454 mm"},
    "load": {"gravity": "1.0030146277762089 m/s^2", "point_mass": "4.627682334030259e-10 kg"},
    "initial": {"C": [-0.002525351667895527, -0.0025003043102372973, -0.002496007725039001, -0.002524797735947316]},
    "run": {"duration": "33.79127320727897 ms", "frames": 7, "accuracy": 0.03},
    "numerics": {"backend": "interpreted", "estimate": False, "cells": 11},
}
"""Drawn by Hypothesis: a soft filament with a point mass that stretches far beyond its length."""


def test_a_run_with_an_undefined_stage_is_repeated_with_shorter_steps() -> None:
    scene = sc.Scene.model_validate(_HELD)
    repeated = sc.simulate(scene)
    # A tolerance that is named is kept: what fails with it is given rotary inertia instead, where angles have a rate.
    first = sc.simulate(scene.replace({"numerics.rtol": 3.6e-4}))
    other = sc.simulate(scene.replace({"numerics.solver": "idas", "numerics.rtol": 1e-6}))
    assert first.summary["repeats"] == ["rotary-inertia: the run without it failed"]
    assert repeated.summary["repeats"] == []
    assert repeated.outcome is sc.Outcome.solved
    assert other.outcome is sc.Outcome.solved
    ours, theirs = (float(run.data["midpoint"][-1]) for run in (repeated, other))
    assert abs(ours - theirs) < 1e-3 * abs(theirs)


def test_a_string_without_bending_that_is_pushed_is_refused_with_the_reason() -> None:
    inwards = {"motion": [(0, 0, 0), (10, -0.2, 0)]}
    string = ("inertia", "finite-stretch", "thinning", "large-rotation")
    scene = asked("elastic", E=100, T=2, frames=21, effects=string, ends=inwards, numerics={"estimate": False})
    run = sc.simulate(scene)
    assert run.outcome is sc.Outcome.compressed
    assert "without bending" in run.summary["message"]
