"""Sweeps: a scene run for every value of some parameters, in constant memory, resumable, on cores or a cluster."""

from softcat_sym.study.sweep.plan import SweepPlan, plan_sweep
from softcat_sym.study.sweep.result import Sweep
from softcat_sym.study.sweep.running import run_sweep, sweep

__all__ = ["Sweep", "SweepPlan", "plan_sweep", "run_sweep", "sweep"]
