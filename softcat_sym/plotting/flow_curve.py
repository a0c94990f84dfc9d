"""A fitted flow curve: picture, tables, JSON."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from softcat_sym.fitting.flow_curve import CRITERION, RATE, STRESS, Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.files import columns_csv, json_bytes, write_results
from softcat_sym.plotting.style import legend
from softcat_sym.plotting.units import significant

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.fitting.flow_curve import Candidate, FlowCurveFit
    from softcat_sym.fitting.identifiability import Estimate
    from softcat_sym.scene.scene import Scene

CONVERSION = "in tension: yield stress √3 τ_Y, consistency K = 3^((n+1)/2) k"

_LOOKS: dict[str, tuple[str, Any, str]] = {
    "bingham": (style.BLUE, (0, (5, 1.5)), "s"),
    "power-law": (style.GREEN, (0, (1.5, 1.2)), "^"),
    "herschel-bulkley": (style.VERMILLION, "-", "o"),
}


def flow_curve_figure(fit: FlowCurveFit) -> Figure:
    """Draw data and fitted laws on logarithmic axes, their relative residuals below."""
    curve = fit.curve
    title = curve.path.name if curve.path else "Flow curve"
    found = f"flow curve, {len(curve.shear_rate)} points · {fit.best.law} by AICc · rms relative residuals"
    with style.styled():
        figure, body = style.sheet(title, found, height=5.2)
        above, below = body.subplots(2, 1, height_ratios=[3.4, 1])
        _draw_stresses(above, fit)
        _draw_residuals(below, fit)
        for axes in (above, below):
            _log(axes, "x", curve.shear_rate)
            axes.grid(True)
            style.lighten(axes)
        above.tick_params(labelbottom=False)
        below.set_xlabel("shear rate [1/s]")
        legend(body, "upper left", handles=above.get_legend_handles_labels()[0], ncols=4, handlelength=1.9)
    return figure


def _draw_stresses(axes: Axes, fit: FlowCurveFit) -> None:
    rate, stress = fit.curve.shear_rate, fit.curve.shear_stress
    axes.plot(rate, stress, label="measured", color=style.BLACK, marker="o", markersize=4.5, linestyle="", alpha=0.6)
    dense = np.geomspace(rate.min(), rate.max(), 400)
    for one in fit.candidates:
        color, dashes, _ = _LOOKS[one.law]
        percent = 100 * one.relative_rms
        name = f"{one.law} ({significant(percent) if percent >= 0.01 else '< 0.01'} %)"
        wide = 2.0 if one is fit.best else 1.2
        axes.plot(dense, one.stress(dense), label=name, color=color, linestyle=dashes, linewidth=wide)
    _log(axes, "y", np.concatenate([stress, *(one.fitted for one in fit.candidates)]))
    axes.set_ylabel("shear stress [Pa]")


def _draw_residuals(axes: Axes, fit: FlowCurveFit) -> None:
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    order = np.argsort(fit.curve.shear_rate, kind="stable")
    for one in reversed(fit.candidates):
        color, _, marker = _LOOKS[one.law]
        rate, percent = fit.curve.shear_rate[order], 100 * one.residuals[order]
        axes.plot(rate, percent, color=color, linewidth=0.8, marker=marker, markersize=3.0)
    # Exact data leave rounding only, which is not worth a look.
    far = max(1.12 * max(float(np.abs(100 * one.residuals).max()) for one in fit.candidates), 1e-3)
    axes.set_ylim(-far, far)
    axes.yaxis.set_major_formatter("{x:.3g}")
    axes.set_ylabel("residual [%]")


def _log(axes: Axes, which: Literal["x", "y"], values: Floats) -> None:
    """Make an axis logarithmic, with a little room and ticks written as plain numbers."""
    from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, NullLocator, StrMethodFormatter

    low, high = float(np.log10(values.min())), float(np.log10(values.max()))
    room = max(0.04 * (high - low), 0.02)
    axes.set(**{f"{which}scale": "log"})
    axes.set(**{f"{which}lim": (10 ** (low - room), 10 ** (high + room))})
    axis = axes.xaxis if which == "x" else axes.yaxis
    if high - low < 0.7:
        # Powers of ten, or 1, 2 and 5 times them, would leave one tick or none.
        axis.set_major_locator(MaxNLocator(5))
        axis.set_minor_locator(NullLocator())
    else:
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if high - low < 2.5 else (1.0,), numticks=12))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def flow_curve_csv(fit: FlowCurveFit) -> bytes:
    """Tabulate measured and fitted stresses [Pa] and relative residuals, point by point in the order of the file."""
    columns = {RATE: fit.curve.shear_rate, STRESS: fit.curve.shear_stress}
    for one in fit.candidates:
        name = one.law.replace("-", "_")
        columns |= {f"{name}_Pa": one.fitted, f"{name}_relative_residual": one.residuals}
    return columns_csv(columns)


def flow_curve_document(fit: FlowCurveFit, law: str | None = None) -> dict[str, Any]:
    """Everything of a fit that a program may want, as JSON takes it."""
    curve = fit.curve
    return {
        "curve": str(curve.path) if curve.path else None,
        "points": len(curve.shear_rate),
        "shear_rate_1_s": [float(curve.shear_rate.min()), float(curve.shear_rate.max())],
        "best": fit.best.law,
        "handed_on": fit.candidate(law).law,
        "overrides": fit.candidate(law).overrides,
        "criterion": CRITERION,
        "conversion": CONVERSION,
        "candidates": {one.law: _candidate(one, fit) for one in fit.candidates},
        "warnings": list(fit.warnings),
    }


def _candidate(one: Candidate, fit: FlowCurveFit) -> dict[str, Any]:
    consistency = "shear_consistency" if one.n else "shear_viscosity"
    constants = {"shear_yield_stress": one.tau_Y, consistency: one.k, "index": one.n}
    return {
        "parameters": {name: _estimate(constant) for name, constant in constants.items() if constant is not None},
        "tensile": {
            "yield_stress": one.tensile.yield_stress,
            "viscosity": one.tensile.viscosity,
            "index": one.tensile.index,
        },
        "relative_rms": one.relative_rms,
        "aic": one.aic,
        # JSON knows no infinity: none where there are too few points.
        "aicc": one.aicc if math.isfinite(one.aicc) else None,
        "delta_aicc": one.aicc - fit.best.aicc if math.isfinite(one.aicc) else None,
        "overrides": one.overrides,
        "unfit": one.unfit,
    }


def _estimate(constant: Estimate) -> dict[str, Any]:
    return {
        "value": constant.value,
        "std": constant.standard_error,
        "ci95": list(constant.interval) if constant.interval else None,
        "verdict": constant.verdict,
    }


def flow_curve_table(fit: FlowCurveFit) -> Table:
    """Lay the candidates out side by side, the best first."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(fit.curve.path.name if fit.curve.path else "Flow curve", style="bold"),
        title_justify="left",
        caption=Text(f"± 95 %; rms of the relative residuals; least AICc first\n{CONVERSION}", style="dim"),
        caption_justify="left",
        box=box.SIMPLE_HEAD,
    )
    table.add_column(no_wrap=True, style="dim")
    for one in fit.candidates:
        best = one is fit.best
        table.add_column(Text(one.law, style="bold" if best else ""), justify="right", no_wrap=True)
    names = ("τ_Y [Pa]", "k [Pa sⁿ]", "n", "√3 τ_Y [Pa]", "K [Pa sⁿ]", "rms [%]")
    columns = [_column(one, fit) for one in fit.candidates]
    for name, *texts in zip((*names, "AICc", "AICc − least"), *columns, strict=True):
        table.add_row(Text(name), *(Text(text) for text in texts))
    return table


def _column(one: Candidate, fit: FlowCurveFit) -> tuple[str, ...]:
    tensile = one.tensile
    finite = math.isfinite(one.aicc)
    return (
        _with_interval(one.tau_Y),
        _with_interval(one.k),
        _with_interval(one.n) if one.n else "1",
        "–" if tensile.yield_stress is None else significant(tensile.yield_stress),
        significant(tensile.viscosity),
        significant(100 * one.relative_rms),
        f"{one.aicc:.1f}" if finite else "too few points",
        f"{one.aicc - fit.best.aicc:.1f}" if finite else "–",
    )


def _with_interval(constant: Estimate | None) -> str:
    if constant is None:
        return "–"
    if constant.half_width is None:
        return f"{significant(constant.value)} (bound)" if constant.verdict == "on a bound" else "–"
    return f"{significant(constant.value)} ± {constant.half_width:.2g}"


def print_flow_curve(fit: FlowCurveFit, console: Console | None = None) -> None:
    """Print the table and the warnings."""
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(flow_curve_table(fit))
    for text in fit.warnings:
        screen.print(Text(f"warning: {text}", style="yellow"))


def write_flow_curve(
    fit: FlowCurveFit, directory: str | Path, law: str | None = None, scene: Scene | None = None
) -> list[Path]:
    """Write ``flow_curve.json``, ``flow_curve.csv``, ``flow_curve.png`` and, of a scene, ``scene.toml``."""
    contents = {
        "flow_curve.json": json_bytes(flow_curve_document(fit, law), is_ascii=False),
        "flow_curve.csv": flow_curve_csv(fit),
        "flow_curve.png": flow_curve_figure(fit),
        "scene.toml": None if scene is None else scene.to_toml(),
    }
    return write_results(directory, contents)
