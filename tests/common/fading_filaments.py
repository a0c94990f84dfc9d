"""Filaments on which one effect fades: sags with and without it, and what theory says of their difference.

Units: span 1 m, rho g L = 1e4 Pa. An effect's share is the largest difference of the midpoint over the largest midpoint
of the run without it; theory says share = prefactor * coefficient**exponent for small coefficients.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from tests.common.laying import laid_beam
from tests.common.rheology import GEOMETRY, STRING, Array, limit_of, scene, solved
from tests.common.truths import beam_shaken

WEIGHT = 1e4
"""rho g L [Pa]."""
Pair = tuple[Array, Array]
STRETCHES = ("extensibility",)
PINNED = {"left": "pinned", "right": "pinned"}
LAID_DOWN = 1e11
"""Modulus [Pa] that makes a Maxwell fluid viscous: without one a straight string cannot begin without inertia."""


def sag(material: Mapping[str, Any], filament: Mapping[str, Any], effects: tuple[str, ...], **asked: Any) -> Array:
    """Sags of the midpoint [m]; `asked` goes to the scene, its ``numerics`` over the table there."""
    numerics = {f"numerics.{key}": value for key, value in asked.pop("numerics", {}).items()}
    if "surface_tension" in asked:
        numerics["surroundings.surface_tension"] = f"{asked.pop('surface_tension')!r} N/m"
    numerics |= {f"surroundings.{key}": value for key, value in asked.pop("surroundings", {}).items()}
    run = {"frames": 21, **asked.pop("run", {})}
    made = scene(material, filament, effects=effects, run=run, **{"cells": 16, "rtol": 1e-8, **asked})
    return -np.asarray(solved(made.replace(numerics))["midpoint"].values)


def pair(
    effect: str, without: tuple[str, ...], material: Mapping[str, Any], filament: Mapping[str, Any], **asked: Any
) -> Pair:
    """Sags with an effect and without it."""
    with_it, without_it = (sag(material, filament, names, **asked) for names in ((*without, effect), without))
    return with_it, without_it


def cable_modulus(depth: float) -> float:
    """Modulus [Pa] of the elastic cable of this sag: H^3 = 3 rho g L^4/(64 E)."""
    return 3 * WEIGHT / (64 * depth**3)


def beam_modulus(depth: float, thickness: float) -> float:
    """Modulus [Pa] of the clamped linear beam of this sag: H = 12 rho g L^4/(384 E h^2)."""
    return 12 * WEIGHT / (384 * thickness**2 * depth)


# --- inertia: rho to zero at the same weight ---------------------------------------------------------------------
# Viscous beam. It starts at rest instead of at its creeping speed v, which it reaches at the rate
# gamma = eta I k^4/(rho A): from then on it lags by v/gamma, which goes as rho: exponent 1.
# Viscous string, a singular limit: without inertia it begins with infinite speed, H = (9 W t/(128 eta))^(1/3) L,
# W = rho g L. Free fall g t^2/2 meets it at t_i ~ (rho/W)^(3/5) (W/eta)^(1/5), where both go as rho^(1/5): so does the
# largest error of all times. Later the string is late by ~ t_i, an error ~ rho^(3/5), but that is not all that is left.
# The modes that keep the length of the parabola, tan u = u with u = k L/2, are damped only as its dashpot
# D = 64 eta A H^2/L^3 gives way to their tension: at the rate 4 T/(D L) = 1/(9 t), all alike. Their action a^2 omega is
# else conserved while omega ~ T^(1/2) ~ t^(-1/6), so that a ~ t^(1/12 - 1/9) and a/H ~ (t_i/t)^(1/36 + 1/3): at a fixed
# time the error goes as rho^(3/5 * 13/36) = rho^(13/60).
VISCOSITY = 1e6


@cache
def creeping_string(frames: int) -> Array:
    """Viscous string without inertia."""
    material = {"law": "maxwell", "youngs_modulus": LAID_DOWN, "viscosity": VISCOSITY}
    return sag(material, {"thickness": 0.01}, ("viscous-flow",), cells=8, run={"frames": frames})


def falling_string(density: float, frames: int) -> Array:
    """Viscous string with inertia; `density` in 1000 kg/m^3."""
    filament, load = {"thickness": 0.01, "density": 1000 * density}, {"gravity": 10 / density}
    fluid = {"law": "newtonian", "viscosity": VISCOSITY}
    run = {"frames": frames}
    return sag(fluid, filament, ("inertia", "viscous-stress"), cells=8, rtol=1e-6, load=load, run=run)


def inertia_always(density: float) -> Pair:
    return falling_string(density, 2001), creeping_string(2001)


def inertia_of_a_beam(density: float) -> Pair:
    fluid, load = {"law": "newtonian", "viscosity": 1e5}, {"gravity": 10 / density}
    filament = {"thickness": 0.1, "density": 1000 * density}
    return pair("inertia", ("bending", *STRETCHES, "viscous-stress"), fluid, filament, load=load)


# --- bending: l/L to zero, l = sqrt(EI/T) = L (h/H)/sqrt(32 L^2) on the elastic cable of sag H ---------------------
# T y'' - EI y'''' = w. Between clamps, y = (w/2T)(x(L - x) - l L (1 - exp(-x/l) ...)): at the same tension the midpoint
# loses 4 l/L of its sag. The mean of y'^2 loses 9 l/L, and T^3 goes as it: T falls by 3 l/L and gives back as much: the
# share is l/L. Between pins the midpoint loses 8 (l/L)^2, the mean of y'^2 24 (l/L)^2 - 60 (l/L)^3: T falls by
# 8 (l/L)^2 - 20 (l/L)^3, the squares cancel, and the share is 20 (l/L)^3. On a string that creeps they do not: its
# tension remembers, and the exponent is 2.
CABLE_SAG = 0.05


def bending_of_a_cable(ends: Mapping[str, str], layer: float) -> Pair:
    thickness = layer * np.sqrt(32) * CABLE_SAG
    material = {"law": "elastic", "youngs_modulus": cable_modulus(CABLE_SAG)}
    asked = {"ends": ends, "cells": 120, "run": {"frames": 2}, "numerics": {"grading": 20.0}}
    return pair("bending", STRETCHES, material, {"thickness": thickness}, **asked)


# --- extensibility: H/h to zero ----------------------------------------------------------------------------------
# Clamped beam, y = 16 H u^2 (1 - u)^2: T = (EA/2L) int y'^2 = (256/105) EA (H/L)^2. EI y1'''' = T y'' with clamped ends
# has y1(L/2) = -H T L^2/(40 EI): share (256/105)(12/40)(H/h)^2.
STIFFENING = 256 / 105 * 12 / 40


def extensibility_of_a_beam(relative: float) -> Pair:
    thickness = 0.05
    material = {"law": "elastic", "youngs_modulus": beam_modulus(relative * thickness, thickness)}
    return pair("extensibility", ("bending",), material, {"thickness": thickness}, cells=40, run={"frames": 2})


# --- geometry of a cable: mean strain e = (8/3)(H/L)^2 to zero ----------------------------------------------------
# H goes as the cube root of 1/E. log s is e/2 less than s - 1: e/6. The area is e smaller: e/3. The exact elastic
# catenary, with a = rho g L/(its horizontal force), has 1/E* = (a^3/24)(1 - 9 a^2/80) and H = (a/8)(1 - a^2/48), so
# H^3 E* 64/3 = 1 + a^2/20: share a^2/60 = (16/15)(H/L)^2 = (2/5) e.
def geometry_of_a_cable(effect: str, strain: float) -> Pair:
    material = {"law": "elastic", "youngs_modulus": cable_modulus(float(np.sqrt(3 * strain / 8)))}
    left = STRETCHES + tuple(name for name in STRING if name != effect)
    return pair(effect, left, material, {"thickness": 0.01}, cells=40, run={"frames": 2})


# --- material ----------------------------------------------------------------------------------------------------
# Viscous flow on a cable, e = T/E + int T/eta and T ~ 1/H, e ~ H^2: 3 H_t/H = E/eta.
def flow_of_a_cable(relaxed: float) -> Pair:
    modulus = cable_modulus(0.1)
    material = {"law": "maxwell", "youngs_modulus": modulus, "viscosity": modulus / relaxed}
    return pair("viscous-flow", STRETCHES, material, {"thickness": 0.01})


# Viscous stress on a linear Kelvin-Voigt beam: H(t) = H_elastic(t - eta/E). The quintic ramp is steepest halfway, 15/8.
def viscous_stress_of_a_beam(retarded: float) -> Pair:
    material = {"law": "kelvin-voigt", "youngs_modulus": 1e6, "viscosity": 1e6 * retarded}
    asked = {"load": {"ramp": 1.0}, "run": {"frames": 41}}
    return pair("viscous-stress", ("bending", "gravity-ramp"), material, {"thickness": 0.1}, **asked)


# Yielding on a creeping string, e_t = (sigma - sigma_Y)/eta and sigma = W L/(8 H): (H^3)_t falls by 8 H sigma_Y/W.
# H ~ t^(1/3): H^3 loses 6 H sigma_Y/W, H a third of it.
CREPT = (9 * WEIGHT / (128 * VISCOSITY)) ** (1 / 3)


def yielding_of_a_string(threshold: float) -> Pair:
    material = {"law": "bingham", "youngs_modulus": LAID_DOWN, "viscosity": VISCOSITY}
    material["yield_stress"] = threshold * WEIGHT
    return pair("yielding", (*STRETCHES, "viscous-flow"), material, {"thickness": 0.01})


# Gravity ramp: everything comes half a ramp later. A creeping beam (linear) has H = v t; a swinging one is off by
# half a ramp of its largest speed.
def ramp_of_a_creeping_beam(ramp: float) -> Pair:
    material, filament = {"law": "newtonian", "viscosity": 1e6}, {"thickness": 0.1}
    return pair("gravity-ramp", ("bending", "viscous-stress"), material, filament, load={"ramp": ramp})


# Shaking: linear in a; its prefactor is Duhamel's integral over the modes, at three quarters of the first frequency.
_BEAM = {"law": "elastic", "youngs_modulus": 1e8}
_SHAKEN = {"run": {"frames": 41, "duration": 0.12, "accuracy": 1e-2}, "cells": 60}
_HERTZ = float(0.75 * 22.373285 * 0.05 * np.sqrt(1e8 / (12 * 1000)) / (2 * np.pi))


def shaking_of_a_beam(a: float) -> Pair:
    load, without = {"shake": a, "shake_frequency": f"{_HERTZ!r} Hz"}, ("inertia", "bending")
    shaken = sag(_BEAM, {"thickness": 0.05}, (*without, "gravity-shaking"), load=load, **_SHAKEN)
    return shaken, sag(_BEAM, {"thickness": 0.05}, without, **_SHAKEN)


def duhamel_share() -> float:
    """Largest swing for a = 1 over the largest one without."""
    unit = np.sqrt(0.1)
    time = np.linspace(0.0, 0.12, 41) / unit
    without, shaken = (beam_shaken(time, 1e4, 0.05, a, _HERTZ * unit) for a in (0.0, 1.0))
    return float(np.max(np.abs(shaken - without)) / np.max(np.abs(without)))


# --- surroundings ------------------------------------------------------------------------------------------------
# Surface tension pulls with F = Gam A = 2 gamma h on a square section. A clamped beam under a tension sags by
# q L^2/(8 F) (1 - (2/u) tanh(u/2)), u = (L/2) sqrt(F/EI): q L^4/(384 EI) (1 - F L^2/(40 EI) + ...).
def surface_of_a_beam(force: float) -> Pair:
    thickness = 0.05
    modulus = beam_modulus(1e-3 * thickness, thickness)
    asked = {"cells": 40, "run": {"frames": 2}, "surface_tension": force * modulus * thickness**3 / 24}
    material, filament = {"law": "elastic", "youngs_modulus": modulus}, {"thickness": thickness}
    return pair("surface-tension", ("bending", *STRETCHES), material, filament, **asked)


# Buoyancy: q (1 - rho_b/rho), of a linear beam that share of the sag.
def buoyancy_of_a_beam(ratio: float) -> Pair:
    material = {"law": "elastic", "youngs_modulus": beam_modulus(1e-3, 0.05)}
    bath = {"density": f"{1000 * ratio!r} kg/m^3"}
    return pair("buoyancy", ("bending",), material, {"thickness": 0.05}, run={"frames": 2}, surroundings=bath)


def floor_of_a_beam(reached: float) -> Pair:
    """A linear beam rests with its middle on a floor a little above its sag: the middle misses just that."""
    material = {"law": "elastic", "youngs_modulus": beam_modulus(1e-3, 0.05)}
    # Of the same cells, which sag by some thousandths more than a beam.
    rests = float(sag(material, {"thickness": 0.05}, ("bending",))[-1])
    floor = {"floor.depth": f"{rests * (1 - reached)!r} m", "floor.penetration": f"{1e-9 * reached!r} m"}
    return changed_pair("contact", ("bending",), material, {"thickness": 0.05}, floor)


def laying_of_a_beam(share: float) -> Pair:
    """A viscous beam that was laid in a share of the time: it has crept (T_l/6 + T_h)/(T_l + T_h) as far."""
    run, nozzle = {"duration": 1.0, "frames": 2}, {"print_speed": 0.0999 / share}
    laid, at_once = (laid_beam(16, run=run, extrusion=one) for one in (nozzle, None))
    return tuple(-one.data.midpoint.values[-1:] for one in (laid, at_once))  # type: ignore[return-value]


# Drag and added mass: the first mode of a swinging beam loses zeta/(2 rho A) in time, and its period gains half of the
# share of the mass.
def bath_of_a_beam(effect: str, bath: Mapping[str, str]) -> Pair:
    material = {"law": "elastic", "youngs_modulus": beam_modulus(SWING_SAG, 0.05)}
    asked = {"load": {"ramp": SWING_RAMP}, "run": {"frames": 101, "duration": SWING}, "cells": 12}
    without = ("inertia", "bending", "gravity-ramp")
    return pair(effect, without, material, {"thickness": 0.05}, surroundings=bath, **asked)


def drag_of_a_beam(viscosity: float) -> Pair:
    return bath_of_a_beam("drag", {"viscosity": f"{viscosity!r} Pa*s"})


def mass_of_a_bath(ratio: float) -> Pair:
    return bath_of_a_beam("added-mass", {"density": f"{1000 * ratio!r} kg/m^3"})


# --- section -----------------------------------------------------------------------------------------------------
# Shear: q L^2/(8 kappa_s mu A) over q L^4/(384 EI) (Timoshenko): 8 (1 + nu)/kappa_s (h/L)^2, nu = 0.45, kappa_s = 5/6.
# The limit of two grids: the two theories are discretised differently.
def shear_of_a_beam(delta: float) -> Pair:
    material = {"law": "elastic", "youngs_modulus": beam_modulus(0.01 * delta, delta)}

    def converged(effects: tuple[str, ...]) -> Array:
        asked = {"run": {"frames": 2}}
        coarse, fine = (sag(material, {"thickness": delta}, effects, cells=n, **asked) for n in (20, 40))
        return np.asarray(limit_of(coarse, fine))

    return converged((*GEOMETRY, "shear")), converged(GEOMETRY)


# Fibres: at sigma_Y = 0 the plastic strain is linear through the thickness. To first order in sigma_Y both profiles
# flow alike, since the residual stress has no resultants; it shifts the fibre where the stress changes sign by
# ~ sigma_Y, and there the rate jumps by 2 sigma_Y/eta: exponent 2. (Without tension there is no such shift by symmetry,
# and the exponent is 3.) The linear profile is that of order 1, so that little but the profile differs;
# that this is the run without fibres is a test by itself.
BENDING_FLOW = (*GEOMETRY, "viscous-flow", "yielding")


def bingham_beam(threshold: float, effects: tuple[str, ...], cells: int, numerics: Mapping[str, int]) -> Array:
    """A pinned beam as deep as it is thick."""
    material = {"law": "bingham", "youngs_modulus": 2e6, "viscosity": 5e5, "yield_stress": threshold * WEIGHT}
    asked = {"ends": PINNED, "cells": cells, "rtol": 1e-7, "run": {"frames": 6}, "numerics": numerics}
    return sag(material, {"thickness": 0.1}, effects, **asked)


def fibres_of_a_beam(threshold: float) -> Pair:
    effects, points = (*BENDING_FLOW, "fibres"), {"fibres": 24}
    linear = bingham_beam(threshold, effects, 10, {"order": 1})
    return bingham_beam(threshold, effects, 10, points), linear


# Necking gradient: the force b s_X, b = beta h^2 T/s^4, against T: exponent 2 in h where s is smooth. At a pin it must
# vanish, in a layer as wide as h where s is wrong by h: again h^2.
def gradient_of_a_string(delta: float) -> Pair:
    material, asked = {"law": "maxwell", "youngs_modulus": 1e6, "viscosity": 2e4}, {"ends": PINNED, "cells": 40}
    return pair("necking-gradient", (*STRING, "viscous-flow"), material, {"thickness": delta}, **asked)


# Rotary inertia (Rayleigh): omega^2 of the first clamped mode falls by 12.30 (h/L)^2/12, its swing comes later.
SWING, SWING_RAMP = 0.1, 0.03  # duration and ramp [s]; the ramp excites the first mode, of 0.055 s, nearly alone
SWING_SAG = 1e-3
RAYLEIGH = 12.30


def rotation_of_a_beam(delta: float) -> Pair:
    material = {"law": "elastic", "youngs_modulus": beam_modulus(SWING_SAG, delta)}
    asked = {"load": {"ramp": SWING_RAMP}, "run": {"frames": 101, "duration": SWING}, "cells": 12}
    without = (*GEOMETRY, "shear", "inertia", "gravity-ramp")
    return pair("rotary-inertia", without, material, {"thickness": delta}, **asked)


def swing_share(slower: float, damped: float) -> float:
    """Largest change of a single mode q'' + 2 zeta omega q' + omega^2 (q - ramp) = 0, over its largest swing."""

    def swing(omega: float, loss: float) -> Array:
        def motion(t: float, state: Array) -> list[float]:
            u = min(t / SWING_RAMP, 1.0)
            pull = omega**2 * (10 * u**3 - 15 * u**4 + 6 * u**5 - state[0])
            return [state[1], pull - loss * omega * state[1]]

        times = np.linspace(0.0, SWING, 101)
        found = solve_ivp(motion, (0, SWING), [0, 0], rtol=1e-9, atol=1e-11, t_eval=times, max_step=SWING_RAMP / 20)
        return np.asarray(found.y[0])

    omega = 4.730041**2 * np.sqrt(WEIGHT / (384 * SWING_SAG) / 1000)
    plain = swing(omega, 0.0)
    return float(np.max(np.abs(swing(omega * (1 - slower), damped) - plain)) / np.max(plain))


def rayleigh_share() -> float:
    """Share per (h/L)^2: the frequency falls."""
    return swing_share(1e-4, 0.0) / 1e-4 * RAYLEIGH / 24


# --- solid damping -----------------------------------------------------------------------------------------------
# A mode of a beam loses zeta omega t of its amplitude, zeta = loss_tangent/2 of the first: exponent 1.
def loss_of_a_beam(tangent: float) -> Pair:
    material = {"law": "elastic", "youngs_modulus": beam_modulus(SWING_SAG, 0.05), "loss_tangent": tangent}
    asked = {"load": {"ramp": SWING_RAMP}, "run": {"frames": 101, "duration": SWING}, "cells": 12}
    without = ("inertia", "bending", "gravity-ramp")
    return pair("solid-damping", without, material, {"thickness": 0.05}, **asked)


def loss_share() -> float:
    """Share per loss tangent."""
    return swing_share(0.0, 1e-4) / 1e-4


# --- clocks --------------------------------------------------------------------------------------------------------
# A viscosity eta (1 + r t) of a creeping beam: log(1 + r)/r instead of 1 at the end.
def curing_of_a_creeping_beam(rate: float) -> Pair:
    material = {"law": "newtonian", "viscosity": 1e6}
    changed = {"material.viscosity": f"1e6 Pa*s + {1e6 * rate!r} Pa*t"}
    return changed_pair("curing", ("bending", "viscous-stress"), material, {"thickness": 0.1}, changed)


# A held beam that shrinks by e is pulled by E A e: as by a surface, of which F L^2/(E I) is 12 e (L/h)^2. Drawn back to
# its length it has lost 3 e of its area, and 6 e of its stiffness.
def shrinking_of_a_beam(force: float) -> Pair:
    thickness = 0.05
    material = {"law": "elastic", "youngs_modulus": beam_modulus(1e-3 * thickness, thickness)}
    changed = {"material.natural_strain": f"{-force * thickness**2 / 12!r}*t/(1 s)"}
    without = ("bending", *STRETCHES)
    return changed_pair("natural-strain", without, material, {"thickness": thickness}, changed, cells=40)


# A creeping beam warmer by so many kelvin than what its viscosity is stated for: exp(B (1/T - 1/T_r)).
def warmth_of_a_creeping_beam(kelvin: float) -> Pair:
    heat = {"initial": f"{300 + kelvin!r} K", "heat_capacity": "1e9 J/(kg*K)", "law": "arrhenius"}
    heat |= {"reference": "300 K", "activation_energy": f"{8.31446261815324 * 3000!r} J/mol"}
    changed = {f"temperature.{key}": value for key, value in heat.items()}
    material = {"law": "newtonian", "viscosity": 1e6}
    without = (*STRING, "extensibility", "bending", "viscous-stress")
    return changed_pair("temperature", without, material, {"thickness": 0.1}, changed)


# A Bingham beam whose yield stress grows from a fifth of its weight's to three fifths at the rate of 1/t_b.
def structure_of_a_beam(rate: float) -> Pair:
    material = {"law": "bingham", "youngs_modulus": 1e7, "viscosity": 1e6, "yield_stress": 0.2 * WEIGHT}
    structure = {"build_up_time": f"{1 / rate!r} s", "structured_yield_stress": f"{0.6 * WEIGHT!r} Pa"}
    without, asked = (*BENDING_FLOW, "fibres"), {"numerics": {"fibres": 8}}
    filament = {"thickness": 0.1}
    return changed_pair("structure", without, material, filament, {"material.structure": structure}, **asked)


# A Bingham beam that flows at a fifth of its weight's stress, with a back stress of so many times that per strain.
def hardening_of_a_beam(modulus: float) -> Pair:
    material = {"law": "bingham", "youngs_modulus": 1e7, "viscosity": 1e6, "yield_stress": 0.2 * WEIGHT}
    without, asked = (*BENDING_FLOW, "fibres"), {"numerics": {"fibres": 8}}
    changed = {"material.hardening_modulus": f"{modulus * WEIGHT!r} Pa"}
    return changed_pair("backstress", without, material, {"thickness": 0.1}, changed, **asked)


def changed_pair(
    effect: str,
    without: tuple[str, ...],
    material: Mapping[str, Any],
    filament: Mapping[str, Any],
    changed: Mapping[str, object],
    **asked: Any,
) -> Pair:
    """Sags with an effect of a scene that is changed so, and without it."""
    numerics = {f"numerics.{key}": value for key, value in asked.pop("numerics", {}).items()}
    found = []
    for names in ((*without, effect), without):
        made = scene(material, filament, effects=names, run={"frames": 21}, **{"cells": 16, "rtol": 1e-8, **asked})
        found.append(-np.asarray(solved(made.replace({**changed, **numerics}))["midpoint"].values))
    return found[0], found[1]
