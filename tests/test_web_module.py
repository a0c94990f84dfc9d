"""The solver of a scene as WebAssembly: what a page calls, under wasmtime."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.export import START
from softcat_sym.errors import SoftcatError
from softcat_sym.generation import contents_of, export
from softcat_sym.solvers.solution import Extremes
from softcat_sym.web import module
from tests.common.web_module import NativePage, Page, WasmPage, as_the_scene, need_wasmtime

SCENE = "slime-slope"  # it does not begin straight
BAD_PARAMETER, BAD_CELLS, BAD_TIMES, BAD_SETTINGS, BAD_START, NOT_STRAIGHT = range(100, 106)


@pytest.fixture(scope="module")
def page() -> WasmPage:
    need_wasmtime()
    scene = sc.load_scene(SCENE)
    found = WasmPage(export(scene)[0])
    found.start = np.array(
        [list(map(float, row.split(","))) for row in contents_of(scene, "filament", rhs=False)[START].splitlines()[1:]]
    )
    return found


def values(page: Page) -> list[float]:
    return [one.value for one in page.described.parameters]


def test_a_run_from_a_table_is_that_of_softcat_run(page: WasmPage) -> None:
    assert not page.imports
    run = sc.simulate(sc.load_scene(SCENE, {"numerics.estimate": False}))
    found = page.solve(values(page), as_the_scene(page.described))
    data, scene = run.data, page.described.scene
    assert found.code == 0, found.words
    assert found.reached == pytest.approx(scene.run.duration)
    near = scene.run.accuracy * float(np.abs(data["midpoint"]).max())
    np.testing.assert_allclose(found.midpoint, data["midpoint"], atol=near, rtol=0)
    np.testing.assert_allclose(found.fields["y"], data["y"], atol=near, rtol=0)
    assert found.work.shape == (scene.run.frames, len(page.described.model.powers))
    # Two fibres follow a linear law exactly: with more of them the same module has the same answer.
    more = export(scene.replace({"numerics.fibres": 7}))[0]
    own, page.described = page.described, more
    again = page.solve(values(page), as_the_scene(more))
    page.described = own
    assert again.code == 0 and len(again.fields) > len(found.fields)
    np.testing.assert_allclose(again.midpoint, found.midpoint, atol=0.1 * near, rtol=0)


def test_what_is_wrong_has_a_code_and_a_sentence(page: WasmPage) -> None:
    given, how, start = values(page), as_the_scene(page.described, frames=3), page.start
    names = list(page.described.model.parameters)
    bad = list(given)
    bad[names.index("thickness")] = float("nan")
    found = page.solve(bad, how)
    assert (found.code, found.worst[1]) == (BAD_PARAMETER, names.index("thickness"))
    assert found.words == "a parameter is not finite or out of range" and not found.midpoint.size
    refused = {
        BAD_CELLS: {"cells": 3},
        BAD_TIMES: {"frames": 1},
        BAD_SETTINGS: {"absolute": [0.0] * len(how.absolute)},
    }
    for code, other in refused.items():
        found = page.solve(given, as_the_scene(page.described, **{"frames": 3, **other}))
        assert found.code == code and found.words
    limited = page.solve(given, as_the_scene(page.described, max_steps=3))
    assert limited.code == 1 and 0 < limited.reached < how.duration and len(limited.midpoint) >= 1
    try:
        page.start = np.empty(0)
        assert page.solve(given, how).code == NOT_STRAIGHT
        page.start = np.where(start == start[-1, 0], 0.4, start)
        assert page.solve(given, how).code == BAD_START
    finally:
        page.start = start
    assert page.solve(given, how).code == 0, "and it goes on"


def test_without_a_compiler_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    described = export(sc.load_scene(SCENE))[0]
    monkeypatch.setenv(module.VARIABLE, str(tmp_path / "none"))
    with pytest.raises(SoftcatError, match=r'does not run; pip install "softcat_sym\[web\]"'):
        module.wasm_module(described)
    monkeypatch.delenv(module.VARIABLE)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(module, "of_a_wheel", lambda: iter(()))
    monkeypatch.setattr(module, "_PLACES", ())
    with pytest.raises(SoftcatError, match="no C compiler for WebAssembly was found"):
        module.wasm_module(described)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "changes"), [("arrested-underdamped", {"numerics.fibres": 6}), ("no-yield", {})])
def test_a_page_sees_the_turning_points_and_the_yielding_that_softcat_run_sees(
    name: str, changes: dict[str, object]
) -> None:
    few = {"numerics.estimate": False, "numerics.cells": 6, "run.duration": "1.5 s", "run.frames": 4}
    scene = sc.load_scene(name, {**few, **changes})
    page = NativePage(export(scene)[0])
    found = page.solve(values(page), as_the_scene(page.described))
    assert found.code == 0, found.words
    run = sc.simulate(scene.replace({"run.effects": list(page.described.effects.names)}))
    ours = np.array(run.summary["extremes"])
    seen = Extremes(*found.extremes.T).beyond(0.01 * scene.run.accuracy * run.summary["midpoint_largest_m"])
    np.testing.assert_allclose(seen.time[1:-1][-25:], ours[-25:, 0], rtol=1e-3)
    np.testing.assert_allclose(seen.height[1:-1][-25:], ours[-25:, 1], rtol=1e-4)
    assert found.yielded is (run.summary["regime"] != "no-yield")
