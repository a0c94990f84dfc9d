"""ASTM C338: a glass fibre in its furnace, heated at 5 K/min, elongates 1 mm/min at its softening point.

Glasses 710 and 717a of the National Bureau of Standards by their published constants. What the test method states is
held against what comes out, and against an independent quadrature: there is no free number in either.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.table import show

pytestmark = pytest.mark.slow

LENGTH, HEATED, DIAMETER, GRAVITY = 0.235, 0.1, 0.65e-3, 9.81
RATE, ELONGATES = 5 / 60, 1e-3 / 60
CAPACITY, TRANSFER, CONDUCTIVITY, OUTSIDE = 1250.0, 250.0, 1.3, 500.0
"""About those of glass, and of a fibre at 720 C in a furnace: convection (50) and the walls' radiation (200)."""
ZERO = 273.15


class Glass(NamedTuple):
    """log10 eta/dPa s = A + B/(T - T_0) in Celsius; published softening point; about its density, surface."""

    A: float
    B: float
    T_0: float
    softens: float
    density: float
    surface: float

    def viscosity(self, celsius: Any) -> Any:
        """In Pa s."""
        return 10 ** (self.A - 1 + self.B / (celsius - self.T_0))

    def celsius(self, viscosity: float) -> float:
        """Temperature of a viscosity in Pa s."""
        return float(self.T_0 + self.B / (np.log10(viscosity) + 1 - self.A))


GLASSES = {
    "710": Glass(-1.626, 4236.1, 265.5, 724, 2500, 0.31),
    "717a": Glass(-1.546, 4852.2, 192.5, 720, 2270, 0.28),
}


def scene(glass: Glass, **changes: object) -> sc.Scene:
    """The fibre from 40 K below its softening point to 10 K above it."""
    low, high = glass.softens - 40, glass.softens + 10
    duration = (high - low) / RATE
    table = {
        "filament": {"span": LENGTH, "diameter": DIAMETER, "density": glass.density},
        # The elastic part is some millionths: it spares a velocity that no cold glass has.
        "material": {"law": "maxwell", "youngs_modulus": "1 GPa", "shear_viscosity": "0.1 Pa*s"},
        "ends": {"left": "clamped", "left_angle": "-90 deg", "right": "free"},
        "surroundings": {"surface_tension": glass.surface},
        "temperature": {
            "initial": low + ZERO,
            "ambient": {"0 s": f"{low} degC", f"{duration} s": f"{high} degC"},
            "heated": [0.0, HEATED],
            "outside": f"{OUTSIDE} degC",
            "heat_capacity": CAPACITY,
            "heat_transfer": TRANSFER,
            "conductivity": CONDUCTIVITY,
            "law": "vft",
            "A": glass.A,
            "B": f"{glass.B} K",
            "T_0": f"{glass.T_0} degC",
        },
        "run": {
            "duration": duration,
            "frames": 301,
            "effects": [
                *("bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
                *("surface-tension", "temperature"),
            ],
        },
        "numerics": {"cells": 120, "grading": 1.0, "rtol": 1e-5, "estimate": False},
    }
    return sc.Scene.from_dict(table).replace(changes)


def reached(asked: sc.Scene, softens: float) -> tuple[float, float, float]:
    """Temperatures of furnace and fibre [C] at 1 mm/min; its speed [mm/min] where the furnace has another."""
    found = sc.simulate(asked)
    assert found.outcome.is_success, found.summary["message"]
    time, length = found.fields["time"], -found.fields["y"][:, -1]
    speed = (length[2:] - length[:-2]) / (time[2:] - time[:-2])
    at = float(np.interp(ELONGATES, speed, time[1:-1]))
    furnace = asked.temperature.ambient.at(at) - ZERO  # type: ignore[union-attr]
    middle = int(np.argmin(np.abs(found.fields["X_node"] - (HEATED - LENGTH) / 2)))
    fibre = float(np.interp(at, time, found.fields["temperature"][:, middle])) - ZERO
    later = at + (softens - furnace) / RATE
    return furnace, fibre, float(np.interp(later, time[1:-1], speed)) / ELONGATES


def by_quadrature(glass: Glass, heated: float = HEATED, colder: float = 0.0) -> float:
    """The same of the furnace, slice by slice: each is drawn by the weight below it less what its surface pulls.

    Slices of the undeformed fibre stretch at (rho g (L - X) - gamma sqrt(s)/R0) s/(3 eta), s its stretch; the fibre
    follows the furnace by rho c_p d/(4 h), and is half way to the outside at its end, within sqrt(k d/(4 h)). `colder`:
    how much colder than the middle, where its thermocouple is, the furnace is at its ends [K], as a parabola.
    """
    X = (np.arange(800) + 0.5) * heated / 800
    s, radius = np.ones(800), DIAMETER / 2
    lag = glass.density * CAPACITY * DIAMETER / (4 * TRANSFER)
    cold = np.exp((X - heated) / np.sqrt(CONDUCTIVITY * DIAMETER / (4 * TRANSFER))) / 2
    time, step, before = 0.0, 0.1, 0.0
    furnace = glass.softens - 40.0
    while True:
        inside = furnace - RATE * lag * -np.expm1(-time / lag) - colder * (2 * X / heated - 1) ** 2
        rate = (glass.density * GRAVITY * (LENGTH - X) * s - glass.surface / radius * np.sqrt(s)) * s
        rate /= 3 * glass.viscosity(inside + (OUTSIDE - inside) * cold)
        speed = float(np.sum(rate)) * heated / 800
        if speed >= ELONGATES:
            return furnace - RATE * step * (speed - ELONGATES) / (speed - before)
        s, time, before = s + step * rate, time + step, speed
        furnace += RATE * step


@pytest.mark.parametrize("name", GLASSES)
def test_a_fibre_elongates_where_the_method_says(name: str) -> None:
    """At 10^6.5 to 10^7 Pa s, as the method states; the published softening point is ten kelvin higher."""
    glass = GLASSES[name]
    furnace, fibre, faster = reached(scene(glass), glass.softens)
    exact = by_quadrature(glass)
    decades = float(np.log10(glass.viscosity(fibre)))
    rows = [
        ("published softening point", glass.softens, "", f"{np.log10(glass.viscosity(glass.softens)):.3f}"),
        ("furnace at 1 mm/min, run", f"{furnace:.2f}", f"{furnace - glass.softens:+.2f}", ""),
        ("furnace at 1 mm/min, quadrature", f"{exact:.2f}", f"{exact - glass.softens:+.2f}", ""),
        ("speed in a furnace of the published point, run", f"{faster:.2f} mm/min", "", ""),
        ("fibre at 1 mm/min, run", f"{fibre:.2f}", f"{fibre - glass.softens:+.2f}", f"{decades:.3f}"),
    ]
    # What would have to be otherwise for the published point.
    lengths = np.linspace(0.03, 0.1, 15)
    points = np.array([by_quadrature(glass, one) for one in lengths])
    needed = float(np.interp(-glass.softens, -points, lengths))
    rows.append(("heated length that would give it", f"{1e3 * needed:.0f} mm", "", ""))
    colder = np.linspace(0, 80, 9)
    points = np.array([by_quadrature(glass, colder=one) for one in colder])
    ends = float(np.interp(glass.softens, points, colder))
    rows.append(("ends of the furnace colder than its middle by", f"{ends:.0f} K", "", ""))
    for what, other in (
        ("twice the surface tension", glass._replace(surface=2 * glass.surface)),
        ("no surface tension", glass._replace(surface=0.0)),
        ("density 10 % less", glass._replace(density=0.9 * glass.density)),
    ):
        at = by_quadrature(other)
        rows.append((what, f"{at:.2f}", f"{at - glass.softens:+.2f}", ""))
    show(f"ASTM C338, glass {name}", ("", "C", "from the published [K]", "log10 eta [Pa s]"), rows)
    assert furnace == pytest.approx(exact, abs=0.15)
    assert 6.5 < decades < 7.0
    # The lag of the fibre, rho c_p d/(4 h) times 5 K/min, is no explanation: a sixth of a kelvin.
    assert 0.05 < furnace - fibre < 0.3
    assert -14 < furnace - glass.softens < -8
