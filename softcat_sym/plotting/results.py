"""The pictures that a run has by itself: apart from :mod:`softcat_sym.plotting.run`, which draws without a solver."""

from __future__ import annotations

from matplotlib.figure import Figure

from softcat_sym import drawing
from softcat_sym.plotting.run import FIGURES, figures_with
from softcat_sym.results.run import Run


@drawing.plot.register(Run)
def _of_run(run: Run, what: str, radius: float) -> Figure:
    return drawing.drawn(figures_with(radius), what, run.fields, run.summary, run.scene)


@drawing.figures.register(Run)
def _all_of_run(run: Run) -> dict[str, Figure]:
    return {what: draw(run.fields, run.summary, run.scene) for what, draw in FIGURES.items()}
