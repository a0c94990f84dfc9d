"""Finite elements: record films and lines for the tests; tables of theories against elements for ``measured.md``.

``python -m tests.studies.elements record [FILM ...]`` computes films anew, those on record if none is named, and the
lines. ``python -m tests.studies.elements tables`` prints how far theories are from elements for the paper's scenes,
and at three slendernesses: some 40 minutes of the processor; ``collapse`` the same of strands near the load of the
plastic beam.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Mapping

import softcat_sym as sc
from softcat_sym.effects.effect_sets import terms_of
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.forecast import forecast
from softcat_sym.fitting.likelihood import discrepancy
from softcat_sym.reference.element_loop import Mesh
from tests.common.element_films import RECORD, by_elements, line_by_elements, record
from tests.common.elements import INSTANTS, digits, elements, filament, mean, midpoints, name_of, percent, plane
from tests.common.strand import strand
from tests.common.table import show

THEORIES: Mapping[str, Mapping[str, object]] = {
    "filament": {},
    "published, material closure": {"run.effects": "paper"},
    "published, printed closure": {"run.effects": "paper", "run.closure": "printed"},
}
SCENES = {
    "continual-descent": (Mesh(64, 4), Mesh(96, 6)),
    "arrested-overdamped": (Mesh(64, 4), Mesh(48, 6, grading=10.0)),
    "arrested-underdamped": (Mesh(64, 4), Mesh(96, 6)),
}
SLENDER = {0.03: (Mesh(64, 4),), 0.015: (Mesh(128, 4),), 0.0075: (Mesh(48, 4, grading=8.0),)}


def record_films(names: list[str]) -> None:
    """Write what is computed beside what is on record."""
    found = record()
    for name in names or list(found["films"]):
        found["films"][name] = _rounded(by_elements(name))
        print(name, flush=True)
    for span in found["lines"]:
        found["lines"][span] = [_rounded(axis) for axis in line_by_elements(float(span))]
    text = json.dumps(found, indent=1)
    # An array is one line.
    text = re.sub(r"\[\s+([^\[\]]*?)\s+\]", lambda one: "[" + re.sub(r"\s+", " ", one[1]) + "]", text)
    RECORD.write_text(text + "\n", encoding="utf-8")


def _rounded(values: object) -> list[float]:
    return [float(f"{one:.7g}") for one in values]  # type: ignore[attr-defined]


def table(name: str, meshes: tuple[Mesh, ...], changes: Mapping[str, object]) -> None:
    """Midpoints of elements, and differences of theories from the last mesh."""
    scene = plane(name, changes)
    runs = [elements(scene, mesh) for mesh in meshes]
    truth = [*midpoints(scene, runs[-1]), mean(scene, runs[-1])]
    rows = [[f"elements {name_of(run.mesh)}", *digits([*midpoints(scene, run), mean(scene, run)])] for run in runs]
    for theory, more in THEORIES.items():
        run = filament(name, {"numerics.cells": 160, "numerics.grading": 10.0, **more, **changes})
        both = percent([*midpoints(scene, run), mean(scene, run)], truth)
        rows.append([theory, *both] if run.outcome.is_success else [theory, run.outcome.name, *[""] * len(INSTANTS)])
    show(f"{name} {dict(changes) or ''}", ["midpoint/L", *(f"t~ = {t:g}" for t in INSTANTS), "mean, 60 to 460"], rows)


SEEN = ((3e-3, 200), (4e-3, 151), (4e-3, 110), (5e-3, 260), (5e-3, 200), (5e-3, 136), (6e-3, 283), (6e-3, 200))
"""Span [m] and yield stress [Pa] of the strands by which the theory's error near the plastic beam's load was set."""


def collapse() -> None:
    """Sag of the theory over that of the elements, what fits allow for, and what the necking gradient is worth."""
    rows = []
    for span, stress in SEEN:
        changes: dict[str, object] = {"run.duration": "1 s", "run.frames": 11, "material.yield_stress": f"{stress} Pa"}
        scene = strand(span, {**changes, "numerics.estimate": False})
        names = {*choose_effects(scene).names, NECKING_GRADIENT.name}
        sags = [
            float(sc.simulate(scene.replace({"run.effects": sorted(one)})).data.midpoint.values[-1])
            for one in (names, names - {NECKING_GRADIENT.name})
        ]
        ratio = sags[0] / elements(strand(span, changes), Mesh(24, 4, grading=4.0)).y[-1].min()
        allowed = discrepancy(scene, sorted(names), terms_of(scene, sorted(names))).amplitude
        foreseen = NECKING_GRADIENT.estimate(scene, forecast(scene)).value
        rows.append([f"{1e3 * span:g}", stress, f"{ratio - 1:+.2%}", f"{allowed:.2%}"])
        rows[-1] += [f"{sags[1] / sags[0] - 1:.2%}", f"{foreseen:.2%}"]
    header = ["gap, mm", "yield stress, Pa", "sag over elements'", "allowed", "without the gradient", "foreseen"]
    show("near the load of the plastic beam", header, rows)


if __name__ == "__main__":
    if sys.argv[1:2] == ["record"]:
        record_films(sys.argv[2:])
    elif sys.argv[1:] == ["tables"]:
        for scene_name, of_scene in SCENES.items():
            table(scene_name, of_scene, {})
        for delta, of_delta in SLENDER.items():
            table("continual-descent", of_delta, {"groups.delta": delta})
    elif sys.argv[1:] == ["collapse"]:
        collapse()
    else:
        sys.exit(__doc__)
