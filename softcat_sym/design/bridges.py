"""Sag against the length of a bridge: a table for who prints, and the fields of slicers that it settles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import pandas as pd

from softcat_sym.batch.plan import plan_sweep
from softcat_sym.batch.sweep import sweep
from softcat_sym.design.critical_span import LIMITS, read_limit
from softcat_sym.design.information import SPAN
from softcat_sym.drawing import Drawable
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.span import Limit
from softcat_sym.results.motion import time_of_rest
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.units import NotAQuantity, length_text

if TYPE_CHECKING:
    from softcat_sym.batch.executor import MembersProgress
    from softcat_sym.scene.reading import Changes, SceneLike
    from softcat_sym.scene.scene import Scene

Verdict = Literal["yes", "no", "undecided", "no answer"]


@dataclass(frozen=True)
class Bridge:
    """One row of the table; lengths in m."""

    length: float  # Distance of the supports
    sag: float  # Largest of the midpoint during the run; NaN without an answer
    error: float  # Of the sag, as companion runs estimate it; NaN where it was not estimated
    limit: float  # Largest sag allowed
    settled: float | None  # Time from which it stays within 1 % of its last sag [s]; None if it still moves at the end
    outcome: str  # How the run ended
    message: str  # Why it has no answer

    @property
    def within(self) -> Verdict:
        """Whether it sags less than allowed; undecided where the limit lies within the error."""
        if self.outcome == "broken":
            return "no"
        if not math.isfinite(self.sag):
            return "no answer"
        margin = self.limit - self.sag
        error = self.error if math.isfinite(self.error) else 0.0
        return "undecided" if abs(margin) < error else "yes" if margin >= 0 else "no"


@dataclass(frozen=True)
class BridgeTable(Drawable):
    """Sag against the length of a bridge.

    Attributes
    ----------
    scene : Scene
        The strand; its own span says nothing.
    max_sag : Limit
        The largest sag allowed.
    bridges : tuple of Bridge
        The rows, by length.
    """

    scene: Scene
    max_sag: Limit
    bridges: tuple[Bridge, ...]

    def __repr__(self) -> str:
        return "\n".join(self.text)

    @property
    def longest(self) -> float | None:
        """The longest bridge that sags less than allowed, as all shorter ones of the table do [m]; None without one."""
        found = None
        for one in self.bridges:
            if one.within != "yes":
                break
            found = one.length
        return found

    @property
    def text(self) -> tuple[str, ...]:
        """Plain sentences, the first with the longest bridge."""
        rows, longest = self.bridges, self.longest
        allowed = f"{100 * self.max_sag.value:g} % of the length"
        if not self.max_sag.of_span:
            allowed = length_text(self.max_sag.value)
        found = [f"bridges up to {length_text(longest, 4)} sag less than {allowed}"] if longest else []
        found = found or [f"not even a bridge of {length_text(rows[0].length, 4)} surely sags less than {allowed}"]
        first = next((one for one in rows if one.within != "yes"), None)
        if first is not None:
            sag = f"sags {length_text(first.sag)}" if math.isfinite(first.sag) else f"ends as {first.outcome}"
            found.append(f"one of {length_text(first.length, 4)} {sag}; within the limit: {first.within}")
        moving = [one for one in rows if one.settled is None and math.isfinite(one.sag)]
        if moving:
            duration = f"{self.scene.run.duration:g} s"
            found.append(f"{len(moving)} of {len(rows)} still move after {duration}: they may sag more later")
        if any(math.isnan(one.error) and math.isfinite(one.sag) for one in rows):
            found.append("errors were not estimated: the sag alone is compared with the limit")
        return (*found, *self.scene.filament.notes)

    def to_frame(self) -> pd.DataFrame:
        """The table in SI; what is not known is empty."""
        rows = [
            {
                "length_m": one.length,
                "sag_m": one.sag,
                "sag_error_m": one.error,
                "limit_m": one.limit,
                "within_limit": one.within,
                "settled_s": math.nan if one.settled is None else one.settled,
                "outcome": one.outcome,
                "message": one.message,
            }
            for one in self.bridges
        ]
        return pd.DataFrame(rows)

    def to_dict(self) -> dict[str, Any]:
        """Content of ``bridges.json``, in SI."""
        rows = self.to_frame().astype(object)
        return {
            "title": self.scene.title,
            "max_sag": {"value": self.max_sag.value, "of_span": self.max_sag.of_span},
            "longest_m": self.longest,
            "thickness_m": self.scene.filament.thickness,
            "bridges": rows.where(rows.notna(), None).to_dict(orient="records"),
            "text": list(self.text),
        }

    def slicer_fields(self, slicer: Literal["OrcaSlicer", "SuperSlicer"]) -> str:
        """Fields of a slicer's print settings as lines ``key = value``; comments say what each number is.

        A field that the table does not determine is named in a comment, without a value.
        """
        millimetres = 0.0 if self.longest is None else 1e3 * self.longest
        head = [f"# {slicer}, print settings for bridges: {self.scene.title or 'a strand'}", *_commented(self.text)]
        longest = f"{millimetres:.6g}"
        if slicer == "OrcaSlicer":
            lines = [
                "# The longest bridge that needs no support, in mm: that of the table; 0 supports all.",
                f"max_bridge_length = {longest}",
                *self._orca_flow(),
            ]
            rest = "bridge_speed, overhang_fan_speed, bridge_density, internal_bridge_flow"
        else:
            lines = [
                "# Bridges without support: right for a model whose bridges are no longer than those of the table,",
                f"# {longest} mm; there is no field for that length. 1: no support; 0: support.",
                f"dont_support_bridges = {int(millimetres > 0)}",
                *self._nozzle_flow("bridge_flow_ratio", percent=True),
            ]
            rest = "bridge_speed, bridge_fan_speed, bridge_overlap, over_bridge_flow_ratio"
        why = "the strand is computed from when it has been laid, by itself, at the temperatures of the scene"
        return "\n".join([*head, "", *lines, f"# Not determined here: {rest}; {why}.", ""])

    def _orca_flow(self) -> list[str]:
        line = self.scene.filament
        if line.line_width is None:
            flow = self._nozzle_flow("bridge_flow", percent=False)
            round_ = "# 1: bridges are round strands of the nozzle's diameter times the root of bridge_flow."
            return flow if line.nozzle is None else [round_, "thick_bridges = 1", *flow]
        size = f"line of {1e3 * line.line_width:g} mm x {1e3 * (line.layer_height or 0.0):g} mm"
        return [
            f"# 0: bridges are extruded as other lines are, here as a {size}.",
            "thick_bridges = 0",
            "# The flow ratio of the scene, where filament_flow_ratio, which multiplies it, is 1.",
            f"bridge_flow = {line.flow_ratio or 1:g}",
        ]

    def _nozzle_flow(self, key: str, *, percent: bool) -> list[str]:
        """The flow of a round strand of the nozzle's diameter that gives it this one's area."""
        filament = self.scene.filament
        if filament.nozzle is None:
            return [f"# Not determined here: {key}, which needs filament.nozzle and a round strand."]
        ratio = (filament.thickness / filament.nozzle) ** 2
        value = f"{100 * ratio:.4g}%" if percent else f"{ratio:.4g}"
        says = "# Area of the strand over that of the nozzle, where bridges are round strands of the nozzle's diameter"
        return [f"{says}.", f"{key} = {value}"] if ratio <= 2 else [f"{says}:", f"# {key} would be {value}; 2 at most."]


def _commented(lines: Sequence[str]) -> list[str]:
    return [f"# {line}" for line in lines]


def bridges(
    scene: SceneLike,
    lengths: str | Sequence[object],
    max_sag: object = "5 %",
    *,
    workers: int | None = None,
    fresh: bool = False,
    progress: MembersProgress | None = None,
    changes: Changes = (),
) -> BridgeTable:
    """Simulate bridges of several lengths: the sag of each with its error, and whether it is within a limit.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The strand; its own span says nothing.
    lengths : str or sequence
        ``"2 mm:20 mm:10"``, ``"2:20 mm:10:log"``, ``"5 mm, 8 mm"``; or lengths, numbers in m.
    max_sag : str or float
        Largest sag allowed during the run: a length with its unit, or a fraction of each length such as ``"5 %"``.
    workers : int, optional
        Number of threads, by default all cores.
    fresh : bool
        Run every bridge, even one that is in the store.
    progress : MembersProgress, optional
        Receiver of the number of finished bridges and the time left.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"material.yield_stress": "200 Pa"}``.

    Returns
    -------
    BridgeTable
        A row for each length, by length; one that has no answer is a row like the others.

    Raises
    ------
    SceneError
        If the lengths or the limit cannot be read, or a length is not more than the thickness.
    """
    strand = as_scene(scene, changes)
    faults, allowed, values = list[Fault](), Limit(math.nan, of_span=False), list[float]()
    if strand.pillars.present:
        faults.append(Fault("pillars", "given, whose gap no table varies", "softcat sweep over pillars.gap"))
    try:
        allowed = read_limit(max_sag)
    except NotAQuantity as found:
        faults.append(Fault("max_sag", str(found), LIMITS))
    try:
        values = sorted(plan_sweep(strand, {SPAN: lengths}).variables()[SPAN][1].tolist())
    except SceneError as refused:
        faults += [Fault("lengths", one.found, one.accepted) for one in refused.faults]
    thickness = strand.filament.thickness
    if values and not values[0] > thickness:
        found_text = f"{length_text(values[0])} is not more than the thickness of the strand, {length_text(thickness)}"
        faults.append(Fault("lengths", found_text, "longer bridges"))
    if faults:
        raise SceneError(faults)
    done = sweep(strand, {SPAN: values}, estimate=True, workers=workers, fresh=fresh, progress=progress)
    data, found_rows = done.data, list[Bridge]()
    for number, length in enumerate(values):
        row = data.isel(member=number)
        sag, outcome = float(row["sag_largest"]), str(row["outcome"].item())
        rest = None
        if math.isfinite(sag):
            rest = time_of_rest(strand.run.duration * data["frame"].values, -row["midpoint"].values)
        error = float(row["error_estimate"]) * abs(sag)
        reason = str(row["message"].item())
        found_rows.append(Bridge(length, sag, error, allowed.at(length), rest, outcome, reason))
    return BridgeTable(strand, allowed, tuple(found_rows))
