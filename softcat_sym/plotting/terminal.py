"""What is on the screen during and after a run."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.plotting.units import error_percent, length_unit, regime_words, significant, time_unit
from softcat_sym.progress import Display
from softcat_sym.solvers.outcome import ANSWERS

if TYPE_CHECKING:
    from rich.console import Console

    from softcat_sym.plotting.units import Summary
    from softcat_sym.scene.scene import Scene


class IntegrationProgress(Display):
    """Shows the stages of a run, and how far its integration is."""

    def __init__(
        self, duration: float, description: str = "", *, quiet: bool = False, console: Console | None = None
    ) -> None:
        super().__init__(quiet=quiet, console=console)
        self._duration, self._clock = duration, time_unit(duration)
        self.stage(description)

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s]."""
        del step_size
        reached = significant(min(simulated_time, self._duration) / self._clock.size)
        self.reach(simulated_time / self._duration, f"{reached} of {self._clock.text(self._duration)}")


class StepProgress(Display):
    """Shows which of a known number of tasks is being done, such as the runs of a study."""

    def __init__(self, steps: int, description: str, *, quiet: bool = False, console: Console | None = None) -> None:
        super().__init__(quiet=quiet, console=console)
        self._steps, self._begun = steps, 0
        self.stage(description)

    def step(self, what: str) -> None:
        """Say which task begins."""
        self.reach(self._begun / self._steps, f"{self._begun + 1} of {self._steps}, {what}")
        self._begun += 1


REFUSED = "NOT TO BE TRUSTED"
"""What stands on top of an answer that is refused."""

_STYLES = {"warning": "bold yellow", "because": "bold red"}

_SEEN = 1e-3

Rows = list[tuple[str, str]]


def answer_rows(summary: Summary, scene: Scene) -> Rows:
    """What is asked of a run, in words."""
    refused = summary["outcome"] not in ANSWERS
    rows: Rows = [("outcome", str(summary["outcome"]))]
    if refused:
        rows = [("because", str(summary["message"]))] if summary.get("message") else []
        rows.append(("advice", str(summary.get("advice") or "none")))
    if summary.get("broken"):
        rows.append(("breaks", str(summary["message"])))
    if summary.get("midpoint_final_m") is not None:
        rows.append(_place(summary, scene, refused=refused))
    if summary.get("next_digit") and not refused:
        rows.append(("next digit", str(summary["next_digit"]["text"])))
    if summary.get("regime"):
        rows.append(("regime", f"{regime_words(str(summary['regime']))}{_rebound(summary)}"))
    if "settled_s" in summary and not refused and not summary.get("broken"):
        rows.append(("settled", _settled(summary)))
    if summary.get("backend") == "interpreted" and summary.get("backend_reason"):
        rows.append(("interpreted", str(summary["backend_reason"])))
    if _left_out_worth(summary) > summary.get("accuracy", float("inf")):
        rows.append(_left_out(summary))
    return rows + _listed(summary, converted="converted", assumed="assumed", warnings="warning")


def _listed(summary: Summary, **names: str) -> Rows:
    """A row for each text of some lists of a summary."""
    return [(name, str(text)) for key, name in names.items() for text in summary.get(key) or ()]


_PARTS = {"space": "grid", "time": "time steps", "section": "fibres"}
_OWN = {"sideways": "way aside", "turn": "turn", "torque": "torque"}
"""Parts of the estimated error, and what has one of its own."""


def detail_rows(summary: Summary) -> Rows:
    """Everything else that a summary holds."""
    estimate = summary.get("error_estimate")
    known = {key: error_percent(share) for key, share in (estimate or {}).items() if share is not None}
    parts = ", ".join(f"{name} {known[key]}" for key, name in _PARTS.items() if key in known)
    total = f"{known['total']} of the largest displacement" if "total" in known else "not estimated in full"
    own = [f"{known[key]} of the largest {name}" for key, name in _OWN.items() if key in known]
    error = "; ".join([total + (f" ({parts})" if parts else ""), *own])
    rows = [("error", "not estimated" if estimate is None else error)]
    if summary.get("energy_residual") is not None:
        rows.append(("energy", f"balanced to {significant(summary['energy_residual'])} of the largest energy"))
    effects = [f"{name}: on" + (f", {why}" if why else "") for name, why in (summary.get("effects") or {}).items()]
    rows.append(("effects", "\n".join(effects) or "none"))
    if summary.get("left_out"):
        rows.append(_left_out(summary))
    rows += _listed(summary, repeats="repeated", refinements="refined")
    solver = [str(summary[key]) for key in ("solver", "backend") if summary.get(key)]
    if summary.get("cells") is not None:
        solver.append(f"{summary['cells']} cells a half span")
    wall = [f"{name} {significant(seconds)} s" for name, seconds in (summary.get("wall_s") or {}).items()]
    rows.append(("solver", ", ".join(solver) or "not stated"))
    return [*rows, ("wall time", ", ".join(wall) or "not measured")]


def print_summary(
    summary: Summary,
    scene: Scene,
    files: Sequence[Path] = (),
    *,
    verbose: bool = False,
    console: Console | None = None,
) -> None:
    """Print what a run has come to."""
    from rich.console import Console
    from rich.text import Text

    out = console or Console()
    title, answers = scene.title or "Filament", summary["outcome"] in ANSWERS
    stamped = title if answers else f"{REFUSED} ({summary['outcome']}): {title}"
    out.print(Text(stamped, style="bold" if answers else "bold red"))
    rows = answer_rows(summary, scene)
    if verbose:
        rows = [row for row in rows if row[0] != "left out"] + detail_rows(summary)
    if files:
        names, folder = [path.name for path in files], files[0].parent
        few = verbose or len(names) <= 2
        listed = f": {', '.join(names)}" if few else f" ({len(names)}: {', '.join(names[:2])}, ...)"
        rows.append(("files", f"{folder}{listed}"))
    print_rows(rows, out)


def print_rows(rows: Rows, console: Console) -> None:
    """Print names to the left and texts to the right of them, no line longer than the screen unless a word is."""
    from rich.text import Text

    indent = max(len(name) for name, _ in rows) + 2
    room = max(30, console.width - indent)
    for name, text in rows:
        style = "bold green" if (name, text) == ("outcome", "solved") else ""
        wrapped = (
            textwrap.wrap(line, room, break_long_words=False, break_on_hyphens=False) or [""]
            for line in text.splitlines() or [""]
        )
        for number, line in enumerate(line for lines in wrapped for line in lines):
            label = ("" if number else name).ljust(indent)
            console.print(Text.assemble((label, _STYLES.get(name, "dim")), (line, style)), soft_wrap=True)


def _length(value: float, span: float = 1.0) -> str:
    return length_unit(abs(value), span).text(abs(value))


def _of_span(value: float, scene: Scene) -> str:
    return f"{float(f'{100 * abs(value) / scene.filament.span:.2g}'):g} % of the span"


def _place(summary: Summary, scene: Scene, *, refused: bool) -> tuple[str, str]:
    """Where the midpoint is in the end, with its error; the mean of what still swings.

    Where it hardly moves, or far less than it hangs down, the node that moves farthest is told.
    """
    rest, ends = summary.get("midpoint_settled_m") or {}, scene.ends
    total = (summary.get("error_estimate") or {}).get("total")
    place = float(summary["midpoint_final_m"] if rest.get("mean") is None else rest["mean"])
    largest, moved = float(summary.get("midpoint_largest_m", abs(place))), summary.get("displacement")
    if moved and (moved["midpoint_m"] < _HARDLY * moved["scale_m"] or largest > moved["largest_m"] / _FAR):
        return _displacement(summary, scene, refused=refused)
    sags = place <= 0 and not any(one.is_free for one in ends.supports) and ends.drop == 0 and not ends.motion
    where = f"{_length(place, scene.filament.span)}{'' if sags else ' down' if place <= 0 else ' up'}"
    if refused and total is None:
        return "reached", f"midpoint {where} when the run ended: no answer"
    swing = float(rest.get("amplitude") or 0.0)
    swings = f", swinging by {_length(swing)} about it" if swing > abs(place) / 1000 else ""
    text = f"{where}{_error(summary, abs(place), largest)}, {_of_span(place, scene)}{swings}{_creep(summary)}"
    return "sag" if sags else "midpoint", text


def _creep(summary: Summary) -> str:
    """How fast what does not swing still moves when the run ends, and where it tends if that is known."""
    if not (creep := summary.get("creep")):
        return ""
    rate, tends, unit = creep["rate_m_per_s"], creep["tends_to_m"], time_unit(summary["time_final_s"])
    pace = f"{'down' if rate < 0 else 'up'} by {_length(rate * unit.size)}/{unit.symbol}"
    return f", still moving {pace}" + ("" if tends is None else f" towards {_length(tends)}")


def _rebound(summary: Summary) -> str:
    """How far the midpoint came back up, where that tells the regime; empty where it hardly did."""
    back = float(summary.get("rebound") or 0.0)
    told = str(summary["regime"]).startswith("arrested") and back >= _SEEN
    return f", coming back up by {100 * back:.2g} % of its sag" if told else ""


_HARDLY, _FAR = 0.1, 0.5
"""Rise or fall of the midpoint over the largest displacement, and the latter over the midpoint's depth, below which the
midpoint does not tell what has happened."""

_WAYS = (("to the left", "to the right"), ("down", "up"), ("to the back", "to the front"))


def _displacement(summary: Summary, scene: Scene, *, refused: bool) -> tuple[str, str]:
    """How far the node that moves farthest has moved in the end."""
    moved, span = summary["displacement"], scene.filament.span
    if moved["largest_m"] < moved["scale_m"]:
        return "displacement", f"as good as none: at most {_length(moved['largest_m'], span)}"
    where, size = float(moved["where"]), math.hypot(*moved["final_m"])
    names = {-0.5: "left end", 0.0: "midpoint", 0.5: "right end"}
    name = names.get(round(where, 6), f"point at X/L = {where:.2g}")
    ruler, parts = length_unit(size, span), zip(moved["final_m"], _WAYS, strict=False)
    ways = [f"{ruler.text(abs(part))} {way[part > 0]}" for part, way in parts if abs(part) > _HARDLY * size]
    text = f"{ruler.text(size)} {ways[0].split(' ', 2)[2]}" if len(ways) == 1 else ", ".join([ruler.text(size), *ways])
    if refused and not summary.get("error_estimate"):
        return "reached", f"{name} moved {text} when the run ended: no answer"
    return name, f"moved {text}{_error(summary, size, float(moved['largest_m']))}, {_of_span(size, scene)}"


def _error(summary: Summary, size: float, largest: float) -> str:
    """The error of a number, by that of the largest displacement; of the numbers, and of the theory."""
    total = (summary.get("error_estimate") or {}).get("total")
    if total is None:
        return " (error not estimated)"
    error = total * float((summary.get("displacement") or {}).get("scale_m", largest))
    # What swings, or has come back: a share of nearly nothing would mislead.
    numbers = error_percent(error / size) if size >= largest / 2 and size > 0 else _length(error)
    theory = summary.get("theory_error")
    return f" ± {numbers}" + (f" (numbers), about {error_percent(theory)} (slender theory)" if theory else "")


def _settled(summary: Summary) -> str:
    """Whether anything still moves by more than the accuracy asked when the run ends."""
    when, rest = summary["settled_s"], summary.get("midpoint_settled_m")
    if when is not None:
        return f"from {time_unit(when).text(when)} on"
    farthest = summary.get("displacement") or {}
    largest = float(farthest.get("scale_m") or summary.get("midpoint_largest_m") or 0.0)
    least = float(summary.get("accuracy", 0.0)) * largest
    moved = max(abs(float(summary.get("midpoint_last_fifth_m", 0.0))), farthest.get("last_fifth_m", 0.0))
    if rest is not None and rest["amplitude"] > least:
        return "no: it still swings when the run ends"
    if rest is not None and moved <= least:
        return "yes, to the accuracy asked"
    return f"no: it moved by {_length(moved)} in the last fifth of the run"


def _left_out_worth(summary: Summary) -> float:
    """What all that was left out may change, of the largest midpoint: as the run shows it, else as expected."""
    found: Mapping[str, float] = summary.get("checked") or summary.get("left_out") or {}
    return float(sum(found.values()))


def _left_out(summary: Summary) -> tuple[str, str]:
    return "left out", left_out_words(list(summary["left_out"]), _left_out_worth(summary))


def left_out_words(names: Sequence[str], worth: float) -> str:
    """Effects that are left out, and one number for all of them."""
    return f"{', '.join(names)}: at most {error_percent(worth)} of the sag{' together' if len(names) > 1 else ''}"
