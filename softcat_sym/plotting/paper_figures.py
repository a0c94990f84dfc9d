"""The paper's figures: pictures for screen and print, data and facts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import SubFigure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.drawing import Report
from softcat_sym.plotting import phase, style
from softcat_sym.plotting.compare import draw_strip
from softcat_sym.plotting.section import FilamentOutline, elastic_core, quads_outside, section_at
from softcat_sym.plotting.style import legend, styled
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

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.discretization.unknowns import Floats
    from softcat_sym.studies.phase import PhaseDiagram, PhaseSheet

DPI = 240
"""Of the PNG files: a figure as wide as a page is sharp in print."""


def _report(
    name: str, draw: Callable[[SubFigure], None], height: float, files: Mapping[str, Any], facts: Mapping[str, Any]
) -> Report:
    """A picture as wide as a page with its caption below as PNG and PDF, its data, and its facts as JSON."""
    caption = _CAPTIONS[name]
    with styled():
        figure, body = style.sheet("", height=height, notes=caption, width=9.6, columns=158)
        draw(body)
        png, pdf = BytesIO(), BytesIO()
        figure.savefig(png, format="png", dpi=DPI)
        # Without a date the same figure has the same bytes.
        figure.savefig(pdf, format="pdf", dpi=DPI, metadata={"CreationDate": None})
    pictures = {f"{name}.pdf": pdf.getvalue(), f"{name}.png": png.getvalue()}
    return Report({**pictures, **files, f"{name}.json": {"caption": caption, **facts}}, [caption])


_CAPTIONS = {
    "figure2": "Figure 2. Sag of the midpoint of a Maxwell filament, gravity switched on at once, B = 3.3e-5; times in "
    "sqrt(L/g). Vertical lines: t_low and t_high. The curves of (2.21) and (2.22) have three constants each, fitted to "
    "the full model over one and a half periods after t_high; (2.20) from rest starts at phi(0) = (6 B tau)^(1/3), the "
    "elastic string; as printed its constant is another. Above, delta = 0.0025: tension carries the filament, which "
    "falls freely, rings and follows the 1/3 law, as the text says. Below, delta = 0.025 as printed under the figure: "
    "bending rules until t* of about 10, and it does neither.",
    "figure3a": "Figure 3(a). Regimes by what each run shows, paper's physics, gravity switched on over t~ = 10, each "
    "filament watched until it has shown whether it stops; span, density and modulus are the paper's. Crosses: its "
    "parameter sets. Dots: runs. Arrested: in the last tenth of the run no fibre flows faster than sigma_Y/(2 eta). "
    "First yield: (3.11) is a beam's under a slow load; a sudden one at worst halves G. Arrest: (3.12) and "
    "the exact G = 1.3255 are a catenary's at rest; a filament has hinges at its clamps too, and falls past its rest "
    "with speed. Light tint: it flows within L/10 of the clamps alone. Grey: a neck at the clamp is drawn out, for "
    "which the published physics has no limit.",
    "figure3b": "Figure 3(b). Height of the midpoint, delta = 0.03, gravity switched on over t~ = 10. Top left: the "
    "paper's four parameter sets, finite elements (plane stress) wide and pale, the filament by the paper's physics "
    "thin. Other panels: the elements against the paper's physics in both closures and against what the program "
    "chooses. Dotted level: the stopping depth (3.13); sudden loading and creep carry the filament below it. With the "
    "paper's underdamped numbers (G = 0.4, V = 0.4) a neck is drawn out at the clamp: filaments are refused as "
    "localised and drawn as far as the frame. At G = 0.25 elements and filament ring about the same sag.",
    "figure4": "Figure 4. (a)-(c) Left half: finite elements (plane stress), grey by the plastic shear rate "
    "|Lp| L sqrt(rho/E) from 0 = white to 4.4e-4 = black; |Lp| is sqrt(3) times the equivalent tensile rate. Right "
    "half: the filament by the paper's physics, its centreline (dashed) and its faces, shaded where the stress linear "
    "in z exceeds the yield stress. alpha = 46. (a) Nothing flows. (b) Flow begins at the clamps and at midspan, "
    "spreads, and dies out. (c) All but a corner at the clamp flows. (d) Deformed mesh and filaments at t~ = 10 alpha "
    "= 460, continual descent.",
}


def _table(frames: Sequence[pd.DataFrame]) -> bytes:
    """Tables below each other as one CSV file, numbers to eight digits."""
    text: str = pd.concat(frames).to_csv(index=False, float_format="%.8g")
    return text.encode()


_MAXWELL_LINES: dict[str, dict[str, Any]] = {
    "full model": {"color": style.BLACK, "linewidth": 2.0},
    "reduced model (2.18)": {"color": style.SKY, "linewidth": 1.2, "linestyle": "--"},
    "free fall": {"color": style.GREEN, "linewidth": 1.2, "linestyle": ":"},
    "(2.20) from rest": {"color": style.BLUE, "linewidth": 1.2, "linestyle": "-."},
    "(2.20) as printed": {"color": style.BLUE, "linewidth": 0.8, "linestyle": ":"},
    "1/3 law": {"color": style.PURPLE, "linewidth": 1.2, "linestyle": ":"},
    "(2.21) integrated": {"color": style.ORANGE, "linewidth": 1.4},
    "(2.22)": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": "--"},
}


def maxwell_descent_report(panels: Sequence[Panel]) -> Report:
    """Picture, data and facts of figure 2: panels, two a row."""
    rows = (len(panels) + 1) // 2

    def draw(body: SubFigure) -> None:
        each = body.subplots(rows, 2, squeeze=False, sharex=True)
        for axes, panel in zip(each.flat, panels, strict=False):
            for curve in panel.curves:
                shown = (curve.sag > 0) & (curve.time > 0)
                axes.plot(curve.time[shown], curve.sag[shown], label=curve.name, **_MAXWELL_LINES[curve.name])
            highest = 2.2 * max(float(np.max(curve.sag)) for curve in panel.curves[:2])
            style.log_axes(axes, xlim=(0.02, 20), ylim=(1.5e-4, highest))
            for time, name, side in ((panel.t_low, "t_low ", "right"), (panel.t_high, " t_high", "left")):
                axes.axvline(time, color=style.GREY, linewidth=0.8)
                axes.text(time, 1.8e-4, name, ha=side, fontsize=7.5, color=style.GREY)
            axes.set_title(f"tau* = {panel.tau_star:g}, delta = {panel.delta:g}", fontsize=9)
            axes.set(xlabel="t* = t sqrt(g/L)", ylabel="sag / L")
            axes.grid(True)
            axes.label_outer()
        legend(body, of=each.flat[0], ncols=4)

    curves, facts = [], []
    for panel in panels:
        named = {"delta": panel.delta, "tau_star": panel.tau_star}
        for curve in panel.curves:
            columns = {"curve": curve.name, "time_star": curve.time, "sag_over_span": curve.sag}
            curves.append(pd.DataFrame(named | columns))
        share = {"tension_over_bending_at_t_high": panel.tension_over_bending, "outcomes": panel.outcomes}
        facts.append(named | {"t_low": panel.t_low, "t_high": panel.t_high} | share)
    return _report("figure2", draw, 3.7 * rows + 0.5, {"figure2.csv": pd.concat(curves)}, {"panels": facts})


_PHASE_LINES: dict[str, tuple[str, dict[str, Any]]] = {
    "paper": (
        "the paper: G = 2δ, G = √2",
        {"color": style.BLACK, "linewidth": 1.4, "linestyle": (0, (5, 2))},
    ),
    "exact": (
        "exact: sudden load (left), slow load with tension, catenary",
        {"color": style.BLUE, "linewidth": 1.3},
    ),
    "estimate": (
        "estimates: first yield with this ramp, spring-back of 5 %",
        {"color": style.PURPLE, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
    ),
}

# The paper's parameters in figure 3(b): G, V.
_PAPER = ((0.01, 26.0), (0.4, 26.0), (0.4, 0.4), (1.9, 26.0))


def phase_report(diagram: PhaseDiagram) -> Report:
    """Picture, data and facts of figure 3(a): the planes beside each other."""

    def draw(body: SubFigure) -> None:
        for axes, sheet in zip(body.subplots(1, len(diagram.sheets), squeeze=False).flat, diagram.sheets, strict=True):
            _draw_phases(axes, diagram, sheet)
        used = {phase.look_of(str(mark)) for sheet in diagram.sheets for mark in np.unique(sheet.lattice.labels)}
        patches = [
            Patch(facecolor=look.tint, edgecolor=style.GREY, linewidth=0.4, label=look.words)
            for look in dict.fromkeys([*phase.LOOKS.values(), *used])
            if look in used
        ]
        legend(body, handles=patches, ncols=len(patches), handlelength=2.0, fontsize=7.2)
        lines = [Line2D([], [], label=name, **line) for name, line in _PHASE_LINES.values()]
        legend(body, "upper left", handles=lines, ncols=len(lines), handlelength=2.0, fontsize=7.2)

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
    files = {
        "figure3a-runs.csv": _table([runs.fillna({"regime": "none"})]),
        "figure3a-lines.csv": _table([lines.replace(",", " with", regex=True)]),
    }
    return _report("figure3a", draw, 4.6, files, {"planes": planes})


def _draw_phases(axes: Axes, diagram: PhaseDiagram, sheet: PhaseSheet) -> None:
    groups, upwards = groups_of(diagram.scene), sheet.plane.y.key
    phase.draw_tints(axes, sheet)
    runs = np.array([(sheet.x[point.i], sheet.y[point.j]) for point in sheet.points])
    axes.plot(*runs.T, ".", color=style.BLACK, markersize=1.6, alpha=0.35, markeredgewidth=0)
    for line in sheet.lines:
        axes.plot(line.G, line.other, **_PHASE_LINES[line.source][1])
    for G, V in _PAPER:
        if upwards == "V" or np.isclose(V, groups.V or np.nan):
            other = V if upwards == "V" else groups.delta
            axes.plot(G, other, "x", color=style.BLACK, markersize=6, markeredgewidth=1.4, clip_on=False)
    phase.finish(axes, sheet)
    axes.set_title(f"δ = {groups.delta:.3g}" if upwards == "V" else f"V = {groups.V:.3g}", fontsize=9)


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


def midpoint_report(scenes: Sequence[FilmedScene]) -> Report:
    """Picture, data and facts of figure 3(b): the paper's axes with all scenes, then each scene by itself."""
    known = {filmed.of.name: scene_facts(filmed) for filmed in scenes}

    def draw(body: SubFigure) -> None:
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
        legend(body, of=panels[0, 1], ncols=4)

    curves = []
    for filmed in scenes:
        named = {"elements": filmed.elements, **{name: filmed.filament(name) for name in THEORIES}}
        for name, (time, height) in named.items():
            keys = {"scene": filmed.of.name, "curve": name.replace(",", " with")}
            curves.append(pd.DataFrame(keys | {"t_tilde": time, "midpoint_over_L": height}))
    files, facts = {"figure3b.csv": _table(curves)}, {"scenes": list(known.values())}
    return _report("figure3b", draw, 5.6, files, facts)


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
    note: dict[str, Any] = {"ha": "right", "fontsize": 7, "color": style.GREY}
    if stop is not None and filmed.of.name != "no-yield":
        axes.axhline(-stop, color=style.GREY, linewidth=1.0, linestyle=":")
        axes.text(455, -stop, "(3.13)", va="bottom", **note)
    if refused:
        which = "all filaments" if len(refused) == len(THEORIES) else "paper's physics"
        axes.text(0.98, 0.02, f"{which}: refused, localised", transform=axes.transAxes, **note)
    axes.set_title(f"{filmed.of.title}: {filmed.of.parameters}", fontsize=8.3)
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
    axes.yaxis.set_major_formatter("{x:.3g}")


BLACK_RATE = 4.4e-4
"""Plastic shear rate times L sqrt(rho/E) that the paper's scale shows as black; white is 0."""

YIELDED = style.VERMILLION


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


_ZOOM, _MARGIN = 2.6, 0.008
_SHARES = ("α/4", "α/2", "α", "2α")
_LETTERS = "abc"
_OUTLINES: dict[str, dict[str, Any]] = {
    PAPER: {"color": style.ORANGE, "linewidth": 1.3},
    OWN: {"color": style.BLUE, "linewidth": 1.0, "linestyle": (0, (4, 1.5))},
}


def _depth(filmed: FilmedScene, instants: Sequence[float]) -> tuple[float, float]:
    """How far the strips reach above and below the supports, over the span."""
    heights = np.concatenate([filmed.film.at(instant).outline[..., 1].ravel() for instant in instants])
    return float(heights.max()) + _MARGIN, _MARGIN - float(heights.min())


def _frame(axes: Axes, depth: tuple[float, float]) -> None:
    axes.set(xlim=(-0.515, 0.515), ylim=(-depth[1], depth[0]), aspect="equal", xticks=np.linspace(-0.5, 0.5, 5))
    axes.set_yticks([-step for step in (0.0, 0.05, 0.1, 0.15, 0.2, 0.25) if step < depth[1]])
    axes.tick_params(labelsize=7)


def _draw_instants(part: SubFigure, scenes: Mapping[str, FilmedScene], rows: Sequence[tuple[float, float]]) -> None:
    """Panels (a) to (c): elements on the left, the filament with its yielded zones on the right."""
    panels = part.subplots(len(rows), 2, height_ratios=[sum(depth) for depth in rows], sharex=True)
    for (row, column), axes in np.ndenumerate(panels):
        scene, number = scenes[SNAPSHOTS[row // 2]], 2 * (row % 2) + column
        shot, through = scene.film.at(INSTANTS[number]), scene.film.run.mesh.through
        # Mirrored: the half X >= 0 of the elements is drawn on the left.
        bar = draw_strip(axes, shot, through, (-1.0, 1.0), cmap="gray_r", norm=Normalize(0.0, BLACK_RATE))
        strip = strip_at(scene, INSTANTS[number])
        quads: dict[str, Any] = {"edgecolors": "none", "antialiaseds": False, "rasterized": True}
        axes.add_collection(PolyCollection(list(strip.yielded), facecolors=YIELDED, **quads), autolim=False)
        bottom, middle, top = (strip.side(zeta) for zeta in (-1.0, 0.0, 1.0))
        for line, dashes in ((bottom, "-"), (middle, (0, (6, 2))), (top, "-"), (np.stack([bottom[-1], top[-1]]), "-")):
            axes.plot(*line.T, color=style.BLACK, linewidth=0.5, linestyle=dashes)
        axes.axvline(0.0, color=style.GREY, linewidth=0.5, linestyle=":")
        _frame(axes, rows[row])
        name = f"({_LETTERS[row // 2]}) {scene.of.title}, " if number == 0 else ""
        axes.set_title(f"{name}t~ = {_SHARES[number]}", loc="left", fontsize=8.5, pad=2.5)
    for axes in panels[-1]:
        axes.set_xlabel("x / L", labelpad=1.0)
    colours = part.colorbar(bar, ax=panels, location="bottom", extend="max", aspect=60, fraction=0.03)
    colours.set_ticks([0, 1.1e-4, 2.2e-4, 3.3e-4, BLACK_RATE], labels=["0", "1.1e−4", "2.2e−4", "3.3e−4", "4.4e−4"])
    colours.ax.tick_params(labelsize=7)
    colours.set_label("|Lp| L √(ρ/E), elements", fontsize=7.5)


def _draw_last(part: SubFigure, filmed: FilmedScene, depth: tuple[float, float]) -> None:
    """Panel (d), both halves of the deformed mesh with the outlines of filaments, and its clamp enlarged."""
    axes, close = part.subplots(1, 2, width_ratios=[3, 1])
    mesh = filmed.film.at(INSTANTS[-1]).outline
    both = [*(mesh * np.array([-1.0, 1.0])), *mesh]
    for each in (axes, close):
        quads: dict[str, Any] = {"facecolors": "#f2f2f2", "edgecolors": "#5a5a5a", "linewidths": 0.3}
        each.add_collection(PolyCollection(both, **quads), autolim=False)
        for theory, line in _OUTLINES.items():
            section = strip_at(filmed, INSTANTS[-1], theory).section
            for zeta in (-1.0, 1.0):
                each.plot(*section.at(zeta).T, **line)
        each.set_xlabel("x / L", labelpad=1.0)
        _frame(each, depth)
    thickness = filmed.scene.filament.thickness / filmed.scene.filament.span
    close.set_xlim(0.5 + 0.25 * thickness - _ZOOM * thickness, 0.5 + 0.25 * thickness)
    close.set(ylim=(0.75 * thickness - 1.5 * _ZOOM * thickness, 0.75 * thickness), xticks=[0.45, 0.5])
    axes.set_title(f"(d) {filmed.of.title}, t~ = 10α = 460", loc="left", fontsize=8.5, pad=2.5)
    close.set_title("at the clamp", loc="left", fontsize=8.5, pad=2.5)
    outlines = [Line2D([], [], label=f"(d) {theory}", **line) for theory, line in _OUTLINES.items()]
    legend(part, handles=[Patch(facecolor=YIELDED, label="yielded, filament"), *outlines], ncols=3)


def snapshot_report(filmed: Sequence[FilmedScene]) -> Report:
    """Picture, data and facts of figure 4: (a)-(c), four instants each, and (d) with its clamp enlarged."""
    scenes = {each.of.name: each for each in filmed if each.of.name in SNAPSHOTS}
    last = scenes[SNAPSHOTS[-1]]
    depths = [_depth(scenes[name], INSTANTS[k : k + 2]) for name in SNAPSHOTS for k in (0, 2)]
    final = _depth(last, INSTANTS[-1:])
    # Panels are so wide that lengths are equal along both axes.
    tall = [4.3 * sum(map(sum, depths)) + 0.34 * len(depths) + 0.9, 6.2 * sum(final) + 1.0]

    def draw(body: SubFigure) -> None:
        parts: Any = body.subfigures(2, 1, height_ratios=tall)
        _draw_instants(parts[0], scenes, depths)
        _draw_last(parts[1], last, final)

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
    corners = pd.DataFrame({"element": element, "corner": corner, "x_over_L": x, "y_over_L": y})
    tables = {"elements": points, "filament": cells, "mesh": [corners]}
    files = {f"figure4-{name}.csv": _table(frames) for name, frames in tables.items()}
    facts_of = {"alpha": ALPHA, "snapshots": facts}
    return _report("figure4", draw, sum(tall) + 0.04, files, facts_of)
