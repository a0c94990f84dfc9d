"""Error of the one-dimensional theories against the variable of a study, the elements' own, the slender limit."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from softcat_sym.report import style
from softcat_sym.report.canvas import HEADING, axes_in_inches, head, new_figure
from softcat_sym.report.theory_end_tables import moment_names
from softcat_sym.study.discrepancy import SHARES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.graph.grid import Floats
    from softcat_sym.study.theory_end import Measured, TheoryEnd, TheoryError

_LEFT, _RIGHT, _GAP, _TALL, _BELOW, _LINE = 0.8, 0.15, 0.2, 2.7, 0.98, 0.145
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
    """Draw one panel for the published theory, one for the scene's own; errors in % upwards, all on one scale.

    Parameters
    ----------
    end : TheoryEnd
        As from :func:`softcat_sym.study.theory_end.where_theory_ends`.
    """
    names = [name for name in _SHOWN if name in end.names]
    notes = _notes(end, names)
    below = _BELOW + _LINE * len(notes)
    with style.styled():
        figure = new_figure(style.WIDTH, below + _TALL + 0.25 + HEADING)
        head(figure, "midpoint, filament against elements: where the theory ends", {}, end.scene, _LEFT)
        wide = (style.WIDTH - _LEFT - _RIGHT - _GAP * (len(names) - 1)) / len(names)
        extent = _ROOM * max(_LEAST, *_known(end, names))
        for k, name in enumerate(names):
            axes = axes_in_inches(figure, _LEFT + k * (wide + _GAP), below, wide, _TALL)
            _scales(axes, end, extent)
            _panel(axes, end, name)
            own = end.scene.run.effects == "auto" or name != "filament"
            axes.set_title(_TITLES[name] if own else "the scene's own effects", fontsize=9.0, loc="left")
            if k == 0:
                axes.set_ylabel("filament / elements − 1  [%]\n← sags less        sags more →", fontsize=8.5)
            else:
                axes.tick_params(labelleft=False)
        _legend(figure, end, below, notes)
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
        clip_on=False,
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
    return [line for text in said for line in textwrap.wrap(text, 112)]


def _untrusted(one: Measured, names: list[str]) -> bool:
    return any(not theory.error.trusted for theory in one.theories if theory.row.name in names)


def _legend(figure: Figure, end: TheoryEnd, below: float, notes: list[str]) -> None:
    height = figure.get_size_inches()[1]
    moments = moment_names(end)[: len(SHARES)]
    handles: list[Any] = [
        Line2D([], [], color=colour, marker="o", markersize=4.5, linewidth=1.2, label=name)
        for colour, name in zip(_COLOURS, moments, strict=True)
    ]
    handles.append(Line2D([], [], label="largest since the first", **_LARGEST))
    handles.append(
        Line2D(
            [],
            [],
            color=style.BLACK,
            marker="o",
            markerfacecolor="white",
            linestyle="none",
            markersize=4.5,
            label="at rest",
        )
    )
    handles.append(Patch(label="elements' own", **_BAND))
    figure.legend(
        handles=handles,
        loc="center left",
        bbox_to_anchor=(_LEFT / style.WIDTH, (0.3 + _LINE * len(notes)) / height),
        ncols=len(handles),
        borderaxespad=0.0,
        columnspacing=0.9,
        handlelength=1.5,
        handletextpad=0.4,
        fontsize=7.5,
    )
    for k, line in enumerate(reversed(notes)):
        figure.text(_LEFT / style.WIDTH, (0.08 + _LINE * k) / height, line, fontsize=7.5, color=style.GREY)
