"""Viscous filaments: a thread that its surface thins, and threads that sag under their weight."""

from __future__ import annotations

import numpy as np

from softcat_sym.studies.published.case import (
    CaseCurve,
    CasePicture,
    Finding,
    PublishedValue,
    answer_of,
    answers_of,
    published_scene,
)


def _thinning() -> Finding:
    run = answer_of(published_scene("thinning-thread"))
    data, scene = run.data, run.scene
    surface, viscosity = scene.surroundings.surface_tension, (scene.material.viscosity or 0.0) / 3
    middle = data.sizes["node"] // 2
    # The two cells beside midspan.
    stretch = np.mean(data["stretch"].values[:, middle - 1 : middle + 1], axis=1)
    force = np.mean(data["axial_force"].values[:, middle - 1 : middle + 1], axis=1)
    radius, time = scene.filament.thickness / 2 / np.sqrt(stretch), data["time"].values
    # A Newtonian thread pulled by X 2 pi gamma R thins at (2 X - 1) gamma/(6 mu), whatever its radius.
    by_speed = (1 - 6 * viscosity / surface * np.gradient(radius, time)) / 2
    by_force = force / (2 * np.pi * surface * radius)
    thin = radius / radius[0]
    rows = (
        PublishedValue("X = F/(2 pi gamma R), from the force", "", 0.7127, float(by_force[-1])),
        PublishedValue("X from the speed of thinning, (2 X - 1) gamma/(6 mu)", "", 0.7127, float(by_speed[-2])),
    )
    later = slice(10, -1)
    curves = (
        CaseCurve("X from the force", thin[later].tolist(), by_force[later].tolist()),
        CaseCurve("X from the speed", thin[later].tolist(), by_speed[later].tolist()),
    )
    return Finding(rows, CasePicture("R/R at the start", "X", curves, is_log_x=True, published_y=0.7127))


_DIAMETERS, _VISCOSITIES = (1e-3, 1.4e-3, 2e-3, 2.8e-3), (9.7, 97.0, 970.0)
_DEEP = 0.4
"""Sag over span at which the shapes are compared."""


def _shapes() -> Finding:
    scene, curves, shapes = published_scene("hanging-oil"), [], []
    fluid = scene.material.viscosity or 0.0
    for viscosity in _VISCOSITIES:
        factor = 3 * viscosity / fluid
        rows = [
            {
                "filament.diameter": f"{diameter!r} m",
                "material.shear_viscosity": f"{viscosity!r} Pa*s",
                "run.duration": f"{1.35 * factor!r} s",
            }
            for diameter in _DIAMETERS
        ]
        found = []
        for run in answers_of(scene, rows):
            sag = -run.midpoint / scene.filament.span
            frame = int(np.argmax(sag >= _DEEP))
            thickness, X = run.fields["thickness"][frame], run.cells / scene.filament.span
            found.append(float(np.interp(0.0, X, thickness) / np.interp(0.3, X, thickness)))
        shapes.append(found)
        curves.append(CaseCurve(f"{viscosity:g} Pa·s", [1e3 * d for d in _DIAMETERS], found))
    spread = np.ptp(np.array(shapes), axis=0) / np.mean(shapes, axis=0)
    row = PublishedValue("shape at a sag of 0.4 L, largest over smallest", "", 1.0, 1 + float(spread.max()))
    picture = CasePicture("diameter [mm]", "thickness, X = 0 over X = 0.3 L", tuple(curves))
    return Finding((row,), picture)


def _cube_root() -> Finding:
    run = answer_of(published_scene("viscous-string"))
    time, sag = run.data["time"].values[10:], -run.data["midpoint"].values[10:] / run.scene.filament.span
    exponent = np.polyfit(np.log(time), np.log(sag), 1)[0]
    rows = (PublishedValue("exponent of the sag in time", "", 1 / 3, float(exponent)),)
    law = sag[-1] * (time[::15] / time[-1]) ** (1 / 3)
    curves = (
        CaseCurve("run", time.tolist(), sag.tolist()),
        CaseCurve("t^(1/3) through its end", time[::15].tolist(), law.tolist(), is_published=True),
    )
    return Finding(rows, CasePicture("time in eta/(rho g L)", "sag/L", curves, is_log_x=True, is_log_y=True))


RUNS = {"sachsenheimer": _thinning, "zylstra": _shapes, "brochard": _cube_root}
