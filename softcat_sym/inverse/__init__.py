"""From measurements to constants of a law. What an import does not need is loaded when it is used."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softcat_sym.inverse.design import CriticalSpan, Experiment, critical_span, design_experiment
    from softcat_sym.inverse.estimation.least_squares import Loss
    from softcat_sym.inverse.filament_fit import fit
    from softcat_sym.inverse.fit_outcome import FitOutcome
    from softcat_sym.inverse.fitted import Fit, FittedParameter
    from softcat_sym.inverse.flow_curve.candidate import Candidate
    from softcat_sym.inverse.flow_curve.curve import FlowCurve, read_flow_curve
    from softcat_sym.inverse.flow_curve.curve_fit import FlowCurveFit, fit_flow_curve
    from softcat_sym.inverse.flow_curve.handing_on import fitted_scene
    from softcat_sym.inverse.laws import LawComparison, fit_laws
    from softcat_sym.inverse.measurements.reading import read_measurements
    from softcat_sym.inverse.measurements.series import Measurements, Series, Shapes

_HOMES = {
    "Candidate": "flow_curve.candidate",
    "CriticalSpan": "design",
    "Experiment": "design",
    "Fit": "fitted",
    "FitOutcome": "fit_outcome",
    "FittedParameter": "fitted",
    "FlowCurve": "flow_curve.curve",
    "FlowCurveFit": "flow_curve.curve_fit",
    "LawComparison": "laws",
    "Loss": "estimation.least_squares",
    "Measurements": "measurements.series",
    "Series": "measurements.series",
    "Shapes": "measurements.series",
    "critical_span": "design",
    "design_experiment": "design",
    "fit": "filament_fit",
    "fit_flow_curve": "flow_curve.curve_fit",
    "fit_laws": "laws",
    "fitted_scene": "flow_curve.handing_on",
    "read_flow_curve": "flow_curve.curve",
    "read_measurements": "measurements.reading",
}

__all__ = [
    "Candidate",
    "CriticalSpan",
    "Experiment",
    "Fit",
    "FitOutcome",
    "FittedParameter",
    "FlowCurve",
    "FlowCurveFit",
    "LawComparison",
    "Loss",
    "Measurements",
    "Series",
    "Shapes",
    "critical_span",
    "design_experiment",
    "fit",
    "fit_flow_curve",
    "fit_laws",
    "fitted_scene",
    "read_flow_curve",
    "read_measurements",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'softcat_sym.inverse' has no attribute {name!r}; it has {', '.join(__all__)}")
    return getattr(importlib.import_module(f"softcat_sym.inverse.{_HOMES[name]}"), name)
