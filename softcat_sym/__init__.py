"""softcat_sym: slender soft filaments that sag, stretch, yield and stop.

``load_scene`` reads a scene, ``explain`` says what it calls for, ``simulate`` runs it, ``open_run`` reads a run again,
``generate`` writes it as C, ``live_page`` as a page with sliders; every function that takes a scene also takes its
name, its path or a dict. ``simulate_many`` runs a table of them, ``sweep`` any number; ``price_effects`` tells what
each effect is worth; ``longest_span`` how far a filament reaches, ``bridges`` how much it sags over each of many spans;
``track`` reads a film, ``fit`` finds the material of a filament that was filmed, ``read_material`` that of a
rheometer's files; ``card`` puts all on one page; ``register_effect`` adds physics. SymPy, CasADi and matplotlib are
loaded when they are first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

# Not lazily: the function must take the place of its module's name in this package.
from softcat_sym.simulate import simulate

if TYPE_CHECKING:
    from softcat_sym.batch.ensemble import Ensemble, simulate_many
    from softcat_sym.batch.sweep import Sweep, sweep
    from softcat_sym.design.bridges import BridgeTable, bridges
    from softcat_sym.design.critical_span import longest_span
    from softcat_sym.effects.effect import Effect, EffectConstant, Estimate
    from softcat_sym.effects.registry import register_effect
    from softcat_sym.errors import SceneError, SoftcatError, SoftcatWarning
    from softcat_sym.fitting.closed_form import closed_form
    from softcat_sym.fitting.fit import fit
    from softcat_sym.fitting.flow_curve import fit_flow_curve
    from softcat_sym.fitting.measurements import Measurements
    from softcat_sym.fitting.result import Fit
    from softcat_sym.fitting.rheometer import read_material
    from softcat_sym.generation import generate
    from softcat_sym.results.run import Run, open_run
    from softcat_sym.scene.bundled import bundled_names
    from softcat_sym.scene.reading import load_scene
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.outcome import Outcome
    from softcat_sym.studies.card import Card, card
    from softcat_sym.studies.effect_importance import Pricing, price_effects
    from softcat_sym.studies.explanation import Explanation, explain
    from softcat_sym.tracking.result import Track
    from softcat_sym.tracking.track import track
    from softcat_sym.web.page import live_page

    __version__: str

_HOMES = {
    "effects.effect": ("Effect", "EffectConstant", "Estimate"),
    "effects.registry": ("register_effect",),
    "batch.ensemble": ("Ensemble", "simulate_many"),
    "design.bridges": ("BridgeTable", "bridges"),
    "design.critical_span": ("longest_span",),
    "errors": ("SceneError", "SoftcatError", "SoftcatWarning"),
    "fitting.closed_form": ("closed_form",),
    "fitting.fit": ("fit",),
    "fitting.result": ("Fit",),
    "fitting.flow_curve": ("fit_flow_curve",),
    "fitting.measurements": ("Measurements",),
    "fitting.rheometer": ("read_material",),
    "generation": ("generate",),
    "results.run": ("Run", "open_run"),
    "scene.bundled": ("bundled_names",),
    "scene.reading": ("load_scene",),
    "scene.scene": ("Scene",),
    "solvers.outcome": ("Outcome",),
    "studies.card": ("Card", "card"),
    "studies.explanation": ("Explanation", "explain"),
    "studies.effect_importance": ("Pricing", "price_effects"),
    "batch.sweep": ("Sweep", "sweep"),
    "tracking.result": ("Track",),
    "tracking.track": ("track",),
    "web.page": ("live_page",),
}

__all__ = [
    "BridgeTable",
    "Card",
    "Effect",
    "EffectConstant",
    "Ensemble",
    "Estimate",
    "Explanation",
    "Fit",
    "Measurements",
    "Outcome",
    "Pricing",
    "Run",
    "Scene",
    "SceneError",
    "SoftcatError",
    "SoftcatWarning",
    "Sweep",
    "Track",
    "bridges",
    "bundled_names",
    "card",
    "closed_form",
    "explain",
    "fit",
    "fit_flow_curve",
    "generate",
    "live_page",
    "load_scene",
    "longest_span",
    "open_run",
    "price_effects",
    "read_material",
    "register_effect",
    "simulate",
    "simulate_many",
    "sweep",
    "track",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("softcat_sym")
    for home, names in _HOMES.items():
        if name in names:
            return getattr(importlib.import_module(f"softcat_sym.{home}"), name)
    raise AttributeError(f"module 'softcat_sym' has no attribute {name!r}; it has {', '.join(__all__)}")


def __dir__() -> list[str]:
    return list(__all__)
