"""A Graph is integrated in time; the Outcome says how that went."""

from softcat_sym.solve.backend import Backend, choose_backend
from softcat_sym.solve.interrupts import watched
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Progress, Silence
from softcat_sym.solve.run import Prepared, prepare
from softcat_sym.solve.settings import Settings, choose_settings, compiled_settings, settings_for
from softcat_sym.solve.solution import Solution
from softcat_sym.solve.starting import Start

__all__ = [
    "Backend",
    "Outcome",
    "Prepared",
    "Progress",
    "Settings",
    "Silence",
    "Solution",
    "Start",
    "choose_backend",
    "choose_settings",
    "compiled_settings",
    "prepare",
    "settings_for",
    "watched",
]
