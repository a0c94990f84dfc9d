"""What is printed after a sweep: how members ended, what they show, how fast it was."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softcat_sym.report.phase_diagram import LOOKS

if TYPE_CHECKING:
    from rich.console import Console

    from softcat_sym.study.sweep import Sweep


def sweep_rows(sweep: Sweep) -> list[tuple[str, str]]:
    """Name and text of each row, in the order of reading."""
    counts = sweep.counts
    rows = [("members", _members(sweep))]
    rows += [(f"  {name}", _share(count, len(sweep))) for name, count in counts.outcomes.most_common()]
    if counts.regimes:
        rows.append(("regimes", ""))
        rows += [
            (f"  {LOOKS[name].words if name in LOOKS else name}", _share(count, len(sweep)))
            for name, count in counts.regimes.most_common()
        ]
    ran = len(sweep) - sweep.resumed
    if ran:
        rows.append(("time", f"{sweep.wall_s:.1f} s, {ran / sweep.wall_s:.0f} members/s; {sweep.place}"))
    if sweep.peak_memory:
        rows.append(("peak memory", f"{sweep.peak_memory:.0f} MB"))
    return rows


def print_sweep(sweep: Sweep, console: Console | None = None) -> None:
    """Print them as a table."""
    from rich import box
    from rich.console import Console as Terminal
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE, show_header=False, padding=(0, 1, 0, 0), title_justify="left")
    table.title = Text(sweep.plan.scene.title or "sweep", style="bold")
    for name, text in sweep_rows(sweep):
        table.add_row(Text(name), Text(text))
    (console or Terminal()).print(table)


def _members(sweep: Sweep) -> str:
    axes = " x ".join(str(len(axis.values)) for axis in sweep.plan.axes)
    how = {
        "grid": f"{axes} grid" if len(sweep.plan.axes) > 1 else "one axis",
        "zip": "values side by side",
        "lhs": f"Latin hypercube, seed {sweep.plan.seed}",
        "table": "rows of a table",
    }[sweep.plan.mode]
    before = f", {sweep.resumed} of them from before" if sweep.resumed else ""
    return f"{len(sweep)} ({how}){before}"


def _share(count: int, of: int) -> str:
    return f"{count} ({count / of:.0%})"
