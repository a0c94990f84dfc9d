"""All files of one comparison."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.compare_clamp import clamp_figure
from softcat_sym.report.compare_midpoint import midpoint_figure
from softcat_sym.report.compare_rate import rate_figure
from softcat_sym.report.compare_shapes import shapes_figure
from softcat_sym.report.compare_tables import clamp_csv, document, errors_csv, midpoint_csv, rate_csv, shapes_csv

if TYPE_CHECKING:
    from softcat_sym.study.compare import Comparison


def write_comparison(comparison: Comparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, four pictures and their tables.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Parameters
    ----------
    comparison : Comparison
        As from :func:`softcat_sym.study.compare.compare`.
    directory : str or pathlib.Path
        Where the files go; made if missing.

    Returns
    -------
    list of pathlib.Path
        The files written.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    contents = {
        "compare.json": (json.dumps(document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(midpoint_figure(comparison)),
        "compare_shapes.png": png(shapes_figure(comparison)),
        "compare_plastic_rate.png": png(rate_figure(comparison)),
        "compare_clamp_strain.png": png(clamp_figure(comparison)),
        "compare_errors.csv": errors_csv(comparison),
        "compare_midpoint.csv": midpoint_csv(comparison),
        "compare_shapes.csv": shapes_csv(comparison),
        "compare_plastic_rate.csv": rate_csv(comparison),
        "compare_clamp_strain.csv": clamp_csv(comparison),
    }
    return write_all(directory, contents)
