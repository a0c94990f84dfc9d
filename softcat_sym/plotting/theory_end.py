"""Where the one-dimensional theory ends: chart, tables, terminal and files."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator
from rich.console import Console
from rich.text import Text

from softcat_sym.plotting import style
from softcat_sym.plotting.compare import document as comparison_document
from softcat_sym.plotting.files import csv_bytes, write_results
from softcat_sym.plotting.style import headed, legend
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import significant
from softcat_sym.studies import theory_end
from softcat_sym.studies.compare import SHARES, moments
from softcat_sym.studies.theory_end import Limit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.reference.elements import ElementRun
    from softcat_sym.studies.compare import FilamentRow
    from softcat_sym.studies.theory_end import Measured, TheoryEnd, TheoryError

LIMIT_DEFINITION = (
    "fit of e0 + a delta (+ b delta^2 from five values on) to the errors; leaving_out: largest change of e0 when one "
    "value is left out; mesh: change of e0 when the coarser elements judge; order: power of delta between the two "
    "thinnest filaments"
)


def key_of(name: str) -> str:
    """A theory's name as a key: ``published_material_closure``."""
    return name.replace(",", "").replace(" ", "_")


def moment_names(end: TheoryEnd) -> tuple[str, ...]:
    """What the errors of :class:`RelativeError` belong to: ``t = 46``, ..., ``mean``, ``largest``."""
    run = end.measured[0].comparison.elements
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    return (*(f"t = {time:.4g}" for time in times), "mean", "largest")


def errors_csv(end: TheoryEnd) -> bytes:
    """A row for each value and theory; the elements' own rows are those of the coarser against the finer."""
    names = [name.replace(" = ", "_") for name in moment_names(end)]
    header = ["value", "theory", "outcome", "regime", "midpoint_final_over_span", *names, "grid"]
    rows: list[Sequence[object]] = []
    for one in end.measured:
        span = one.comparison.scene.filament.span
        for run, error in ((one.comparison.elements, None), (one.coarse, one.mesh)):
            values = [None] * len(names) if error is None else error.values
            rows.append([one.value, mesh_name(run), "", "", run.midpoint[-1] / span, *values, None])
        for theory in one.theories:
            summary, last = theory.row.trajectory.summary, theory.row.midpoint[-1] / span
            told = [theory.row.name.replace(",", ""), summary["outcome"], summary["regime"] or ""]
            rows.append([one.value, *told, last, *theory.error.values, theory.grid])
    rows += [[lost.value, "", "not run", "", None, *[None] * len(names), None] for lost in end.unmeasured]
    return csv_bytes(header, rows)


def limits_csv(end: TheoryEnd) -> bytes:
    """A row for each theory and moment that has a limit."""
    header = ["theory", "moment", "intercept", "uncertainty", "leaving_out", "mesh", "slope", "order"]
    rows: list[Sequence[object]] = []
    for name, limits in end.limits.items():
        for moment, limit in zip(moment_names(end), limits, strict=True):
            if limit is not None:
                parts = (limit.intercept, limit.uncertainty, limit.leaving_out, limit.mesh, limit.coefficients[1])
                rows.append([name.replace(",", ""), moment, *parts, limit.order])
    return csv_bytes(header, rows)


def cost_rows(one: Measured) -> Iterator[tuple[str, int, int, float, float | None, float]]:
    """Who, unknowns, steps, seconds of the solve and in all, largest error; the elements' seconds are of their steps.

    The finer elements come first, with the error that their coarser companions have against them; the coarser have the
    same.
    """
    for run in (one.comparison.elements, one.coarse):
        yield mesh_name(run), run.dofs, run.steps, run.wall, None, one.mesh.largest
    for theory in one.theories:
        summary = theory.row.trajectory.summary
        wall = summary["wall_s"]
        yield theory.row.name, theory.row.dofs, summary["steps"], wall["solve"], wall["total"], theory.error.largest


def cost_csv(end: TheoryEnd) -> bytes:
    """A row for each value and run, with the ratios of the finer elements over it."""
    header = ["value", "run", "dofs", "steps", "solve_s", "total_s", "largest_error"]
    header += ["dofs_ratio", "steps_ratio", "solve_ratio"]
    rows: list[Sequence[object]] = []
    for one in end.measured:
        run = one.comparison.elements
        for name, dofs, steps, solve, total, error in cost_rows(one):
            ratios = (_over(run.dofs, dofs), _over(run.steps, steps), _over(run.wall, solve))
            rows.append([one.value, name.replace(",", ""), dofs, steps, solve, total, error, *ratios])
    return csv_bytes(header, rows)


def document(end: TheoryEnd) -> dict[str, Any]:
    """What ``compare.json`` holds of a varied scene; every number finite or null.

    Each of ``values`` holds what a comparison of that scene alone would, and beside it the errors of this study.
    """
    return {
        "title": end.scene.title,
        "vary": end.variation.path,
        "definition": theory_end.DEFINITION,
        "moments": list(moment_names(end)),
        "values": [_value(one) for one in end.measured],
        "not_run": [{"value": lost.value, "reason": lost.reason} for lost in end.unmeasured],
        "slender_limit": {
            "definition": LIMIT_DEFINITION,
            **{key_of(name): [_limit(limit) for limit in limits] for name, limits in end.limits.items()},
        }
        if end.limits
        else None,
    }


def mesh_name(run: ElementRun) -> str:
    """``elements 32 x 4``, with the grading if there is one."""
    mesh = run.mesh
    graded = f" graded {mesh.grading:g}" if mesh.grading != 1 else ""
    return f"elements {mesh.along} x {mesh.through}{graded}"


def _value(one: Measured) -> dict[str, Any]:
    coarse = one.coarse
    return {
        "value": one.value,
        **comparison_document(one.comparison),
        "mesh_grading": one.comparison.elements.mesh.grading,
        "elements_coarser": {
            "along": coarse.mesh.along,
            "through": coarse.mesh.through,
            "midpoint_final_m": float(coarse.midpoint[-1]),
            "wall_s": coarse.wall,
            "dofs": coarse.dofs,
            "steps": coarse.steps,
            "errors": list(one.mesh.values),
        },
        "theory_errors": {
            key_of(theory.row.name): {
                "errors": list(theory.error.values),
                "trusted": theory.error.trusted,
                "grid": theory.grid,
                **_ratios(one.comparison.elements, theory.row),
            }
            for theory in one.theories
        },
    }


def _ratios(run: ElementRun, row: FilamentRow) -> dict[str, float]:
    summary = row.trajectory.summary
    return {
        "dofs_ratio": _over(run.dofs, row.dofs),
        "steps_ratio": _over(run.steps, summary["steps"]),
        "solve_ratio": _over(run.wall, summary["wall_s"]["solve"]),
    }


def _limit(limit: Limit | None) -> dict[str, Any] | None:
    if limit is None:
        return None
    return {
        "intercept": limit.intercept,
        "uncertainty": limit.uncertainty,
        "leaving_out": limit.leaving_out,
        "mesh": limit.mesh,
        "coefficients": list(limit.coefficients),
        "order": limit.order,
    }


def _over(one: float, other: float) -> float:
    return one / other if other else math.nan


_ROOM, _LEAST = 1.12, 0.5
_LOGARITHMIC = 5.0
"""Values that span this ratio stand on a logarithmic axis."""

_BAND: dict[str, Any] = {"color": "#dddddd", "linewidth": 0.0, "zorder": 0}
_LARGEST: dict[str, Any] = {"color": style.GREY, "linewidth": 1.0, "linestyle": (0, (1.2, 1.2)), "zorder": 1}
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.BLACK)
_TITLES = {
    "filament": "all that the program chooses",
    "published, material closure": "published theory, material closure",
    "published, printed closure": "published theory, printed closure",
}
_SHOWN = ("published, material closure", "filament")


def theory_end_figure(end: TheoryEnd) -> Figure:
    """Draw one panel for the published theory, one for the scene's own; errors in % upwards, all on one scale."""
    names = [name for name in _SHOWN if name in end.names]
    what = "midpoint, filament against elements: where the theory ends"
    with style.styled():
        figure, body = headed(end.scene, what, {}, height=3.9, notes="\n".join(_notes(end, names)))
        extent = _ROOM * max(_LEAST, *_known(end, names))
        panels = body.subplots(1, len(names), squeeze=False, sharey=True).ravel()
        for axes, name in zip(panels, names, strict=True):
            _scales(axes, end, extent)
            _panel(axes, end, name)
            own = end.scene.run.effects == "auto" or name != "filament"
            axes.set_title(_TITLES[name] if own else "the scene's own effects", fontsize=9.0, loc="left")
        panels[0].set_ylabel("filament / elements − 1  [%]\n← sags less        sags more →", fontsize=8.5)
        handles = _handles(end)
        legend(body, handles=handles, ncols=len(handles), columnspacing=0.9, handlelength=1.5, handletextpad=0.4)
    return figure


def _panel(axes: Axes, end: TheoryEnd, name: str) -> None:
    found = [(one, theory) for one in end.measured for theory in one.theories if theory.row.name == name]
    values = np.array([one.value for one in end.measured])
    own = 100 * np.abs([one.mesh.at for one in end.measured]).max(axis=1)
    axes.fill_between(values, -own, own, **_BAND)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=1)
    sound = [(one, theory) for one, theory in found if theory.error.trusted]
    axes.plot([one.value for one, _ in sound], [100 * theory.error.largest for _, theory in sound], **_LARGEST)
    for k, colour in enumerate(_COLOURS):
        line = [100 * theory.error.at[k] for _, theory in sound]
        if end.limits:
            _extrapolated(axes, end, name, k)
        else:
            axes.plot([one.value for one, _ in sound], line, color=colour, linewidth=1.2, zorder=2)
        for one, theory in found:
            axes.plot([one.value], [100 * theory.error.at[k]], color=colour, zorder=3, **_mark(theory))


def _mark(theory: TheoryError) -> dict[str, Any]:
    """Full where it flows on, hollow where it has come to rest, a cross where it is not to be trusted."""
    if not theory.error.trusted:
        return {"marker": "x", "markersize": 5.5, "linestyle": "none"}
    regime = theory.row.trajectory.summary["regime"] or ""
    resting = regime.startswith(("arrested", "no-yield", "elastic"))
    return {
        "marker": "o",
        "markersize": 4.5,
        "linestyle": "none",
        **({"markerfacecolor": "white"} if resting else {}),
    }


def _extrapolated(axes: Axes, end: TheoryEnd, name: str, moment: int) -> None:
    """The fit down to a thickness of zero, and its intercept with the uncertainty."""
    limit = end.limits[name][moment]
    if limit is None:
        return
    span = end.scene.filament.span
    # The variable is h0/L or h0 itself.
    unit = 1.0 if end.variation.path == "groups.delta" else 1 / span
    values = np.linspace(0.0, end.measured[-1].value, 60)
    axes.plot(values, 100 * limit.at(values * unit), color=_COLOURS[moment], linewidth=1.2, zorder=2)
    axes.errorbar(
        [0.0],
        [100 * limit.intercept],
        [100 * limit.uncertainty],
        color=_COLOURS[moment],
        marker="D",
        markersize=4.0,
        capsize=2.5,
        linewidth=1.0,
        zorder=4,
    )


def _known(end: TheoryEnd, names: list[str]) -> Iterator[float]:
    """Magnitudes of all errors that are to be seen, in %."""
    for one in end.measured:
        for theory in one.theories:
            if theory.row.name in names and theory.error.trusted:
                yield from (
                    100 * abs(value) for value in (*theory.error.at, theory.error.largest) if np.isfinite(value)
                )


def _scales(axes: Axes, end: TheoryEnd, extent: float) -> None:
    values = np.array([one.value for one in end.measured])
    if end.limits:
        axes.set_xlim(-0.03 * values[-1], 1.04 * values[-1])
    elif values[0] > 0 and values[-1] / values[0] >= _LOGARITHMIC:
        axes.set_xscale("log")
        room = (values[-1] / values[0]) ** 0.05
        axes.set_xlim(values[0] / room, values[-1] * room)
        _round_numbers(axes, values)
    else:
        room = 0.05 * float(np.ptp(values) or 1.0)
        axes.set_xlim(values[0] - room, values[-1] + room)
    axes.set_ylim(-extent, extent)
    axes.set_xlabel(_label(end))
    axes.grid(True)
    style.lighten(axes)


def _round_numbers(axes: Axes, values: Floats) -> None:
    """Ticks at 1, 2, 5 within each decade; at the decades alone where they are many."""
    decades = np.arange(np.floor(np.log10(values[0])), np.ceil(np.log10(values[-1])) + 1)
    steps = (1, 2, 5) if len(decades) <= 4 else (1,)
    ticks = [step * 10.0**decade for decade in decades for step in steps]
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _label(end: TheoryEnd) -> str:
    path = end.variation.path
    known = {
        "groups.delta": "δ = h₀ / L",
        "groups.G": "G = ρ g L / σY",
        "groups.V": "V = η / (ρ √(g L³))",
        "filament.thickness": "thickness [m]",
    }
    return known.get(path, path)


def _notes(end: TheoryEnd, names: list[str]) -> list[str]:
    """What the points cannot say."""
    said = []
    if bad := [one.text for one in end.measured if _untrusted(one, names)]:
        said.append(f"Refused by the program itself (crosses, some beyond the axes): {', '.join(bad)}.")
    if end.unmeasured:
        said.append(f"Not run: {', '.join(lost.text for lost in end.unmeasured)}.")
    if any(limit for name in names for limit in end.limits.get(name, ())):
        terms = max(len(limit.coefficients) for name in names for limit in end.limits[name] if limit is not None)
        order = "first" if terms == 2 else "second"
        said.append(f"Lines: fit of {order} order in the thickness; diamonds: its intercept, with uncertainty.")
    return said


def _untrusted(one: Measured, names: list[str]) -> bool:
    return any(not theory.error.trusted for theory in one.theories if theory.row.name in names)


def _handles(end: TheoryEnd) -> list[Any]:
    point: dict[str, Any] = {"marker": "o", "markersize": 4.5}
    named = zip(_COLOURS, moment_names(end)[: len(SHARES)], strict=True)
    return [
        *(Line2D([], [], color=colour, linewidth=1.2, label=name, **point) for colour, name in named),
        Line2D([], [], label="largest since the first", **_LARGEST),
        Line2D([], [], color=style.BLACK, markerfacecolor="white", linestyle="none", label="at rest", **point),
        Patch(label="elements' own", **_BAND),
    ]


Table = tuple[str, tuple[str, ...], list[tuple[str, ...]]]
"""Title, header, rows."""

_NOTE = "filament/elements − 1 in %: positive where the filament sags more; t in L √(ρ/E)"


def error_table(end: TheoryEnd) -> Table:
    """Errors of half as many elements, and of each theory, at each value."""
    rows: list[tuple[str, ...]] = []
    for one in end.measured:
        rows.append((one.text, "half the elements", *map(percent, one.mesh.values)))
        rows += [("", _short(theory.row.name), *map(percent, theory.error.values)) for theory in one.theories]
    rows += [(lost.text, "not run", *[""] * 6) for lost in end.unmeasured]
    return f"{end.variation.path}: error of the midpoint\n{_NOTE}", ("", "", *_moments(end)), rows


def limit_table(end: TheoryEnd) -> Table:
    """Intercept and uncertainty of each theory at each moment, then the order of its error."""
    rows = []
    for name, limits in end.limits.items():
        orders = ["–" if limit is None or math.isnan(limit.order) else f"{limit.order:.2f}" for limit in limits]
        rows += [
            (_short(name), "limit", *("–" if limit is None else percent(limit.intercept) for limit in limits)),
            ("", "±", *("–" if limit is None else f"{100 * limit.uncertainty:.2f}" for limit in limits)),
            ("", "order", *orders),
        ]
    return "Slender limit: the error as the thickness goes to zero, in %", ("", "", *_moments(end)), rows


def cost_table(end: TheoryEnd) -> Table:
    """What each run took, and how many times as much the finer elements did."""
    rows = [cells for one in end.measured for cells in _cost(one)]
    header = ("", "", "unknowns", "steps", "solve [s]", "×", "error")
    return "Cost; ×: seconds of the finer elements over it; error: the largest, in %", header, rows


def remarks(end: TheoryEnd) -> list[str]:
    """Each value at which a theory is not to be trusted or could not be run, and the warnings, each once."""
    path = end.variation.path
    said = [
        f"{path} = {one.text}, {theory.row.name}: {theory.row.trajectory.outcome.name}, not to be trusted"
        for one in end.measured
        for theory in one.theories
        if not theory.row.trajectory.outcome.is_success
    ]
    said += [f"{path} = {lost.text}: {lost.reason}" for lost in end.unmeasured]
    if resting := [one.text for one in end.measured if _rests(one)]:
        said.append(f"at rest in the end: {path} = {', '.join(resting)}")
    warnings = dict.fromkeys(text for one in end.measured for text in one.comparison.warnings)
    return [*said, *(f"warning: {text}" for text in warnings)]


def print_theory_end(end: TheoryEnd, console: Console | None = None) -> None:
    """Print the tables and the remarks."""
    screen = console or Console()
    tables = [error_table(end), *([limit_table(end)] if end.limits else []), cost_table(end)]
    for title, header, rows in tables:
        looks: dict[str, Any] = {"right": range(2, len(header)), "whole": range(9), "padding": (0, 1, 0, 0)}
        screen.print(text_table(header, rows, title=title, title_style="none", **looks))
    for text in remarks(end):
        screen.print(Text(text))


def percent(error: float) -> str:
    """A share as a signed percentage without its sign of per cent."""
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"


def _short(name: str) -> str:
    return name.removesuffix(" closure")


def _moments(end: TheoryEnd) -> tuple[str, ...]:
    return tuple(name.replace("t = ", "t ") for name in moment_names(end))


def _rests(one: Measured) -> bool:
    return str(one.comparison.filament.trajectory.summary["regime"]).startswith(("arrested", "no-yield"))


def _cost(one: Measured) -> Iterator[tuple[str, ...]]:
    finer = one.comparison.elements.wall
    for k, (name, dofs, steps, solve, _, error) in enumerate(cost_rows(one)):
        ratio = significant(finer / solve) if solve > 0 else "–"
        # The finest mesh has no finer one to be measured against.
        yield (
            one.text if k == 0 else "",
            name,
            str(dofs),
            str(steps),
            significant(solve),
            ratio,
            percent(error) if k else "",
        )


def write_theory_end(end: TheoryEnd, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, the chart and the tables of errors, costs and limits."""
    contents = {
        "compare.json": document(end),
        "scene.toml": end.scene.to_toml(),
        "compare_vary.png": theory_end_figure(end),
        "compare_vary_errors.csv": errors_csv(end),
        "compare_vary_cost.csv": cost_csv(end),
        "compare_vary_limit.csv": limits_csv(end) if end.limits else None,
    }
    return write_results(directory, contents)
