"""What a run returns: the trajectory, judged; written and read again."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cache, cached_property
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from pydantic import TypeAdapter, ValidationError

from softcat_sym import drawing
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.effect_sets import terms_of
from softcat_sym.effects.selection import Effects
from softcat_sym.effects.theory_limits import theory_error
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.estimates.free_vibration import damping_note
from softcat_sym.estimates.scaling import surface_note
from softcat_sym.files import write_results
from softcat_sym.physics.terms import Terms
from softcat_sym.results.breaking import break_frame
from softcat_sym.results.fields import (
    COORDINATES,
    displacements,
    energy_residual,
    midpoint_table,
    min_energy,
    node_positions,
    variables_of,
    whole_span_fields,
)
from softcat_sym.results.motion import (
    beyond_noise,
    creep_of,
    frames_a_period,
    has_yielded,
    largest_of,
    last_fifth,
    midpoint_extremes,
    observed_motion,
    rebound_of,
    regime_of,
    ringing_of,
    rings_on,
    settled_height,
    too_few_frames,
    turning_points,
)
from softcat_sym.results.netcdf import netcdf_bytes, read_netcdf, variable_attrs
from softcat_sym.results.observed import DISPLACEMENT, Series, Watched
from softcat_sym.results.out_of_plane_stability import out_of_plane_instability, perturbed_3d_scene
from softcat_sym.results.verdict import measures, missing_effect, rupture_frame, saved, verdict, warnings_of
from softcat_sym.scene.dimensions import is_spatial, reason_for_dimensions
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Extremes, Solution
from softcat_sym.solvers.solve import Prepared
from softcat_sym.store import Form, packed, unpacked, version

if TYPE_CHECKING:
    import os

    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

REFERENCES: Final = (
    "K. Kamrin and L. Mahadevan, Soft catenaries, J. Fluid Mech. (2012)",
    "J. A. E. Andersson et al., CasADi, Math. Prog. Comp. 11, 1-36 (2019)",
    "A. C. Hindmarsh et al., SUNDIALS, ACM Trans. Math. Softw. 31, 363-396 (2005)",
    "A. Meurer et al., SymPy, PeerJ Comput. Sci. 3, e103 (2017)",
)
_VERSIONS: Final = ("softcat_sym", "casadi", "sympy", "numpy")


@cache
def versions_now() -> str:
    """Versions of this package and of those it calculates with, as JSON."""
    return json.dumps({name: version(name) for name in _VERSIONS})


@dataclass(frozen=True, eq=False)
class Run(drawing.Drawable):
    """A finished run.

    Attributes
    ----------
    scene : Scene
        The scene that was run.
    fields : mapping of str to ndarray
        Arrays of ``trajectory.nc`` by name, coordinates among them.
    data : xarray.Dataset
        The same arrays; dims ``time``, ``node``, ``cell``; variables in SI units with ``units`` attributes.
    summary : dict
        What ``summary.json`` holds.
    outcome : Outcome
        Verdict: whether the answer may be used, and otherwise advice.
    missing_effect : dict of str to str
        Effects that ``auto`` has left out although the run shows that they matter, with the reason; empty in a
        successful run that `simulate` returns.
    watched : Watched
        Where what is compared with other runs is largest, and how large.
    series : mapping of str to ndarray
        Its values there, at the frames or at more times, evenly spaced, where these do not show its ringing; empty of
        a run that was read from a file or is refused.
    versions : str
        Versions of this package and of those that it calculates with, as JSON; a run that was read from a file has
        the versions of that file.
    """

    scene: Scene
    fields: Mapping[str, Floats]
    summary: dict[str, Any]
    outcome: Outcome
    missing_effect: dict[str, str]
    watched: Watched = field(default_factory=lambda: Watched({}, {}))
    series: Series = field(default_factory=dict)
    versions: str = field(default_factory=versions_now)

    @property
    def terms(self) -> Terms:
        """What the effects in force left of the equations."""
        return terms_of(self.scene, self.summary["effects"])

    @cached_property
    def data(self) -> xr.Dataset:
        """The fields as a Dataset."""
        import xarray as xr

        arrays = {
            name: (variable.dims, self.fields[name], variable_attrs(name))
            for name, variable in variables_of(self.fields).items()
        }
        coordinates = {name: arrays.pop(name) for name in COORDINATES}
        return xr.Dataset(arrays, coords=coordinates, attrs=self._attrs())

    def _attrs(self) -> dict[str, str]:
        attrs = {
            "title": self.scene.title,
            "scene": self.scene.to_toml(),
            "effects": json.dumps(self.summary.get("effects", {})),
            "versions": self.versions,
            "references": "; ".join(REFERENCES),
            "outcome": self.outcome.name,
        }
        return attrs | ({"wall_s": json.dumps(self.summary["wall_s"])} if "wall_s" in self.summary else {})

    def __repr__(self) -> str:
        summary, time = self.summary, self.fields["time"]
        share = (summary.get("error_estimate") or {}).get("total")
        error = "not estimated" if share is None else f"{100 * share:.2g} % of the largest displacement"
        notes = [f"warnings: {len(summary['warnings'])}"] if summary.get("warnings") else []
        sizes = {"time": len(time), "node": len(self.fields["X_node"]), "cell": len(self.fields["X_cell"])}
        lines = (
            f"Run {self.scene.title!r}: {', '.join([self.outcome.name, *notes])}",
            f"midpoint {self.fields['midpoint'][-1]:.4g} m at {time[-1]:.4g} s; error {error}",
            f"regime {summary.get('regime') or 'none'}",
            f"effects {', '.join(summary.get('effects') or ['unknown'])}",
            f".data: {', '.join(f'{name} {count}' for name, count in sizes.items())}; .summary, .scene, .outcome",
        )
        return "\n  ".join(lines)

    def revised(
        self, changes: Mapping[str, Any], outcome: Outcome | None = None, message: str = "", scene: Scene | None = None
    ) -> Run:
        """The same run with other entries in its summary, as the answer to `scene`.

        With an outcome a sound run is refused, or qualified, for the reason in the message; it then has no regime.
        """
        changed = dict(changes)
        if outcome is not None and self.outcome.is_success:
            changed |= {"outcome": outcome.name, "advice": outcome.value, "message": message, "regime": None}
        else:
            outcome = self.outcome
        return replace(self, scene=scene or self.scene, summary=self.summary | changed, outcome=outcome)

    def plot(self, what: str = "midpoint", radius: float = 1.0) -> Figure:
        """Draw one picture of the run.

        Parameters
        ----------
        what : str
            ``midpoint``, ``shapes``, ``energy`` or ``space-time``.
        radius : float
            Factor by which ``shapes`` draws the filament thicker, to show the beads of a thin thread.

        Raises
        ------
        SoftcatError
            If there is no such picture, or the radius is not positive.
        """
        return drawing.plot(self, what, radius)

    def to_frame(self) -> pd.DataFrame:
        """What ``midpoint.csv`` holds."""
        import pandas as pd

        return pd.DataFrame(midpoint_table(self.fields, self.summary))

    def to_dict(self) -> dict[str, Any]:
        """What ``summary.json`` holds."""
        return self.summary

    def files(self) -> dict[str, Any]:
        """What a folder of the run holds, pictures apart."""
        return {"trajectory.nc": self.to_netcdf, "summary.json": self.summary, "scene.toml": self.scene.to_toml}

    def save(self, directory: str | Path) -> list[Path]:
        """Write ``trajectory.nc``, ``summary.json`` and ``scene.toml``; files of the same name are replaced whole.

        Raises
        ------
        OSError
            If the directory cannot be made or written.
        """
        return write_results(directory, self.files())

    def written(self, directory: str | Path, contents: Mapping[str, object]) -> tuple[Run, list[Path]]:
        """Write files into a folder; the run returned, and ``summary.json``, state how long that took, too."""
        began = perf_counter()
        files = write_results(directory, contents)
        spent, wall = perf_counter() - began, self.summary["wall_s"]
        run = self.revised({"wall_s": {**wall, "write": wall["write"] + spent, "total": wall["total"] + spent}})
        write_results(directory, {"summary.json": run.summary})
        return run, files

    def to_netcdf(self) -> bytes:
        """``trajectory.nc``."""
        return netcdf_bytes(self.fields, self._attrs())


def judge(scene: Scene, effects: Effects, prepared: Prepared, solution: Solution, wall: dict[str, float]) -> Run:
    """Turn a raw solution into a Run, and decide whether it may be trusted."""
    fields = whole_span_fields(scene, prepared, solution)
    places, time = node_positions(prepared.graph, rest_length(scene)), solution.time * prepared.scale
    residual = energy_residual(fields, min_energy(scene))
    # A sequence of equilibria is exact frame by frame: there the imbalance only tells how far apart the frames are.
    carried = residual if prepared.integration is not None else 0.0
    audited = carried if prepared.graph.conserves_energy else 0.0
    outcome, message = verdict(scene, effects, solution, fields, places[0], audited)
    seen_of = [one.observe(scene, fields | {"time": time, "X_node": places[0]}) for one in effects.in_force]
    fields |= {name: values for one in seen_of for name, values in one.fields.items()}
    if outcome.is_success and (doubts := [one.doubt for one in seen_of if one.doubt]):
        outcome, message = Outcome.penetrated, "; ".join(doubts)
    # The run ends there: what follows is no filament.
    if outcome is Outcome.ruptured:
        sound = max(1, rupture_frame(scene, fields["stretch"]) or 0)
    elif outcome is Outcome.broken:
        sound = 1 + (break_frame(scene, {**fields, "X_node": places[0], "X_cell": places[1]}) or 0)
    else:
        sound = len(time)
    time, fields = time[:sound], {name: values[:sound] for name, values in fields.items()}
    midpoint = fields["y"][:, fields["y"].shape[1] // 2]
    moved = displacements(scene, time, fields, places[0], prepared.graph)
    watched, answers = Watched.of(scene, fields, moved, places), outcome.is_success
    # What is no answer, or breaks, ends in the frame that is its last.
    seen = midpoint_extremes(scene, prepared, solution) if answers else Extremes.of(time, midpoint)
    extremes = beyond_noise(scene, seen)
    rings, most = ringing_of(extremes) if answers else None, watched.scale[DISPLACEMENT]
    settled, why = settled_height(scene, effects, extremes, rings)
    motion = observed_motion(scene, effects, time, places, fields, moved, extremes)
    measured = measures(scene, effects, replace(motion, rings_on=rings_on(scene, rings, most)))
    per_period, yielded = frames_a_period(extremes, len(time)), has_yielded(prepared, solution)
    aside = out_of_plane_instability(scene, fields | {"time": time, "X_node": places[0]}) if answers else None
    warnings = [
        *warnings_of(scene, effects, motion, places[0], fields, carried),
        *(too_few_frames(time[-1], len(time), per_period) if answers else []),
        *saved(scene, effects, measured),
        *([aside.warning] if aside is not None else []),
    ]
    grid, settings = prepared.graph.grid, prepared.settings
    summary = {
        "schema": 2,
        "title": scene.title,
        "outcome": outcome.name,
        "advice": outcome.value,
        "message": message,
        # An answer that is not to be trusted has no regime.
        "regime": regime_of(scene, effects, fields, extremes.height, yielded=yielded) if answers else None,
        "rebound": rebound_of(extremes.height),
        "accuracy": scene.run.accuracy,
        "theory_error": theory_error(scene, effects.names, effects.terms()),
        "midpoint_final_m": float(midpoint[-1]),
        "midpoint_largest_m": largest_of(extremes),
        "displacement": watched.told(time, moved, places[0]),
        "midpoint_lowest_m": float(np.min(extremes.height)),
        "midpoint_last_fifth_m": last_fifth(time, midpoint),
        "extremes": turning_points(extremes),
        "creep": creep_of(scene, seen, time, midpoint) if answers else None,
        "frames_a_period": per_period,
        "midpoint_settled_m": settled if answers else None,
        "midpoint_settled_why": why if answers else "the run has not reached its end",
        "time_final_s": float(time[-1]),
        "settled_s": None,
        "broken": None,
        "descends": None if solution.ended is None else {"time_s": solution.ended * prepared.scale},
        "error_estimate": None,
        "next_digit": None,
        "resolution": None,
        "refinements": [],
        "energy_residual": residual,
        "effects": dict(effects.reasons),
        "left_out": dict(effects.left_out),
        "checked": {name: measure.value for name, measure in measured.items()},
        "repeats": [],
        "closure": scene.run.closure,
        "dimensions": 3 if is_spatial(scene) else 2,
        "dimensions_reason": reason_for_dimensions(scene),
        "sideways": None if aside is None else asdict(aside),
        "cells": grid.cells if grid.is_half else grid.cells // 2,
        "solver": settings.solver,
        "solver_reason": settings.reason,
        "rtol": settings.rtol,
        "steps": solution.steps,
        "tail_from_s": None if solution.tail_from is None else solution.tail_from * prepared.scale,
        "tail_error": solution.tail_error,
        "backend": "compiled" if prepared.backend.compiled else "interpreted",
        "backend_reason": prepared.backend.reason,
        "converted": [*scene.notes, *filter(None, [damping_note(scene)])],
        "assumed": [
            *filter(None, [scene.material.assumed, tail_note(solution, prepared.scale)]),
            *([surface_note(scene)] if effects.terms().surface_tension else []),
        ],
        "warnings": warnings,
        "wall_s": wall,
        **{name: value for one in seen_of for name, value in one.summary.items()},
    }
    fields |= {"time": time, "X_node": places[0], "X_cell": places[1], "midpoint": midpoint}
    return Run(scene, fields, summary, outcome, missing_effect(scene, effects, measured, outcome), watched)


def tail_note(solution: Solution, scale: float) -> str:
    """From when on the modes of vibration carry a run; empty of one that is integrated to its end."""
    if solution.tail_from is None:
        return ""
    return (
        f"from {solution.tail_from * scale:.4g} s on nothing flows, and it rings as its modes of vibration do; "
        "numerics.tail = 'integrate' integrates that, too"
    )


_SUMMARY = "summary"


def run_form(scene: Scene) -> Form[Run]:
    """Return the form in which runs of a scene are stored, whatever its title was when it was run."""

    def write(run: Run) -> bytes:
        about = json.dumps([run.summary, run.outcome.name, run.missing_effect])
        return packed({_SUMMARY: np.array(about), **run.fields})

    def read(content: bytes) -> Run:
        arrays = unpacked(content)
        summary, outcome, missing = json.loads(str(arrays.pop(_SUMMARY)))
        moved = scene if is_spatial(scene) == (summary["dimensions"] == 3) else perturbed_3d_scene(scene)
        return Run(moved or scene, arrays, summary | {"title": scene.title}, Outcome[outcome], missing)

    return Form(write, read)


_DRAWN: Final = (*COORDINATES, "x", "y", "midpoint", "thickness")
_NEEDED: Final = (
    *_DRAWN, "stress_mean", "stress_bending", "yielded_fraction", "energy_kinetic", "energy_elastic",
    "energy_potential", "energy_dissipated", "energy_gradient", "work_external",
)  # fmt: skip
_ACCEPTED = "accepted: a trajectory.nc that softcat run wrote, or the folder that holds it"


def open_run(directory: str | os.PathLike[str]) -> Run:
    """Read a finished run again, as :func:`softcat_sym.simulate` returned it.

    Parameters
    ----------
    directory : str or path
        Folder into which ``softcat run`` or ``run.save`` wrote, or its ``trajectory.nc``.

    Returns
    -------
    Run
        ``.data``, ``.scene``, ``.outcome``; ``.summary`` is that of the ``summary.json`` beside it, without one of this
        run it holds title and outcome only.

    Raises
    ------
    SoftcatError
        If there is no run of this program, or it is damaged.
    """
    path = Path(directory)
    path = path / "trajectory.nc" if path.is_dir() else path
    if not path.is_file():
        raise SoftcatError(f"{path}: no such file; {_ACCEPTED}")
    try:
        fields, attrs = read_netcdf(path)
    except OSError as error:
        raise SoftcatError(f"{path}: cannot be read as netCDF4 ({error}); {_ACCEPTED}") from None
    if "energy_gradient" in fields:
        # Of a run from before there was surface tension.
        fields.setdefault("energy_surface", 0 * fields["energy_gradient"])
    missing = [name for name in _NEEDED if name not in fields]
    text = attrs.get("scene")
    if missing or not isinstance(text, str) or not len(fields["time"]):
        lacking = ", ".join(missing) or ("its scene" if not isinstance(text, str) else "frames")
        raise SoftcatError(f"{path}: this is no trajectory, since it lacks {lacking}; {_ACCEPTED}")
    outcome = Outcome.__members__.get(str(attrs.get("outcome")))
    if outcome is None:
        raise SoftcatError(f"{path}: its outcome {attrs.get('outcome')!r} is not known; {_ACCEPTED}")
    try:
        scene = Scene.model_validate(tomllib.loads(text))
    except (tomllib.TOMLDecodeError, SceneError) as error:
        raise SoftcatError(f"{path}: its scene cannot be read ({error}); {_ACCEPTED}") from None
    if path.with_name("scene.toml").exists():
        # The trajectory has its own, but a folder of which one file is damaged is not to be believed.
        load_scene(path.with_name("scene.toml"))
    summary = _summary_beside(path) or {}
    # Only if that is of the same run.
    if summary.get("midpoint_final_m") != float(fields["midpoint"][-1]):
        summary = {"title": attrs.get("title", ""), "outcome": outcome.name}
    return Run(scene, fields, summary, outcome, {}, versions=str(attrs.get("versions", "")))


@dataclass(frozen=True)
class _SummaryRead:
    """Entries of ``summary.json`` that are used again, and their types."""

    outcome: str
    midpoint_final_m: float | None
    title: str = ""
    regime: str | None = None
    frames_a_period: float | None = None
    effects: Mapping[str, str] = field(default_factory=dict)
    error_estimate: Mapping[str, Any] | None = None
    warnings: Sequence[str] = ()
    wall_s: Mapping[str, float] = field(default_factory=dict)


def _summary_beside(trajectory: Path) -> dict[str, Any] | None:
    """The ``summary.json`` in the folder of a trajectory; None without one."""
    path = trajectory.with_name("summary.json")
    try:
        content = path.read_bytes()
        TypeAdapter(_SummaryRead).validate_json(content, strict=True)
    except FileNotFoundError:
        return None
    except ValidationError as error:
        (first, *_) = error.errors()
        where = ".".join(map(str, first["loc"]))
        accepted = "accepted: the summary.json that softcat run wrote, or none"
        raise SoftcatError(f"{path}: it is damaged ({where}{': ' * bool(where)}{first['msg']}); {accepted}") from None
    return dict(json.loads(content))


def check_drawable(run: Run) -> None:
    """Refuse a run that is not finite everywhere."""
    for name in _DRAWN:
        if not np.isfinite(run.fields[name]).all():
            raise SoftcatError(f"{name} is not finite everywhere, so there is nothing to draw; {_ACCEPTED}")
