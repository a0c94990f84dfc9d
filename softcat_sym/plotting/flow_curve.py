"""A fitted flow curve: picture, tables, JSON."""

from __future__ import annotations

from functools import partial
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.fitting.flow_curve import CONVERSION, FITTED, FlowCurveFit
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, number_axis, styled
from softcat_sym.plotting.units import significant

if TYPE_CHECKING:
    from softcat_sym.fitting.identifiability import FittedConstant
    from softcat_sym.scene.scene import Scene

_LOOKS: tuple[tuple[str, Any, str], ...] = (
    (style.GREY, "-.", "v"),
    (style.BLUE, (0, (5, 1.5)), "s"),
    (style.GREEN, (0, (1.5, 1.2)), "^"),
    (style.VERMILLION, "-", "o"),
    (style.PURPLE, (0, (3, 1, 1, 1)), "D"),
)
"""Of the laws that are fitted, in their order."""


_FAR = 50.0
"""Residual beyond which a law is as good as none [%]."""


@drawing.plot.register(FlowCurveFit)
@styled()
def flow_curve_figure(fit: FlowCurveFit) -> Figure:
    """Draw data and fitted laws on logarithmic axes, their relative residuals below."""
    curve, rate = fit.curve, fit.curve.shear_rate
    title = curve.path.name if curve.path else "Flow curve"
    found = f"flow curve, {len(rate)} points · {fit.best.law} by the criterion · rms relative residuals"
    figure, body = style.sheet(title, found, height=5.2)
    above, below = body.subplots(2, 1, height_ratios=[3.4, 1], sharex=True)
    order, dense = np.argsort(rate, kind="stable"), np.geomspace(rate.min(), rate.max(), 400)
    measured: dict[str, Any] = {"color": style.BLACK, "marker": "o", "markersize": 4.5, "linestyle": ""}
    above.plot(rate, curve.shear_stress, label="measured", alpha=0.6, **measured)
    below.axhline(0.0, color=style.GREY, linewidth=0.8)
    looks = {law.name: look for law, look in zip(FITTED, cycle(_LOOKS), strict=False)}
    for one in fit.candidates:
        color, dashes, marker = looks[one.law]
        percent = 100 * one.relative_rms
        name = f"{one.law} ({significant(percent) if percent >= 0.01 else '< 0.01'} %)"
        wide = 2.0 if one is fit.best else 1.2
        above.plot(dense, one.stress(dense), label=name, color=color, linestyle=dashes, linewidth=wide)
        below.plot(rate[order], 100 * one.residuals[order], color=color, lw=0.8, marker=marker, markersize=3.0)
    # A law that does not fit leaves the picture; of exact data there is rounding only, which is not worth a look.
    number_axis(above, "y", curve.shear_stress.min(), curve.shear_stress.max(), is_log=True, ticks=8, room=0.15)
    largest = max(float(np.abs(100 * one.residuals).max()) for one in fit.candidates)
    far = max(1.12 * min(largest, _FAR), 1e-3)
    below.set(ylim=(-far, far), ylabel="residual [%]", xlabel="shear rate [s⁻¹]")
    below.yaxis.set_major_formatter("{x:.3g}")
    above.set_ylabel("shear stress [Pa]")
    number_axis(below, "x", rate.min(), rate.max(), is_log=True, ticks=8)
    above.grid(True)
    below.grid(True)
    legend(body, "upper left", of=above, ncols=4, handlelength=1.9)
    return figure


def flow_curve_table(fit: FlowCurveFit) -> TextTable:
    """A row for each candidate, the best first."""
    rows = [
        (
            one.law,
            _with_interval(one.tau_Y),
            _with_interval(one.k),
            _with_interval(one.n) if one.n else "1",
            "–" if one.tensile.yield_stress is None else significant(one.tensile.yield_stress),
            significant(one.tensile.viscosity),
            significant(100 * one.relative_rms),
            f"{one.criterion - fit.best.criterion:.1f}",
        )
        for one in fit.candidates
    ]
    header = ("law", "τ_Y [Pa]", "k [Pa·sⁿ]", "n", "√3 τ_Y [Pa]", "K [Pa·sⁿ]", "rms [%]", "above best")
    title = fit.curve.path.name if fit.curve.path else "Flow curve"
    caption = f"± 95 %; rms of the relative residuals; above best: of the criterion\n{CONVERSION}"
    return TextTable(header, rows, range(1, len(header)), title=title, caption=caption, whole=[0])


def _with_interval(constant: FittedConstant | None) -> str:
    if constant is None:
        return "–"
    if constant.half_width is None:
        return f"{significant(constant.value)} (bound)" if constant.verdict == "on a bound" else "–"
    return f"{significant(constant.value)} ± {constant.half_width:.2g}"


@drawing.report.register(FlowCurveFit)
def flow_curve_report(fit: FlowCurveFit, law: str | None = None, scene: Scene | None = None) -> Report:
    """The candidates and the warnings; with the scene that gets the fitted law."""
    files = {
        "flow_curve.json": partial(fit.to_dict, law),
        "flow_curve.csv": fit.to_frame,
        "flow_curve.png": partial(flow_curve_figure, fit),
        "scene.toml": None if scene is None else scene.to_toml,
    }
    return Report(files, [flow_curve_table(fit), *(Text(f"warning: {t}", style="yellow") for t in fit.warnings)])
