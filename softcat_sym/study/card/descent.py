"""What a finished run shows of a sagging filament: how far, how fast, and whether it rests."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.effects.prediction import effective_viscosity, yield_stress_of
from softcat_sym.scene import undeformed_area
from softcat_sym.study.card.contents import Certificate, Descent
from softcat_sym.trajectory.regime import ARREST_RATE, ARREST_TIME, TURNED_BACK, turned_back

if TYPE_CHECKING:
    from softcat_sym.trajectory import Trajectory

Floats = npt.NDArray[np.float64]

_STILL = 0.01


def descent_of(run: Trajectory) -> Descent | None:
    """Measure the descent of the midpoint; None if the run holds a single frame."""
    time, sag = run.data["time"].values, -run.data["midpoint"].values
    if len(time) < 2 or not np.all(np.isfinite(sag)):
        return None
    final = float(sag[-1])
    stretch = run.data["stretch"].values[-1]
    most = int(np.argmax(stretch))
    rise = turned_back(-sag)
    return Descent(
        final=final,
        largest=float(np.max(sag)),
        settled=_settled(time, sag),
        to_90=_first_at(time, sag, 0.9 * final) if final > 0 else None,
        rise=rise,
        damping="underdamped" if rise > TURNED_BACK else "overdamped",
        stretch=float(stretch[most]),
        stretch_at=float(run.data["X_cell"].values[most]) / run.scene.filament.span,
    )


def certificate_of(run: Trajectory, descent: Descent) -> Certificate:
    """Gather what says that it has stopped, or that it has not."""
    scene, data = run.scene, run.data
    sag = -data["midpoint"].values
    begin = min(len(sag) - 1, int((1 - ARREST_TIME) * (len(sag) - 1)))
    drift = float(np.ptp(sag[begin:]) / abs(descent.final)) if descent.final else 0.0
    limit, names = yield_stress_of(scene), tuple(run.summary["effects"])
    if limit is None:
        text = "no yield stress: only elasticity stops it" if not _flows(names) else "no yield stress: it never stops"
        return Certificate(None, None, None, None, None, None, None, drift, text)
    expected = expected_regime(scene, names)
    viscosity = effective_viscosity(scene)
    rate = float(np.max(data["plastic_rate"].values[begin:]))
    length = np.diff(data["X_node"].values)
    regime = str(run.summary.get("regime") or "")
    arrested = regime == "no-yield" or regime.startswith("arrested")
    found = Certificate(
        arrested=arrested,
        gravity_number=expected.gravity_number,
        first_yield=expected.first_yield,
        threshold=expected.arrest_exact,
        stress=largest_fibre_stress(run, -1) / limit,
        yielding=float(np.average(data["yielded_fraction"].values[-1], weights=length)),
        rate=rate * viscosity / limit if viscosity else None,
        drift=drift,
        text="",
    )
    return _worded(found, regime)


def _worded(found: Certificate, regime: str) -> Certificate:
    """The certificate in words."""
    if regime == "no-yield":
        return replace(found, text="no fibre ever yields: what it sags is elastic")
    rate = "" if found.rate is None else f"plastic rate {found.rate:.2g} sigma_Y/eta (limit {ARREST_RATE:g})"
    share = f"{100 * (found.yielding or 0.0):.2g} % still yields"
    if not regime:
        return replace(found, arrested=None, text=f"the run is not to be trusted; {rate}")
    return replace(found, text="; ".join(part for part in (rate, share) if part))


def _flows(names: tuple[str, ...]) -> bool:
    return "viscous-flow" in names


def _settled(time: Floats, sag: Floats) -> float | None:
    away = np.flatnonzero(np.abs(sag - sag[-1]) > _STILL * abs(sag[-1]))
    if away.size == 0:
        return float(time[0])
    first = int(away[-1]) + 1
    return float(time[first]) if time[first] <= time[0] + (1 - ARREST_TIME) * (time[-1] - time[0]) else None


def _first_at(time: Floats, sag: Floats, level: float) -> float:
    """When the sag first reaches a level, linear between frames."""
    after = int(np.argmax(sag >= level))
    if after == 0:
        return float(time[0])
    low, high = float(sag[after - 1]), float(sag[after])
    return float(time[after - 1] + (level - low) / (high - low) * (time[after] - time[after - 1]))


def largest_fibre_stress(run: Trajectory, frame: int | None = None) -> float:
    """Largest fibre stress of a frame, of the whole run by default [Pa].

    Of a section linear through the thickness it is |sigma_0| + |sigma_1|. A section that yields carries its
    yield stress and what flow adds to it, sigma_Y + K rate^n.
    """
    picked = slice(None) if frame is None else [frame]
    data, material = run.data.isel(time=picked), run.scene.material
    linear = np.abs(data["stress_mean"].values) + np.abs(data["stress_bending"].values)
    limit = yield_stress_of(run.scene)
    if limit is None or material.viscosity is None or "yielding" not in run.summary["effects"]:
        return float(np.max(linear))
    flowing = limit + material.viscosity * data["plastic_rate"].values ** material.index
    return float(np.max(np.where(data["yielded_fraction"].values > 0, flowing, np.minimum(linear, limit))))


def support_pull(run: Trajectory) -> float:
    """Force of the left support at the end over the area of the undeformed section [Pa]."""
    last = run.data.isel(time=-1, cell=0)
    along = last["axial_force"] if "axial_force" in last else last["tension"]
    return float(np.hypot(along, last["shear_force"])) / undeformed_area(run.scene)
