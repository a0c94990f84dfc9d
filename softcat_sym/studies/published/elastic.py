"""Elastic filaments: undulations by surface tension, rods in three dimensions, the modulus of a spanning strand."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from softcat_sym.studies.published.case import (
    CaseCurve,
    CasePicture,
    Finding,
    PublishedValue,
    answers_of,
    published_scene,
)

_GENTLEST = 2 ** (1 / 3)
"""Stretch at which a neo-Hookean cylinder is unstable first: 2 (s^(3/2) + 2 s^(-3/2)) has its minimum sqrt(32)."""

_RATIOS = (1.0, 2.0, 3.0, 3.5)
"""gamma/(G R) of the runs, all below every threshold."""


def _threshold(stretch: float) -> tuple[float, CaseCurve, CaseCurve]:
    """gamma/(G R) at which undulations grow without limit, from their amplitude below it.

    The response (a + b x)/(x_c - x) to the undulation of the radius has its pole there; three runs determine it.
    """
    scene = published_scene("undulation")
    radius, modulus = scene.filament.thickness / 2, float(scene.material.youngs_modulus or 0) / 3
    length = scene.filament.span
    rows = [
        {"surroundings.surface_tension": ratio * modulus * radius, "filament.span": stretch * length}
        for ratio in _RATIOS
    ]
    grown = np.array([np.ptp(run.fields["stretch"][-1]) for run in answers_of(scene, rows)])
    ratios = np.array(_RATIOS)
    # Each run is one linear equation for the pole, a and b.
    matrix = np.column_stack([grown, -np.ones(len(ratios)), -ratios])
    (pole, a, b), *_ = np.linalg.lstsq(matrix, grown * ratios, rcond=None)
    line = np.linspace(_RATIOS[0] / 2, 0.98 * pole, 80)
    words = "unstretched" if stretch == 1 else f"stretched by {stretch:.3g}"
    response = CaseCurve(f"{words}, (a + b x)/(x_c - x)", line.tolist(), ((a + b * line) / (pole - line)).tolist())
    return float(pole), response, CaseCurve(f"{words}, runs", _RATIOS, grown.tolist(), is_published=True)


def _undulations(published: float, stretch: float) -> Finding:
    pole, line, runs = _threshold(stretch)
    row = PublishedValue("threshold gamma/(G R)", "", published, pole)
    picture = CasePicture(
        "gamma/(G R)", "undulation of the stretch", (line, runs), is_log_y=True, published_x=published
    )
    return Finding((row,), picture)


_ANGLES = (15, 45, 75)
_SOLID = {
    8.896: ((10.57180106, 8.686786771, 3.481999513), (41.01165651, 105.976311, 139.59474)),
    13.345: ((16.37026068, 14.8505521, 6.062461977), (62.70699533, 153.554457, 192.972233)),
}
"""Tip displacements [mm] the stiff and the soft way, by load [N]: 4 x 12 x 500 solid elements."""
_BEAMS = {8.896: ((10.61328706, 8.837226265, 3.538889001), (42.08232124, 108.987937, 142.19437))}
"""The same for 199 beam elements."""


def _newtons(*force: float) -> list[str]:
    return [f"{part!r} N" for part in force]


def _tips(force: float) -> list[list[float]]:
    """Tip displacements [mm] the stiff and the soft way, at every angle."""
    angles = np.radians(_ANGLES)
    rows = [{"load.tip_force": _newtons(0.0, -force * math.cos(a), force * math.sin(a))} for a in angles]
    runs = [run.fields for run in answers_of(published_scene("princeton"), rows)]
    return [[-1e3 * float(run["y"][-1, -1]) for run in runs], [1e3 * float(run["z"][-1, -1]) for run in runs]]


def _princeton() -> Finding:
    rows, curves = [], []
    for force, solid in _SOLID.items():
        ours, beams = _tips(force), _BEAMS.get(force)
        for way, name in enumerate(("stiff", "soft")):
            rows.append(PublishedValue(f"tip the {name} way, {force:g} N at 45 deg", "mm", solid[way][1], ours[way][1]))
            if beams:
                rows.append(PublishedValue("the same of their beam elements", "mm", beams[way][1], ours[way][1]))
            curves.append(CaseCurve(f"{name}, {force:g} N", _ANGLES, ours[way]))
            curves.append(CaseCurve(f"{name}, {force:g} N, solid elements", _ANGLES, solid[way], is_published=True))
    return Finding(tuple(rows), CasePicture("loading angle [deg]", "displacement of the tip [mm]", tuple(curves)))


_BENDS = {300.0: (58.84, 22.33, 40.08), 600.0: (47.23, 15.79, 53.37)}
"""Place of the tip by force: eight elements of Simo & Vu-Quoc."""


def _curved_beam() -> Finding:
    rows = []
    runs = answers_of(
        published_scene("curved-beam"), [{"load.tip_force": _newtons(0.0, 0.0, force)} for force in _BENDS]
    )
    for (force, theirs), run in zip(_BENDS.items(), runs, strict=True):
        # Our axes are along the chord and across it; theirs along the tangent at the clamp and towards the centre.
        tip = [float(run.fields[axis][-1, -1] - run.fields[axis][-1, 0]) for axis in "xyz"]
        rows += [
            PublishedValue(f"{axis} of the tip, force {force:g}", "", b, a)
            for axis, a, b in zip("xyz", tip, theirs, strict=True)
        ]
    return Finding(tuple(rows))


_LIMIT = 0.05
"""Largest sag in diameters by the rule."""


def _spanning() -> Finding:
    scene = published_scene("spanning-strand")
    filament, gravity = scene.filament, scene.load.gravity
    unit = filament.density * gravity * (filament.span / filament.thickness) ** 4 * filament.thickness
    moduli = np.array([0.5, 1.0, 2.0, 4.0]) * unit
    runs = answers_of(scene, [{"material.youngs_modulus": 3 * modulus} for modulus in moduli])
    sags = np.array([-run.midpoint[-1] for run in runs]) / filament.thickness
    needed = math.exp(np.interp(-math.log(_LIMIT), -np.log(sags), np.log(moduli)))
    rows = (PublishedValue("G' D^3/(rho g L^4) for a sag of 0.05 D", "", 1.4, needed / unit, band=(1.35, 1.45)),)
    curves = (
        CaseCurve("runs", (moduli / unit).tolist(), sags.tolist()),
        CaseCurve("their rule", (1.4,), (_LIMIT,), is_published=True),
    )
    return Finding(rows, CasePicture("G' D^3/(rho g L^4)", "sag/D", curves, is_log_x=True, is_log_y=True))


RUNS = {
    "mora": partial(_undulations, 6.0, 1.0),
    "stretched-gel": partial(_undulations, math.sqrt(32), _GENTLEST),
    "princeton": _princeton,
    "curved-beam": _curved_beam,
    "smay": _spanning,
}
