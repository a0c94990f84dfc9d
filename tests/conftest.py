"""Results of a test are its own, work is shared evenly, and what compiles C is skipped where nothing can.

Compiled models are kept in the user's cache (SOFTCAT_CACHE), which all workers of a session share.
"""

from __future__ import annotations

import hashlib
import math
import os
import re
import signal
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from softcat_sym import cache, progress
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.errors import SceneError

if TYPE_CHECKING:
    from tests.common.in_process import Softcat

PROMISED = "SOFTCAT_TESTS_NEED_A_COMPILER"
"""Set where a missing compiler is a fault of the machine, as in continuous integration."""
COMPILING = re.compile(
    "backend|c_printer|cache|calculix|codegen|compar|compil|element|ensemble|external|figures|in_c|material_point|native|necking"
    "|phase|reference|ringings|rosenbrock|slenderness|solvers|theory_end|vtk"
    "|forward_model|generated|test_ends|web_model|without_sympy"
)
"""Files of tests, or their folders, that need a compiler."""

_OF_POSIX = "cache calculix command_line compiler_cache ensemble faults hard_cases least_squares properties solvers"
collect_ignore = [f"test_{name}.py" for name in _OF_POSIX.split()] if sys.platform == "win32" else []
"""Files whose tests send signals, limit processes, open pseudo-terminals, or put scripts in the place of programs."""


def pytest_configure() -> None:
    """No plain lines of progress and no warnings where tests ask that nothing else is printed; Ctrl-C arrives."""
    progress._PLAIN_DELAY = math.inf
    # A job behind the `&` of a script ignores it.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    # Where others could write into the user's cache, every test would be warned.
    if cache.problem(cache.LIBRARIES):
        os.environ["SOFTCAT_CACHE"] = tempfile.mkdtemp(prefix="softcat-tests-")
    # Zig compiles the libraries of C for itself, half a minute's work: once, also for tests with a cache of their own.
    os.environ.setdefault("ZIG_GLOBAL_CACHE_DIR", str(cache.folder(cache.ZIG) / "tests"))


@pytest.fixture(autouse=True)
def results_of_studies(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The store of this test alone: none takes what another has run."""
    name = hashlib.sha256(request.node.nodeid.encode()).hexdigest()[:16]
    folder = tmp_path_factory.getbasetemp() / f"results-{name}"
    with pytest.MonkeyPatch.context() as patch:
        usual = cache.folder
        patch.setattr(cache, "folder", lambda kind: folder if kind == cache.RESULTS else usual(kind))
        yield folder


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    """The command line, as a user meets it."""
    from tests.common.in_process import Softcat

    return Softcat(monkeypatch, capsys)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Each worker begins with files of its own, whose tests share what they assemble, and then helps the others."""
    from xdist.scheduler import WorkStealingScheduling

    return WorkStealingScheduling(config, log) if config.option.dist == "load" else None


_NEEDS = "no C compiler: install gcc, or set CC"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call() -> Iterator[None]:
    """Skip what asks for the compiled backend where nothing compiles, in whichever file it stands."""
    try:
        return (yield)
    except SceneError as error:
        if find_compiler() is None and [fault.path for fault in error.faults] == ["numerics.backend"]:
            pytest.skip(_NEEDS)
        raise


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Skip what needs a compiler, if there is none."""
    if find_compiler() is not None:
        return
    if os.environ.get(PROMISED):
        raise pytest.UsageError(f"{PROMISED} is set, but there is no C compiler: install gcc, or set CC")
    for item in items:
        path = item.path.relative_to(Path(__file__).parent).as_posix()
        if COMPILING.search(path) or item.get_closest_marker("compiled"):
            item.add_marker(pytest.mark.skip(reason=_NEEDS))
