"""Experiments designed before they are made: what to film, and how far a filament may span."""

from softcat_sym.inverse.design.critical_span import CriticalSpan, critical_span
from softcat_sym.inverse.design.experiment import Experiment, design_experiment
from softcat_sym.inverse.design.trial import Trial

__all__ = ["CriticalSpan", "Experiment", "Trial", "critical_span", "design_experiment"]
