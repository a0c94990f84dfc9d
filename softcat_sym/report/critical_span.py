"""The largest span that sags less than a limit: the scan that found it, in a picture and a table."""

from __future__ import annotations

import math
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.report import style
from softcat_sym.report.canvas import HEADING, axes_in_inches, new_figure
from softcat_sym.report.fit_panels import plain
from softcat_sym.report.units import length_unit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.inverse.design import CriticalSpan

_LEFT, _RIGHT, _TALL, _LINE = 0.85, 0.25, 2.9, 0.17


def critical_span_figure(found: CriticalSpan) -> Figure:
    """Draw sag over span as scanned, with the critical span; crosses at the top: the run has no answer."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    text = [fill(sentence, 112) for sentence in found.text]
    bottom = 0.6 + _LINE * sum(paragraph.count("\n") + 1 for paragraph in text)
    height = HEADING + _TALL + bottom
    spans, sags = np.array(found.scan).T
    finite = np.isfinite(sags) & (sags > 0)
    ruler, across = length_unit(found.sag), length_unit(found.span)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        left = 0.2 / style.WIDTH
        title = "Largest span that sags less than a limit"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        below = "spans that were scanned; ring: the critical span; crosses: the filament has no answer"
        figure.text(left, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        axes = axes_in_inches(figure, _LEFT, bottom, style.WIDTH - _LEFT - _RIGHT, _TALL)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.plot(across.of(spans[finite]), ruler.of(sags[finite]), ".-", color=style.BLUE, linewidth=1.0)
        if not finite.all():
            top = np.full(int((~finite).sum()), float(ruler.of(sags[finite].max())))
            axes.plot(across.of(spans[~finite]), top, "x", color=style.GREY, markersize=5)
        axes.plot(
            [found.span / across.size], [found.sag / ruler.size], "o", markersize=10, fillstyle="none",
            color=style.VERMILLION,
        )  # fmt: skip
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(numticks=8))
            axis.set_major_formatter(FuncFormatter(plain))
            axis.set_minor_formatter(NullFormatter())
        axes.margins(0.04)
        axes.grid(True)
        axes.set_xlabel(f"span [{across.symbol}]")
        axes.set_ylabel(f"largest sag [{ruler.symbol}]")
        style.lighten(axes)
        figure.text(left, 0.1 / height, "\n".join(text), va="bottom", fontsize=7.5, linespacing=1.4, parse_math=False)
    return figure


def critical_span_csv(found: CriticalSpan) -> bytes:
    """Tabulate the scan [m], the critical span among it; an empty sag is no answer."""
    rows = sorted([(span, sag, "scanned") for span, sag in found.scan] + [(found.span, found.sag, "critical")])
    lines = [f"{span!r},{'' if math.isinf(sag) else repr(sag)},{what}\n" for span, sag, what in rows]
    return "".join(["span_m,sag_m,what\n", *lines]).encode()


def critical_span_document(found: CriticalSpan) -> dict[str, Any]:
    """Everything of a critical span that a program may want, in SI; the gradient is of logarithms."""
    return {
        "span_m": found.span,
        "sag_m": found.sag,
        "gradient": dict(found.gradient),
        "crossings_m": [list(pair) for pair in found.crossings],
        "effects": list(found.effects),
        "notes": list(found.notes),
        "text": list(found.text),
    }
