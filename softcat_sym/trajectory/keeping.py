"""A trajectory as bytes and back, the same to the last bit: for those that outlive an interruption."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from softcat_sym.solve import Outcome
from softcat_sym.solve.keeping import Form, packed, unpacked
from softcat_sym.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    from softcat_sym.scene import Scene

_TOLD = "told"


def trajectory_form(scene: Scene) -> Form[Trajectory]:
    """Return the form of runs of a scene.

    Parameters
    ----------
    scene : Scene
        What was asked, which the trajectory carries.
    """
    return Form(_written, lambda content: _read(scene, content))


def _written(run: Trajectory) -> bytes:
    data = run.data
    told = {
        "summary": run.summary,
        "outcome": run.outcome.name,
        "overlooked": run.overlooked,
        "attrs": data.attrs,
        "variables": {str(name): [list(one.dims), one.attrs] for name, one in data.variables.items()},
        "coordinates": [str(name) for name in data.coords],
    }
    return packed({_TOLD: np.array(json.dumps(told))} | {str(name): one.values for name, one in data.variables.items()})


def _read(scene: Scene, content: bytes) -> Trajectory:
    arrays = unpacked(content)
    told = json.loads(str(arrays[_TOLD]))
    variables = {name: (dims, arrays[name], attrs) for name, (dims, attrs) in told["variables"].items()}
    coordinates = {name: variables.pop(name) for name in told["coordinates"]}
    data = xr.Dataset(variables, coords=coordinates, attrs=told["attrs"])
    return Trajectory(scene, data, told["summary"], Outcome[told["outcome"]], told["overlooked"])
