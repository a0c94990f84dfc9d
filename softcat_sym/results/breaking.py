"""Breaking: when and where a fibre of the filament first reaches the strain or the stress that its material bears."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.scene import Scene

_KEYS = ("breaking_strain", "breaking_stress")

_BENT = 0.01
"""Share of the strain above which it matters on which side a filament breaks."""


@dataclass(frozen=True, slots=True)
class Break:
    """Where a filament breaks."""

    time_s: float
    X_m: float  # Material coordinate, 0 at midspan
    side: str  # ``top``, ``bottom``, or ``section`` where tension tears all of it
    strain: float  # True (Hencky) strain of the outer fibre
    stress_Pa: float  # True stress of the fibre
    by: str  # ``strain`` or ``stress``: which limit was reached
    rate_per_s: float  # At which its load grows, over what the material bears
    time_error_s: float | None = None  # None where it is not estimated

    @property
    def text(self) -> str:
        """In words."""
        where = "through the section" if self.side == "section" else f"from the {self.side}"
        error = "" if self.time_error_s is None else f" ± {self.time_error_s:.2g} s"
        return (
            f"it breaks after {self.time_s:.6g} s{error} at X = {self.X_m:.4g} m, {where}, by its {self.by} "
            f"(outer fibre: true strain {self.strain:.4g}, true stress {self.stress_Pa:.4g} Pa)"
        )


def breakable(scene: Scene) -> bool:
    """Whether the scene says what its material bears."""
    return scene.material.breaking_strain is not None or scene.material.breaking_stress is not None


def unbreakable(scene: Scene) -> Scene:
    """The scene of a filament that bears anything."""
    return scene.replace({f"material.{key}": None for key in _KEYS})


def refuse_broken(scene: Scene) -> NoReturn:
    """Say that the filament bears less than it is asked to from the beginning, or as soon as that can be told."""
    keys = [key for key in _KEYS if getattr(scene.material, key) is not None]
    found = "exceeded as soon as anything moves"
    raise SceneError([Fault(f"material.{key}", found, "more than what the start asks of it") for key in keys])


def fibres(fields: Mapping[str, Floats]) -> tuple[Floats, Floats, Floats, Floats]:
    """Where the outer fibre is most loaded, its true strain and stress, and the curvature.

    At the middles of cells, shape (time, cell + 2), and at both ends, by a straight line through the last two: where an
    end is clamped the bending is largest there. The strain is log(s (1 + |kappa| h/2)), the logarithm of what the fibre
    is stretched by, and the stress its mean and its linear part over the section.
    """
    cells, nodes = fields["X_cell"], fields["X_node"]
    ends = ((0, 1, nodes[0]), (-1, -2, nodes[-1]))
    shares = [(place - cells[near]) / (cells[near] - cells[far]) for near, far, place in ends]

    def extended(name: str) -> Floats:
        values = fields[name]
        outer = [values[:, near] * (1 + s) - values[:, far] * s for (near, far, _), s in zip(ends, shares, strict=True)]
        return np.column_stack([outer[0], values, outer[1]])

    curvature = extended("curvature")
    bent = np.log1p(np.abs(curvature) * extended("thickness") / 2)
    strain = np.log(np.maximum(extended("stretch"), 1e-300)) + bent
    stress = extended("stress_mean") + np.abs(extended("stress_bending"))
    return np.array([nodes[0], *cells, nodes[-1]]), strain, stress, curvature


def load_of(scene: Scene, fields: Mapping[str, Floats]) -> Floats:
    """Strain and stress of the outer fibre over what the material bears, shape (2, time, cell + 2)."""
    _, strain, stress, _ = fibres(fields)
    limits = (scene.material.breaking_strain, scene.material.breaking_stress)
    found = [
        0 * strain if limit is None else value / limit for value, limit in zip((strain, stress), limits, strict=True)
    ]
    return np.nan_to_num(np.array(found), nan=0.0, posinf=np.inf)


def first_break(scene: Scene, fields: Mapping[str, Floats]) -> Break | None:
    """When, between which frames and where the filament first bears all that it can; None if it never does."""
    frame = break_frame(scene, fields)
    if frame is None:
        return None
    load = load_of(scene, fields)
    upto = slice(frame + 1)
    return _at(fields, load, frame, *_crossing(fields["time"][upto], np.max(load, axis=(0, 2))[upto]))


def break_frame(scene: Scene, fields: Mapping[str, Floats]) -> int | None:
    """The first frame in which the filament bears more than it can; None without."""
    over = np.flatnonzero(np.max(load_of(scene, fields), axis=(0, 2)) >= 1)
    return int(over[0]) if len(over) else None


def break_at_end(scene: Scene, fields: Mapping[str, Floats], rate: float) -> tuple[Break, float]:
    """Where a filament that was followed up to its break does so, and its load there, which grows at this rate."""
    load, end = load_of(scene, fields), len(fields["time"]) - 1
    reached = float(np.max(load[:, end]))
    return _at(fields, load, end, float(fields["time"][end] - (reached - 1) / rate), rate), reached


def _at(fields: Mapping[str, Floats], load: Floats, frame: int, when: float, rate: float) -> Break:
    """The break at an instant in or just before a frame, as the frame shows it."""
    kind, at = np.unravel_index(int(np.argmax(load[:, frame])), load[:, frame].shape)
    places, strain, stress, curvature = (values[..., at] for values in fibres(fields))
    bent = abs(curvature[frame]) * np.max(fields["thickness"][frame]) / 2 > _BENT * strain[frame]
    side = ("bottom" if curvature[frame] > 0 else "top") if bent else "section"
    by = ("strain", "stress")[int(kind)]
    return Break(when, float(places), side, float(strain[frame]), float(stress[frame]), by, rate)


def _crossing(time: Floats, load: Floats) -> tuple[float, float]:
    """When a load that is below one in all frames but the last reaches it, and its rate over the last two."""
    if len(time) == 1:
        return float(time[-1]), np.inf
    rate = float((min(load[-1], 1e6) - load[-2]) / (time[-1] - time[-2]))
    if load[-1] <= 1:
        return float(time[-1]), rate
    # Imported here, since they take half a second to load.
    from scipy.interpolate import PchipInterpolator
    from scipy.optimize import brentq

    smooth = PchipInterpolator(time, np.minimum(load, 1e6))
    when = float(brentq(lambda instant: smooth(instant) - 1, time[-2], time[-1]))
    # At a corner that curve may be level.
    return when, max(float(smooth(when, 1)), rate)
