"""The solver of a scene as WebAssembly: what a page asks of it, in node as in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.generation import export
from softcat_sym.web import description, module
from tests.common.javascript import evaluated
from tests.common.pages import SLOW

SCENE = "slime-slope"  # it does not begin straight
BAD_PARAMETER, BAD_CELLS, BAD_TIMES, BAD_SETTINGS, BAD_START, NOT_STRAIGHT = range(100, 106)

ASKED = """instantiate(require("fs").readFileSync(given.place)).then(module => {
  const { data } = given, state = ownState(data), at = data.resolution, { start } = data
  const run = solve(data, module, state, at)
  const raw = (changed, grid) => {
    const { code, sentence, reached, midpoint } = solvedRaw({ ...data, ...changed }, module, state, { ...at, ...grid })
    return { code, sentence, reached, frames: midpoint.length }
  }
  const thick = data.numbers.indexOf("thickness")
  const elsewhere = start.numbers.map((one, k) => k < start.rows ? Math.min(one, 0.4) : one)
  return [
    WebAssembly.Module.imports(new WebAssembly.Module(require("fs").readFileSync(given.place))).length,
    { outcome: run.verdict.outcome, midpoint: run.midpoint, y: run.fields.y },
    raw({ coefficients: data.coefficients.map((one, k) => k === thick ? NaN : one) }),
    raw({}, { cells: 3 }),
    raw({}, { frames: 1 }),
    raw({ settings: { ...data.settings, absolute: data.settings.absolute.map(row => row.map(() => 0)) } }),
    raw({ start: { ...start, numbers: elsewhere } }),
    raw({ start: null }),
    raw({}, { max_steps: 3 }),
    raw(),
  ]
})"""


@pytest.mark.slow
def test_a_run_is_that_of_softcat_run_and_what_is_wrong_has_a_code_and_a_sentence(tmp_path: Path) -> None:
    if module.find_wasm_compiler() is None:
        pytest.skip("no C compiler for WebAssembly: the package ziglang, or SOFTCAT_WASM_CC")
    scene = sc.load_scene(SCENE, {"numerics.estimate": False})
    with mock.patch.multiple(description, **SLOW, choose_sliders=lambda *_: description.Sliders()):
        page = description.describe_page(scene)
    place = tmp_path / "page.wasm"
    place.write_bytes(module.wasm_module(page.described))
    imports, found, *wrong, limited, sound = evaluated(ASKED, in_node=True, data=page.data, place=str(place))
    run = sc.simulate(scene)
    near = scene.run.accuracy * float(np.abs(run.fields["midpoint"]).max())
    assert (imports, found["outcome"], sound["code"]) == (0, "computed", 0)
    np.testing.assert_allclose(found["midpoint"], run.fields["midpoint"], atol=near, rtol=0)
    np.testing.assert_allclose(np.reshape(found["y"], run.fields["y"].shape), run.fields["y"], atol=near, rtol=0)
    codes = [BAD_PARAMETER, BAD_CELLS, BAD_TIMES, BAD_SETTINGS, BAD_START, NOT_STRAIGHT]
    assert [one["code"] for one in wrong] == codes and all(one["sentence"] for one in wrong)
    assert wrong[0]["sentence"] == "a parameter is not finite or out of range" and not wrong[0]["frames"]
    assert limited["code"] == 1 and 0 < limited["reached"] < scene.run.duration and limited["frames"]


def test_without_a_compiler_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    described = export(sc.load_scene(SCENE))[0]
    monkeypatch.setenv(module.VARIABLE, str(tmp_path / "none"))
    with pytest.raises(SoftcatError, match=r'does not run; pip install "softcat_sym\[web\]"'):
        module.wasm_module(described)
    monkeypatch.delenv(module.VARIABLE)
    monkeypatch.setenv("PATH", str(tmp_path))
    none: Any = iter(())
    monkeypatch.setattr(module, "of_a_wheel", lambda: none)
    monkeypatch.setattr(module, "_PLACES", ())
    with pytest.raises(SoftcatError, match="no C compiler for WebAssembly was found"):
        module.wasm_module(described)
