"""Expected behaviour of a scene, with effects, equations and costs, before anything is integrated."""

from __future__ import annotations

import dataclasses
import math
import re
from collections import Counter
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.drawing import html
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.theory_limits import laying_note, theory_limits
from softcat_sym.estimates.expected_regime import ExpectedRegime, expected_regime
from softcat_sym.estimates.forecast import expected_sag, expected_strain
from softcat_sym.estimates.free_vibration import damping_note
from softcat_sym.estimates.span import DEFAULT_LIMIT, foreseen_span
from softcat_sym.scene.dimensions import is_spatial, reason_for_dimensions
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import groups_of
from softcat_sym.solvers.run_cost import run_cost
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.solvers.solve import assembled

if TYPE_CHECKING:
    from softcat_sym.physics.equation import Stated

GROUP_MEANINGS = {
    "delta": "thickness over span, h0/L [3.9]",
    "G": "weight over yield stress, rho g L/sigma_Y [3.10]",
    "V": "viscosity, eta/(rho sqrt(g L^3)) [3.10]",
    "eps_Y": "yield strain, sigma_Y/E [3.9]",
    "E_star": "modulus over weight, E/(rho g L)",
    "tau_star": "relaxation time eta/E in sqrt(L/g)",
    "B": "weight over viscosity, 1/(2 V)",
}

KINDS = {
    "x": "horizontal positions",
    "y": "heights",
    "z": "positions across the plane",
    "u": "horizontal velocities",
    "v": "vertical velocities",
    "w": "velocities across the plane",
    "q0": "cosines of half the turns of the sections, first of a unit quaternion",
    **{f"q{n}": f"sines of half the turns of the sections, along axis {n}" for n in (1, 2, 3)},
    **{f"o{n}": f"spins of the sections about their axis {n}" for n in (1, 2, 3)},
    "psi": "angles of the section",
    "omega": "rates of the angle of the section",
    "warming": "temperatures",
    "a_0": "axial plastic strains",
    "a_1": "bending plastic strains",
    "axial": "axial plastic strains, at every point through the thickness",
    "shear": "plastic shear strains, at every point through the thickness",
    **{f"shear{n}": f"plastic shear strains along axis {n}, at every point of the section" for n in (2, 3)},
    "chains_along": "relaxed part of the conformation along the fibres",
    "chains_across": "relaxed part of the conformation across the fibres",
    "chains_width": "relaxed part of the conformation in the width of a sheet",
}
_NUMBERS = re.compile(
    r"_mode\d+$|(?<=axial|shear|along|width)_\d+(_mode\d+)?$|(?<=shear2|shear3)_\d+(_mode\d+)?$|(?<=across)_\d+$"
)


@dataclass(frozen=True, slots=True)
class Explanation:
    """Everything that is known about a run beforehand.

    Attributes
    ----------
    title, law, model, closure, accuracy : str or float
        The scene's own, as it states them.
    dimensions : int
        2 where everything lies in one plane, or 3.
    dimensions_reason : str
        Why the filament is computed in so many dimensions.
    groups : list of dict
        Dimensionless groups of the law: `name`, `value` (None where it is infinite), `meaning`.
    regime : ExpectedRegime
        Regime that a run should show.
    sag, strain : float
        Rough largest sag over span, and mean strain.
    longest_span : float or None
        Rough longest span whose sag stays below 5 % of it [m]; None where the forecast knows none.
    effects : list of dict
        All effects, in the order of the registry: `effect`, `summary`, `in_force`, `reason`, and the change of the
        midpoint without it, `estimate` (None where there is no estimate), its `meaning` and `formula`.
    equations : tuple of Stated
        Equations in force.
    unknowns : list of dict
        Unknowns by `kind`: `meaning`, `number`, and `algebraic`, whether the unknown has no rate of its own.
    graph : dict
        Size of the graph: `cells` (of the half span where `half`), `differential`, `algebraic`, `instructions`,
        `parameters`.
    integrator : dict
        Settings of the integrator: `solver`, `backend`, `rtol`, `atol`, `reason`.
    damping, ringing : str
        First natural frequency with the loss below yield; duration and cost of the ringing. Empty if there is none.
    seconds : float
        What the run costs [s of the processor].
    laying : str
        Whether a nozzle at 10 mm/s would change the sag of what the scene releases at once; empty if not.
    warnings : tuple of str
        Sentences on limits of the theory.
    """

    title: str
    law: str
    model: str
    closure: str
    accuracy: float
    dimensions: int
    dimensions_reason: str
    groups: list[dict[str, Any]]
    regime: ExpectedRegime
    sag: float
    strain: float
    longest_span: float | None
    effects: list[dict[str, Any]]
    equations: tuple[Stated, ...]
    unknowns: list[dict[str, Any]]
    graph: dict[str, Any]
    integrator: dict[str, Any]
    damping: str
    ringing: str
    seconds: float
    laying: str
    warnings: tuple[str, ...]

    @property
    def in_force(self) -> tuple[str, ...]:
        """Names of the effects in force."""
        return tuple(each["effect"] for each in self.effects if each["in_force"])

    def to_dict(self) -> dict[str, Any]:
        """Content of ``explain.json``."""
        return dataclasses.asdict(self)

    def __repr__(self) -> str:
        lines = (
            f"Explanation {self.title!r}: {self.regime.name}",
            self.regime.reason,
            f"sag about {self.sag:.2g} of the span; about {self.seconds:.2g} s of the processor",
            f"effects {', '.join(self.in_force)}",
            *(f"warning: {text}" for text in self.warnings),
            ".effects, .equations, .groups, .regime, .graph, .integrator, .to_dict()",
        )
        return "\n  ".join(filter(None, lines))

    def _repr_html_(self) -> str:
        equations = (f"<p>{escape(one.name)}</p>$$ {escape(one.latex)} $$" for one in self.equations)
        return "".join([html(repr(self)), *equations])


def explain(scene: SceneLike, changes: Changes = ()) -> Explanation:
    """Predict the behaviour of a scene; equations and graph are built, nothing is integrated.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The filament.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Returns
    -------
    Explanation
        Groups, expected regime, each effect with its estimate and reason, equations, sizes, integrator, limits.

    Raises
    ------
    SceneError
        If the scene names effects that it cannot have.
    """
    # The equations need SymPy, which is loaded only here.
    from softcat_sym.physics.section_equations import equations_of
    from softcat_sym.physics.written_equations import equations_in_force

    scene = as_scene(scene, changes)
    effects = choose_effects(scene)
    filament = assembled(scene, effects)
    graph, regime = filament.graph, expected_regime(scene, effects.names)
    decisions = [
        {
            "effect": decision.effect.name,
            "summary": decision.effect.summary,
            "in_force": decision.in_force,
            "estimate": decision.estimate.value if decision.estimate else None,
            "meaning": decision.estimate.meaning if decision.estimate else "",
            "formula": decision.estimate.formula if decision.estimate else "",
            "reason": decision.why,
        }
        for decision in effects.decisions
    ]
    groups = groups_of(scene)
    known = {name: getattr(groups, name) for name in GROUP_MEANINGS}
    # The plastic states of all points through the thickness, and of all modes, are one kind of unknown.
    unknowns = [
        {"kind": kind, "meaning": KINDS.get(kind, "plastic strains"), "number": number, "algebraic": algebraic}
        for kinds, algebraic in ((graph.differential.kinds, False), (graph.algebraic.kinds, True))
        for kind, number in Counter(_NUMBERS.sub("", kind) or kind for kind in kinds).items()
    ]
    values = parameter_values(scene)
    size: dict[str, Any] = {
        "cells": graph.grid.cells,
        "half": graph.grid.is_half,
        "differential": len(graph.start),
        "algebraic": len(graph.straight),
        "instructions": graph.symbolic.instructions,
        "parameters": {name: float(values[name]) for name in graph.parameters},
    }
    backend = choose_backend(scene, effects)
    settings = settings_for(scene, effects, compiled=backend.compiled)
    price = run_cost(scene, effects)
    return Explanation(
        title=scene.title,
        law=scene.material.law,
        model=scene.model,
        closure=scene.run.closure,
        accuracy=scene.run.accuracy,
        dimensions=3 if is_spatial(scene) else 2,
        dimensions_reason=reason_for_dimensions(scene),
        groups=[
            {"name": name, "value": float(value) if value < math.inf else None, "meaning": GROUP_MEANINGS[name]}
            for name, value in known.items()
            if value is not None
        ],
        regime=regime,
        sag=expected_sag(scene),
        longest_span=foreseen_span(scene, DEFAULT_LIMIT),
        strain=expected_strain(scene),
        effects=decisions,
        equations=equations_in_force(
            equations_of(filament.structure.recorded.formulation), reduced=scene.model == "small-deflection"
        ),
        unknowns=unknowns,
        graph=size,
        integrator={
            "solver": settings.solver,
            "backend": str(backend),
            **{key: getattr(settings, key) for key in ("rtol", "atol", "reason")},
        },
        damping=damping_note(scene),
        ringing=price.text,
        seconds=price.seconds,
        laying=laying_note(scene, regime.name),
        warnings=theory_limits(scene, effects.names, effects.terms()),
    )
