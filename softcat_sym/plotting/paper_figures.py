"""The paper's figures: pictures for screen and print, data and facts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.drawing import Report
from softcat_sym.physics.beams import ARREST_THRESHOLD_EXACT
from softcat_sym.plotting import phase, style
from softcat_sym.plotting.compare import draw_strip
from softcat_sym.plotting.section import FilamentOutline, elastic_core, quads_outside, section_at
from softcat_sym.plotting.style import legend
from softcat_sym.reference.elements import Snapshot
from softcat_sym.scene.scene import elastic_time, groups_of
from softcat_sym.studies.paper_figures import (
    ALPHA,
    INSTANTS,
    MOMENTS,
    OWN,
    PAPER,
    PRINTED,
    SNAPSHOTS,
    THEORIES,
    FilmedScene,
    Panel,
    scene_facts,
)
from softcat_sym.studies.phase_runs import CLAMPS_ONLY

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.discretization.unknowns import Floats
    from softcat_sym.studies.phase import PhaseDiagram, PhaseSheet

DPI = 240
"""Of the PNG files: a figure as wide as a page is sharp in print."""


def printed(name: str, figure: Figure) -> dict[str, bytes]:
    """Draw a figure as PNG and PDF; the same figure gives the same bytes."""
    with style.styled():
        return style.printed(name, figure, DPI)


def table(frames: Sequence[pd.DataFrame]) -> bytes:
    """Write tables below each other as one CSV file, numbers to eight digits."""
    text: str = pd.concat(frames).to_csv(index=False, float_format="%.8g")
    return text.encode()


def _figure(height: float, caption: str) -> tuple[Figure, SubFigure]:
    """A figure as wide as a page with its caption below."""
    return style.sheet("", height=height, notes=caption, width=9.6, columns=158)


_MAXWELL_LINES: dict[str, Any] = {
    "full model": {"color": style.BLACK, "linewidth": 2.0},
    "reduced model (2.18)": {"color": style.SKY, "linewidth": 1.2, "linestyle": "--"},
    "free fall": {"color": style.GREEN, "linewidth": 1.2, "linestyle": ":"},
    "(2.20) from rest": {"color": style.BLUE, "linewidth": 1.2, "linestyle": "-."},
    "(2.20) as printed": {"color": style.BLUE, "linewidth": 0.8, "linestyle": ":"},
    "1/3 law": {"color": style.PURPLE, "linewidth": 1.2, "linestyle": ":"},
    "(2.21) integrated": {"color": style.ORANGE, "linewidth": 1.4},
    "(2.22)": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": "--"},
}

_MAXWELL_CAPTION = (
    "Figure 2. Sag of the midpoint of a Maxwell filament, gravity switched on at once, B = 3.3e-5; times in sqrt(L/g). "
    "Vertical lines: t_low and t_high. The curves of (2.21) and (2.22) carry three constants each, fitted to the full "
    "model over one and a half periods after t_high; (2.20) from rest starts at phi(0) = (6 B tau)^(1/3), the "
    "elastic string; as printed its constant is another, and the 1/3 law alone is nearer. "
    "Above, delta = 0.0025: at t_high tension carries {slender:.1f} times what bending does, and the filament falls "
    "freely, rings and follows the 1/3 law, as the text says. Below, delta = 0.025 as printed under the figure: "
    "tension carries only {thick:.2f} of what bending does at t_high, bending rules until t* of about 10, and neither "
    "the ringing of (2.22) nor the 1/3 law is what the filament does."
)


def maxwell_caption(panels: Sequence[Panel]) -> str:
    """The caption, with the share of tension at t_high measured for both slendernesses."""
    shares = {panel.delta: panel.tension_over_bending for panel in panels}
    return _MAXWELL_CAPTION.format(slender=shares[min(shares)], thick=shares[max(shares)])


def maxwell_descent_figure(panels: Sequence[Panel]) -> Figure:
    """Draw the panels, two a row, with the caption below."""
    rows = (len(panels) + 1) // 2
    with style.styled():
        figure, body = _figure(3.7 * rows + 0.5, maxwell_caption(panels))
        each = body.subplots(rows, 2, squeeze=False, sharex=True)
        for axes, panel in zip(each.flat, panels, strict=False):
            for curve in panel.curves:
                shown = (curve.sag > 0) & (curve.time > 0)
                look = _MAXWELL_LINES[curve.name]
                axes.loglog(curve.time[shown], curve.sag[shown], label=curve.name, **look)
            axes.set_xlim(0.02, 20)
            axes.set_ylim(1.5e-4, 2.2 * max(float(np.max(curve.sag)) for curve in panel.curves[:2]))
            for time, name, side in ((panel.t_low, "t_low ", "right"), (panel.t_high, " t_high", "left")):
                axes.axvline(time, color=style.GREY, linewidth=0.8)
                axes.text(time, 1.8e-4, name, ha=side, fontsize=7.5, color=style.GREY)
            axes.set_title(f"tau* = {panel.tau_star:g}, delta = {panel.delta:g}", fontsize=9)
            axes.grid(True)
            for axis in (axes.xaxis, axes.yaxis):
                style.plain_log(axis)
        for axes in each[-1]:
            axes.set_xlabel("t* = t sqrt(g/L)")
        for axes in each[:, 0]:
            axes.set_ylabel("sag / L")
        legend(body, handles=each.flat[0].get_legend_handles_labels()[0], ncols=4)
    return figure


def maxwell_descent_report(panels: Sequence[Panel]) -> Report:
    """Picture, data and facts of figure 2."""
    curves, facts = [], []
    for panel in panels:
        named = {"delta": panel.delta, "tau_star": panel.tau_star}
        for curve in panel.curves:
            columns = {"curve": curve.name, "time_star": curve.time, "sag_over_span": curve.sag}
            curves.append(pd.DataFrame(named | columns))
        share = {"tension_over_bending_at_t_high": panel.tension_over_bending, "outcomes": panel.outcomes}
        facts.append(named | {"t_low": panel.t_low, "t_high": panel.t_high} | share)
    caption = maxwell_caption(panels)
    files = {"figure2.csv": pd.concat(curves), "figure2.json": {"caption": caption, "panels": facts}}
    return Report({**printed("figure2", maxwell_descent_figure(panels)), **files}, [caption])


_PHASE_LINES: dict[str, dict[str, Any]] = {
    "paper": {"color": style.BLACK, "linewidth": 1.4, "linestyle": (0, (5, 2))},
    "exact": {"color": style.BLUE, "linewidth": 1.3},
    "estimate": {"color": style.PURPLE, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}
_NAMES = {
    "paper": "the paper: G = 2δ, G = √2",
    "exact": "exact: sudden load (left), slow load with tension, catenary",
    "estimate": "estimates: first yield with this ramp, spring-back of 5 %",
}

# The paper's parameters in figure 3(b): G, V.
_PAPER = ((0.01, 26.0), (0.4, 26.0), (0.4, 0.4), (1.9, 26.0))

_PHASE_CAPTION = (
    "Figure 3(a). Regimes by what each run shows, paper's physics, gravity switched on over t~ = 10, each filament "
    "watched until it has shown whether it stops. Left: V = {V:.3g}; right: delta = {delta:.3g}; span, density and "
    "modulus are the paper's. Crosses: its parameter sets. Dots: {runs} runs, {nodes} lattice nodes; {saved} of them "
    "needed no run. Arrested: in the last tenth of the run no fibre flows faster than sigma_Y/(2 eta). "
    "First yield: (3.11) is a beam's under a slow load. The load that is suddenly there swings the beam to twice that "
    "sag, which at worst halves G; with this ramp the runs yield at {yields:.2f} of 2 delta in the median. The most "
    "slender are carried by their tension, which (3.11) leaves out, and yield later. "
    "Arrest: (3.12) and the exact G = 1.3255 are a catenary's at rest. A filament has hinges at its clamps too, and "
    "falls past its rest with speed: some fibre flows on from {descends:.2f} of sqrt 2 in the median. In the light "
    "tint that is so within L/10 of the clamps alone; the rest of it flows at {below:.2f} sigma_Y/eta in the median "
    "where G < 1.3255, at {above:.2f} where it is larger (left). "
    "Right: with less viscosity the overshoot is deeper, and a neck at the clamp is drawn out for which the published "
    "physics has no limit (grey); the paper's underdamped set is there."
)


def phase_caption(diagram: PhaseDiagram) -> str:
    """The caption, every number from the runs."""
    groups, first = groups_of(diagram.scene), diagram.sheets[0]
    clamps = [point.run for point in first.points if point.run.mark == CLAMPS_ONLY]
    below = [run.span_rate for run in clamps if run.place.G < ARREST_THRESHOLD_EXACT]
    above = [run.span_rate for run in clamps if run.place.G >= ARREST_THRESHOLD_EXACT]
    return _PHASE_CAPTION.format(
        V=groups.V,
        delta=groups.delta,
        runs=sum(sheet.runs for sheet in diagram.sheets),
        saved=sum(sheet.lattice.saved for sheet in diagram.sheets),
        nodes=sum(sheet.nodes for sheet in diagram.sheets),
        yields=1 + _median(first, "first yield"),
        descends=1 + _median(first, "arrest"),
        below=np.median(below) if below else np.nan,
        above=np.median(above) if above else np.nan,
    )


def _median(sheet: PhaseSheet, kind: str) -> float:
    """Median distance of a simulated boundary from the paper's line, as a share of it."""
    medians = (each.median for each in sheet.distances if each.kind == kind and each.line.source == "paper")
    return next(medians, float("nan"))


def phase_figure(diagram: PhaseDiagram) -> Figure:
    """Draw the planes beside each other."""
    with style.styled():
        figure, body = _figure(4.6, phase_caption(diagram))
        for axes, sheet in zip(body.subplots(1, len(diagram.sheets), squeeze=False).flat, diagram.sheets, strict=True):
            _draw_phases(axes, diagram, sheet)
        used = {phase.look_of(str(mark)) for sheet in diagram.sheets for mark in np.unique(sheet.lattice.labels)}
        patches = [
            Patch(facecolor=look.tint, edgecolor=style.GREY, linewidth=0.4, label=look.words)
            for look in dict.fromkeys([*phase.LOOKS.values(), *used])
            if look in used
        ]
        lines = [Line2D([], [], label=_NAMES[source], **line) for source, line in _PHASE_LINES.items()]
        legend(body, handles=patches, ncols=len(patches), handlelength=2.0, fontsize=7.2)
        legend(body, "upper left", handles=lines, ncols=len(lines), handlelength=2.0, fontsize=7.2)
    return figure


def _draw_phases(axes: Axes, diagram: PhaseDiagram, sheet: PhaseSheet) -> None:
    groups, upwards = groups_of(diagram.scene), sheet.plane.y.key
    phase.draw_tints(axes, sheet)
    runs = np.array([(sheet.x[point.i], sheet.y[point.j]) for point in sheet.points])
    axes.plot(*runs.T, ".", color=style.BLACK, markersize=1.6, alpha=0.35, markeredgewidth=0)
    for line in sheet.lines:
        axes.plot(line.G, line.other, **_PHASE_LINES[line.source])
    for G, V in _PAPER:
        if upwards == "V" or np.isclose(V, groups.V or np.nan):
            other = V if upwards == "V" else groups.delta
            axes.plot(G, other, "x", color=style.BLACK, markersize=6, markeredgewidth=1.4, clip_on=False)
    phase.finish(axes, sheet)
    axes.set_title(f"δ = {groups.delta:.3g}" if upwards == "V" else f"V = {groups.V:.3g}", fontsize=9)


def phase_report(diagram: PhaseDiagram) -> Report:
    """Picture, data and facts of figure 3(a)."""
    names = {"sag_over_span": "sag_over_L", "rate": "largest_rate_over_sY_by_eta"}
    runs = diagram.to_frame()[["plane", "G", "V", "delta", "regime", "outcome", *names]].rename(columns=names)
    lines = diagram.lines().drop(columns=["boundary", "other"]).rename(columns={"other_value": "other"})
    planes = [
        {
            **{"plane": sheet.plane.name, "runs": sheet.runs, "lattice_nodes": sheet.nodes},
            **{"nodes_never_run": sheet.lattice.saved, "regimes": sheet.counts},
            "boundary_over_formula": [
                each.to_dict() | {name: 1 + getattr(each, name) for name in ("median", "least", "most")}
                for each in sheet.distances
            ],
        }
        for sheet in diagram.sheets
    ]
    caption = phase_caption(diagram)
    files = {
        "figure3a-runs.csv": table([runs.fillna({"regime": "none"})]),
        "figure3a-lines.csv": table([lines.replace(",", " with", regex=True)]),
        "figure3a.json": {"caption": caption, "planes": planes},
    }
    return Report({**printed("figure3a", phase_figure(diagram)), **files}, [caption])


_ELEMENTS: dict[str, Any] = {"color": style.BLACK, "linewidth": 3.2, "alpha": 0.35, "solid_capstyle": "butt"}
_MIDPOINTS_LINES: dict[str, dict[str, Any]] = {
    PAPER: {"color": style.ORANGE, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    PRINTED: {"color": style.VERMILLION, "linewidth": 1.1, "linestyle": (0, (1.5, 1.2))},
    OWN: {"color": style.BLUE, "linewidth": 1.0},
}
_COLOURS = (style.BLUE, style.GREEN, style.PURPLE, style.VERMILLION, style.ORANGE)

# The panel with all scenes has the paper's own parameters; ours of the underdamped arrest has a panel to itself.
_LEFT_OUT, _MIDPOINTS_EDGE = "arrested-underdamped", "edge-of-rupture"

# Whose curves stay within a few per cent of one level: there is nothing to see above it.
_LEVEL, _SHOWN = "arrested-overdamped", 0.72

_MIDPOINTS_CAPTION = (
    "Figure 3(b). Height of the midpoint, delta = 0.03, gravity switched on over t~ = 10. Top left: the paper's four "
    "parameter sets, finite elements ({along} x {through} over the half span, plane stress) wide and pale, the "
    "filament by the paper's physics thin. Other panels: the elements against the paper's physics in both closures and "
    "against what the program chooses. G and V are the paper's; with its E, rho and L the yield strains are {strains} "
    "where the paper rounds to 0.07, 0.002, 0.0005. At t~ = 460 the paper's physics misses the elements by "
    "{over[0]:+.1f}\u00a0% (overdamped) and {descent[0]:+.1f}\u00a0% (descent), the program's choice by "
    "{over[1]:+.1f}\u00a0% and {descent[1]:+.1f}\u00a0%. Dotted level: the stopping depth (3.13). Sudden loading and "
    "creep carry the filament below it: the overdamped one to {deep:.4f} L, {beyond:.0f}\u00a0% past. With the "
    "paper's underdamped numbers (G = 0.4, V = 0.4) a neck is drawn out at the clamp: elements still stop on this "
    "mesh, at {edge:.3f} L, "
    "a little deeper on each finer one; filaments are refused as localised and drawn as far as the frame. At "
    "G = 0.25 the elements and the program's filament ring about the same sag, {ring[0]:.4f} and {ring[1]:.4f} L in "
    "the mean."
)


def midpoints_caption(facts_of: Mapping[str, Mapping[str, Any]]) -> str:
    """The caption, every number from the runs."""
    over, descent, ring = (facts_of[name] for name in ("arrested-overdamped", "continual-descent", _LEFT_OUT))
    last = f"{MOMENTS[-1]:g}"
    deep = -over["midpoint_over_L"]["elements"][last]
    strains = ", ".join(
        f"{facts_of[name]['eps_Y']:.2g}" for name in ("no-yield", "arrested-overdamped", "continual-descent")
    )
    return _MIDPOINTS_CAPTION.format(
        along=over["mesh"][0],
        through=over["mesh"][1],
        strains=strains,
        over=_misses(over, last),
        descent=_misses(descent, last),
        deep=deep,
        beyond=100 * (deep / over["stopping_depth_over_L"]["paper"] - 1),
        edge=-facts_of[_MIDPOINTS_EDGE]["midpoint_over_L"]["elements"][last],
        ring=[-(ring["midpoint_over_L"][name]["mean"] or np.nan) for name in ("elements", OWN)],
    )


def _misses(facts: Mapping[str, Any], moment: str) -> list[float]:
    """Per cent by which the filaments sag more than the elements: the paper's physics, the program's choice."""
    heights = facts["midpoint_over_L"]
    return [100 * ((heights[name][moment] or np.nan) / heights["elements"][moment] - 1) for name in (PAPER, OWN)]


def midpoints_figure(scenes: Sequence[FilmedScene]) -> Figure:
    """Draw the paper's axes with all scenes, then each scene by itself."""
    known = {filmed.of.name: scene_facts(filmed) for filmed in scenes}
    with style.styled():
        figure, body = _figure(5.6, midpoints_caption(known))
        panels = body.subplots(2, 3, sharex=True)
        _draw_together(panels[0, 0], scenes)
        for axes, filmed in zip(panels.flat[1:], scenes, strict=True):
            _draw_alone(axes, filmed, known[filmed.of.name]["stopping_depth_over_L"]["paper"])
        for axes in panels.flat:
            axes.set_xlim(0, MOMENTS[-1])
            axes.grid(True)
        for axes in panels[-1]:
            axes.set_xlabel("t~ = (t/L) √(E/ρ)")
        for axes in panels[:, 0]:
            axes.set_ylabel("y / L of the midpoint")
        legend(body, handles=panels[0, 1].get_legend_handles_labels()[0], ncols=4)
    return figure


def _draw_together(axes: Axes, scenes: Sequence[FilmedScene]) -> None:
    chosen = [filmed for filmed in scenes if filmed.of.name != _LEFT_OUT]
    for filmed, colour in zip(chosen, _COLOURS, strict=False):
        title = "arrested, underdamped" if filmed.of.name == _MIDPOINTS_EDGE else filmed.of.title
        axes.plot(*filmed.elements, color=colour, linewidth=2.6, alpha=0.4, label=title)
        if filmed.filaments[PAPER].outcome.is_success:
            axes.plot(*filmed.filament(PAPER), color=colour, linewidth=0.9)
    axes.set_ylim(-0.27, 0.005)
    axes.set_title("the paper's parameters", fontsize=9)
    axes.legend(fontsize=6.8, loc="lower left")


def _draw_alone(axes: Axes, filmed: FilmedScene, stop: float | None) -> None:
    time, height = filmed.elements
    deepest = float(-height.min())
    axes.plot(time, height, label="elements", **_ELEMENTS)
    for name in THEORIES:
        axes.plot(*filmed.filament(name), label=name, **_MIDPOINTS_LINES[name])
    refused = [name for name in THEORIES if not filmed.filaments[name].outcome.is_success]
    top = -_SHOWN * deepest if filmed.of.name == _LEVEL else 0.03 * deepest
    axes.set_ylim(-(1.45 if refused else 1.05) * deepest, top)
    if stop is not None and filmed.of.name != "no-yield":
        axes.axhline(-stop, color=style.GREY, linewidth=1.0, linestyle=":")
        axes.text(455, -stop, "(3.13)", ha="right", va="bottom", fontsize=7, color=style.GREY)
    if refused:
        which = "all filaments" if len(refused) == len(THEORIES) else "paper's physics"
        label = f"{which}: refused, localised"
        axes.text(0.98, 0.02, label, fontsize=7, ha="right", color=style.GREY, transform=axes.transAxes)
    axes.set_title(f"{filmed.of.title}: {filmed.of.parameters}", fontsize=8.3)
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
    axes.yaxis.set_major_formatter("{x:.3g}")


def midpoint_report(scenes: Sequence[FilmedScene]) -> Report:
    """Picture, data and facts of figure 3(b)."""
    known = {filmed.of.name: scene_facts(filmed) for filmed in scenes}
    curves = []
    for filmed in scenes:
        named = {"elements": filmed.elements, **{name: filmed.filament(name) for name in THEORIES}}
        for name, (time, height) in named.items():
            keys = {"scene": filmed.of.name, "curve": name.replace(",", " with")}
            curves.append(pd.DataFrame(keys | {"t_tilde": time, "midpoint_over_L": height}))
    caption = midpoints_caption(known)
    files = {"figure3b.csv": table(curves), "figure3b.json": {"caption": caption, "scenes": list(known.values())}}
    return Report({**printed("figure3b", midpoints_figure(scenes)), **files}, [caption])


BLACK_RATE = 4.4e-4
"""Plastic shear rate times L sqrt(rho/E) that the paper's scale shows as black; white is 0."""

YIELDED = style.VERMILLION
_MIRROR = (-1.0, 1.0)
"""Factors that draw the half X >= 0 of the elements on the left."""

_STRIPS_EDGE = 0.5


@dataclass(frozen=True)
class Strip:
    """A filament at one instant, whole span; lengths over the span."""

    section: FilamentOutline  # Centreline, normals, thickness on the nodes
    # shape (cells,); Limits in zeta of the part that does not yield, by the stress sigma_0 + sigma_1 zeta of (2.24).
    low: Floats
    high: Floats
    X: Floats  # shape (cells,); Material coordinate and place of the middle of each cell
    place: Floats

    @property
    def yielded_share(self) -> float:
        """Part of the side view that yields, cells weighted by their length."""
        length = np.hypot(np.diff(self.section.x), np.diff(self.section.y))
        return float(np.average(1 - (self.high - self.low) / 2, weights=length))

    def side(self, zeta: float) -> Floats:
        """Right half of a face, or of the centreline; shape (points, 2)."""
        return np.asarray(self.section.at(zeta)[self.section.x >= -1e-12])

    @property
    def yielded(self) -> Floats:
        """Quads of the yielded zones of the right half; shape (quads, 4, 2)."""
        quads = quads_outside(self.section, self.low, self.high)
        return np.asarray(quads[quads[:, :, 0].mean(axis=1) > 0])


def strip_at(filmed: FilmedScene, instant: float, theory: str = PAPER) -> Strip:
    """The filament of one theory at the frame nearest to t~."""
    data, span = filmed.filaments[theory].data, filmed.scene.filament.span
    frame = int(np.abs(data["time"].values / elastic_time(filmed.scene) - instant).argmin())
    section = _section_of(data, frame)
    scaled = FilamentOutline(section.x / span, section.y / span, section.normal, section.thickness / span)
    mean, bending = data["stress_mean"].values[frame], data["stress_bending"].values[frame]
    low, high = elastic_core(mean, bending, filmed.scene.material.yield_stress or np.inf)
    middle = np.column_stack([(c[1:] + c[:-1]) / 2 for c in (scaled.x, scaled.y)])
    return Strip(scaled, low, high, data["X_cell"].values / span, middle)


def _section_of(data: xr.Dataset, frame: int) -> FilamentOutline:
    """Sections turn by psi = theta - atan(Gam/Lam): normal to the centreline only where nothing shears."""
    section = section_at(data, frame, (True, True))
    shear = data["shear"].values[frame] if "shear" in data else np.zeros(data.sizes["cell"])
    if not shear.any():
        return section
    turned = np.arctan2(np.diff(section.y), np.diff(section.x)) - np.arctan(shear)
    nodes, cells = data["X_node"].values, data["X_cell"].values
    angle = np.interp(nodes, [nodes[0], *cells, nodes[-1]], [0.0, *turned, 0.0])
    return replace(section, normal=np.column_stack([-np.sin(angle), np.cos(angle)]))


def draw_filament(axes: Axes, strip: Strip) -> None:
    """Draw the filament as the right half: centreline, faces, and its yielded zones."""
    zones = PolyCollection(
        list(strip.yielded), facecolors=YIELDED, edgecolors="none", antialiaseds=False, rasterized=True
    )
    axes.add_collection(zones, autolim=False)
    for zeta, line in ((-1.0, "-"), (0.0, (0, (6, 2))), (1.0, "-")):
        axes.plot(*strip.side(zeta).T, color=style.BLACK, linewidth=_STRIPS_EDGE, linestyle=line)
    bottom, top = strip.side(-1.0)[-1], strip.side(1.0)[-1]
    axes.plot([bottom[0], top[0]], [bottom[1], top[1]], color=style.BLACK, linewidth=_STRIPS_EDGE)


def draw_mesh(axes: Axes, shot: Snapshot) -> None:
    """Draw both halves of the deformed mesh."""
    for side in (-1.0, 1.0):
        mesh = PolyCollection(
            list(np.array([side, 1.0]) * shot.outline), facecolors="#f2f2f2", edgecolors="#5a5a5a", linewidths=0.3
        )
        axes.add_collection(mesh, autolim=False)


_ZOOM = 2.6
_MARGIN = 0.008
_SHARES = ("α/4", "α/2", "α", "2α")
_LETTERS = "abc"
_OUTLINES: dict[str, dict[str, Any]] = {
    PAPER: {"color": style.ORANGE, "linewidth": 1.3},
    OWN: {"color": style.BLUE, "linewidth": 1.0, "linestyle": (0, (4, 1.5))},
}

_SNAPSHOTS_CAPTION = (
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


def snapshots_caption(scenes: Mapping[str, FilmedScene]) -> str:
    """The caption, every number from the runs."""
    last = scenes[SNAPSHOTS[-1]]
    arrest = scenes[SNAPSHOTS[1]].film
    rate = last.film.at(ALPHA).rate
    return _SNAPSHOTS_CAPTION.format(
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
    depths = [_depth(scenes[name], INSTANTS[k : k + 2]) for name in SNAPSHOTS for k in (0, 2)]
    final = _depth(scenes[SNAPSHOTS[-1]], INSTANTS[-1:])
    # Panels are so wide that lengths are equal along both axes.
    rows, last = [4.3 * sum(depth) for depth in depths], 6.2 * sum(final)
    with style.styled():
        height = sum(rows) + last + 0.34 * (len(rows) + 1) + 1.6
        figure, body = _figure(height, snapshots_caption(scenes))
        parts: Any = body.subfigures(2, 1, height_ratios=[sum(rows) + 0.34 * len(rows) + 0.9, last + 1.0])
        upper, lower = parts
        panels = upper.subplots(len(rows), 2, height_ratios=rows, sharex=True)
        for (row, column), axes in np.ndenumerate(panels):
            scene, instant = scenes[SNAPSHOTS[row // 2]], 2 * (row % 2) + column
            shot, through = scene.film.at(INSTANTS[instant]), scene.film.run.mesh.through
            bar = draw_strip(axes, shot, through, _MIRROR, cmap="gray_r", norm=Normalize(0.0, BLACK_RATE))
            draw_filament(axes, strip_at(scene, INSTANTS[instant]))
            axes.axvline(0.0, color=style.GREY, linewidth=0.5, linestyle=":")
            _frame(axes, depths[row])
            name = f"({_LETTERS[row // 2]}) {scene.of.title}, " if instant == 0 else ""
            axes.set_title(f"{name}t~ = {_SHARES[instant]}", loc="left", fontsize=8.5, pad=2.5)
        for axes in panels[-1]:
            axes.set_xlabel("x / L", labelpad=1.0)
        colours = upper.colorbar(bar, ax=panels, location="bottom", extend="max", aspect=60, fraction=0.03)
        colours.set_ticks([0, 1.1e-4, 2.2e-4, 3.3e-4, BLACK_RATE], labels=["0", "1.1e−4", "2.2e−4", "3.3e−4", "4.4e−4"])
        colours.ax.tick_params(labelsize=7)
        colours.set_label("|Lp| L √(ρ/E), elements", fontsize=7.5)
        _draw_last(lower, scenes[SNAPSHOTS[-1]], final)
    return figure


def _depth(filmed: FilmedScene, instants: Sequence[float]) -> tuple[float, float]:
    """How far the strips reach above and below the supports, over the span."""
    heights = np.concatenate([filmed.film.at(instant).outline[..., 1].ravel() for instant in instants])
    return float(heights.max()) + _MARGIN, _MARGIN - float(heights.min())


def _frame(axes: Axes, depth: tuple[float, float]) -> None:
    axes.set_xlim(-0.515, 0.515)
    axes.set_ylim(-depth[1], depth[0])
    axes.set_aspect("equal")
    axes.set_yticks([-step for step in (0.0, 0.05, 0.1, 0.15, 0.2, 0.25) if step < depth[1]])
    axes.set_xticks([-0.5, -0.25, 0.0, 0.25, 0.5])
    axes.tick_params(labelsize=7)


def _draw_last(part: SubFigure, filmed: FilmedScene, depth: tuple[float, float]) -> None:
    """Panel (d), and its clamp enlarged."""
    axes, close = part.subplots(1, 2, width_ratios=[3, 1])
    shot = filmed.film.at(INSTANTS[-1])
    for each in (axes, close):
        draw_mesh(each, shot)
        for theory, line in _OUTLINES.items():
            section = strip_at(filmed, INSTANTS[-1], theory).section
            for zeta in (-1.0, 1.0):
                each.plot(*section.at(zeta).T, **line)
        each.set_xlabel("x / L", labelpad=1.0)
        _frame(each, depth)
    thickness = filmed.scene.filament.thickness / filmed.scene.filament.span
    close.set_xlim(0.5 + 0.25 * thickness - _ZOOM * thickness, 0.5 + 0.25 * thickness)
    close.set_ylim(0.75 * thickness - 1.5 * _ZOOM * thickness, 0.75 * thickness)
    close.set_xticks([0.45, 0.5])
    axes.set_title(f"(d) {filmed.of.title}, t~ = 10α = 460", loc="left", fontsize=8.5, pad=2.5)
    close.set_title("at the clamp", loc="left", fontsize=8.5, pad=2.5)
    handles = [
        Patch(facecolor=YIELDED, label="yielded, filament"),
        *(Line2D([], [], label=f"(d) {theory}", **line) for theory, line in _OUTLINES.items()),
    ]
    legend(part, handles=handles, ncols=3)


def snapshot_report(filmed: Sequence[FilmedScene]) -> Report:
    """Picture, data and facts of figure 4."""
    scenes = {each.of.name: each for each in filmed if each.of.name in SNAPSHOTS}
    last = scenes[SNAPSHOTS[-1]]
    points, cells, facts = [], [], []
    panels = [
        (letter, t, scenes[name]) for letter, name in zip(_LETTERS, SNAPSHOTS, strict=True) for t in INSTANTS[:-1]
    ]
    for letter, instant, scene in (*panels, ("d", INSTANTS[-1], last)):
        shot, strip = scene.film.at(instant), strip_at(scene, instant)
        named = {"panel": letter, "t_tilde": instant}
        (X, Y), (x, y) = scene.film.point.T, shot.place.T
        columns = {"X_over_L": X, "Y_over_L": Y, "x_over_L": x, "y_over_L": y, "plastic_shear_rate": shot.rate}
        points.append(pd.DataFrame(named | columns))
        thickness = (strip.section.thickness[1:] + strip.section.thickness[:-1]) / 2
        x, y = strip.place.T
        columns = {"X_over_L": strip.X, "x_over_L": x, "y_over_L": y, "thickness_over_L": thickness}
        cells.append(pd.DataFrame(named | columns | {"core_low": strip.low, "core_high": strip.high}))
        sags = {"elements": -float(np.interp(instant, *scene.elements)), "filament": -float(strip.section.y.min())}
        shares = {"flowing_share_of_elements": float(np.mean(shot.rate > 0))}
        shares |= {"yielded_share_of_filament": strip.yielded_share}
        place = {"panel": letter, "scene": scene.of.name, "t_tilde": shot.time, "largest_rate": float(shot.rate.max())}
        facts.append(place | shares | {"sag_over_L": sags})
    outline = last.film.at(INSTANTS[-1]).outline
    element, corner = np.indices(outline.shape[:2]).reshape(2, -1)
    x, y = outline.reshape(-1, 2).T
    corners = [pd.DataFrame({"element": element, "corner": corner, "x_over_L": x, "y_over_L": y})]
    caption = snapshots_caption(scenes)
    files = {
        "figure4-elements.csv": table(points),
        "figure4-filament.csv": table(cells),
        "figure4-mesh.csv": table(corners),
        "figure4.json": {"caption": caption, "alpha": ALPHA, "snapshots": facts},
    }
    return Report({**printed("figure4", snapshots_figure(filmed)), **files}, [caption])
