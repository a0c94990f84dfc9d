"""The paper's figure 4: snapshots of elements and filament side by side, and the deformed mesh at the end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from softcat_sym.plotting import style
from softcat_sym.plotting.figure_files import facts, printed, table
from softcat_sym.plotting.figure_strips import (
    BLACK_RATE,
    YIELDED,
    draw_elements,
    draw_filament,
    draw_mesh,
    strip_at,
)
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.studies.paper_figures import ALPHA, INSTANTS, OWN, PAPER, SNAPSHOTS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.paper_figures import FilmedScene

_WIDTH, _LEFT, _RIGHT, _GAP = 9.6, 0.62, 0.12, 0.5
_TOP, _TITLE, _BETWEEN, _LAST, _BOTTOM = 0.1, 0.24, 0.1, 0.5, 1.95
_ZOOM_WIDTH, _ZOOM = 2.35, 2.6
_MARGIN = 0.008
_SHARES = ("α/4", "α/2", "α", "2α")
_LETTERS = "abc"
_OUTLINES = {
    PAPER: {"color": style.ORANGE, "linewidth": 1.3},
    OWN: {"color": style.BLUE, "linewidth": 1.0, "linestyle": (0, (4, 1.5))},
}

CAPTION = (
    "Figure 4. (a)-(c) Left half: finite elements ({along} x {through} over the half span, plane stress), grey by the "
    "plastic shear rate |Lp| L sqrt(rho/E) from 0 = white to 4.4e-4 = black; |Lp| is sqrt(3) times the equivalent "
    "tensile rate, which (3.7) as printed gives at the same stress. Right half: the filament by the paper's physics, "
    "its centreline (dashed) and its faces, shaded where the stress linear in z exceeds the yield stress. alpha = 46. "
    "The paper's text names alpha and 10 alpha; the other instants are chosen here, early, where the flow varies most. "
    "(a) Nothing flows. (b) Flow begins at the clamps and at midspan, spreads, and dies out: at 2 alpha the largest "
    "rate is {fades:.2f} of that at alpha/2. (c) All but a corner at the clamp flows, faster than the scale's end: "
    "half of the points by more than {median:.1e} at alpha, the fastest by {rates}. "
    "(d) Deformed mesh and filaments at t~ = 10 alpha = 460, continual descent: the midpoint hangs {sag:.3f} L deep "
    "(elements), {paper:.3f} L (paper's physics), {own:.3f} L (chosen by the program); the axial strain of the "
    "elements at the clamp is {mean:.0f}\u00a0% in the mean, {strain:.0f}\u00a0% at most."
)


def caption(scenes: Mapping[str, FilmedScene]) -> str:
    """The caption, every number from the runs."""
    last = scenes[SNAPSHOTS[-1]]
    arrest = scenes[SNAPSHOTS[1]].film
    rate = last.film.at(ALPHA).rate
    return CAPTION.format(
        along=last.film.run.mesh.along,
        through=last.film.run.mesh.through,
        fades=float(arrest.at(2 * ALPHA).rate.max() / arrest.at(ALPHA / 2).rate.max()),
        median=float(np.median(rate)),
        rates=f"{rate.max():.1e}",
        sag=-last.elements[1][-1],
        paper=-last.filament(PAPER)[1][-1],
        own=-last.filament(OWN)[1][-1],
        mean=100 * np.expm1(last.film.run.clamp_strain[-1]),
        strain=100 * np.expm1(last.film.run.clamp_strain_largest[-1]),
    )


def snapshots_figure(filmed: Sequence[FilmedScene]) -> Figure:
    """Draw (a)-(c), four instants each, and (d) with its clamp enlarged."""
    scenes = {each.of.name: each for each in filmed}
    width = (_WIDTH - _LEFT - _RIGHT - _GAP) / 2
    depths = [_depth(scenes[name], INSTANTS[k : k + 2]) for name in SNAPSHOTS for k in (0, 2)]
    inch = width / 1.03
    final = _depth(scenes[SNAPSHOTS[-1]], INSTANTS[-1:])
    mesh_width = _WIDTH - _LEFT - _RIGHT - _GAP - _ZOOM_WIDTH
    tall = mesh_width / 1.03 * sum(final)
    rows = [inch * sum(depth) for depth in depths]
    height = _TOP + sum(rows) + 6 * _TITLE + 5 * _BETWEEN + _LAST + _TITLE + tall + _BOTTOM
    with style.styled():
        figure = new_figure(_WIDTH, height)
        top, bar = height - _TOP, None
        for row, (depth, high) in enumerate(zip(depths, rows, strict=True)):
            of, letter = scenes[SNAPSHOTS[row // 2]], _LETTERS[row // 2]
            for column in range(2):
                instant = 2 * (row % 2) + column
                place = (_LEFT + column * (width + _GAP), top - _TITLE - high, width, high)
                axes = axes_in_inches(figure, *place)
                bar = draw_elements(axes, of.film.at(INSTANTS[instant]), of.film.run.mesh.through)
                draw_filament(axes, strip_at(of, INSTANTS[instant]))
                _frame(axes, depth, labelled=row == len(rows) - 1)
                name = f"({letter}) {of.of.title}, " if instant == 0 else ""
                axes.set_title(f"{name}t~ = {_SHARES[instant]}", loc="left", fontsize=8.5, pad=2.5)
            top -= _TITLE + high + _BETWEEN
        top -= _LAST - _BETWEEN
        _last(figure, scenes[SNAPSHOTS[-1]], (top - _TITLE - tall, mesh_width, tall), final)
        _explain(figure, bar, caption(scenes))
    return figure


def _depth(of: FilmedScene, instants: Sequence[float]) -> tuple[float, float]:
    """How far the strips reach above and below the supports, over the span."""
    heights = [of.film.at(instant).outline[..., 1] for instant in instants]
    return max(float(h.max()) for h in heights) + _MARGIN, _MARGIN - min(float(h.min()) for h in heights)


def _frame(axes: Axes, depth: tuple[float, float], *, labelled: bool) -> None:
    axes.set_xlim(-0.515, 0.515)
    axes.set_ylim(-depth[1], depth[0])
    axes.axvline(0.0, color=style.GREY, linewidth=0.5, linestyle=":")
    axes.set_yticks([-step for step in (0.0, 0.05, 0.1, 0.15) if step < depth[1]])
    axes.set_xticks([-0.5, -0.25, 0.0, 0.25, 0.5])
    axes.tick_params(labelbottom=labelled, labelsize=7)
    if labelled:
        axes.set_xlabel("x / L", labelpad=1.0)
    style.lighten(axes)


def _last(figure: Figure, of: FilmedScene, room: tuple[float, float, float], depth: tuple[float, float]) -> None:
    """Panel (d); `room` is bottom, width and height [inch]."""
    bottom, width, tall = room
    axes = axes_in_inches(figure, _LEFT, bottom, width, tall)
    close = axes_in_inches(figure, _LEFT + width + _GAP, bottom, _ZOOM_WIDTH, tall)
    shot = of.film.at(INSTANTS[-1])
    for each in (axes, close):
        draw_mesh(each, shot)
        for theory, line in _OUTLINES.items():
            section = strip_at(of, INSTANTS[-1], theory).section
            for zeta in (-1.0, 1.0):
                each.plot(*section.at(zeta).T, label=theory if zeta > 0 else None, **line)  # type: ignore[arg-type]
        style.lighten(each)
        each.tick_params(labelsize=7)
        each.set_xlabel("x / L", labelpad=1.0)
    axes.set_xlim(-0.515, 0.515)
    axes.set_ylim(-depth[1], depth[0])
    thickness = of.scene.filament.thickness / of.scene.filament.span
    half = _ZOOM * thickness / 2
    close.set_xlim(0.5 + 0.25 * thickness - 2 * half, 0.5 + 0.25 * thickness)
    high = 2 * half * tall / _ZOOM_WIDTH
    close.set_ylim(0.75 * thickness - high, 0.75 * thickness)
    axes.set_title(f"(d) {of.of.title}, t~ = 10α = 460", loc="left", fontsize=8.5, pad=2.5)
    close.set_title("at the clamp", loc="left", fontsize=8.5, pad=2.5)


def _explain(figure: Figure, bar: Any, text: str) -> None:
    width, height = figure.get_size_inches()
    colours = axes_in_inches(figure, _LEFT, _BOTTOM - 0.62, 2.6, 0.12)
    figure.colorbar(bar, cax=colours, orientation="horizontal", extend="max", ticks=[0, 1.1e-4, 2.2e-4, 3.3e-4, 4.4e-4])
    colours.set_xticklabels(["0", "1.1e−4", "2.2e−4", "3.3e−4", f"{BLACK_RATE:.1e}".replace("e-04", "e−4")])
    colours.tick_params(labelsize=7)
    colours.set_title("|Lp| L √(ρ/E), elements", fontsize=7.5, loc="left", pad=2.5)
    handles = [
        Patch(facecolor=YIELDED, label="yielded, filament"),
        *(Line2D([], [], label=f"(d) {theory}", **line) for theory, line in _OUTLINES.items()),  # type: ignore[arg-type]
    ]
    place = ((_LEFT + 3.0) / width, (_BOTTOM - 0.47) / height)
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=place, ncols=3, borderaxespad=0.0, fontsize=7.5)
    figure.text(_LEFT / width, (_BOTTOM - 0.9) / height, fill(text, 158), va="top", fontsize=7.2, parse_math=False)


def snapshot_files(filmed: Sequence[FilmedScene]) -> dict[str, bytes]:
    """Picture, data and facts of figure 4, by file name."""
    scenes = {each.of.name: each for each in filmed if each.of.name in SNAPSHOTS}
    last = scenes[SNAPSHOTS[-1]]
    outline = last.film.at(INSTANTS[-1]).outline
    corners = ((e, k, *map(float, outline[e, k])) for e in range(len(outline)) for k in range(8))
    return {
        **printed("figure4", snapshots_figure(filmed)),
        "figure4-elements.csv": table(
            ("panel", "t_tilde", "X_over_L", "Y_over_L", "x_over_L", "y_over_L", "plastic_shear_rate"),
            (row for panel in _panels(scenes) for row in _points(*panel)),
        ),
        "figure4-filament.csv": table(
            ("panel", "t_tilde", "X_over_L", "x_over_L", "y_over_L", "thickness_over_L", "core_low", "core_high"),
            (row for panel in _panels(scenes) for row in _cells(*panel)),
        ),
        "figure4-mesh.csv": table(("element", "corner", "x_over_L", "y_over_L"), corners),
        "figure4.json": facts({"caption": caption(scenes), "alpha": ALPHA, "snapshots": _facts(scenes)}),
    }


def _panels(scenes: Mapping[str, FilmedScene]) -> Iterator[tuple[str, float, FilmedScene]]:
    for letter, name in zip(_LETTERS, SNAPSHOTS, strict=True):
        for instant in INSTANTS[:-1]:
            yield letter, instant, scenes[name]
    yield "d", INSTANTS[-1], scenes[SNAPSHOTS[-1]]


def _points(letter: str, instant: float, of: FilmedScene) -> Iterator[tuple[object, ...]]:
    shot = of.film.at(instant)
    for reference, place, rate in zip(of.film.point.tolist(), shot.place.tolist(), shot.rate.tolist(), strict=True):
        yield letter, instant, *reference, *place, rate


def _cells(letter: str, instant: float, of: FilmedScene) -> Iterator[tuple[object, ...]]:
    strip = strip_at(of, instant)
    thickness = (strip.section.thickness[1:] + strip.section.thickness[:-1]) / 2
    columns = np.column_stack([strip.X, strip.place, thickness, strip.low, strip.high])
    for row in columns.tolist():
        yield letter, instant, *row


def _facts(scenes: Mapping[str, FilmedScene]) -> list[dict[str, Any]]:
    found = []
    for letter, instant, of in _panels(scenes):
        shot, strip = of.film.at(instant), strip_at(of, instant)
        flowing = float(np.mean(shot.rate > 0))
        found.append(
            {
                "panel": letter,
                "scene": of.of.name,
                "t_tilde": shot.time,
                "largest_rate": float(shot.rate.max()),
                "flowing_share_of_elements": flowing,
                "yielded_share_of_filament": strip.yielded_share,
                "sag_over_L": {"elements": _lowest(of, instant), "filament": -float(strip.section.y.min())},
            }
        )
    return found


def _lowest(of: FilmedScene, instant: float) -> float:
    return -float(np.interp(instant, *of.elements))
