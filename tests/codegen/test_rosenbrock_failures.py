"""Each failure of the compiled integrator gives its code, kinks are not stepped over, and sanitisers see nothing."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from softcat_sym.codegen.compiler import find_compiler
from tests.codegen import rosenbrock_library as rosenbrock
from tests.codegen.rosenbrock_library import PROBLEMS, RUNTIME, Settings, consistent, integrate, problem


def test_step_limit_leaves_what_was_reached() -> None:
    """The state is that of the last accepted step, later rows are untouched."""
    run = integrate(problem("smooth"), [1.0, 1.0], [0.0, 2.0], Settings(max_steps=4))
    assert run.status.code == rosenbrock.STEP_LIMIT
    assert run.status.steps + run.status.rejected == 4
    again = integrate(problem("smooth"), [1.0, 1.0], [0.0, run.status.reached], Settings(relative=1e-10))
    np.testing.assert_allclose(run.state, again.state, rtol=1e-4)
    assert np.all(np.isnan(run.states[1]))


def test_unbounded_solution_stops_before_its_pole() -> None:
    """y' = y^2 from 1 has its pole at t = 1."""
    run = integrate(problem("explosion"), [1.0], [0.0, 2.0], Settings(relative=1e-9))
    assert run.status.code == rosenbrock.STEP_TOO_SMALL
    assert run.status.reached == pytest.approx(1.0, abs=1e-6)


def test_smallest_step_is_kept() -> None:
    """The pole is left at a distance where a coarser smallest step is wanted."""
    run = integrate(problem("explosion"), [1.0], [0.0, 2.0], Settings(relative=1e-9, smallest_step=1e-4))
    assert run.status.code == rosenbrock.STEP_TOO_SMALL
    assert 0.9 < run.status.reached < 1.0 - 1e-4


def test_rates_that_are_no_number() -> None:
    """sqrt(1 - t) has no value after t = 1; steps shrink towards it."""
    run = integrate(problem("root"), [1.0], [0.0, 2.0], Settings())
    assert run.status.code == rosenbrock.NON_FINITE
    assert 0.999 < run.status.reached <= 1.0
    assert run.status.worst_site == run.status.worst_slot == 0


def test_start_that_is_no_number() -> None:
    """No step is taken from it."""
    run = integrate(problem("explosion"), [np.nan], [0.0, 2.0], Settings())
    assert run.status.code == rosenbrock.NON_FINITE
    assert run.status.steps == 0


def test_singular_matrix() -> None:
    """An algebraic unknown that no row sees."""
    run = integrate(problem("undetermined"), [1.0, 1.0], [0.0, 2.0], Settings())
    assert run.status.code == rosenbrock.SINGULAR
    status, _ = consistent(problem("undetermined"), 0.0, [1.0, 1.0], Settings())
    assert status.code == rosenbrock.SINGULAR


def test_stop_flag() -> None:
    """Set before the first step, it ends the run there."""
    run = integrate(problem("smooth"), [1.0, 1.0], [0.0, 2.0], Settings(stop=ctypes.c_int(1)))
    assert (run.status.code, run.status.steps) == (rosenbrock.STOPPED, 0)


def test_arguments_are_looked_at() -> None:
    """What the header asks for is checked."""
    for times, settings in [
        ([0.0, 1.0, 1.0], Settings()),
        ([0.0, np.nan], Settings()),
        ([0.0, 1.0], Settings(relative=0.0)),
        ([0.0, 1.0], Settings(absolute=-1.0)),
        ([0.0, 1.0], Settings(method=9)),
        ([0.0, 1.0], Settings(kinks=[0.5, 0.5])),
    ]:
        assert integrate(problem("smooth"), [1.0, 1.0], times, settings).status.code == rosenbrock.ARGUMENT


def test_every_code_has_its_sentence() -> None:
    """No two codes say the same, an unknown one says so."""
    said = {rosenbrock.library().softcat_message(code) for code in range(rosenbrock.NO_CONVERGENCE + 1)}
    assert len(said) == rosenbrock.NO_CONVERGENCE + 1
    assert rosenbrock.library().softcat_message(99) == b"unknown code"


def test_a_jump_of_pace_costs_nothing_where_it_is_announced() -> None:
    """y' = 1 before, -2 after t = 1/3, whichever holds at that time: exact, without a rejected step."""
    for method in rosenbrock.METHODS:
        for late in [0.0, 1.0]:
            what, kink = problem("jump", 1.0 / 3.0, late), 1.0 / 3.0
            told = integrate(what, [0.0], [0.0, 0.2, 1.0], Settings(method=method, kinks=[-1.0, kink, 7.0]))
            np.testing.assert_allclose(told.states[:, 0], [0.0, 0.2, kink - 2.0 * (1.0 - kink)], atol=1e-14)
            assert told.status.rejected == 0
            untold = integrate(what, [0.0], [0.0, 0.2, 1.0], Settings(method=method))
            assert untold.status.rejected > 3


def test_consistent_start_is_found_from_afar() -> None:
    """exp(z) = y = 1 from z = -4, where the undamped correction overshoots to 50; y is not touched."""
    status, state = consistent(problem("algebraic", 1e-3), 0.0, [1.0, -4.0], Settings(relative=1e-10, absolute=1e-10))
    assert status.code == rosenbrock.SOLVED
    np.testing.assert_allclose(state, [1.0, 0.0], atol=1e-12)


@pytest.mark.slow
def test_sanitised(tmp_path: Path) -> None:
    """All of it under AddressSanitizer, its leak check, and UBSan, also where an allocation fails."""
    compiler = find_compiler()
    assert compiler is not None
    program = tmp_path / "sanitised"
    strict = ["-std=c99", "-O1", "-g", "-Wall", "-Wextra", "-Werror", "-pedantic", f"-I{RUNTIME}"]
    sanitised = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-Dcalloc=rationed_calloc"]
    files = [*sorted(RUNTIME.glob("*.c")), *sorted(PROBLEMS.glob("*.c"))]
    command = [*compiler.command, *strict, *sanitised, "-o", str(program), *map(str, files), "-lm"]
    subprocess.run(command, check=True, capture_output=True, text=True)
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.endswith("0 surprises\n")
