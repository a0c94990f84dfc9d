"""What an ensemble returns: a row for each member, whatever became of it."""

from __future__ import annotations

import importlib.metadata
import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.ensemble.grouped import is_group
from softcat_sym.ensemble.members import Member
from softcat_sym.ensemble.running import Record
from softcat_sym.ensemble.table import Row, is_number, kind_of
from softcat_sym.scene import Scene
from softcat_sym.scene.kinds import Number, Quantity
from softcat_sym.scene.units import SI_UNITS
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solve import Outcome
from softcat_sym.trajectory import Trajectory

if TYPE_CHECKING:
    import xarray as xr

_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


@dataclass(frozen=True)
class Ensemble:
    """Finished members, in the order of the table.

    Attributes
    ----------
    scenes : tuple of Scene
        What each member is.
    data : xarray.Dataset
        Dims ``member`` and ``time``. Variables ``midpoint`` (member, time) [m], NaN after the time that a member has
        reached; and for each member ``midpoint_final`` [m] and ``time_final`` [s] (the last frame reached),
        ``outcome`` (name of the `Outcome`), ``complaint``, ``energy_residual`` (between first and last frame),
        ``effects``, ``steps`` and ``wall_s``. Every column of the table is a coordinate along ``member``, quantities in
        SI. ``time`` is in seconds where all members last equally long; otherwise it is the share of each member's own
        ``duration`` [s], which is then a variable.
    outcomes : tuple of Outcome
        Verdict on each member.

    Notes
    -----
    A member is judged by its integration, by the neck in its last frame, and by the energy balance between its first
    and its last frame. What `simulate` does beyond that is left to `trajectory`: an energy balance at every frame, and
    a look whether an effect that was left out has mattered, with a repetition if so.
    """

    scenes: tuple[Scene, ...]
    data: xr.Dataset
    outcomes: tuple[Outcome, ...]

    def __len__(self) -> int:
        return len(self.scenes)

    def trajectory(self, member: int) -> Trajectory:
        """Run one member again by `simulate`: whole shapes, every check, effects as its own scene asks for them.

        Parameters
        ----------
        member : int
            Its row in the table, from 0.

        Raises
        ------
        IndexError
            If there is no such row.
        """
        return simulated(without_estimate(self.scenes[member]))


def collect(
    scene: Scene, rows: Sequence[Row], members: Sequence[Member], records: Sequence[Record], notes: dict[str, str]
) -> Ensemble:
    """Records become a Dataset.

    Parameters
    ----------
    scene : Scene
        The base.
    rows : sequence of dict
        The table as it was given.
    members, records
        A member and a record for each row.
    notes : dict of str to str
        Attributes of the Dataset, beside scene and versions.
    """
    import xarray as xr

    scenes = tuple(member.scene for member in members)
    durations = np.array([one.run.duration for one in scenes])
    alike = bool(np.all(durations == durations[0]))
    share = np.linspace(0.0, 1.0, scene.run.frames)
    if alike:
        time = ("time", share * durations[0], {"units": "s", "long_name": "time"})
    else:
        time = ("time", share, {"units": "1", "long_name": "time over the duration of the member"})
    variables = _variables(members, records)
    if not alike:
        variables["duration"] = (("member",), durations, {"units": "s", "long_name": "duration of the run"})
    coordinates = {key: _column(scenes, rows, key) for key in rows[0]}
    versions = json.dumps({name: importlib.metadata.version(name) for name in _VERSIONS})
    data = xr.Dataset(
        variables,
        coords={"member": np.arange(len(rows)), "time": time, **coordinates},
        attrs={"title": scene.title, "scene": scene.to_toml(), "versions": versions, **notes},
    )
    return Ensemble(scenes, data, tuple(record.outcome for record in records))


def _variables(members: Sequence[Member], records: Sequence[Record]) -> dict[str, Any]:
    midpoint = np.stack([record.midpoint for record in records])
    # At least the first frame is always there.
    last = np.count_nonzero(~np.isnan(midpoint), axis=1) - 1
    each: dict[str, tuple[Any, dict[str, str]]] = {
        "midpoint_final": (
            midpoint[np.arange(len(last)), last],
            {"units": "m", "long_name": "height of the midpoint in the last frame reached, negative down"},
        ),
        "time_final": ([r.reached for r in records], {"units": "s", "long_name": "time of the last frame reached"}),
        "outcome": ([r.outcome.name for r in records], {"long_name": "how the run ended"}),
        "complaint": ([r.complaint for r in records], {"long_name": "why, if that is no success"}),
        "energy_residual": (
            [r.energy_residual for r in records],
            {"units": "1", "long_name": "energy imbalance of the last frame against the first, of the largest energy"},
        ),
        "effects": ([", ".join(member.effects.names) for member in members], {"long_name": "effects in force"}),
        "steps": ([r.steps for r in records], {"long_name": "steps of the integrator"}),
        "wall_s": (
            [r.wall for r in records],
            {"units": "s", "long_name": "wall time, side by side with other members"},
        ),
    }
    whole = {"units": "m", "long_name": "height of the midpoint X = 0, negative down; NaN where it was not reached"}
    found: dict[str, Any] = {"midpoint": (("member", "time"), midpoint, whole)}
    return found | {name: (("member",), np.asarray(values), note) for name, (values, note) in each.items()}


def _column(scenes: Sequence[Scene], rows: Sequence[Row], key: str) -> tuple[str, Any, dict[str, str]]:
    """A column of the table: quantities in SI, other numbers as they are, the rest as text."""
    kind = kind_of(scenes[0], rows[0], key)
    if isinstance(kind, (Quantity, Number)):
        table, _, name = key.partition(".")
        values = [getattr(getattr(scene, table), name) for scene in scenes]
        unit = (kind.unit or SI_UNITS[kind.dimension]) if isinstance(kind, Quantity) else "1"
        return "member", np.array([np.nan if value is None else value for value in values], float), {"units": unit}
    given = [row[key] for row in rows]
    if all(is_number(value) for value in given):
        return "member", np.array(given), {"units": "1"} if is_group(key) else {}
    return "member", np.array([str(value) for value in given]), {}
