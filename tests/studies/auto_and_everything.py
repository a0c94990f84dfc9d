"""What ``auto`` answers beside the run with everything switched on, and what each chosen effect is worth.

``python -m tests.studies.auto_and_everything`` prints the table of ``measured.md`` over the bundled scenes, two hundred
random ones, and these in random surroundings: an hour or two of all cores. Answers are kept in the user's cache under
the fingerprint of the scene and of the package's sources, so that an interrupted study goes on.
``tests/slow/test_random_scenes.py`` looks at some of them.
"""

from __future__ import annotations

import os
import tomllib
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from multiprocessing import get_context
from statistics import median

import numpy as np

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SoftcatError
from softcat_sym.results.run import Run
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.simulate import without_estimate
from tests.common.kept_answers import fingerprint, kept
from tests.common.random_scenes import in_surroundings, random_scenes
from tests.common.table import show

ASIDE = "rotary-inertia"
"""In everything only where it is in ``auto``."""

COARSE = 10
"""Cells per half span on which chosen effects are left out in turn: one grid, so that only the physics differs."""

TIGHTER = 10
"""By how much the time steps are refined there, so that a hundredth of the accuracy is not their noise."""


_QUICK = 0.1  # s of solving


@dataclass(frozen=True)
class Answer:
    """One scene."""

    name: str
    scene: str
    accuracy: float
    messages: tuple[str, ...]
    chosen: tuple[str, ...] = ()
    repeats: tuple[str, ...] = ()
    error: float = np.nan
    finer: float = np.nan
    seconds: float = np.nan
    everything_seconds: float = np.nan
    idle: dict[str, float] | None = None


def answers(scenes: Sequence[tuple[str, sc.Scene]], *, idle: bool = True) -> list[Answer]:
    """The answers, in the order of the scenes; `idle` asks what each chosen effect is worth."""
    jobs = [(name, scene.to_toml(), "idle" if idle else "") for name, scene in scenes]
    with ProcessPoolExecutor(max_workers=os.cpu_count(), mp_context=get_context("spawn")) as pool:
        return list(pool.map(_kept, jobs))


def _kept(job: tuple[str, str, str]) -> Answer:
    return Answer(**kept(job, fingerprint(__file__), lambda: asdict(answer_of(*job))))


def answer_of(name: str, text: str, idle: str) -> Answer:
    """Run ``auto``, everything, and ``auto`` without each of its effects."""
    scene = sc.Scene.model_validate(tomllib.loads(text))
    if not is_spatial(scene):
        # One of both runs might leave its plane, and the other not.
        scene = scene.replace({"run.dimensions": 2})
    auto = _run(scene)
    turning = not isinstance(auto, str) and ASIDE in auto.summary["effects"]
    everything = [e.name for e in REGISTRY if e.applies(scene) and (e.name != ASIDE or turning)]
    complete = _run(scene.replace({"run.effects": everything}))
    messages = tuple(
        f"{what}: {run if isinstance(run, str) else run.summary['message'] or run.outcome.name}"
        for what, run in (("everything", complete), ("auto", auto))
        if isinstance(run, str) or not run.outcome.is_success
    )
    if isinstance(complete, str) or isinstance(auto, str) or messages:
        return Answer(name, text, scene.run.accuracy, messages)
    chosen, error = tuple(auto.summary["effects"]), difference(auto, complete)
    finer = np.nan
    if error > scene.run.accuracy:
        fine = _twice_as_fine(auto, scene)
        pair = [_run(fine.replace({"run.effects": list(names)})) for names in (chosen, everything)]
        finer = np.inf if any(isinstance(run, str) for run in pair) else difference(*pair)  # type: ignore[arg-type]
    return Answer(
        name=name,
        scene=text,
        accuracy=scene.run.accuracy,
        messages=(),
        chosen=chosen,
        repeats=tuple(auto.summary["repeats"]),
        error=error,
        finer=finer,
        seconds=seconds_of(auto),
        # Where everything is chosen, both runs are one, and the second finds what the first has loaded.
        everything_seconds=seconds_of(auto if {*chosen} == {*everything} else complete),
        idle=_idle(scene, chosen, quick=seconds_of(auto) < _QUICK) if idle else None,
    )


def _twice_as_fine(run: Run, scene: sc.Scene) -> sc.Scene:
    """The scene on twice the cells of a run, graded as they are."""
    lengths = np.diff(run.data.X_node.values)
    ratio = float(np.max(lengths) / np.min(lengths))
    return scene.replace({"numerics.cells": 2 * run.summary["cells"], "numerics.grading": max(1.0, round(ratio, 6))})


def _idle(scene: sc.Scene, chosen: tuple[str, ...], *, quick: bool) -> dict[str, float] | None:
    """What leaving out each chosen effect changes; what the scene cannot do without is not among them.

    None where the coarse run has no answer itself: then nothing can be said of its effects.
    """
    tight = scene.run.accuracy / TIGHTER
    coarse = scene.replace(
        {
            "numerics.cells": scene.numerics.cells or COARSE,
            "run.accuracy": tight,
            # Every effect in turn is another C text to compile, which takes longer than a quick run.
            "numerics.backend": "interpreted" if quick else "auto",
        }
    )
    base = _run(coarse.replace({"run.effects": list(chosen)}))
    if isinstance(base, str) or not base.outcome.is_success:
        return None
    changes: dict[str, float] = {}
    for effect in REGISTRY:
        if effect.name not in chosen or effect.indispensable(scene):
            continue
        less = _run(coarse.replace({"run.effects": list(without(chosen, effect.name))}))
        if isinstance(less, str) and "run.effects" in less:
            continue  # a list that makes no sense: the effect cannot be left out
        answered = not isinstance(less, str) and less.outcome.is_success
        changes[effect.name] = difference(less, base) if answered else np.inf  # type: ignore[arg-type]
    return changes


def without(names: Sequence[str], left_out: str) -> tuple[str, ...]:
    """The names without one, and without what needs it."""
    gone = {left_out}
    for _ in names:
        gone |= {effect.name for effect in REGISTRY if gone & {*effect.needs}}
    return tuple(name for name in names if name not in gone)


def seconds_of(run: Run) -> float:
    """What the answer took, beyond what filaments of its kind share."""
    return float(run.summary["wall_s"]["solve"] + run.summary["wall_s"]["estimate"])


def difference(run: Run, reference: Run) -> float:
    """Largest difference of the midpoint at the output times, over the largest of the reference."""
    found, wanted = run.data.midpoint.values, reference.data.midpoint.values
    if len(found) != len(wanted):
        return np.inf
    return float(np.max(np.abs(found - wanted)) / np.max(np.abs(wanted)))


def _run(scene: sc.Scene) -> Run | str:
    try:
        return sc.simulate(without_estimate(scene))
    except SoftcatError as error:
        return str(error)


LEAST = 1 / 100
"""Of the accuracy: an effect that changes less is not worth having been chosen."""


def print_answers(title: str, studied: Sequence[Answer]) -> None:
    """Who misses, who is repeated, what it saves, and which effects are worth nothing."""
    answered = [answer for answer in studied if not answer.messages]
    show(
        f"{title}: without an answer", ("scene", "why"), [(a.name, a.messages[0][:100]) for a in studied if a.messages]
    )
    beyond = [answer for answer in answered if answer.error > answer.accuracy]
    rows = [(a.name, f"{a.accuracy:g}", f"{a.error:.1e}", f"{a.finer:.1e}", ", ".join(a.chosen)) for a in beyond]
    show("beyond the accuracy", ("scene", "accuracy", "error", "on a finer grid", "chosen"), rows)
    within = 1 - sum(answer.finer > answer.accuracy for answer in beyond) / len(answered)
    repeats = Counter(len(answer.repeats) for answer in answered)
    ratio = median(answer.everything_seconds / answer.seconds for answer in answered)
    idle = [
        name for answer in answered for name, change in (answer.idle or {}).items() if change < LEAST * answer.accuracy
    ]
    print(f"\n{len(answered)} of {len(studied)} answered, {within:.1%} within the accuracy; repeats {dict(repeats)}")
    print(f"everything takes {ratio:.2f} times as long (median); chosen for nothing: {Counter(idle).most_common()}")


if __name__ == "__main__":
    bundled = [(name, sc.load_scene(name)) for name in sc.bundled_names()]
    drawn = random_scenes()
    random = [(f"random {number}", scene) for number, scene in enumerate(drawn)]
    print_answers("bundled and random scenes", answers([*bundled, *random]))
    surrounded = [(f"random {number}", scene) for number, scene in enumerate(in_surroundings(drawn))]
    print_answers("in surroundings", answers(surrounded, idle=False))
