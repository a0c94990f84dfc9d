"""Laws at a point against RheoJAX: bars in runs of the package, drawn and hung, beside kernels integrated by SciPy.

``pip install softcat_sym[peers]`` brings RheoJAX (Wei Chen, https://github.com/imewei/rheojax) to Python 3.12 or newer.
Only its files ``models/*/_kernels.py`` and JAX are called, so they may stand in a package of that name on the path.

What its kernels know in shear alone is taken to extension. Scalar laws: stresses by sqrt 3, viscosities by 3, rates by
sqrt 3. Giesekus and FENE-P: its kernel relaxes the tensor, and what stretches it, L A + A L^T, is added here. Oldroyd-B
is extension in RheoJAX itself (a VLB network). It has no Phan-Thien & Tanner: the upper-convected, linear one of
``tests.common.polymers`` stands in, a tensor that shares nothing with the package.

DMT is compared in what the two have in common: breakdown by any power, yield stress and viscosity linear in lambda
(RheoJAX's Herschel-Bulkley closure with n = m1 = m2 = 1), of a bar so stiff that all of its rate is flow. It differs in
de Souza Mendes & Thompson's exponential viscosity of lambda and in their modulus of lambda, which the package has not.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import softcat_sym as sc
from tests.common import polymers
from tests.common.polymers import LAMBDA, OWN, SOLVENT, Floats, G
from tests.common.table import show
from tests.test_structure import bar as thixotropic_bar

pytestmark = pytest.mark.slow

ROOT = math.sqrt(3)
MODULUS, STIFF = 1e5, 1e9
TOLERANCE = 1e-4
DESTROYED, STRUCTURED = 300.0, 900.0
EXTENSION = np.array([2.0, -1.0, -1.0])
"""What a fibre's rate makes of the logarithms of a tensor's components along it and across."""


@dataclass(frozen=True)
class Point:
    """A law at a point in extension: its state, and what a strain rate or a stress does to it."""

    start: Floats
    rates: Callable[[Floats, float], Floats]  # Of the state, at a strain rate
    stress: Callable[[Floats, float], float]
    rate_under: Callable[[Floats, float], float]  # Strain rate under a stress that grows with the stretch
    modulus: float = math.inf  # Of what is strained as soon as a weight is hung on it; its stress is the first state


def kernels_of(family: str) -> Any:
    """Kernels of RheoJAX for a family of laws; skips without it."""
    path = f"rheojax.models.{family}._kernels"
    reason = "RheoJAX cannot be imported: pip install softcat_sym[peers] on Python 3.12 or newer"
    pytest.importorskip(path, reason=reason, exc_type=ImportError)
    return import_module(path)


def mikh(build_up: float, breakdown: float) -> Point:
    """RheoJAX's MIKH without backstress; its state is sigma, alpha, lambda."""
    kernels = kernels_of("ikh")
    given = {"C": 0.0, "gamma_dyn": 1.0, "m": 1.0, "eta": 1e30, "mu_p": 5e4 / 3, "G": MODULUS / 3, "k3": 0.0}
    given |= {"sigma_y0": DESTROYED / ROOT, "delta_sigma_y": (STRUCTURED - DESTROYED) / ROOT}
    given |= {"tau_thix": build_up, "Gamma": breakdown / ROOT / build_up}
    scale = np.array([ROOT, ROOT, 1.0])

    def rates(state: Floats, rate: float) -> Floats:
        shear = {**given, "gamma_dot": ROOT * rate}
        return scale * np.asarray(kernels.ikh_maxwell_ode_rhs(0.0, state / scale, shear), dtype=float)

    def rate_under(state: Floats, stress: float) -> float:
        # sigma_t = E (rate - flow) = sigma rate.
        return float(-rates(state, 0.0)[0] / (MODULUS - stress))

    return Point(np.zeros(3), rates, lambda state, _: float(state[0]), rate_under, MODULUS)


def dmt(build_up: float, breakdown: float, power: float) -> Point:
    """RheoJAX's DMT without elasticity; its state is lambda, a third at the start."""
    kernels, given = kernels_of("dmt"), dmt_constants(breakdown, power)
    law = given["tau_y0"], given["m1"], given["K0"], given["m2"]

    def parts(lam: float) -> tuple[float, float]:
        limit, viscosity = kernels.yield_stress(lam, *law[:2]), kernels.consistency(lam, *law[2:])
        return ROOT * float(limit), 3 * float(viscosity + given["eta_inf"])

    def rates(state: Floats, rate: float) -> Floats:
        kinetics = build_up, given["a"], given["c"]
        return np.asarray(kernels.structure_evolution(state, ROOT * rate, *kinetics), dtype=float)

    def stress(state: Floats, rate: float) -> float:
        limit, viscosity = parts(state[0])
        return limit + viscosity * rate

    def rate_under(state: Floats, sigma: float) -> float:
        limit, viscosity = parts(state[0])
        return max(sigma - limit, 0.0) / viscosity

    return Point(np.array([DESTROYED / STRUCTURED]), rates, stress, rate_under)


def dmt_constants(breakdown: float, power: float) -> dict[str, float]:
    """Constants in shear of sigma_Y = 900 Pa lambda, eta = (25 + 75 lambda) kPa s."""
    closure = {"tau_y0": STRUCTURED / ROOT, "K0": 7.5e4 / 3, "n_flow": 1.0, "eta_inf": 2.5e4 / 3}
    return closure | {"a": (breakdown / ROOT) ** power, "c": power, "m1": 1.0, "m2": 1.0}


def polymer(law: str) -> Point:
    """The chains of a polymer law beside its solvent."""
    across = np.array([2.0, -1.0, 0.0, -1.0])
    rest, rates, chains = {
        "oldroyd-b": (np.ones(2), _oldroyd_b, lambda A: G * (A[0] - A[1])),
        "giesekus": (np.zeros(4), lambda tau, rate: _giesekus(tau) + rate * across * (tau + G), lambda t: t[0] - t[1]),
        "fene-p": (np.array([1.0, 1, 1, 0]), lambda A, rate: _fene_p(A) + rate * np.append(EXTENSION, 0) * A, _spring),
        "ptt": (np.ones(3), lambda A, rate: _ptt(A) + rate * EXTENSION * A, lambda A: G * (A[0] - A[1])),
    }[law]

    def stress(state: Floats, rate: float) -> float:
        return float(chains(state)) + SOLVENT * rate

    return Point(rest, rates, stress, lambda state, sigma: (sigma - stress(state, 0.0)) / SOLVENT)


def _oldroyd_b(A: Floats, rate: float) -> Floats:
    return np.array([float(one) for one in kernels_of("vlb").vlb_mu_rhs_uniaxial(A[0], A[1], rate, 1 / LAMBDA)])


def _giesekus(tau: Floats) -> Floats:
    """Relaxation of the stress (xx, yy, xy, zz), drawn along x."""
    mobility = OWN["giesekus"]["mobility"]
    return np.asarray(kernels_of("giesekus").giesekus_ode_rhs(0.0, tau, 0.0, G * LAMBDA, LAMBDA, mobility))


def _fene_p(A: Floats) -> Floats:
    """Relaxation of (xx, yy, zz, xy), without Bell's breakage, creation by stretch and slip."""
    longest = math.sqrt(OWN["fene-p"]["finite_extensibility"])
    return np.asarray(_network()(0.0, A, 0.0, G, LAMBDA, 0.0, 0.0, 0.0, longest, 0.0), dtype=float)


@cache
def _network() -> Any:
    """Transient network of finite extensibility, compiled once."""
    return kernels_of("tnt").build_tnt_ode_rhs("constant", use_fene=True)


def _spring(A: Floats) -> float:
    longest = math.sqrt(OWN["fene-p"]["finite_extensibility"])
    return float(kernels_of("tnt").stress_fene_n1(A[0], A[1], A[2], G, longest))


def _ptt(A: Floats) -> Floats:
    return -np.diag(polymers.relaxation("ptt", np.diag(A))) / LAMBDA


def integrated(rates: Callable[[float, Floats], Floats], start: Floats, times: Floats) -> Floats:
    """States at some times, the first of which is that of the start."""
    found = solve_ivp(rates, (times[0], times[-1]), start, "LSODA", times, rtol=1e-9, atol=1e-11)
    assert found.success
    return np.asarray(found.y.T)


def drawn_apart(point: Point, run: sc.Run) -> float:
    """Difference in start-up of a bar whose end is drawn along straight pieces, over the largest stress."""
    path, times = run.scene.ends.motion, run.data.time.values
    length, state, expected = run.scene.filament.span, point.start, {}
    for (a, x, _), (b, y, _) in pairwise(path):
        speed = (y - x) / (b - a)

        def rate(t: float, a: float = a, x: float = x, speed: float = speed) -> float:
            return speed / (length + x + speed * (t - a))

        asked = times[(times >= a) & (times < b)]
        states = integrated(lambda t, s, rate=rate: point.rates(s, rate(t)), state, np.array([a, *asked[asked > a], b]))
        for t, one in zip([a, *asked[asked > a]], states, strict=False):
            expected[float(t)] = point.stress(one, rate(t))
        state = states[-1]
    exact = np.array([expected[float(t)] for t in times[1:]])
    return float(np.max(np.abs(stress_of(run)[1:] - exact)) / np.max(exact))


def simulated(scene: sc.Scene) -> sc.Run:
    """The run of a scene, which must reach its end."""
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.outcome
    return run


def stress_of(run: sc.Run) -> Floats:
    """True stress of a bar: its tension over the area that its stretch leaves."""
    area = math.pi / 4 * run.scene.filament.thickness**2
    return np.asarray((run.data.tension * run.data.stretch).values[:, 0] / area)


def creep_apart(point: Point, scene: sc.Scene) -> float:
    """Difference of the strains in a bar that hangs by its own weight, at every height a creep under constant force."""
    run = simulated(scene)
    load, apart, largest = scene.filament.density * scene.load.gravity, 0.0, 0.0
    times = run.data.time.values
    for cell, place in enumerate(run.data.X_cell.values):
        # X is measured from the middle; the bar hangs by its left end.
        pull = load * (scene.filament.span / 2 - float(place))
        begin, state = 0.0, point.start
        if math.isfinite(point.modulus):
            begin = brentq(lambda e, pull=pull: point.modulus * e - pull * math.exp(e), 0.0, 0.9)
            state = np.array([point.modulus * begin, *state[1:]])

        def rates(_: float, both: Floats, pull: float = pull) -> Floats:
            state, strain = both[:-1], both[-1]
            rate = point.rate_under(state, pull * math.exp(strain))
            return np.append(point.rates(state, rate), rate)

        exact = integrated(rates, np.append(state, begin), times)[1:, -1]
        found = np.log(run.data.stretch.values[1:, cell])
        apart, largest = max(apart, float(np.max(np.abs(found - exact)))), max(largest, float(np.max(exact)))
    return apart / largest


HANGING = {"left": "clamped", "right": "free", "left_angle": "-90 deg"}


def hung(scene: sc.Scene, stress: float, duration: float) -> sc.Scene:
    """The bar of a scene hung by its left end, its weight a stress there."""
    # A clamp holds it upright, and asks for bending of fibres.
    effects = list(dict.fromkeys([*scene.run.effects, "bending", "fibres"]))
    gravity = f"{stress / (scene.filament.density * scene.filament.span)!r} m/s^2"
    return scene.replace(
        {"ends": HANGING, "load.gravity": gravity, "numerics.cells": 8}
        | {"run.duration": f"{duration} s", "run.effects": effects, "run.frames": 21}
    )


def thixotropic(kind: str, build_up: float, breakdown: float, power: float, **changes: Any) -> sc.Scene:
    """The bar for one of RheoJAX's laws of structure; DMT's is as good as rigid, and its viscosity builds up too."""
    table = {"build_up_time": f"{build_up!r} s", "breakdown_time": f"{breakdown} s", "exponent": power}
    if kind == "DMT":
        table |= {"destroyed_yield_stress": "0 Pa", "structured_viscosity": "100 kPa*s"}
        changes = {"material.youngs_modulus": f"{STIFF} Pa", **changes}
    return thixotropic_bar(table, **{"numerics.backend": "compiled", **changes})


def structured(kind: str) -> tuple[float, float]:
    """Start-up and creep of DMT or MIKH: each the largest difference of some constants."""
    worst = [0.0, 0.0]
    cases = [(1.0, 10.0, 1.0), (4.0, 30.0, 0.5), (20.0, 20.0, 1.7)]
    for build_up, breakdown, power in cases:
        power = power if kind == "DMT" else 1.0
        point = dmt(build_up, breakdown, power) if kind == "DMT" else mikh(build_up, breakdown)
        run = simulated(thixotropic(kind, build_up, breakdown, power))
        hanging = hung(thixotropic(kind, build_up, breakdown, power), 3000.0, 5.0)
        apart = drawn_apart(point, run), creep_apart(point, hanging)
        worst = [max(pair) for pair in zip(worst, apart, strict=True)]
    return worst[0], worst[1]


def polymeric(law: str) -> tuple[float, float]:
    """Start-up and creep of a polymer law."""
    point = polymer(law)
    compiled = {"numerics.backend": "compiled", "run.frames": 33}

    def drawn(wi: float, duration: float, rows: int) -> sc.Run:
        # The run ends within a piece, and writes no frame where one begins: there its rate is two.
        whole = polymers.bar(law, lambda t: np.exp(wi * t / LAMBDA), duration, rows, **compiled)
        return simulated(whole.replace({"run.duration": f"{duration * (1 - 0.5 / rows)!r} s"}))

    start_up = max(drawn_apart(point, drawn(wi, 3.0, 40)) for wi in (0.3, 1.0))
    scene = polymers.bar(law, lambda t: 1 + t, 1.0, 1, **compiled)
    return start_up, creep_apart(point, hung(scene, 1.0, 2.0))


def test_laws_at_a_point_are_those_of_rheojax() -> None:
    """Start-up of a drawn bar, creep of one that hangs."""
    measured = {kind: structured(kind) for kind in ("DMT", "MIKH")}
    measured |= {law: polymeric(law) for law in ("oldroyd-b", "giesekus", "fene-p", "ptt")}
    words = {"DMT": "DMT, linear in lambda", "MIKH": "MIKH, C = 0", "oldroyd-b": "Oldroyd-B", "giesekus": "Giesekus"}
    words |= {"fene-p": "FENE-P", "ptt": "PTT (a tensor by SciPy: RheoJAX has none)"}
    show(
        "Largest difference of a bar in a run from RheoJAX at a point",
        ("law", "start-up, stress", "creep, strain"),
        [(words[law], *(f"{one:.1e}" for one in row)) for law, row in measured.items()],
    )
    assert all(max(row) < TOLERANCE for row in measured.values()), measured
