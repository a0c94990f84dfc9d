"""Interpreted by CasADi or compiled from generated C: which a run gets, and why."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from softcat_sym.effects import Effects
from softcat_sym.errors import Fault, SceneError
from softcat_sym.native import find_compiler
from softcat_sym.scene import Scene

_HERE = "numerics.backend"

ONE_TENSION = "the tension of the small-deflection model is one number for all cells, not a row of sites"
NOTHING_TO_INTEGRATE = "without inertia or flow there is nothing to integrate, only a row of equilibria"


@dataclass(frozen=True, slots=True)
class Backend:
    """What evaluates the right-hand side.

    Attributes
    ----------
    compiled : bool
        Whether generated C does, its integrator included; otherwise CasADi interprets the graph.
    reason : str
        By which compiler, or why not.
    """

    compiled: bool
    reason: str

    def __str__(self) -> str:
        return f"{'compiled' if self.compiled else 'interpreted'}: {self.reason}"


def choose_backend(scene: Scene, effects: Effects) -> Backend:
    """Choose the backend: compiled where there is a compiler and the filament has a compiled form.

    Raises
    ------
    SceneError
        If the scene asks for the compiled one and cannot have it.
    """
    asked = scene.numerics.backend
    if asked == "interpreted":
        return Backend(False, "named in numerics.backend")
    obstacle = _obstacle(scene, effects, asked)
    if not obstacle:
        compiler = find_compiler()
        if compiler is not None:
            return Backend(True, compiler.version)
        obstacle = "there is no C compiler that runs: install gcc or clang, or set CC"
    if asked == "compiled":
        raise SceneError([Fault(_HERE, f"'compiled', but {obstacle}", "auto or interpreted")])
    return Backend(False, obstacle)


def integrates(effects: Collection[str]) -> bool:
    """Whether a filament with these effects is carried through time, rather than from equilibrium to equilibrium."""
    return bool({"inertia", "viscous-flow", "viscous-stress"} & set(effects))


def _obstacle(scene: Scene, effects: Effects, asked: str) -> str:
    """Why the filament has no compiled form; empty if it has one."""
    if scene.model == "small-deflection":
        return ONE_TENSION
    if scene.numerics.solver in ("cvodes", "idas") and asked == "auto":
        return f"{scene.numerics.solver} is named in numerics.solver, and rarely runs faster on compiled expressions"
    if not integrates(effects.names):
        return NOTHING_TO_INTEGRATE
    return ""
