"""What is on the screen during and after a run."""

from __future__ import annotations

import textwrap
from collections.abc import Container, Iterable, Mapping, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from softcat_sym.plotting.units import error_percent, length_unit, regime_words, significant, time_unit
from softcat_sym.progress import Display

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.plotting.units import Summary
    from softcat_sym.scene.scene import Scene


class IntegrationProgress(Display):
    """Tells the stages of a run, and how far its integration is."""

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
    """Tells which of a known number of tasks is being done, such as the runs of a study."""

    def __init__(self, steps: int, description: str, *, quiet: bool = False, console: Console | None = None) -> None:
        super().__init__(quiet=quiet, console=console)
        self._steps, self._begun = steps, 0
        self.stage(description)

    def step(self, what: str) -> None:
        """Say which task begins."""
        self.reach(self._begun / self._steps, f"{self._begun + 1} of {self._steps}, {what}")
        self._begun += 1


class FitProgressBar(Display):
    """Tells what a fit is doing."""

    def __enter__(self) -> Self:
        self.doing("reading and compiling")
        return super().__enter__()

    def stage(self, name: str, done: int = 0, total: int = 1) -> None:
        """Say what begins, and how much of it is done."""
        if not self.stages or self.stages[-1].name != name:
            super().stage(name)
        if total > 1:
            self.reach(done / total, f"{done + 1} of {total}")


STAGES = ("build", "compile", "solve", "estimate", "write", "total")

REFUSED = "NOT TO BE TRUSTED"
"""What stands on top of an answer that is refused."""

_STYLES = {"warning": "bold yellow", "because": "bold red"}
_STILL = 0.5
"""Share of its largest distance below which a midpoint's error is told as a length: it swings, or has come back."""

_NAMED, _NARROW = 2, 30

Rows = list[tuple[str, str]]


def headline(summary: Summary, scene: Scene) -> str:
    """The title, behind a stamp if the answer is refused."""
    title = scene.title or "Filament"
    return title if summary["outcome"] == "solved" else f"{REFUSED} ({summary['outcome']}): {title}"


def answer_rows(summary: Summary, scene: Scene) -> Rows:
    """What is asked of a run, in words."""
    refused = summary["outcome"] != "solved"
    rows: Rows = [("outcome", str(summary["outcome"]))]
    if refused:
        rows = [("because", str(summary["message"]))] if summary.get("message") else []
        rows.append(("advice", str(summary.get("advice") or "none")))
    rows += _place(summary, scene, refused=refused)
    if summary.get("regime"):
        rows.append(("regime", regime_words(str(summary["regime"]))))
    if "settled_s" in summary and not refused:
        rows.append(("settled", _settled(summary)))
    if _left_out_worth(summary) > summary.get("accuracy", float("inf")):
        rows.append(("left out", _left_out(summary)))
    rows.extend(("converted", str(text)) for text in summary.get("converted") or ())
    rows.extend(("warning", str(text)) for text in summary.get("warnings") or ())
    return rows


def detail_rows(summary: Summary) -> Rows:
    """Everything else that a summary tells; parameters as :func:`answer_rows`."""
    rows = [("error", _estimate(summary.get("error_estimate")))]
    if summary.get("energy_residual") is not None:
        rows.append(("energy", f"balanced to {significant(summary['energy_residual'])} of the largest energy"))
    rows.append(("effects", _effects(summary.get("effects"))))
    if summary.get("left_out"):
        rows.append(("left out", _left_out(summary)))
    rows.extend(("repeated", str(text)) for text in summary.get("repeats") or ())
    rows.extend(("refined", str(text)) for text in summary.get("refinements") or ())
    parts = [str(summary[key]) for key in ("solver", "backend") if summary.get(key)]
    if summary.get("cells") is not None:
        parts.append(f"{summary['cells']} cells a half span")
    rows.append(("solver", ", ".join(parts) or "not stated"))
    rows.append(("wall time", _wall(summary.get("wall_s"))))
    return rows


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
    sound = summary["outcome"] == "solved"
    out.print(Text(headline(summary, scene), style="bold" if sound else "bold red"))
    rows = answer_rows(summary, scene)
    if verbose:
        rows = [row for row in rows if row[0] != "left out"] + detail_rows(summary)
    if files:
        rows.append(("files", _files(files, verbose=verbose)))
    print_rows(rows, out)


def print_rows(rows: Rows, console: Console) -> None:
    """Print names to the left and texts to the right of them, no line longer than the screen unless a word is."""
    from rich.text import Text

    indent = max(len(name) for name, _ in rows) + 2
    for name, text in rows:
        style = "bold green" if (name, text) == ("outcome", "solved") else ""
        room = max(_NARROW, console.width - indent)
        lines = [
            part
            for line in text.splitlines() or [""]
            for part in textwrap.wrap(line, room, break_long_words=False, break_on_hyphens=False) or [""]
        ]
        for number, line in enumerate(lines):
            label = (name if number == 0 else "").ljust(indent)
            console.print(Text.assemble((label, _STYLES.get(name, "dim")), (line, style)), soft_wrap=True)


def text_table(
    header: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    title: str = "",
    caption: str = "",
    right: Container[int] = (),
    styles: Iterable[str] = (),
    whole: Container[int] = (),
    **settings: Any,
) -> Table:
    """A table of texts, none of which is read as markup; columns on the `right`, and those that stay `whole`."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    looks: dict[str, Any] = {
        "box": box.SIMPLE_HEAD,
        "show_header": any(header),
        "title_justify": "left",
        "title_style": "bold",
    } | settings
    table = Table(title=Text(title) if title else None, **looks)
    if caption:
        table.caption, table.caption_justify = Text(caption, style="dim"), "left"
    for k, name in enumerate(header):
        table.add_column(Text(name), justify="right" if k in right else "left", no_wrap=k in whole, overflow="fold")
    for row, style in zip_longest(rows, styles, fillvalue=""):
        table.add_row(*(Text(cell, style=style) for cell in row))
    return table


def _place(summary: Summary, scene: Scene, *, refused: bool) -> Rows:
    """Where the midpoint is in the end, with its error; the mean of what still swings."""
    final = summary.get("midpoint_final_m")
    if final is None:
        return []
    estimate = summary.get("error_estimate") or {}
    rest = summary.get("midpoint_settled_m") or {}
    place = float(final if rest.get("mean") is None else rest["mean"])
    ruler = length_unit(abs(place), scene.filament.span)
    error = _error(place, estimate.get("total"), float(summary.get("midpoint_largest_m", abs(place))))
    ends = scene.ends
    sags = place <= 0 and "free" not in (ends.left, ends.right) and ends.drop == 0 and not ends.motion
    where = f"{ruler.text(abs(place))}{'' if sags else ' down' if place <= 0 else ' up'}"
    share = f"{float(f'{100 * abs(place) / scene.filament.span:.2g}'):g} % of the span"
    if refused and estimate.get("total") is None:
        return [("reached", f"midpoint {where} when the run ended: no answer")]
    swing = float(rest.get("amplitude") or 0.0)
    swings = f", swinging by {length_unit(swing).text(swing)} about it" if swing > abs(place) / 1000 else ""
    return [("sag" if sags else "midpoint", f"{where}{error}, {share}{swings}")]


def _error(place: float, total: float | None, largest: float) -> str:
    """The error of a place, of which the estimate is a share of the largest."""
    if total is None:
        return " (error not estimated)"
    if abs(place) < _STILL * largest:
        return f" ± {length_unit(total * largest).text(total * largest)}"
    return f" ± {error_percent(total * largest / abs(place) if total else 0.0)}"


def _settled(summary: Summary) -> str:
    """Whether anything still moves by more than the accuracy asked when the run ends."""
    when, rest = summary["settled_s"], summary.get("midpoint_settled_m")
    if when is not None:
        return f"from {time_unit(when).text(when)} on"
    least = float(summary.get("accuracy", 0.0)) * float(summary.get("midpoint_largest_m", 0.0))
    if rest is not None and rest["amplitude"] > least:
        return "no: it still swings when the run ends"
    moved = abs(float(summary.get("midpoint_last_fifth_m", 0.0)))
    if rest is not None and moved <= least:
        return "yes, to the accuracy asked"
    return f"no: it moved by {length_unit(moved).text(moved)} in the last fifth of the run"


def _estimate(estimate: Mapping[str, Any] | None) -> str:
    """The total and its parts, or that nothing has estimated it."""
    if estimate is None:
        return "not estimated"
    named = {"space": "grid", "time": "time steps", "section": "fibres"}
    parts = [f"{word} {error_percent(estimate[key])}" for key, word in named.items() if estimate.get(key) is not None]
    total = estimate.get("total")
    text = f"{error_percent(total)} of the largest midpoint" if total is not None else "not estimated in full"
    return f"{text} ({', '.join(parts)})" if parts else text


def _effects(reasons: Mapping[str, Any] | None) -> str:
    """One name and its reason per line."""
    return "\n".join(f"{name}: on, {why}" if why else f"{name}: on" for name, why in (reasons or {}).items()) or "none"


def _left_out_worth(summary: Summary) -> float:
    """What all that was left out may change, of the largest midpoint: as the run shows it, else as expected."""
    found = summary.get("checked") or summary.get("left_out") or {}
    return float(sum(found.values()))


def _left_out(summary: Summary) -> str:
    names, worth = list(summary["left_out"]), _left_out_worth(summary)
    return left_out_words(names, worth)


def left_out_words(names: Sequence[str], worth: float) -> str:
    """Effects that are left out, and one number for all of them."""
    return f"{', '.join(names)}: {'together ' if len(names) > 1 else ''}worth at most {error_percent(worth)} of the sag"


def _wall(stages: Mapping[str, float] | None) -> str:
    """Wall time of each stage, in the order in which they happen."""
    if not stages:
        return "not measured"
    known = [name for name in STAGES if name in stages] + [name for name in stages if name not in STAGES]
    return ", ".join(f"{name} {significant(stages[name])} s" for name in known if stages[name] is not None)


def _files(files: Sequence[Path], *, verbose: bool) -> str:
    """The folder, and what is in it."""
    names, folder = [path.name for path in files], files[0].parent
    if verbose or len(names) <= _NAMED:
        return f"{folder}: {', '.join(names)}"
    return f"{folder} ({len(names)}: {', '.join(names[:_NAMED])}, ...)"
