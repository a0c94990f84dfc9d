"""The result of a run, with its energy audit, regime and verdict."""

from softcat_sym.trajectory.stored_run import open_run
from softcat_sym.trajectory.trajectory import Trajectory, judge

__all__ = ["Trajectory", "judge", "open_run"]
