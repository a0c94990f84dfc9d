"""What a page knows of its scene: all that its JavaScript needs, computed once, as JSON holds it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

import numpy as np

from softcat_sym.batch.members import Row, written
from softcat_sym.codegen.interface import Description
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects import theory_limits
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control.estimate import Resolution
from softcat_sym.errors import Fault, SceneError
from softcat_sym.generation import ended_at
from softcat_sym.results.run import Run
from softcat_sym.results.verdict import largest_stretch
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, refuse_settled
from softcat_sym.scene.tables import bodies_of
from softcat_sym.scene.toml import toml_key, toml_value
from softcat_sym.simulate import recalled
from softcat_sym.solvers.compiled import OUTCOMES
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import RODAS5P, Settings, compiled_settings
from softcat_sym.web.fixed import Fixed, between, random_points, share_of, value_of
from softcat_sym.web.sliders import Slider, Sliders, choose_sliders

_POINTS, _SCANNED = 96, 11
_MAX_STEPS = 100_000
_QUICK = 0.03
"""Seconds below which a run follows a slider by itself."""

_PREVIEW: Final = (12, 0.5, 10.0)
"""Cells of a preview, share of the fibres, and how much looser its tolerances are."""

_FEWEST = 4
"""Fibres of a preview."""

_EFFECT = "\t"


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
        found = "given, but a page draws nothing that the filament lies on"
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
    chosen = choose_sliders(base, sliders)
    described, filament = base.exported
    coefficients = chosen.coefficients(base)
    data = {
        "title": described.title,
        "name": name,
        "effects": run.summary["effects"],
        "left_out": {key: f"{value:.2g} of the sag" for key, value in run.summary["left_out"].items()},
        "ends": [support.kind for support in given.ends.supports],
        "half": filament.graph.grid.is_half,
        "axes": 3 if filament.structure.recorded.theory.is_spatial else 2,
        "numbers": base.names,
        "parameters": len(base.parameters),
        "coefficients": [coefficients[one] for one in base.names],
        "keys": chosen.values(ended),
        "toml": toml_with(given, chosen),
        "duration": ended.run.duration,
        "start": _start(base),
        "settings": _settings(base, at, chosen),
        "resolution": {"looser": 1.0, **_resolved(base)},
        "preview": _preview(base, at) if run.summary["wall_s"]["solve"] > _QUICK else None,
        "accuracy": _said_of(run),
        "sliders": [slider.to_dict() for slider in chosen.each],
        "interpolations": {name: asdict(one) for name, one in chosen.interpolations.items()},
        "notes": _notes(given, base, chosen),
        "words": {
            "outcomes": {outcome.name: outcome.value for outcome in Outcome},
            "codes": {str(code): outcome.name for code, outcome in OUTCOMES.items()},
        },
        "largest_stretch": largest_stretch(ended),
    }
    return Page(data, described)


def _start(base: Fixed) -> dict[str, Any] | None:
    """Where its nodes are and what it begins with there; None of what begins straight."""
    start = base.start
    if start is None:
        return None
    return {"rows": len(start), "numbers": [*base.exported[1].graph.grid.nodes.tolist(), *start.ravel().tolist()]}


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
            {"name": shown.name, "first": shown.first, "behind": shown.behind}
            for shown in described.model.signature.shown
        ],
        "points": None if rule is None else rule.points,
        "weights": [] if rule is None else rule.weight.tolist(),
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
    """A coarse resolution, for what is shown while a slider moves; None where the page's own is as coarse as can be."""
    cells, share, looser = _PREVIEW
    if cells >= at.cells:
        return None
    grading = base.scene.numerics.grading and choose_grading(base.scene, cells, base.effects)
    fibres = at.fibres and max(_FEWEST, round(share * at.fibres))
    coarse = {"numerics.cells": cells, "numerics.grading": grading, "numerics.fibres": fibres}
    try:
        return {"looser": looser, **_resolved(Fixed(base.scene.replace(coarse)))}
    except SceneError:  # a shape that turns needs more cells
        return None


def _said_of(run: Run) -> str:
    """What ``softcat run`` says of the scene's own values, and how accurate its grid is there."""
    errors, regime = run.summary["error_estimate"], run.summary["regime"]
    total = None if errors is None else errors["total"]
    error = "not estimated" if total is None else f"about {100 * total:.2g} % of the sag"
    ends = f"{run.outcome.name}{f', {regime}' if regime else ''}"
    asked = f"{100 * run.summary['accuracy']:.2g} % were asked"
    return f"Of the scene's own values softcat run says: {ends}; error {error}, {asked}."


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
    return found | {words.partition(":")[0].partition(" (")[0]: words for words in warnings}
