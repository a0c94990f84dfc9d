"""Random scenes: two hundred filaments of every law, section, end and start, drawn from ranges fixed beforehand.

Ranges (log: evenly in the logarithm):

====================  =================================================================================================
accuracy              0.01 or 0.001
h0/L                  log, 0.001 to 0.1; rectangle, circle or sheet
law                   elastic, newtonian, kelvin-voigt, standard-linear, maxwell, multimode-maxwell, bingham, power-law,
                      herschel-bulkley, equally often
E* = E/(rho g L)      log, 10 to 100 000
duration T            log, 1 to 100 sqrt(L/g); of a filament that rings, ten of its periods at the most
eta/E                 log, 0.01 T to 100 T; of a solid 0.01 to 10 sqrt(L/g); Newtonian V: log, 10 to 100 000
G, V (yield stress)   log, 0.02 to 2; log, 3 to 10 000
n                     0.5 to 1.5
ends                  clamped 50 %, pinned 25 %, one of each 10 %, one free 15 %
ramp                  none 50 %, else log, 1 to 30 sqrt(L/g), half the duration at the most
in 10 % each          slack by up to 30 % (or, of an elastic filament, drawn by up to 5 %); a support lowered by up to
                      0.3 L; a point mass of up to the filament's own. None of them with a free end, none slack with a
                      ramp; no Newtonian fluid slack or with a lowered support, which gives it no shape to begin with
surroundings          if asked for: a surface tension of 1 to 72 mN/m (log) in 60 %, of an elastic filament a tenth of
                      what it withstands at the most; none 25 %, air 25 %, a liquid as thin as water of 300 to 1500
                      kg/m^3 25 %, an oil of 900 kg/m^3 and 0.01 to 10 Pa s (log) 25 %
====================  =================================================================================================
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

import softcat_sym as sc
from tests.common.rheology import scene

SEED = 20261121
NUMBER = 200
FRAMES = 101

_SPAN, _DENSITY, _GRAVITY = 0.2, 1000.0, 9.81
_STRESS, _TIME = _DENSITY * _GRAVITY * _SPAN, math.sqrt(_SPAN / _GRAVITY)
LAWS = (
    "elastic",
    "newtonian",
    "kelvin-voigt",
    "standard-linear",
    "maxwell",
    "multimode-maxwell",
    "bingham",
    "power-law",
    "herschel-bulkley",
)
_ENDS = (("clamped", "clamped"), ("pinned", "pinned"), ("clamped", "pinned"), ("clamped", "free"))
_HOW_OFTEN = (0.5, 0.25, 0.1, 0.15)
_MODES = (0.1, 1.0, 10.0)
_PERIODS = 10.0


@dataclass(frozen=True)
class Draw:
    """Numbers of one scene before its law takes what it needs."""

    law: str
    section: str
    delta: float
    modulus: float
    viscous: float
    relaxation: float
    G: float
    index: float
    share: float
    duration: float
    ends: tuple[str, str]


def random_scenes(number: int = NUMBER, seed: int = SEED) -> list[sc.Scene]:
    """The scenes, always the same for a seed; the first of a longer list are those of a shorter one."""
    generator = np.random.default_rng(seed)
    return [_scene(generator) for _ in range(number)]


def in_surroundings(scenes: list[sc.Scene], seed: int = SEED) -> list[sc.Scene]:
    """The same filaments, each in surroundings of its own."""
    generator = np.random.default_rng(seed + 1)
    return [_surrounded(scene, generator) for scene in scenes]


def _surrounded(scene: sc.Scene, generator: np.random.Generator) -> sc.Scene:
    pulled, kind, tension, thin, oil = (float(u) for u in generator.uniform(size=5))
    bath = ((0.0, 0.0), (1.2, 1.8e-5), (300 + 1200 * thin, 1e-3), (900.0, 10 ** (3 * oil - 2)))[int(4 * kind)]
    gamma = 1e-3 * 72**tension if pulled < 0.6 else 0.0
    if scene.material.law in ("elastic", "kelvin-voigt", "standard-linear") and scene.material.youngs_modulus:
        gamma = min(gamma, 0.1 * scene.material.youngs_modulus * scene.filament.thickness)
    return scene.replace(
        {
            "surroundings.surface_tension": f"{gamma!r} N/m",
            "surroundings.density": f"{bath[0]!r} kg/m^3",
            "surroundings.viscosity": f"{bath[1]!r} Pa*s",
        }
    )


def _scene(generator: np.random.Generator) -> sc.Scene:
    def log(low: float, high: float) -> float:
        return float(np.exp(generator.uniform(math.log(low), math.log(high))))

    drawn = Draw(
        law=str(generator.choice(LAWS)),
        section=str(generator.choice(("rectangle", "circle", "sheet"))),
        delta=log(1e-3, 0.1),
        modulus=log(10, 1e5),
        viscous=log(10, 1e5),
        relaxation=log(1e-2, 1e2),
        G=log(0.02, 2),
        index=float(generator.uniform(0.5, 1.5)),
        share=log(0.1, 10),
        duration=log(1, 100),
        ends=_ENDS[generator.choice(4, p=_HOW_OFTEN)],
    )
    pace, retardation, ramp = log(3, 1e4), log(0.01, 10), log(1, 30)
    accuracy, ramped, extra, much = (float(u) for u in generator.uniform(size=4))
    duration = not_too_long(drawn, retardation)
    material = material_of(drawn, duration, pace, retardation)
    filament: dict[str, Any] = {"span": _SPAN, "density": _DENSITY, "thickness": drawn.delta * _SPAN}
    filament["section"] = drawn.section
    load: dict[str, Any] = {"gravity": _GRAVITY, "ramp": min(ramp, duration / 2) * _TIME if ramped < 0.5 else 0.0}
    ends: dict[str, Any] = {"left": drawn.ends[0], "right": drawn.ends[1]}
    initial: dict[str, Any] = {}
    if "free" not in drawn.ends:
        if extra < 0.1:
            if drawn.law == "elastic":
                initial = {"stretch": 1 + 0.05 * much, "relaxed": False}
            elif drawn.law != "newtonian":
                filament["rest_length"] = _SPAN * (1 + 0.3 * much)
                load["ramp"] = 0.0
        elif extra < 0.2 and drawn.law != "newtonian":
            ends["drop"] = 0.3 * much * _SPAN
        elif extra < 0.3:
            load["point_mass"] = much * _DENSITY * _SPAN * (drawn.delta * _SPAN) ** 2
    return scene(
        material,
        filament,
        effects="auto",
        ends=ends,
        initial=initial,
        load=load,
        run={"duration": duration * _TIME, "frames": FRAMES, "accuracy": 1e-2 if accuracy < 0.5 else 1e-3},
    ).replace({"numerics": {}})


def not_too_long(drawn: Draw, retardation: float, periods: float = _PERIODS) -> float:
    """Duration over sqrt(L/g): so many periods of what rings on."""
    if drawn.law == "newtonian":
        return drawn.duration
    beam, cable = 1 / (32 * drawn.delta**2 * drawn.modulus), (3 / (64 * drawn.modulus)) ** (1 / 3)
    period = 2 * math.pi * math.sqrt(1 / (1 / beam + 1 / cable))
    damped = {"kelvin-voigt": retardation > 0.1 * period, "standard-linear": False}.get(
        drawn.law, drawn.law in ("maxwell", "power-law", "multimode-maxwell") and drawn.relaxation < 0.01
    )
    return drawn.duration if damped else min(drawn.duration, periods * period)


def material_of(
    drawn: Draw, duration: float, pace: float, retardation: float, stress: float = _STRESS, time: float = _TIME
) -> dict[str, Any]:
    """Table ``[material]`` in SI numbers; `stress` is rho g L, `time` sqrt(L/g)."""
    modulus = drawn.modulus * stress
    viscosity = modulus * drawn.relaxation * duration * time
    elastic = {"law": drawn.law, "youngs_modulus": modulus}
    consistency = drawn.viscous * stress * time**drawn.index
    yields = {"yield_stress": stress / drawn.G}
    modes = [
        {"youngs_modulus": modulus / 3, "viscosity": modulus / 3 * drawn.relaxation * duration * time * factor}
        for factor in _MODES
    ]
    return {
        "elastic": elastic,
        "newtonian": {"law": "newtonian", "viscosity": drawn.viscous * stress * time},
        "kelvin-voigt": elastic | {"viscosity": modulus * retardation * time},
        "standard-linear": elastic
        | {"second_modulus": modulus * drawn.share, "viscosity": modulus * drawn.share * retardation * time},
        "maxwell": elastic | {"viscosity": viscosity},
        "multimode-maxwell": {"law": drawn.law, "modes": modes},
        "bingham": elastic | yields | {"viscosity": pace * stress * time},
        "power-law": elastic | {"viscosity": consistency, "index": drawn.index},
        "herschel-bulkley": elastic | yields | {"viscosity": pace * stress * time**drawn.index, "index": drawn.index},
    }[drawn.law]
