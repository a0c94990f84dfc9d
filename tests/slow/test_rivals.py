"""What rivals are compared with."""

from __future__ import annotations

import pytest

from softcat_sym.codegen.compiler import find_compiler
from tests.common.rivals import scenes
from tests.common.rivals.scenes import Physics
from tests.common.table import show
from tests.test_rivals import NAMES

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]


@pytest.mark.parametrize("physics", ["paper", "fibres"])
@pytest.mark.parametrize("name", NAMES)
def test_converged_midpoints_are_what_is_stored(name: str, physics: Physics) -> None:
    stored = scenes.converged_midpoint(name, physics), scenes.converged_error(name, physics)
    found = scenes.extrapolate(name, physics)
    show(f"{name}, {physics}", ("stored", "found", "error"), [[stored[0], found.value, f"{found.error:.1e}"]])
    assert abs(found.value - stored[0]) < stored[1]
