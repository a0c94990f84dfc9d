"""Structure of a thixotropic material: one parameter at every point, which rest builds up and flow destroys.

d lambda/dt = (1 - lambda - lambda (tau |rate|)^c)/t_b (Moore 1959, with the power of de Souza Mendes & Thompson 2013);
yield stress and viscosity are linear in lambda (Houska 1981). Without a limit, d lambda/dt = (1 - lambda (tau
|rate|)^c)/t_b (Roussel 2006). The state is how far lambda has come from where it starts.
"""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.symbols import ONE, RATE, STRESS, TIME, VISCOSITY, enter, eta, sigma_Y
from softcat_sym.physics.time_dependent_constants import Clock, State

_MOORE, _ROUSSEL = "Moore 1959; de Souza Mendes & Thompson 2013", "Roussel 2006"

lam = enter("lambda", r"\lambda", ONE, "structure parameter of a fibre: 0 destroyed, 1 built up", _MOORE)
change = enter("Delta_lambda", r"\Delta\lambda", ONE, "change of the structure parameter since the start", _MOORE)
speed = enter("flow_rate", r"|\dot\epsilon^p|", RATE, "equivalent plastic strain rate of a fibre", "2.7")

t_b = enter("t_b", "t_b", TIME, "time in which structure builds up at rest", _MOORE, positive=True)
tau_b = enter("tau_b", r"\tau_b", TIME, "time that compares flow with build-up", _MOORE)
exponent = enter("c_b", "c_b", ONE, "power of the rate in the breakdown", _MOORE, positive=True)
rest = enter("t_rest", r"t_{rest}", TIME, "time at rest before the start", _ROUSSEL)
initial = enter("lambda_i", r"\lambda_i", ONE, "structure parameter for which the constants are stated", _MOORE)
yield_ends = (
    enter("sigma_Ys", r"\sigma_{Ys}", STRESS, "yield stress of the built-up material", "Houska 1981"),
    enter("sigma_Yd", r"\sigma_{Yd}", STRESS, "yield stress of the destroyed material", "Houska 1981"),
)
viscosity_ends = (
    enter("eta_s_b", r"\eta_{s}", VISCOSITY, "viscosity of the built-up material", "Houska 1981"),
    enter("eta_d_b", r"\eta_{d}", VISCOSITY, "viscosity of the destroyed material", "Houska 1981"),
)

_SYMBOLS = {
    "build_up_time": t_b,
    "breakdown_time": tau_b,
    "exponent": exponent,
    "rest": rest,
    "initial": initial,
    "structured_yield_stress": yield_ends[0],
    "destroyed_yield_stress": yield_ends[1],
    "structured_viscosity": viscosity_ends[0],
    "destroyed_viscosity": viscosity_ends[1],
}

_SLOW = sp.Rational(1, 10**8)
"""Of tau |rate|: below it the power is rounded, whose slope may be infinite at rest."""


def breakdown() -> sp.Expr:
    """(tau |rate|)^c, with a finite slope at rest."""
    relative = tau_b * speed
    return relative**2 * (relative**2 + _SLOW**2) ** (exponent / 2 - 1)


def build_up_rate(*, linear: bool) -> sp.Expr:
    """The rate of lambda [1/s]."""
    return ((1 if linear else 1 - lam) - lam * breakdown()) / t_b


def rested(start: sp.Expr, *, linear: bool) -> sp.Expr:
    """Lambda after a rest that began at `start`."""
    return start + rest / t_b if linear else 1 - (1 - start) * sp.exp(-rest / t_b)


def structure_clock(given: Collection[str], *, linear: bool) -> Clock:
    """What the keys of ``[material.structure]`` that a scene gives make of its yield stress and viscosity."""
    high, low = (
        symbol if f"{end}_yield_stress" in given else sigma_Y
        for end, symbol in zip(("structured", "destroyed"), yield_ends, strict=True)
    )
    of_yield = high is not sigma_Y or low is not sigma_Y
    start = (sigma_Y - low) / (high - low) if of_yield else initial if "initial" in given else sp.S.Zero
    begin = rested(start, linear=linear) if "rest" in given else start
    since = begin - start + change
    replaces = []
    if of_yield:
        replaces.append((sigma_Y, sigma_Y + (high - low) * since))
    if "structured_viscosity" in given:
        replaces.append((eta, eta + (viscosity_ends[0] - eta) * since / (1 - start)))
    if "destroyed_viscosity" in given:
        replaces.append((eta, eta + (eta - viscosity_ends[1]) * since / start))
    state = State("structure", change, lam, begin + change, build_up_rate(linear=linear))
    names = [name for name in _SYMBOLS if name in given]
    constants = tuple(Constant(f"material_structure_{name}", _SYMBOLS[name]) for name in names)
    return Clock("structure", tuple(replaces), constants, state=state)
