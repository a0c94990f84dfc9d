"""Whole scenes for Hypothesis: every law, section, end, start, body, load and list of effects within stated ranges.

Ranges, fixed before any scene was run (log: evenly in the logarithm; T is the duration, q = sqrt(L/g)). Materials are
drawn as in ``tests/common/random_scenes.py``, and the law ``custom`` besides.

====================  =================================================================================================
L, rho, g             log, 1 mm to 10 m; 500 to 5000 kg/m^3; log, 1 to 30 m/s^2
h0/L, section         log, 0.001 to 0.1; rectangle (perhaps wide), circle or sheet; Poisson's ratio 0 to 0.49
law                   each of the package's, equally often; of ``custom`` four rules of flow
E* = E/(rho g L)      log, 10 to 100 000
T                     log, 1 to 30 q; of a filament that rings, three of its periods at the most
eta/E                 log, 0.01 T to 100 T, but eta at least rho g L T/3, as of a Newtonian fluid; of a solid 0.01 to
                      10 q; Newtonian V: log, 10 to 100 000
G, V (yield stress)   log, 0.02 to 2; log, 3 to 10 000
n                     0.5 to 1.5
accuracy, frames      0.1, 0.03 or 0.01; 3 to 9 frames; its error estimated in 1 of 8
cells                 8 to 12 per half span, of any grading from 1 to 6, or the program's own
ends                  clamped 50 %, pinned 25 %, one of each 12 %, one free 12 %
ramp                  none 50 %, else log, 1 to 30 q, half the duration at the most
in 1 of 8 each        a drop of -0.3 to 0.3 L; clamps turned by up to 30 deg; a motion of one or two rows by up to
                      0.15 L either way; a profile of 2 to 5 values from 0.7 to 1.3; a curvature of up to 1/L; a point
                      mass of up to the filament's own; a surface tension that stretches it by up to a thousandth; a
                      bath of 0.1 to 1.5 of its density that drags by log 0.001 to 10 of its weight
start                 as it is 60 %; slack by up to 30 %; drawn by up to 5 % (what flows up to 30 %, at ease); P of up
                      to 0.02, C of up to 0.1 h0/L
effects               ``auto`` 60 %, ``paper`` 20 %, else a list with all that its members need; in 1 of 8 of ``paper``
                      the printed closure
in 1 of 8             gravity shaken by 0.05 to 1 of itself at 0.1 to 2 per q, but for the printed closure
in 1 of 8             the backend that the program chooses, else the interpreted one
in 1 of 16 each       the small-deflection model; an integrator by name; an order 2 to 4 or 4 to 12 fibres
====================  =================================================================================================

None of these where a scene has no such thing: no drop or motion with a free end, no slack with a ramp, nothing that
gives a Newtonian fluid a shape of its own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from hypothesis import strategies as st

from softcat_sym.effects.registry import REGISTRY
from tests.common.random_scenes import LAWS, Draw, material_of, not_too_long

T = TypeVar("T")

# Bytes are drawn evenly.
_fraction = st.binary(min_size=3, max_size=3).map(lambda some: int.from_bytes(some, "big") / 2**24)


def even(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers from `low` to `high`, evenly."""
    return _fraction.map(lambda share: low + (high - low) * share)


def log(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers from `low` to `high`, evenly in the logarithm."""
    return even(math.log(low), math.log(high)).map(math.exp)


def whole(least: int, most: int) -> st.SearchStrategy[int]:
    """Whole numbers from `least` to `most`, each equally often."""
    return _fraction.map(lambda share: least + int((most - least + 1) * share))


def choice(values: Sequence[T]) -> st.SearchStrategy[T]:
    """One of several values, each equally often."""
    return whole(0, len(values) - 1).map(lambda k: values[k])


def one_in(number: int) -> st.SearchStrategy[bool]:
    """True once in so many draws."""
    return whole(1, number).map(lambda k: k == number)


Table = dict[str, Any]

PERIODS = 3.0
SOLIDS = ("elastic", "kelvin-voigt", "standard-linear")
STIFF = ("elastic", "newtonian", "kelvin-voigt")
"""Laws without plastic strain that ``viscous-flow`` belongs to."""

RULES = (
    "sinh(sigma/s0)/t0",
    "sigma*(1 + (sigma/s0)**2)/(s0*t0)",
    "sign(sigma)*max(abs(sigma) - s0, 0)/(s0*t0)",
    "sigma*abs(sigma/s0)**power/(s0*t0)",
)
"""Own rules of flow; s0 is at least 3 rho g L, and s0 t0 the viscosity of a Maxwell law."""

_UNITS = {"youngs_modulus": "Pa", "second_modulus": "Pa", "yield_stress": "Pa", "viscosity": "Pa*s"}


@dataclass(frozen=True)
class Scales:
    """What a scene is measured in; SI."""

    span: float
    density: float
    gravity: float
    delta: float

    @property
    def stress(self) -> float:
        return self.density * self.gravity * self.span

    @property
    def time(self) -> float:
        return math.sqrt(self.span / self.gravity)


@st.composite
def scenes(draw: st.DrawFn, quick: bool = False) -> Table:
    """Raw tables as a scene file holds them; `quick` ones need no C compiler and few runs for an estimate."""
    at = Scales(draw(log(1e-3, 10)), draw(even(500, 5000)), draw(log(1, 30)), draw(log(1e-3, 0.1)))
    small = draw(one_in(16))
    law = draw(choice(("elastic", "maxwell") if small else (*LAWS, "custom")))
    numbers = Draw(
        law=law,
        section=draw(choice(("rectangle", "circle") if small else ("rectangle", "circle", "sheet"))),
        delta=at.delta,
        modulus=draw(log(10, 1e5)),
        viscous=draw(log(10, 1e5)),
        relaxation=draw(log(1e-2, 1e2)),
        G=draw(log(0.02, 2)),
        index=draw(even(0.5, 1.5)),
        share=draw(log(0.1, 10)),
        duration=draw(log(1, 30)),
        ends=("clamped", "clamped"),
    )
    # A viscosity at which the filament does not run away within the run.
    numbers = replace(numbers, relaxation=max(numbers.relaxation, 1 / (3 * numbers.modulus)))
    retardation = draw(log(0.01, 10))
    duration = not_too_long(numbers, retardation, PERIODS)
    ends = draw(_ends(at, law, small, duration * at.time))
    held = "free" not in (ends["left"], ends["right"])
    table: Table = {
        "model": "small-deflection" if small else "filament",
        "filament": draw(_bodies(at, numbers.section, law, small)),
        "material": draw(_materials(at, numbers, duration, retardation)),
        "ends": ends,
        "load": draw(_loads(at, duration)),
        "initial": {},
        "run": {"duration": f"{duration * at.time!r} s", "frames": draw(whole(3, 9))}
        | {"accuracy": draw(choice((0.1, 0.03, 0.01)))},
    }
    if draw(one_in(8)):
        tension = draw(even(0, 1e-3)) * numbers.modulus * at.stress * at.delta * at.span
        table["surroundings"] = {"surface_tension": f"{tension!r} N/m"}
    if draw(one_in(8)):
        # Viscous drag at the pace of free fall of up to ten times the weight.
        bath = {"density": f"{draw(even(0.1, 1.5)) * at.density!r} kg/m^3"}
        thick = draw(log(1e-3, 10)) * at.density * at.gravity * (at.delta * at.span) ** 2 / (at.span / at.time)
        table["surroundings"] = table.get("surroundings", {}) | bath | {"viscosity": f"{thick!r} Pa*s"}
    if held and not small:
        draw(_starts(table, at, law))
    draw(_physics(table, law))
    draw(_numerics(table, quick))
    return table


@st.composite
def _ends(draw: st.DrawFn, at: Scales, law: str, small: bool, duration: float) -> Table:
    how = draw(whole(0, 6 if small else 7))
    left = "clamped" if how < 4 or how == 7 else "pinned"
    right = "clamped" if how < 4 else "free" if how == 7 else "pinned"
    if how == 6:
        left, right = draw(choice((("clamped", "pinned"), ("pinned", "clamped"))))
    if how == 7 and draw(one_in(2)):
        left, right = right, left
    table: Table = {"left": left, "right": right}
    if small:
        return table
    held = how != 7
    if held and draw(one_in(8)) and law != "newtonian":
        table["drop"] = f"{draw(even(-0.3, 0.3)) * at.span!r} m"
    if law != "newtonian" and draw(one_in(8)):
        for side, end in (("left", left), ("right", right)):
            if end == "clamped":
                table[f"{side}_angle"] = f"{draw(even(-30, 30))!r} deg"
    if right != "free" and draw(one_in(8)):
        rows, last = [["0 s", "0 m", "0 m"]], 0.0
        for _ in range(draw(whole(1, 2))):
            last += draw(even(0.2, 0.5)) * duration
            shift = (draw(even(-0.15, 0.15)) * at.span, draw(even(-0.15, 0.15)) * at.span)
            rows.append([f"{last!r} s", *(f"{one!r} m" for one in shift)])
        table["motion"] = rows
    elif right != "free" and draw(one_in(8)):
        # Held by a motion that goes nowhere, so that the whole span is run even of a symmetric filament.
        table["motion"] = [["0 s", "0 m", "0 m"]]
    return table


@st.composite
def _bodies(draw: st.DrawFn, at: Scales, section: str, law: str, small: bool) -> Table:
    thickness = at.delta * at.span
    table: Table = {"span": f"{at.span!r} m", "thickness": f"{thickness!r} m", "density": f"{at.density!r} kg/m^3"}
    table["section"] = section
    if section == "rectangle" and draw(one_in(4)):
        table["width"] = f"{draw(log(0.5, 10)) * thickness!r} m"
    if not small and draw(one_in(8)):
        half = [draw(even(0.7, 1.3)) for _ in range(draw(whole(2, 5)))]
        table["profile"] = half[::-1] + half if draw(one_in(2)) else half
    if not small and law != "newtonian" and draw(one_in(8)):
        table["curvature"] = f"{draw(even(-1, 1)) / at.span!r} 1/m"
    return table


@st.composite
def _materials(draw: st.DrawFn, at: Scales, numbers: Draw, duration: float, retardation: float) -> Table:
    poisson = {"poisson": draw(even(0, 0.49))}
    if numbers.law == "custom":
        rule = draw(choice(RULES))
        s0, modulus = 3 * at.stress * max(1, 0.1 / numbers.G), numbers.modulus * at.stress
        t0 = modulus * numbers.relaxation * duration * at.time / s0
        parameters: Table = {"s0": f"{s0!r} Pa", "t0": f"{t0!r} s"} | (
            {"power": numbers.index} if "power" in rule else {}
        )
        known = {"law": "custom", "youngs_modulus": f"{modulus!r} Pa", "flow": rule, "parameters": parameters}
        return known | poisson
    plain = material_of(numbers, duration, draw(log(3, 1e4)), retardation, at.stress, at.time)
    indexed = "index" in plain
    units = _UNITS | ({"viscosity": f"Pa*s**{plain['index']!r}"} if indexed else {})
    table = {key: f"{value!r} {units[key]}" if key in units else value for key, value in plain.items()}
    if "modes" in table:
        table["modes"] = [{key: f"{value!r} {units[key]}" for key, value in one.items()} for one in table["modes"]]
    return table | poisson


@st.composite
def _loads(draw: st.DrawFn, at: Scales, duration: float) -> Table:
    table: Table = {"gravity": f"{at.gravity!r} m/s^2"}
    if draw(one_in(2)):
        table["ramp"] = f"{min(draw(log(1, 30)), duration / 2) * at.time!r} s"
    if draw(one_in(8)):
        # Of a square section; a circle weighs less, a wide rectangle more.
        table["point_mass"] = f"{draw(even(0, 1)) * at.density * at.span * (at.delta * at.span) ** 2!r} kg"
    if draw(one_in(8)):
        table |= {"shake": draw(even(0.05, 1)), "shake_frequency": f"{draw(log(0.1, 2)) / at.time!r} Hz"}
    return table


@st.composite
def _starts(draw: st.DrawFn, table: Table, at: Scales, law: str) -> None:
    """Slack, drawn, or with a plastic strain; changes `table`."""
    how, much = draw(whole(0, 9)), draw(even(0, 1))
    drop = float(table["ends"].get("drop", "0 m").split()[0])
    if how == 6 and law != "newtonian":
        table["filament"]["rest_length"] = f"{math.hypot(at.span, drop) * (1 + 0.3 * much)!r} m"
        table["load"].pop("ramp", None)
    elif how == 7:
        flows = law not in SOLIDS
        table["initial"] = {"stretch": 1 + (0.3 if flows else 0.05) * much, "relaxed": flows}
    elif how >= 8 and law not in (*SOLIDS, "newtonian"):
        if how == 8 or draw(one_in(2)):
            table["initial"]["P"] = [draw(even(-0.02, 0.02)) for _ in range(draw(whole(1, 4)))]
        else:
            most = 0.1 * at.delta
            table["initial"]["C"] = [draw(even(-most, most)) for _ in range(draw(whole(1, 4)))]


@st.composite
def _physics(draw: st.DrawFn, table: Table, law: str) -> None:
    """Effects and the closure; changes `table`."""
    how = draw(whole(0, 9))
    if table["model"] == "small-deflection":
        return
    if how in (6, 7):
        table["run"]["effects"] = "paper"
        if draw(one_in(8)):
            table["run"]["closure"] = "printed"
            for key in ("shake", "shake_frequency"):
                table["load"].pop(key, None)
    elif how > 7:
        held = set(table["load"]) | set(table.get("surroundings", {}))
        table["run"]["effects"] = draw(_lists(law, held, table["filament"].get("section", "rectangle")))


@st.composite
def _lists(draw: st.DrawFn, law: str, load: set[str], section: str) -> list[str]:
    """Any effects that law and scene may have, with all that they need; always bending, and what makes it flow."""
    flowing = law not in STIFF
    cannot = set() if flowing else {"viscous-flow", "fibres", "necking-gradient"}
    if law not in ("newtonian", "kelvin-voigt"):
        cannot |= {"viscous-stress"}
    if law not in ("bingham", "herschel-bulkley"):
        cannot |= {"yielding"}
    if "ramp" not in load:
        cannot |= {"gravity-ramp"}
    # No scene drawn here states a loss, a clock or a back stress.
    cannot |= {"solid-damping", "temperature", "curing", "structure", "natural-strain", "backstress", "contact"}
    if "shake" not in load:
        cannot |= {"gravity-shaking"}
    if "surface_tension" not in load:
        cannot |= {"surface-tension"}
    if "density" not in load:
        cannot |= {"buoyancy"}
    if "density" not in load or section == "sheet":
        cannot |= {"drag", "added-mass"}
    allowed = [effect.name for effect in REGISTRY if effect.name not in cannot]
    needs = {effect.name: effect.needs for effect in REGISTRY}
    wanted = {name for name in allowed if draw(one_in(2))} | {"bending", "extensibility"}
    wanted |= {"viscous-flow", "viscous-stress", "yielding", "gravity-shaking"} & set(allowed)
    while missing := {need for name in wanted for need in needs[name]} - wanted:
        wanted |= missing
    return [name for name in needs if name in wanted]


@st.composite
def _numerics(draw: st.DrawFn, table: Table, quick: bool) -> None:
    """Cells, integrator and backend; changes `table`."""
    numerics: Table = {"backend": "auto" if not quick and draw(one_in(8)) else "interpreted"}
    numerics["estimate"] = draw(one_in(16 if quick else 8))
    if numerics["estimate"]:
        table["run"]["accuracy"] = 0.1 if quick else table["run"]["accuracy"]
    elif quick or not draw(one_in(8)):
        numerics["cells"] = draw(whole(8, 12))
    if draw(one_in(4)):
        numerics["grading"] = draw(even(1, 6))
    if draw(one_in(16)):
        numerics["solver"] = draw(choice(("cvodes", "idas", "rosenbrock")))
    fibres = table["run"].get("effects", "auto")
    if (isinstance(fibres, list) and "fibres" in fibres) or (fibres == "auto" and draw(one_in(16))):
        law = table["material"]["law"]
        if table["model"] == "filament" and law not in STIFF:
            by_order = draw(one_in(2))
            numerics |= {"order": draw(whole(2, 4))} if by_order else {"fibres": draw(whole(4, 12))}
    table["numerics"] = numerics
