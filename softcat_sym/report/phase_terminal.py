"""What is printed after a phase diagram: runs, what refinement saved, boundaries against formulas."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softcat_sym.report.phase_strains import strain_caption

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.study.phase_diagram import PhaseDiagram, PhaseSheet

HEADER = ("boundary of the runs", "against the line", "source", "rows", "off by")


def saved_text(sheet: PhaseSheet) -> str:
    """Runs, lattice, saving and time in a sentence."""
    marks = ", ".join(f"{count} {mark}" for mark, count in sheet.counts.items())
    again = sheet.runs - len(sheet.points)
    twice = f", {again} of them twice" if again else ""
    return (
        f"{sheet.plane.name}: {len(sheet.points)} of {sheet.nodes} filaments run{twice}; refinement saved "
        f"{sheet.saved} ({sheet.saved / sheet.nodes:.0%}); {sheet.wall:.1f} s, "
        f"{sheet.processor:.1f} s of processor time. {marks}."
    )


def boundary_rows(sheet: PhaseSheet) -> list[tuple[str, ...]]:
    """Below `HEADER`: G of the runs over that of the line, less one: median of the rows, least and most."""
    return [
        (
            one.kind,
            one.line.name,
            one.line.source,
            str(one.rows),
            f"{100 * one.median:+.0f} % ({100 * one.least:+.0f} to {100 * one.most:+.0f})",
        )
        for one in sheet.distances
    ]


def boundary_table(sheet: PhaseSheet) -> Table:
    """The rows as a table for the terminal."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(f"boundaries over {sheet.plane.name}: G of the runs against the lines", style="bold"),
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for k, name in enumerate(HEADER):
        table.add_column(Text(name), justify="right" if k == 3 else "left")
    for row in boundary_rows(sheet):
        table.add_row(*(Text(cell) for cell in row))
    return table


def print_phase_diagram(diagram: PhaseDiagram, console: Console | None = None) -> None:
    """Print a table and a sentence for each plane, and the strains of the paper's continual descent."""
    from rich.console import Console

    out = console or Console()
    for sheet in diagram.sheets:
        out.print(boundary_table(sheet))
        out.print(saved_text(sheet), markup=False, highlight=False)
    out.print(strain_caption(diagram), markup=False, highlight=False)
