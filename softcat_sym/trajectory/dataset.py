"""Fields become an xarray Dataset with coordinates, units and what a reader must know to cite it."""

from __future__ import annotations

import importlib.metadata
import json
from collections.abc import Mapping

import xarray as xr

from softcat_sym.effects import Effects
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.trajectory.variables import VARIABLES

REFERENCES = (
    "K. Kamrin and L. Mahadevan, Soft catenaries, J. Fluid Mech. (2012)",
    "J. A. E. Andersson et al., CasADi, Math. Prog. Comp. 11, 1-36 (2019)",
    "A. C. Hindmarsh et al., SUNDIALS, ACM Trans. Math. Softw. 31, 363-396 (2005)",
    "A. Meurer et al., SymPy, PeerJ Comput. Sci. 3, e103 (2017)",
)
_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


def dataset_of(
    scene: Scene, effects: Effects, time: Floats, places: tuple[Floats, Floats], fields: Mapping[str, Floats]
) -> xr.Dataset:
    """Build the Dataset of ``trajectory.nc``.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        [s].
    places : pair of ndarray
        Material coordinates [m] of nodes and cells.
    fields : mapping of str to ndarray
        As from :func:`softcat_sym.trajectory.fields.whole_span_fields`.
    """
    nodes, cells = places
    variables = {
        v.name: (
            (("time", v.place) if v.place else ("time",)),
            fields[v.name],
            {"units": v.unit, "long_name": v.meaning},
        )
        for v in VARIABLES
        if v.name in fields
    }
    middle = fields["y"][:, fields["y"].shape[1] // 2]
    note = {"units": "m", "long_name": "height of the midpoint X = 0, negative down"}
    return xr.Dataset(
        {**variables, "midpoint": (("time",), middle, note)},
        coords={
            "time": ("time", time, {"units": "s", "long_name": "time"}),
            "X_node": ("node", nodes, {"units": "m", "long_name": "material coordinate of nodes"}),
            "X_cell": ("cell", cells, {"units": "m", "long_name": "material coordinate of cells"}),
        },
        attrs={
            "title": scene.title,
            "scene": scene.to_toml(),
            "effects": json.dumps(dict(effects.reasons)),
            "versions": json.dumps({name: importlib.metadata.version(name) for name in _VERSIONS}),
            "references": "; ".join(REFERENCES),
        },
    )
