"""What a page knows of its scene: all that its JavaScript needs, computed once, as JSON holds it."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

import numpy as np

from softcat_sym.batch.members import Row, written
from softcat_sym.codegen.interface import Description
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.section_rule import POINT
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects import theory_limits
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.error_control.estimate import Resolution
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.expected_regime import TURNS_BACK, expected_regime
from softcat_sym.generation import ended_at
from softcat_sym.results import motion, verdict
from softcat_sym.results.breaking import breakable
from softcat_sym.results.fields import LOST, VARIABLES, energies_of, is_odd, midpoint_heights, variable_of
from softcat_sym.results.run import Run
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import SceneLike, as_scene, load_scene
from softcat_sym.scene.scene import Scene, refuse_settled, rest_length
from softcat_sym.scene.tables import bodies_of
from softcat_sym.scene.toml import toml_key, toml_value
from softcat_sym.simulate import recalled
from softcat_sym.single_run import STEP_SIZE_OUTCOMES, TIGHTER, TRIES, build
from softcat_sym.solvers.compiled import OUTCOMES
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import RODAS5P, Settings, compiled_settings
from softcat_sym.solvers.solution import Silence, thread_of
from softcat_sym.web.fixed import Fixed, between, random_points, share_of, value_of
from softcat_sym.web.sliders import Slider, Sliders, choose_sliders, is_needed

_POINTS, _SCANNED = 96, 11
_MAX_STEPS = 100_000
_QUICK = 0.03
"""Seconds below which a run follows a slider by itself."""

_PREVIEWS: Final = ((12, 0.5, 10.0), (20, 0.5, 10.0), (20, 1.0, 10.0), (20, 1.0, 3.0))
"""Cells, share of the fibres, and how much looser the tolerances are: from the cheapest on."""

_FEWEST = 4
"""Fibres of a preview."""

_OWN: Final = ("too thick for a filament", "it never stops")
"""Warnings that the page gives by itself, with the numbers of its state."""

_THRESHOLDS: Final = {
    verdict: ("SHARE_OF_ONE_CELL", "DRAWN_OUT", "SMOOTH", "RUPTURED", "COMPRESSION", "GAIN", "NOISE", "BEADED"),
    motion: ("ARREST_RATE", "ARREST_TIME", "FRAMES_A_PERIOD", "PERIODS", "SEEN"),
}
"""Limits by which a run is judged, as the page names them but for the case."""

_EFFECT = "\t"

_ENOUGH = 3.0
"""Times the accuracy asked: what a preview may err by."""


@dataclass(frozen=True)
class Page:
    """All that is put together to a page."""

    data: dict[str, Any]  # As its JSON has it
    described: Description  # The structure whose C text is compiled


def describe_page(scene: SceneLike, sliders: Sequence[str] = (), name: str = "") -> Page:
    """Describe the live page of a scene.

    Parameters
    ----------
    scene : Scene, str, path or dict
        What is asked. It is run once, for the effects and the resolution that ``softcat run`` ends with.
    sliders : sequence of str
        Further keys to move, or other ranges, as ``KEY=low:high[:log]``.
    name : str
        Of the scene, for links; that of a bundled one by default.

    Returns
    -------
    Page
        The data of the page, and the structure that is to be compiled for it.

    Raises
    ------
    SceneError
        If the scene has no compiled form, or a key cannot be a slider.
    """
    given = as_scene(scene)
    name = name or (scene if isinstance(scene, str) and scene in bundled_names() else "scene")
    refuse_settled(given, "a page runs to the end of its duration")
    for body in bodies_of(given):
        found = "given, but a page does not judge how deep the filament sinks in"
        raise SceneError([Fault(body.table_name, found, "leaving it out, or softcat run")])
    if given.extrusion.present:
        found = "given, but the solver of a page does not end its steps where the nozzle hands a node over"
        raise SceneError([Fault("extrusion", found, "leaving it out, or softcat run")])
    run = recalled(given)
    if run.scene.run.dimensions != given.run.dimensions:
        accepted = "run.dimensions = 2 or 3"
        raise SceneError([Fault("run.dimensions", "'auto', but it is unstable sideways", accepted)])
    ended, at = ended_at(given, run)
    base = Fixed(ended)
    others = _alike(base, at)
    chosen = choose_sliders(base, sliders, tuple(one.scene for one in others.values()))
    fitting = {key: one for key, one in others.items() if key != name and _fits(one, base, chosen)}
    described, filament = base.exported
    optional = [name for name in base.numbers if not is_needed(base, name)]
    usual = base.numbers.keys() - chosen.lost(base, optional)
    model = described.model
    data = {
        "title": described.title,
        "name": name,
        "effects": run.summary["effects"],
        "left_out": {key: f"{value:.2g} of the sag" for key, value in run.summary["left_out"].items()},
        "ends": [support.kind for support in given.ends.supports],
        "half": filament.graph.grid.is_half,
        "axes": 3 if filament.structure.recorded.theory.is_spatial else 2,
        "parameters": list(model.parameters),
        "powers": list(model.powers),
        "settings": _settings(base, at, chosen),
        "resolution": {"looser": 1.0, **_resolved(base)},
        "preview": _preview(base, at),
        "accuracy": _accuracy(run),
        "scenes": [
            _scene(title, one, given if one is base else load_scene(title), base, chosen, usual)
            for title, one in ({name: base} | fitting).items()
        ],
        "sliders": [slider.to_dict() for slider in chosen.each],
        "interpolations": {name: asdict(one) for name, one in chosen.interpolations.items()},
        "notes": _notes(given, base, chosen),
        "words": {
            "outcomes": {outcome.name: outcome.value for outcome in Outcome},
            "codes": {str(code): outcome.name for code, outcome in OUTCOMES.items()},
        },
        "limits": _limits(base, chosen, usual, given.numerics.rtol),
    }
    return Page(data, described)


def _alike(base: Fixed, at: Resolution) -> dict[str, Fixed]:
    """Bundled scenes of the same structure, at the same resolution."""
    found = {}
    for name in bundled_names():
        scene = load_scene(name)
        if scene.material.law != base.scene.material.law or scene.run.until == "settled":
            continue
        names = choose_effects(scene).names
        if names != base.effects.names:
            continue
        other = Fixed(at.of(scene.replace({"run.effects": list(names)})))
        other.__dict__["parameters"] = base.parameters
        if other.structure == base.structure and not base.differs(other) and not base.starts_elsewhere(other):
            found[name] = other
    return found


def _fits(other: Fixed, base: Fixed, sliders: Sliders) -> bool:
    """Whether another scene's numbers follow from the sliders as this one's do, within their ranges."""
    values = {key: value for key, value in sliders.values(other.scene).items() if value is not None}
    if not all(one.low <= values.get(one.key, math.nan) <= one.high for one in sliders.each):
        return False
    coefficients = sliders.coefficients(other)
    return all(
        sliders.follows(name, coefficients[name], values, other) for name in base.numbers if is_needed(base, name)
    )


def _scene(title: str, one: Fixed, asked: Scene, base: Fixed, sliders: Sliders, usual: set[str]) -> dict[str, Any]:
    """One scene of a page: what its numbers are multiplied by, where it begins, and its TOML."""
    coefficients = sliders.coefficients(one)
    start, grid = one.start, one.exported[1].graph.grid
    return {
        "name": title,
        "title": one.scene.title or title,
        "toml": toml_with(asked, sliders),
        "keys": sliders.values(one.scene),
        "coefficients": [coefficients[name] for name in base.parameters],
        "numbers": {name.removeprefix("."): coefficients[name] for name in sorted(usual) if name.startswith(".")},
        "duration": one.scene.run.duration,
        "start": None
        if start is None
        else {"rows": len(start), "numbers": [*grid.nodes.tolist(), *start.ravel().tolist()]},
    }


def toml_with(scene: Scene, sliders: Sliders) -> str:
    """A scene as it was given, with a line of its own for each key that a slider moves."""
    values: Row = {key: value for key, value in sliders.values(scene).items() if value is not None}
    tables = scene.replace(written(scene, values)).given()
    plain = {name: value for name, value in tables.items() if not isinstance(value, Mapping)}
    lines = [f"{name} = {toml_value(value)}" for name, value in plain.items()]
    for table, entries in tables.items():
        if isinstance(entries, Mapping) and entries:
            lines += ["", f"[{table}]", *_lines(entries)]
    return "\n".join([*lines, ""])


def _lines(entries: Mapping[str, object], before: str = "") -> list[str]:
    lines = []
    for name, value in entries.items():
        key = before + toml_key(name)
        lines += _lines(value, f"{key}.") if isinstance(value, Mapping) else [f"{key} = {toml_value(value)}"]
    return lines


def _resolved(one: Fixed) -> dict[str, Any]:
    """Grid and section of a scene, and what its solver shows at a site."""
    described, filament = one.exported
    rule = filament.graph.rule
    return {
        "cells": described.cells,
        "fibres": described.fibres,
        "frames": one.scene.run.frames,
        "grading": described.grading,
        "max_steps": _MAX_STEPS,
        "nodes": filament.graph.grid.nodes.tolist(),
        "slots": [slot.name for slot in described.model.slots],
        "rows": [
            {"name": shown.name, "first": shown.first, "behind": shown.behind, "summed": shown.summed}
            for shown in described.model.signature.shown
        ],
        "points": rule
        and {
            "count": rule.points,
            "weight": rule.weight.tolist(),
            "zeta": rule.zeta.tolist() if not rule.is_spatial else None,
        },
    }


def _settings(base: Fixed, at: Resolution, sliders: Sliders) -> dict[str, Any]:
    """How ``softcat run`` would integrate at the scene's own values, which come first, and at random points.

    ``at`` has the share of each slider's range; ``absolute`` the tolerances of the kinds of slots, which ``kinds``
    numbers; ``largest_step`` is in units of the time scale, 0 for none. A page takes the tightest of the nearest.
    """
    slots = sorted({slot.name for slot in base.exported[0].model.slots})
    own = base.scene.replace({"numerics.rtol": None})
    refined = at.rtol / compiled_settings(own, base.effects).rtol
    ranges = {slider.key: slider.range for slider in sliders.each}
    first = {key: value or 0.0 for key, value in sliders.values(base.scene).items()}
    found, shares, longest = list[Settings](), list[list[float]](), list[float]()
    for values, moved in [(first, base), *random_points(base, ranges, _POINTS)]:
        scene = moved.scene.replace({"numerics.rtol": None})
        try:
            rtol = compiled_settings(scene, moved.effects).rtol * refined
        except SceneError:
            continue  # No filament withstands these numbers together.
        found.append(compiled_settings(scene.replace({"numerics.rtol": rtol}), moved.effects))
        shares.append([round(share_of(*ranges[key], value), 4) for key, value in values.items()])
        longest.append((found[-1].max_step or 0.0) / moved.numbers["time_scale"])
    absolute = np.array([one.absolute(slots) for one in found])
    kinds, number = np.unique(absolute, axis=1, return_inverse=True)
    return {
        "at": shares,
        "relative": [one.rtol for one in found],
        "method": [one.method for one in found],
        "largest_step": longest,
        "absolute": [[float(f"{one:.4g}") for one in row] for row in kinds.tolist()],
        "kinds": dict(zip(slots, number.ravel().tolist(), strict=True)),
        "mixed": RODAS5P,
    }


def _preview(base: Fixed, at: Resolution) -> dict[str, Any] | None:
    """The cheapest resolution that errs by little at the scene's own values."""
    exact, seconds = _solved(base.scene, base.effects)
    if seconds < _QUICK or exact is None:
        return None
    best: dict[str, Any] | None = None
    for cells, share, looser in _PREVIEWS:
        if cells >= at.cells or (share < 1 and at.fibres is None):
            continue
        fibres = at.fibres if at.fibres is None or share == 1 else max(_FEWEST, round(share * at.fibres))
        grading = base.scene.numerics.grading and choose_grading(base.scene, cells, base.effects)
        changes = {"numerics.cells": cells, "numerics.grading": grading, "numerics.fibres": fibres}
        coarse = base.scene.replace({**changes, "numerics.rtol": at.rtol * looser})
        rough, _ = _solved(coarse, base.effects)
        if rough is None or len(rough) != len(exact):
            continue
        error = float(np.max(np.abs(rough - exact)) / np.max(np.abs(exact)))
        if best is None or error < best["error"]:
            best = {"looser": looser, **_resolved(Fixed(coarse)), "error": error}
        if error < _ENOUGH * base.scene.run.accuracy:
            break
    return best


def _solved(scene: Scene, effects: Effects) -> tuple[Floats | None, float]:
    """Midpoint and seconds of a run; no midpoint without an answer."""
    prepared = build(scene, effects)
    began = time.perf_counter()
    solution = prepared.solve(Silence())
    spent = time.perf_counter() - began
    sound = solution.outcome.is_success
    return midpoint_heights(prepared.graph, solution) * rest_length(scene) if sound else None, spent


def _accuracy(run: Run) -> dict[str, Any]:
    """How accurate the grid of the page is at the scene's own values."""
    asked, errors = run.summary["accuracy"], run.summary["error_estimate"]
    estimate = None if errors is None else errors["total"]
    error = "was not estimated" if estimate is None else f"is about {100 * estimate:.2g} % of the sag"
    words = f"at the scene's own values its error {error}; {100 * asked:.2g} % were asked"
    return {"asked": asked, "estimate": estimate, "words": words}


def _notes(scene: Scene, base: Fixed, sliders: Sliders) -> list[dict[str, Any]]:
    """From which value of each slider on ``softcat run`` would take other effects, or warn."""
    always = _said(scene, base, {})
    return [note for slider in sliders.each for note in _notes_of(scene, base, slider, always)]


def _notes_of(scene: Scene, base: Fixed, slider: Slider, always: Mapping[str, str]) -> list[dict[str, Any]]:
    """What is said somewhere in the range of a slider and not at the scene's own value."""
    values = [between(*slider.range, share) for share in np.linspace(0.0, 1.0, _SCANNED)]
    own = value_of(scene, slider.key) or values[0]
    said = [_said(scene, base, {slider.key: value}) for value in values]
    found = dict[tuple[float | None, float | None, str], list[str]]()
    for kind in dict.fromkeys(one for some in said for one in some if one not in always):
        where = [value for value, some in zip(values, said, strict=True) if kind in some]
        above = min((value for value in where if value > own), default=None)
        below = max((value for value in where if value < own), default=None)
        begin, _, effect = next(some[kind] for some in said if kind in some).partition(_EFFECT)
        found.setdefault((above, below, begin), []).append(effect)
    return [
        {"key": slider.key, "above": above, "below": below, "words": f"{begin} {', '.join(effects)}".strip()}
        for (above, below, begin), effects in found.items()
    ]


def _said(scene: Scene, base: Fixed, values: Row) -> dict[str, str]:
    """What there is to say of a scene at other values, by kind; names of effects stand behind a mark."""
    try:
        moved = scene.replace(written(scene, values))
        effects = choose_effects(moved)
    except SceneError as error:
        return {"refused": f"softcat run would refuse it: {error.faults[0].found}"}
    found = dict[str, str]()
    if scene.run.effects == "auto":
        ours, theirs = base.effects.names, effects.names
        found |= {f"+{one}": f"softcat run would also take in{_EFFECT}{one}" for one in theirs if one not in ours}
        found |= {f"-{one}": f"softcat run would leave out{_EFFECT}{one}" for one in ours if one not in theirs}
    warnings = theory_limits.theory_limits(moved, effects.names, effects.terms())
    # Numbers in the words differ from value to value: a warning is known by how it begins.
    kinds = {words.partition(":")[0].partition(" (")[0]: words for words in warnings}
    return found | {kind: words for kind, words in kinds.items() if kind not in _OWN}


def _is_per_area(name: str) -> bool:
    """Whether the solver computes a field of a run per undeformed area."""
    return (name in VARIABLES or name in energies_of([name])) and variable_of(name).per_area


def _limits(base: Fixed, sliders: Sliders, usual: set[str], scene_rtol: float | None) -> dict[str, Any]:
    """Numbers and flags from which the page judges a run as ``softcat run`` does."""
    scene, effects, (described, filament) = base.scene, base.effects, base.exported
    terms, graph, model = effects.terms(), filament.graph, described.model
    work = ["energy_dissipated", "work_external", "energy_gradient"]
    work += [name if name in VARIABLES else f"{LOST}{name}" for name in model.powers[3:]]
    names = [*(one.name for one in model.signature.shown if not one.name.startswith(POINT)), *work]
    regime = expected_regime(scene, effects.names)
    exponents = {
        name.removeprefix("."): {s.key: s.exponents[name] for s in sliders.each if name in s.exponents}
        for name in sorted(usual)
        if name.startswith(".")
    }
    flows, solid = terms.flows or terms.viscous, scene.material.spec.is_solid
    kind = "elastic" if solid else "yields" if flows and terms.yields else "viscous" if flows else "unflowing"
    turned = any(scene.load.tip_torque) and "o1" not in (*graph.differential.kinds, *graph.algebraic.kinds)
    return {
        "numbers": exponents,
        "accuracy": scene.run.accuracy,
        "regime": kind,
        "flows": terms.flows,
        "necks": terms.necking_gradient and terms.yields,
        "bends": terms.bending,
        "shaken": scene.load.shake > 0,
        "surface": terms.surface_tension,
        "felt": int(terms.viscous and terms.surface_tension),
        "audited": graph.conserves_energy and not turned,
        "balanced": not turned,
        "swells": terms.finite and not terms.thins and scene.run.closure == "material",
        "gradient_by_frames": not graph.has_velocities,
        "work": work,
        "energies": list(energies_of(names)),
        "per_area": [name for name in names if _is_per_area(name)],
        "odd": [name for name in names if is_odd(name)],
        "since_start": [name for name in energies_of(names) if name == "energy_surface" or name not in VARIABLES],
        "fields": [*VARIABLES, *(name for name in energies_of(names) if name not in VARIABLES)],
        "tries": 1 if scene_rtol is not None else TRIES,
        "tighter": TIGHTER,
        "of_a_step_too_long": [outcome.name for outcome in STEP_SIZE_OUTCOMES],
        "thread": thread_of(terms),
        "largest_stretch": verdict.largest_stretch(scene),
        "beyond_neighbours": 1.0 if terms.yields else verdict.BEYOND_A_LIQUID,
        "turns_back": TURNS_BACK,
        **{name.lower(): getattr(where, name) for where, names in _THRESHOLDS.items() for name in names},
        "turn": motion.NOISE * scene.run.accuracy,
        "no_sag": motion.NO_SAG * scene.filament.span,
        "thick": theory_limits.THICK,
        "uncertain": theory_limits.error_by_slenderness(scene, effects.names, terms),
        "moves": bool(scene.ends.motion),
        "arrest": regime.arrest_exact,
        "breaking": [scene.material.breaking_strain, scene.material.breaking_stress] if breakable(scene) else None,
    }
