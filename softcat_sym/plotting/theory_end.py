"""Where the one-dimensional theory ends: chart, terminal and files."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.compare import percent
from softcat_sym.plotting.phase import AXES
from softcat_sym.plotting.style import legend, plain_log, styled, titled_figure
from softcat_sym.plotting.units import Unit, length_unit, significant
from softcat_sym.studies.theory_end import TheoryEnd, TheoryError

_LOGARITHMIC = 5.0
"""Values that span this ratio stand on a logarithmic axis."""

_BAND: dict[str, Any] = {"color": "#dddddd", "linewidth": 0.0, "zorder": 0}
_LARGEST: dict[str, Any] = {"color": style.GREY, "linewidth": 1.0, "linestyle": ":", "zorder": 1}
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.BLACK)
_TITLES = {
    "published, material closure": "published theory, material closure",
    "filament": "all that the program chooses",
}


@drawing.plot.register(TheoryEnd)
@styled()
def theory_end_figure(end: TheoryEnd) -> Figure:
    """Draw one panel for the published theory, one for the scene's own; errors in % upwards, all on one scale."""
    names = [name for name in _TITLES if name in end.names]
    shown = [(each.text, each.theories[name]) for each in end.measured for name in names if name in each.theories]
    values = [np.delete(theory.error, 4) for _, theory in shown if theory.trusted]  # the mean is not drawn
    extent = 112 * np.nanmax([0.5e-2, *np.abs(values).ravel()])
    notes, untrusted = [], dict.fromkeys(text for text, theory in shown if not theory.trusted)
    if untrusted:
        notes.append(f"Refused by the program itself (crosses, some beyond the axes): {', '.join(untrusted)}.")
    if end.unmeasured:
        notes.append(f"Not run: {', '.join(lost.text for lost in end.unmeasured)}.")
    if end.limits:
        notes.append("Lines: fit of first or second order in the thickness; diamonds: its intercept, with uncertainty.")
    path, (first, last) = end.variation.path, (end.measured[0].value, end.measured[-1].value)
    group, unit = path.removeprefix("groups."), Unit("", 1.0)
    if path == "filament.thickness":
        unit = length_unit(last)
    label = AXES.get(group, group.rpartition(".")[2].replace("_", " ")) + (f" [{unit.symbol}]" if unit.symbol else "")
    what = "midpoint, filament against elements: where the theory ends"
    figure, body = titled_figure(end.scene, what, {}, height=3.9, notes="\n".join(notes))
    panels = body.subplots(1, len(names), squeeze=False, sharex=True, sharey=True).ravel()
    for axes, name in zip(panels, names, strict=True):
        _draw(axes, end, name, unit)
        own = end.scene.run.effects == "auto" or name != "filament"
        axes.set_title(_TITLES[name] if own else "the scene's own effects", fontsize=9.0, loc="left")
        axes.set_xlabel(label)
        axes.grid(True)
    if not end.limits and first > 0 and last / first >= _LOGARITHMIC:
        panels[0].set_xscale("log")
        plain_log(panels[0].xaxis)
    panels[0].margins(x=0.05)
    panels[0].set_ylim(-extent, extent)
    panels[0].set_ylabel("filament / elements − 1  [%]\n← sags less        sags more →", fontsize=8.5)
    point: dict[str, Any] = {"marker": "o", "markersize": 4.5}
    handles = [
        *(Line2D([], [], color=c, label=name, **point) for c, name in zip(_COLOURS, end.moments, strict=False)),
        Line2D([], [], label="largest since the first", **_LARGEST),
        Line2D([], [], color=style.BLACK, markerfacecolor="white", linestyle="none", label="at rest", **point),
        Patch(label="elements' own", **_BAND),
    ]
    legend(body, handles=handles, ncols=len(handles), columnspacing=0.9, handlelength=1.5, handletextpad=0.4)
    return figure


def _draw(axes: Axes, end: TheoryEnd, name: str, unit: Unit) -> None:
    """Errors of one theory at four moments, with the extrapolation to a thickness of zero if there is one."""
    found = [(each.value, each.theories[name]) for each in end.measured if name in each.theories]
    values = np.array([each.value for each in end.measured])
    own = 100 * np.abs([each.mesh[:4] for each in end.measured]).max(axis=1)
    axes.fill_between(unit.of(values), -own, own, **_BAND)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=1)
    places = unit.of([value for value, theory in found if theory.trusted])
    errors = 100 * np.array([theory.error for _, theory in found if theory.trusted]).reshape(-1, len(end.moments))
    axes.plot(places, errors[:, -1], **_LARGEST)
    for k, colour in enumerate(_COLOURS):
        limit = end.limits[name][k] if end.limits else None
        if not end.limits:
            axes.plot(places, errors[:, k], color=colour, linewidth=1.2, zorder=2)
        elif limit is not None:
            # The variable is h0/L or h0 itself.
            span = 1.0 if end.variation.path == "groups.delta" else end.scene.filament.span
            line = np.linspace(0.0, values[-1], 60)
            fitted = np.polynomial.polynomial.polyval(line / span, limit["coefficients"])
            axes.plot(unit.of(line), 100 * fitted, color=colour, linewidth=1.2, zorder=2)
            bar: dict[str, Any] = {"fmt": "D", "markersize": 4.0, "capsize": 2.5, "linewidth": 1.0, "zorder": 4}
            axes.errorbar([0.0], [100 * limit["intercept"]], [100 * limit["uncertainty"]], color=colour, **bar)
        for value, theory in found:
            mark = {"color": colour, "linestyle": "none", "zorder": 3, **_mark(theory)}
            axes.plot(unit.of([value]), [100 * theory.error[k]], **mark)


def _mark(theory: TheoryError) -> dict[str, Any]:
    """Full where it flows on, hollow where it has come to rest, a cross where it is not to be trusted."""
    if not theory.trusted:
        return {"marker": "x", "markersize": 5.5}
    regime = theory.row.trajectory.summary["regime"] or ""
    rests = regime.startswith(("arrested", "no-yield", "elastic"))
    return {"marker": "o", "markersize": 4.5, **({"markerfacecolor": "white"} if rests else {})}


_NOTE = "filament/elements − 1 in %: positive where the filament sags more; t in L √(ρ/E)"


def tables(end: TheoryEnd) -> list[TextTable]:
    """Errors of half as many elements and of each theory, and limits; with their titles."""
    errors: list[tuple[str, ...]] = []
    for each in end.measured:
        errors.append((each.text, "half the elements", *map(percent, each.mesh)))
        errors += [("", _short(name), *map(percent, theory.error)) for name, theory in each.theories.items()]
    errors += [(lost.text, "not run", *[""] * 6) for lost in end.unmeasured]
    header = ("", "", *(name.replace("t = ", "t ") for name in end.moments))
    title = f"{end.variation.path}: error of the midpoint\n{_NOTE}"
    found = [TextTable(header, errors, range(2, 8), title=title, whole=range(8))]
    limits: list[tuple[str, ...]] = []
    for name, row in end.limits.items():
        known = [each or dict.fromkeys(("intercept", "uncertainty", "order"), math.nan) for each in row]
        limits.append((_short(name), "limit", *(percent(each["intercept"]) for each in known)))
        limits.append(("", "±", *(percent(each["uncertainty"]).removeprefix("+") for each in known)))
        limits.append(("", "order", *(_plain(each["order"]) for each in known)))
    if limits:
        title = "Slender limit: the error as the thickness goes to zero, in %"
        found.append(TextTable(header, limits, range(2, 8), title=title, whole=range(8)))
    return found


def _plain(number: float) -> str:
    return significant(number) if math.isfinite(number) else "–"


def _short(name: str) -> str:
    return name.removesuffix(" closure")


def remarks(end: TheoryEnd) -> list[str]:
    """Each value at which a theory is not to be trusted or could not be run, and the warnings, each once."""
    path = end.variation.path
    texts = [
        f"{path} = {each.text}, {name}: {theory.row.trajectory.outcome.name}, not to be trusted"
        for each in end.measured
        for name, theory in each.theories.items()
        if not theory.row.trajectory.outcome.is_success
    ]
    texts += [f"{path} = {lost.text}: {lost.reason}" for lost in end.unmeasured]
    regimes = [(each.text, str(each.comparison.filament.trajectory.summary["regime"])) for each in end.measured]
    if resting := [text for text, regime in regimes if regime.startswith(("arrested", "no-yield"))]:
        texts.append(f"at rest in the end: {path} = {', '.join(resting)}")
    warnings = dict.fromkeys(text for each in end.measured for text in each.comparison.warnings)
    return [*texts, *(f"warning: {text}" for text in warnings)]


@drawing.report.register(TheoryEnd)
def theory_end_report(end: TheoryEnd) -> Report:
    """The tables of errors and limits, and the remarks."""
    files = {
        "compare.json": end.to_dict,
        "scene.toml": end.scene.to_toml,
        "compare_vary.png": end.plot,
        "compare_vary_errors.csv": end.to_frame,
        "compare_vary_limit.csv": end.limit_table if end.limits else None,
    }
    return Report(files, [*tables(end), *map(Text, remarks(end))])
