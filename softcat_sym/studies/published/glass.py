"""Glass: the furnace of the softening point, and the beam-bending viscometer."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from softcat_sym.scene.scene import Scene
from softcat_sym.studies.published.case import (
    CaseCurve,
    CasePicture,
    Finding,
    Floats,
    PublishedValue,
    answer_of,
    answers_of,
    published_scene,
)

ELONGATES, RATE = 1e-3 / 60, 5 / 60
"""Elongation rate [m/s] of a fibre at its softening point, and heating rate of its furnace [K/s]: ASTM C338."""
ZERO = 273.15
_BELOW, _ABOVE = 40.0, 10.0


@dataclass(frozen=True)
class Glass:
    """A standard glass of the National Bureau of Standards: log10 eta/dPa s = A + B/(T - T_0), T in Celsius."""

    A: float
    B: float
    T_0: float
    softens: float  # Published softening point [C]
    density: float  # Approximate density [kg/m^3]
    surface: float  # Approximate surface tension [N/m]

    def viscosity(self, celsius: Floats | float) -> Floats:
        """Viscosity [Pa s]."""
        return np.asarray(10 ** (self.A - 1 + self.B / (np.asarray(celsius) - self.T_0)))


GLASSES = {
    "710": Glass(-1.626, 4236.1, 265.5, 724.0, 2500.0, 0.31),
    "717a": Glass(-1.546, 4852.2, 192.5, 720.0, 2270.0, 0.28),
}


def fibre_scene(glass: Glass) -> Scene:
    """The fibre from 40 K below its softening point to 10 K above it."""
    low, high = glass.softens - _BELOW, glass.softens + _ABOVE
    duration = (high - low) / RATE
    return published_scene("softening-fibre").replace(
        {
            "filament.density": f"{glass.density!r} kg/m^3",
            "surroundings.surface_tension": f"{glass.surface!r} N/m",
            "temperature.initial": f"{low!r} degC",
            "temperature.ambient": {"0 s": f"{low!r} degC", f"{duration!r} s": f"{high!r} degC"},
            "temperature.A": glass.A,
            "temperature.B": f"{glass.B!r} K",
            "temperature.T_0": f"{glass.T_0!r} degC",
            "run.duration": f"{duration!r} s",
        }
    )


@dataclass(frozen=True, eq=False)
class Softening:
    """A fibre in its furnace."""

    furnace: Floats  # Temperatures [C]
    speed: Floats  # Elongation rate at these temperatures [m/s]
    at: float  # Temperature of the furnace at 1 mm/min [C]
    fibre: float  # Temperature of the fibre at that time, in the middle of the furnace [C]


def softening(glass: Glass) -> Softening:
    """Heat a fibre as in ASTM C338."""
    run = answer_of(fibre_scene(glass))
    fields, heat = run.fields, run.scene.temperature
    time, length = fields["time"], -fields["y"][:, -1]
    speed = (length[2:] - length[:-2]) / (time[2:] - time[:-2])
    when = float(np.interp(ELONGATES, speed, time[1:-1]))
    furnace = glass.softens - _BELOW + RATE * time[1:-1]
    heated = 0.1 if heat is None or heat.heated is None else float(heat.heated[1])
    middle = int(np.argmin(np.abs(fields["X_node"] - (heated - run.scene.filament.span) / 2)))
    fibre = float(np.interp(when, time, fields["temperature"][:, middle])) - ZERO
    return Softening(furnace, speed, glass.softens - _BELOW + RATE * when, fibre)


def _softens(name: str) -> Finding:
    glass = GLASSES[name]
    found = softening(glass)
    decades = float(np.log10(glass.viscosity(found.fibre)))
    rows = (
        PublishedValue("softening point", "C", glass.softens, found.at, is_absolute=True),
        PublishedValue("log10 of the viscosity there [Pa s]", "", 6.75, decades, band=(6.5, 7.0), is_absolute=True),
    )
    curves = (
        CaseCurve("fibre", found.furnace[5:].tolist(), (6e4 * found.speed[5:]).tolist()),
        CaseCurve("softening point by the run", (found.at,), (1.0,), is_published=True),
    )
    picture = CasePicture("furnace [°C]", "growth [mm/min]", curves, is_log_y=True, published_x=glass.softens)
    return Finding(rows, picture)


_WEIGHT = 0.02


def _beam() -> Finding:
    scene = published_scene("glass-beam")
    filament, gravity = scene.filament, scene.load.gravity
    area, second = filament.thickness**2, filament.thickness**4 / 12
    own, viscosity = filament.density * area * filament.span, (scene.material.viscosity or 0.0) / 3
    bare, loaded = (
        # Per minute, as in the method.
        float(run.midpoint[1] - run.midpoint[2]) * 60 / (scene.run.duration / 2)
        for run in answers_of(scene, [{"load.point_mass": "0 kg"}, {"load.point_mass": f"{_WEIGHT} kg"}])
    )
    first = gravity * filament.span**3 * _WEIGHT / (viscosity * second * (loaded - bare))
    other = gravity * filament.span**3 * own / (viscosity * second * first * bare)
    rows = (
        PublishedValue("constant of the weight in mu = g L^3/(2.4 I v) (M + rho A L/1.6)", "", 2.4, first),
        PublishedValue("constant of the bar's own weight in it", "", 1.6, other),
    )
    masses = np.array([0.0, _WEIGHT])
    line = gravity * filament.span**3 / (2.4 * second * viscosity) * (masses + own / 1.6)
    curves = (
        CaseCurve("runs", (1e3 * masses).tolist(), [1e6 * bare, 1e6 * loaded]),
        CaseCurve("ASTM C598", (1e3 * masses).tolist(), (1e6 * line).tolist(), is_published=True),
    )
    return Finding(rows, CasePicture("weight at midspan [g]", "speed of the midpoint [µm/min]", curves))


RUNS = {
    "softening-710": partial(_softens, "710"),
    "softening-717a": partial(_softens, "717a"),
    "beam-bending": _beam,
}
