"""A material from a rheometer's files: picture of the tests, table of the constants."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.fitting.flow_curve import FlowCurveFit
from softcat_sym.fitting.rheometer import RheometerConstant, RheometerMaterial, RheometerTest
from softcat_sym.plotting import style
from softcat_sym.plotting.style import log_axes, styled
from softcat_sym.plotting.units import Unit, significant, stress_unit, typeset

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

_AXES = {
    "strain": "strain amplitude",
    "angular_frequency": "angular frequency [rad/s]",
    "time": "time [s]",
}


@drawing.plot.register(RheometerMaterial)
@styled()
def material_figure(material: RheometerMaterial) -> Figure:
    """Draw each test with what was fitted to it, two a row."""
    rows, columns = -(-len(material.tests) // 2), min(len(material.tests), 2)
    below = "points: measured; lines: fitted; dashed: stresses or times that were read off"
    figure, body = style.sheet("Material from a rheometer", below, height=2.8 * rows)
    panels = body.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels[len(material.tests) :]:
        axes.remove()
    for axes, test in zip(panels, material.tests, strict=False):
        _draw_curve(axes, test) if isinstance(test, FlowCurveFit) else _draw_test(axes, test)
        axes.margins(x=0.04)
        axes.grid(True)
    return figure


def _draw_curve(axes: Axes, fit: FlowCurveFit) -> None:
    rate, unit = fit.curve.shear_rate, stress_unit(float(fit.curve.shear_stress.max()))
    dense = np.geomspace(rate.min(), rate.max(), 200)
    axes.plot(rate, unit.of(fit.curve.shear_stress), "o", color=style.BLACK, markersize=3.5)
    axes.plot(dense, unit.of(fit.best.stress(dense)), color=style.VERMILLION)
    log_axes(axes, xlabel="shear rate [s⁻¹]", ylabel=f"shear stress [{unit.symbol}]")
    axes.set_title(f"flow curve: {fit.best.law}", loc="left", fontsize=9)


_SHOWN = {"storage_modulus": ("G'", style.BLUE), "loss_modulus": ("G''", style.GREY), "viscosity": ("η", style.BLUE)}


def _draw_test(axes: Axes, test: RheometerTest) -> None:
    at, names = test.table[test.swept].to_numpy(), [name for name in _SHOWN if name in test.table]
    unit, quantity = stress_unit(float(test.table[names].max(axis=None))), "modulus"
    if names == ["viscosity"]:
        unit, quantity = Unit(f"{unit.symbol}·s", unit.size), "viscosity"
    for name in names:
        label, color = _SHOWN[name]
        axes.plot(at, unit.of(test.table[name]), "o", color=color, markersize=3.5, label=label)
    if test.curve is not None:
        dense = np.linspace(at[0], at[-1], 400) if test.kind == "recovery" else np.geomspace(at.min(), at.max(), 200)
        axes.plot(dense, unit.of(test.curve(dense)), color=style.VERMILLION)
    limit = test.found.get("strain_linear")
    if limit is not None:
        axes.axvline(limit.value, color=style.GREY, linestyle="--", linewidth=0.9)
    log_axes(axes, xlabel=_AXES[test.swept], ylabel=f"{quantity} [{unit.symbol}]")
    if test.kind == "recovery":
        axes.set_xscale("linear")
    axes.set_title(test.kind, loc="left", fontsize=9)
    if len(names) > 1:
        axes.legend(loc="best")


def _rows(constants: tuple[RheometerConstant, ...]) -> list[tuple[str, str, str, str]]:
    rows = []
    for one in constants:
        interval = one.estimate.interval
        span = "–" if interval is None else f"{significant(interval[0])} to {significant(interval[1])}"
        unit = f" {typeset(one.unit)}" if one.unit else ""
        rows.append((one.key.replace("_", " "), f"{significant(one.estimate.value)}{unit}", span, one.source))
    return rows


def material_table(material: RheometerMaterial) -> TextTable:
    """A row for each constant with its 95 % interval and source: those of the scene first, then what is told."""
    rows = [*_rows(material.constants), *_rows(material.told)]
    kinds = [""] * len(material.constants) + ["dim"] * len(material.told)
    headings, caption = ("constant, in shear", "value", "95 % interval", "from"), "dim: not in material.toml"
    return TextTable(headings, rows, kinds=kinds, title="Material", caption=caption, whole=[0, 1])


@drawing.report.register(RheometerMaterial)
def material_report(material: RheometerMaterial, scene: Scene | None = None) -> Report:
    """The constants, what is missing and warnings; with the scene that gets the material."""
    files = {
        "material.toml": material.to_toml(),
        "material.json": material.to_dict,
        "material.png": partial(material_figure, material),
        "scene.toml": None if scene is None else scene.to_toml,
    }
    return Report(files, [material_table(material), *material.text])
