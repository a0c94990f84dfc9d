"""Hard cases of grids, shapes, supports and scales: few and many cells, slack, pushed, ruptured, uneven, tiny, huge."""

from __future__ import annotations

import softcat_sym as sc
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.simulate import without_estimate
from tests.common.closed_forms import soft_beam_sag, soft_catenary_sag

from .case import RUPTURES, Case
from .dimensionless import PAPER, STATIC, STRING, Scales, asked
from .judging import ends_at, follows, heights, moves_like, refined
from .truths import hanging_chain_sag, uneven_beam_sag

_BEAM, _SOFT = 1e4, 1e3
_RINGING = 1e-2
"""Accuracy asked of filaments that are struck: waves along and across them ring through thousands of periods, and what
snaps through does so at an instant that every cell shifts."""


def _cells() -> list[Case]:
    return [
        Case(
            "cells",
            f"N = {N}",
            lambda N=N: asked("elastic", E=_BEAM, effects=STATIC, frames=3, numerics={"cells": N}),
            lambda run: ends_at(soft_beam_sag(_BEAM, 0.03, 1 / 12))(run),
            # Who fixes the cells is told the error.
            allowed=0.05 if N == 8 else 1e-3,
        )
        for N in (8, 200, 2000)
    ]


def _slack() -> list[Case]:
    pinned = {"left": "pinned", "right": "pinned"}
    return [
        *(
            Case(
                "slack",
                f"pinned, length {length:g}",
                lambda length=length: asked(
                    "elastic",
                    E=_BEAM,
                    delta=1e-3,
                    effects=STATIC,
                    frames=3,
                    ends=pinned,
                    filament={"rest_length": length},
                ),
                lambda run, length=length: ends_at(hanging_chain_sag(length))(run),
                # The chain neither stretches nor bends at its lowest point.
                allowed=6e-3,
            )
            for length in (1.1, 1.5, 3.0)
        ),
        *(
            Case(
                "slack",
                f"clamped past the vertical, {how}",
                lambda angle=angle: asked(
                    "maxwell",
                    E=_BEAM,
                    V=_SOFT,
                    delta=0.01,
                    accuracy=_RINGING,
                    filament={"rest_length": 2.0},
                    ends={"left_angle": angle, "right_angle": -angle},
                ),
                refined,
                allowed=2 * _RINGING,
            )
            for how, angle in (("hangs", -2.0), ("stands and falls over", 2.0))
        ),
        Case(
            "zero start",
            "a string let go, no stretch and no moment",
            lambda: asked("elastic", E=100, T=0.2, effects=("inertia", *STRING), frames=21),
            # Its middle falls freely until a wave reaches it.
            follows(lambda t: -(t**2) / 2),
            fast=True,
        ),
        Case(
            "zero start",
            "a string at rest",
            lambda: asked("elastic", E=100, effects=STRING, frames=3),
            lambda run: ends_at(soft_catenary_sag(100.0))(run),
        ),
    ]


def _pushed() -> list[Case]:
    inwards = {"motion": [(0, 0, 0), (10, -0.2, 0)]}
    return [
        Case(
            "pushed",
            "elastic, support 0.2 L inwards, at rest",
            lambda: asked("elastic", E=_BEAM, T=10, effects=STATIC, ends=inwards, frames=11),
            # The same filament hung slack over what is left of the span, in its own units.
            lambda run: abs(float(run.data["y"][-1].min()) + _slack_sag()) / _slack_sag(),
        ),
        Case(
            "pushed",
            "maxwell, support 0.2 L inwards",
            lambda: asked("maxwell", E=_BEAM, V=_BEAM, T=20, accuracy=_RINGING, ends=inwards),
            refined,
            allowed=2 * _RINGING,
        ),
        Case(
            "pushed",
            "maxwell, support swings",
            lambda: asked(
                "maxwell",
                E=_BEAM,
                V=_SOFT,
                T=4,
                accuracy=_RINGING,
                # Without what shears: its waves ring ten thousand times.
                effects=(*PAPER, "viscous-flow"),
                ends={"motion": [(k, 0, 0.1 * (-1) ** k if k else 0) for k in range(10)]},
            ),
            refined,
            allowed=2 * _RINGING,
        ),
        Case(
            "pushed",
            "a string, support inwards",
            lambda: asked("elastic", E=100, T=12, effects=("inertia", *STRING), ends=inwards),
            None,
            refusals=("compressed",),
            says="bending",
        ),
        Case(
            "pushed",
            "a string, longer than its span",
            # What is not pushed but slack hangs, and stays at rest: a chain.
            lambda: asked(
                "elastic", E=_BEAM, T=1, effects=("inertia", *STRING), initial={"stretch": 0.9, "relaxed": False}
            ),
            lambda run: ends_at(hanging_chain_sag(1 / 0.9))(run),
            allowed=6e-3,
        ),
    ]


def _slack_sag() -> float:
    """Of a clamped filament of length 1 over a span of 0.8: another start, to fourth order in the grid."""
    scene = without_estimate(
        asked("elastic", E=_BEAM, effects=STATIC, frames=3).replace(
            {"filament.span": "0.8 m", "filament.rest_length": "1 m"}
        )
    )
    runs = [sc.simulate(scene.replace({"numerics.cells": cells})) for cells in (40, 80)]
    assert all(run.outcome.is_success for run in runs)
    coarse, fine = (-float(run.data["midpoint"][-1]) for run in runs)
    return (4 * fine - coarse) / 3


def _ruptures() -> list[Case]:
    return [
        Case("rupture", "elastic, E* = 1", lambda: asked("elastic", E=1), None, refusals=RUPTURES, fast=True),
        Case(
            "rupture",
            "elastic, E* = 2, at rest",
            lambda: asked("elastic", E=2, effects=STATIC),
            None,
            refusals=RUPTURES,
        ),
        Case("rupture", "newtonian, falls on", lambda: asked("newtonian", V=100, T=1000), None, refusals=RUPTURES),
        Case("rupture", "maxwell, falls on", lambda: asked("maxwell", E=_BEAM, V=100, T=1000), None, refusals=RUPTURES),
        Case(
            "rupture",
            "printed closure loses its tension",
            lambda: sc.load_scene(
                "continual-descent", {"groups.V": 10, "run.effects": "paper", "run.closure": "printed"}
            ),
            None,
            refusals=RUPTURES,
        ),
        *(
            Case(
                "necking",
                f"underdamped, G = {G:g}",
                lambda G=G: sc.load_scene("arrested-underdamped", {"groups.G": G}),
                (lambda run, sag=sag: _mean_sag(run, sag)) if sag else None,
                # Of elements in plane stress on 96 x 6, which a finer mesh moves by 0.8 %.
                allowed=0.03,
                refusals=() if sag else RUPTURES,
            )
            for G, sag in ((0.25, 0.0665), (0.3, 0.0790), (0.4, None))
        ),
    ]


def _mean_sag(run: Trajectory, sag: float) -> float:
    mean = -float(heights(run)[run.data["time"].size * 60 // 460 :].mean())
    return abs(mean - sag) / sag


def _bodies() -> list[Case]:
    spike, notch = [1.0] * 20 + [3.0] + [1.0] * 20, [1.0] * 20 + [0.6] + [1.0] * 20
    return [
        Case(
            "profile",
            "elastic, a spike",
            lambda: asked("elastic", E=1e7, effects=STATIC, frames=3, filament={"profile": spike}),
            lambda run: ends_at(uneven_beam_sag(1e7, 0.03, spike))(run),
        ),
        Case(
            "profile",
            "maxwell, a notch",
            lambda: asked("maxwell", E=_BEAM, V=_SOFT, filament={"profile": notch}),
            refined,
        ),
        *(
            Case(
                "scale",
                f"span of {span:g} m, {law}",
                lambda law=law, span=span: made(law, Scales(span, 1000.0, 10.0)),
                moves_like(made(law, Scales())),
                # Rounding moves the step in which a fibre begins to flow.
                allowed=1e-6 if law == "maxwell" else 1e-4,
                fast=law == "maxwell",
            )
            for law in ("maxwell", "bingham")
            for span in (1e-6, 1e3)
        ),
        Case(
            "gravity",
            "reversed",
            lambda: asked("elastic", E=_BEAM).replace({"load.gravity": "-10 m/s^2"}),
            None,
            refusals=("SceneError",),
            says="load.gravity",
        ),
    ]


def made(law: str, scales: Scales) -> sc.Scene:
    """A scene of given groups in given units."""
    return asked(law, E=_SOFT, V=30, G=1 if law == "bingham" else None, T=10, ramp=1, scales=scales)


FAMILIES = (_cells, _slack, _pushed, _ruptures, _bodies)
