"""A fit whose best filament cannot be trusted as a run is not called solved, however well it fits."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.fit import Fit, FitOutcome, fit
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.results import trajectory, verdict
from tests.inverse.filmed import film, scene

NECK = "the cell at X/L = 0.49 carries 60%"


def fitted(*free: str, wave: float = 0.0) -> Fit:
    time, height = film()
    height = height + wave * np.sin(40 * time / time[-1])
    return fit(Measurements.of(time, height), scene(), free or ["viscosity"], starts=0, profiles=False)


def test_a_run_that_is_solved_changes_nothing() -> None:
    found = fitted()
    assert (found.outcome, found.message) == (FitOutcome.solved, "")


def test_a_neck_that_the_grid_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verdict, "neck_that_the_grid_decides", lambda stretch, length, neck: NECK)
    found = fitted()
    assert found.parameters["viscosity"].verdict == "identified"
    assert found.outcome is FitOutcome.localised
    assert found.outcome.converged
    assert "localised" in found.message and NECK in found.message


def test_lost_energy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trajectory, "energy_residual", lambda fields, least: 0.5)
    found = fitted()
    assert found.outcome is FitOutcome.run_in_doubt
    assert "energy residual 0.5" in found.message
    # A graver word stays; the complaint is told beside it.
    other = fitted(wave=2e-3)
    assert other.outcome is FitOutcome.model_error
    assert "energy residual 0.5" in other.message


def test_the_run_is_that_of_the_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the fitted value, the effects of the fit, and for as long as it was filmed."""
    from softcat_sym.fitting import fit as fitted_run

    asked: list[sc.Scene] = []

    def simulate(one: sc.Scene) -> sc.Trajectory:
        asked.append(one)
        return sc.simulate(one)

    monkeypatch.setattr(fitted_run, "recalled", simulate)
    found = fitted("viscosity", "time_offset")
    (one,) = asked
    assert one.material.viscosity == pytest.approx(found.parameters["viscosity"].best)
    assert tuple(one.run.effects) == found.effects
    offset = found.parameters["time_offset"].best
    assert offset != 0
    assert one.run.duration == pytest.approx(float(film()[0].max()) - offset)


def test_a_filament_that_cannot_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    from softcat_sym.fitting import fit as fitted_run

    def refused(one: sc.Scene) -> sc.Trajectory:
        raise sc.SceneError([])

    monkeypatch.setattr(fitted_run, "recalled", refused)
    assert fitted().outcome is FitOutcome.run_in_doubt
