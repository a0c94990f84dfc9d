"""softcat_sym: slender soft filaments that sag, stretch, yield and stop.

``load_scene`` reads a scene, ``explain`` says what it calls for, ``simulate`` runs it, ``open_run`` reads a run again,
``generate`` writes it as C; every function that takes a scene also takes its name, its path or a dict.
``simulate_many`` runs a table of them, ``sweep`` any number; ``price_effects`` tells what each effect is worth; ``fit``
finds the material of a filament that was filmed, ``card`` puts all on one page. SymPy, CasADi and matplotlib are loaded
when they are first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

# Not lazily: the function must take the place of its module's name in this package.
from softcat_sym.simulate import simulate

if TYPE_CHECKING:
    from softcat_sym.ensemble import Ensemble, simulate_many
    from softcat_sym.errors import SceneError, SoftcatError, SoftcatWarning
    from softcat_sym.generating import generate
    from softcat_sym.inverse import Fit, Measurements, fit, fit_flow_curve
    from softcat_sym.scene import Scene, bundled_names, load_scene
    from softcat_sym.solve import Outcome
    from softcat_sym.study.card import Card, card
    from softcat_sym.study.explanation import Explanation, explain
    from softcat_sym.study.pricing import Pricing, price_effects
    from softcat_sym.study.sweep import Sweep, sweep
    from softcat_sym.trajectory import Trajectory, open_run

    __version__: str

_HOMES = {
    "Card": "softcat_sym.study.card",
    "Ensemble": "softcat_sym.ensemble",
    "Explanation": "softcat_sym.study.explanation",
    "Fit": "softcat_sym.inverse",
    "Measurements": "softcat_sym.inverse",
    "Outcome": "softcat_sym.solve",
    "Pricing": "softcat_sym.study.pricing",
    "Scene": "softcat_sym.scene",
    "SceneError": "softcat_sym.errors",
    "SoftcatError": "softcat_sym.errors",
    "SoftcatWarning": "softcat_sym.errors",
    "Sweep": "softcat_sym.study.sweep",
    "Trajectory": "softcat_sym.trajectory",
    "bundled_names": "softcat_sym.scene",
    "card": "softcat_sym.study.card",
    "explain": "softcat_sym.study.explanation",
    "fit": "softcat_sym.inverse",
    "fit_flow_curve": "softcat_sym.inverse",
    "generate": "softcat_sym.generating",
    "load_scene": "softcat_sym.scene",
    "open_run": "softcat_sym.trajectory",
    "price_effects": "softcat_sym.study.pricing",
    "simulate_many": "softcat_sym.ensemble",
    "sweep": "softcat_sym.study.sweep",
}

__all__ = [
    "Card",
    "Ensemble",
    "Explanation",
    "Fit",
    "Measurements",
    "Outcome",
    "Pricing",
    "Scene",
    "SceneError",
    "SoftcatError",
    "SoftcatWarning",
    "Sweep",
    "Trajectory",
    "bundled_names",
    "card",
    "explain",
    "fit",
    "fit_flow_curve",
    "generate",
    "load_scene",
    "open_run",
    "price_effects",
    "simulate",
    "simulate_many",
    "sweep",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("softcat_sym")
    try:
        home = _HOMES[name]
    except KeyError:
        raise AttributeError(f"module 'softcat_sym' has no attribute {name!r}; it has {', '.join(__all__)}") from None
    return getattr(importlib.import_module(home), name)


def __dir__() -> list[str]:
    return list(__all__)
