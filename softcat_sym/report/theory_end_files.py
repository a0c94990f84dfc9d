"""All files of a study of where the theory ends."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.theory_end_chart import theory_end_figure
from softcat_sym.report.theory_end_tables import cost_csv, document, errors_csv, limits_csv

if TYPE_CHECKING:
    from softcat_sym.study.theory_end import TheoryEnd


def write_theory_end(end: TheoryEnd, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, the chart and the tables of errors, costs and limits.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Parameters
    ----------
    end : TheoryEnd
        As from :func:`softcat_sym.study.theory_end.where_theory_ends`.
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
        "compare.json": (json.dumps(document(end), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": end.scene.to_toml().encode(),
        "compare_vary.png": png(theory_end_figure(end)),
        "compare_vary_errors.csv": errors_csv(end),
        "compare_vary_cost.csv": cost_csv(end),
    }
    if end.limits:
        contents["compare_vary_limit.csv"] = limits_csv(end)
    return write_all(directory, contents)
