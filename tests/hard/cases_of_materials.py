"""Hard cases of materials: stiffness, viscosity, relaxation, slenderness, thresholds, yield stress and index."""

from __future__ import annotations

import softcat_sym as sc
from tests.common.closed_forms import soft_beam_sag, soft_catenary_sag, von_karman_sag

from ..acceptance.viscous_string import viscous_string
from .case import PLASTIC, RUPTURES, Case
from .dimensionless import PAPER, STATIC, asked
from .judging import ends_at, ends_like, follows, moves_like, refined
from .truths import beam_let_go, beam_of_modes

_BEAM, _SOFT = 1e4, 1e3
_YIELDING = 5e-3
"""Accuracy asked of filaments that yield and ring: each fibre that begins to flow is a kink in time."""

_SOFTLY = 1e-2
"""Accuracy asked of elastic cables let go, whose waves steepen."""


def _string_at(t: float) -> float:
    """Sag of a viscous string at t in eta/(rho g L)."""
    return float(viscous_string([t]).sag[-1])


def _beam_sag(E: float) -> float:
    """Of the whole elastic theory; linear where the boundary-value problem has nothing left to say."""
    return soft_beam_sag(E, 0.03, 1 / 12) if E < 1e8 else 1 / (32 * 0.03**2 * E)


def _stiffness() -> list[Case]:
    static = [
        Case(
            "stiffness",
            f"E* = {E:g}, at rest",
            lambda E=E: asked("elastic", E=E, effects=STATIC, frames=3),
            lambda run, E=E: ends_at(_beam_sag(E))(run),
            fast=E in (10, 1e12),
        )
        for E in (1e1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12)
    ]
    # The closed form leaves out the stretch of the beam, and one that its modes beyond the twelfth carry.
    ringing = [
        Case(
            "stiffness",
            f"E* = {E:g}, let go",
            lambda E=E: asked("elastic", E=E, effects=PAPER, T=37 / E**0.5, frames=41),
            follows(lambda t, E=E: beam_let_go(t, E, 0.03)),
        )
        for E in (1e7, 1e12)
    ]
    # Waves along it are as slow as those across it, and steepen: a thousandth would take a minute.
    soft = Case(
        "stiffness",
        "E* = 10, let go",
        lambda: asked("elastic", E=10, T=5, accuracy=_SOFTLY),
        refined,
        allowed=2 * _SOFTLY,
    )
    return [*static, *ringing, soft]


def _viscosity() -> list[Case]:
    # A string of h0/L = 0.001 still bends a little beside its clamps.
    drawn = [
        Case(
            "viscosity",
            f"newtonian, V = {V:g}",
            lambda V=V: asked("newtonian", V=V, T=0.05 * V, delta=1e-3),
            lambda run: ends_at(_string_at(0.05))(run),
            allowed=3e-3,
            fast=V == 1e8,
        )
        for V in (1e4, 1e6, 1e8)
    ]
    elastic = asked("elastic", E=_BEAM, T=1)
    return [
        *drawn,
        Case("viscosity", "newtonian, V = 1", lambda: asked("newtonian", V=1, T=1), refined),
        *(
            Case(
                "viscosity",
                f"{law}, V = 1e-6",
                lambda law=law: asked(law, E=_BEAM if law == "maxwell" else None, V=1e-6, T=1),
                # It falls freely, drawn to nothing beside its supports.
                follows(lambda t: -(t**2) / 2),
                refusals=RUPTURES,
            )
            for law in ("newtonian", "maxwell")
        ),
        Case("viscosity", "maxwell, V = 1", lambda: asked("maxwell", E=_BEAM, V=1, T=1), refined),
        Case("viscosity", "maxwell, V = 1e8", lambda: asked("maxwell", E=_BEAM, V=1e8, T=1), moves_like(elastic)),
        Case(
            "viscosity",
            "bingham below yield, V = 1e-6",
            # In the published effects, as `auto` spares what yields rotary inertia, and says so.
            lambda: asked("bingham", E=_BEAM, V=1e-6, G=0.01, T=1, effects=(*PAPER, *PLASTIC)),
            moves_like(asked("elastic", E=_BEAM, T=1, effects=PAPER)),
        ),
        *(
            # Perfectly plastic, without a rate and without the length of a neck: hinges have neither width nor pace.
            Case(
                "viscosity",
                f"bingham beyond yield, V = {V:g}",
                lambda V=V: asked(
                    "bingham", E=_SOFT, V=V, G=0.3, ramp=10, effects=(*STATIC, "gravity-ramp", *PLASTIC), frames=21
                ),
                refined,
                refusals=(*RUPTURES, "no_convergence"),
            )
            for V in (1e-3, 1e-6)
        ),
        Case(
            "viscosity",
            "kelvin-voigt, V = 1e-6",
            lambda: asked("kelvin-voigt", E=_BEAM, V=1e-6, T=1),
            moves_like(elastic),
        ),
        Case(
            "viscosity",
            "kelvin-voigt, V = 1e8",
            lambda: asked("kelvin-voigt", E=_SOFT, V=1e8, T=5, effects=("bending", "viscous-stress")),
            follows(lambda t: -t / (32 * 0.03**2 * 1e8)),
            fast=True,
        ),
    ]


def _relaxation() -> list[Case]:
    fluid = asked("newtonian", V=1e3, T=10)
    solid = asked("elastic", E=_BEAM, T=1)
    short = [
        Case(
            "relaxation",
            f"{r:g} of the run",
            lambda r=r: asked("maxwell", E=100 / r, V=1e3, T=10),
            ends_like(fluid),
        )
        for r in (1e-9, 1e-6)
    ]
    long = [
        Case(
            "relaxation",
            f"{r:g} of the run",
            lambda r=r: asked("maxwell", E=_BEAM, V=_BEAM * r, T=1),
            moves_like(solid),
        )
        for r in (1e6, 1e9)
    ]
    modes = [(1e10, 1e-6), (1e10, 1.0), (1e10, 1e6)]
    return [
        *short,
        *long,
        Case(
            "decades of time",
            "modes that relax in 1e-6, 1 and 1e6",
            lambda: asked(
                "multimode-maxwell", T=1e6, delta=0.1, effects=("bending", "viscous-flow"), material={"modes": modes}
            ),
            follows(lambda t: beam_of_modes(t, modes, 0.1)),
            fast=True,
        ),
        Case(
            "decades of time",
            "maxwell over 1e12 elastic periods",
            lambda: asked("maxwell", E=1e10, V=1e13, T=1e6, ramp=100, delta=0.01),
            # A ramp counts for half its time.
            follows(lambda t: beam_of_modes(t - 50 * (t > 0), [(1e10, 1e3)], 0.01) * (t > 0)),
            # Shear adds some 14 (h0/L)^2 to a beam.
            allowed=4e-3,
        ),
    ]


def _slenderness() -> list[Case]:
    return [
        Case(
            "slenderness",
            "elastic, h0/L = 1e-5",
            lambda: asked("elastic", E=_BEAM, delta=1e-5, effects=STATIC, frames=3),
            lambda run: ends_at(soft_catenary_sag(_BEAM))(run),
        ),
        Case(
            "slenderness",
            "elastic, h0/L = 1e-5, let go",
            # A string but for its clamps: a thousandth would take minutes.
            lambda: asked("elastic", E=_BEAM, T=0.5, delta=1e-5, accuracy=_SOFTLY),
            refined,
            allowed=2 * _SOFTLY,
        ),
        *(
            Case(
                "slenderness",
                f"elastic, h0/L = {d:g}",
                lambda d=d: asked("elastic", E=_BEAM, delta=d, effects=STATIC, frames=3),
                # Small slopes: the next term is of the order of the strain, below 0.001 here.
                lambda run, sag=sag: ends_at(sag())(run),
            )
            for d, sag in (
                (1e-3, lambda: von_karman_sag(_BEAM, 1e-6 / 12, 1.0)),
                # Its sag is 0.0004 of its thickness: nothing of it is tension.
                (0.2, lambda: 1 / (32 * 0.2**2 * _BEAM)),
            )
        ),
        *(
            Case(
                "slenderness",
                f"maxwell, h0/L = {d:g}",
                lambda d=d: asked("maxwell", E=_BEAM, V=100, delta=d),
                refined,
                # What bends beside the clamps of the thinner one is far shorter than a cell.
                allowed=3e-3,
            )
            for d in (1e-5, 0.2)
        ),
        *(
            Case(
                "slenderness",
                f"bingham, h0/L = {d:g}",
                lambda d=d: asked("bingham", E=_SOFT, V=30, G=1, delta=d, T=2, ramp=1, accuracy=_YIELDING),
                refined,
                allowed=2 * _YIELDING,
            )
            for d in (1e-5, 0.2)
        ),
    ]


def _thresholds() -> list[Case]:
    def at(G: float, **more: object) -> sc.Scene:
        return asked("bingham", E=_SOFT, V=30, G=G, T=4, ramp=2, accuracy=_YIELDING, **more)  # type: ignore[arg-type]

    # First yield at the clamps is at G = 2 delta of a beam; a cable of this softness yields at some 0.1, whole at 0.2.
    continuous = [
        Case(
            "thresholds",
            f"{what}, G = {G:g}",
            lambda G=G: at(G),
            moves_like(at(G * 1.0001)),
            allowed=2 * _YIELDING,
            fast=what == "no arrest",
        )
        for what, G in (("first fibre", 0.06), ("hinges", 0.15), ("throughout", 0.3), ("no arrest", 2**0.5))
    ]

    def strength(share: float) -> sc.Scene:
        return asked("bingham", E=_SOFT, V=30, T=4, ramp=2, accuracy=_YIELDING, material={"yield_stress": share})

    return [
        *continuous,
        Case("yield stress", "0", lambda: strength(0.0), None, refusals=("SceneError",), says="yield_stress"),
        Case(
            "yield stress",
            "1e-9 of the weight",
            lambda: strength(1e-9),
            ends_like(asked("maxwell", E=_SOFT, V=30, T=4, ramp=2, accuracy=_YIELDING)),
            allowed=2 * _YIELDING,
        ),
        Case(
            "yield stress",
            "1e9 of the weight",
            lambda: strength(1e9),
            moves_like(asked("elastic", E=_SOFT, T=4, ramp=2, accuracy=_YIELDING)),
            allowed=2 * _YIELDING,
        ),
        *(
            Case(
                "herschel-bulkley",
                f"n = {n:g}",
                lambda n=n: asked("herschel-bulkley", E=_SOFT, V=30, G=1, n=n, T=4, ramp=2, accuracy=_YIELDING),
                moves_like(asked("bingham", E=_SOFT, V=30, G=1, T=4, ramp=2, accuracy=_YIELDING))
                if n == 1
                else refined,
                allowed=2 * _YIELDING,
                # At small rates n = 3 hardly resists: its hinges are drawn to 2.5 times their length.
                refusals=RUPTURES if n == 3 else (),
            )
            for n in (0.2, 0.5, 1.0, 2.0, 3.0)
        ),
    ]


FAMILIES = (_stiffness, _viscosity, _relaxation, _slenderness, _thresholds)
