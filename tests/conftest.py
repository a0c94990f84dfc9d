"""Tests that compile C are skipped where there is no compiler, and fail where one is promised."""

from __future__ import annotations

import hashlib
import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from softcat_sym import progress, store
from softcat_sym.codegen.compiler import find_compiler

HERE = Path(__file__).parent
PROMISED = "SOFTCAT_TESTS_NEED_A_COMPILER"
"""Set where a missing compiler is a fault of the machine, as in continuous integration."""

COMPILING = (
    "native",
    "reference",
    "cli/test_compare.py",
    "codegen",
    "ensemble",
    "acceptance/test_ensemble.py",
    "acceptance/test_compiled_agreement.py",
    "acceptance/test_compiled_speed.py",
    "report/test_compare_pictures.py",
    "rivals",
    "solve/test_backend.py",
    "solve/test_compiled.py",
    "solve/test_external.py",
    "study/test_compare.py",
    "acceptance/test_custom_law_in_c.py",
    "acceptance/test_elements.py",
    "acceptance/test_material_point.py",
    "acceptance/test_against_elements.py",
    "acceptance/test_slenderness.py",
    "acceptance/test_necking.py",
    "acceptance/test_calculix.py",
    "acceptance/test_figures.py",
    "acceptance/test_phase_diagram.py",
    "acceptance/test_where_theory_ends.py",
    "cli/test_compare_calculix.py",
    "cli/test_compare_vary.py",
    "cli/test_figures.py",
    "report/test_figure_elements.py",
    "report/test_figure_phase.py",
    "study/test_phase_",
    "study/test_theory_end.py",
)


def pytest_configure() -> None:
    """No plain lines of progress on a slow machine, where tests ask that nothing else is told."""
    progress._PLAIN_DELAY = math.inf


@pytest.fixture(autouse=True)
def results_of_studies(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The store of this test alone: none takes what another has run."""
    name = hashlib.sha256(request.node.nodeid.encode()).hexdigest()[:16]
    folder = tmp_path_factory.getbasetemp() / f"results-{name}"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(store, "folder", lambda: folder)
        yield folder


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """A file stays with one worker unless asked otherwise: filaments assembled once serve all its tests."""
    from xdist.scheduler import LoadFileScheduling

    return LoadFileScheduling(config, log) if config.option.dist == "load" else None


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Skip what needs a compiler, if there is none."""
    if find_compiler() is not None:
        return
    if os.environ.get(PROMISED):
        raise pytest.UsageError(f"{PROMISED} is set, but there is no C compiler: install gcc, or set CC")
    skipped = pytest.mark.skip(reason="no C compiler: install gcc, or set CC")
    for item in items:
        place = item.path.relative_to(HERE).as_posix()
        if place.startswith(COMPILING):
            item.add_marker(skipped)
