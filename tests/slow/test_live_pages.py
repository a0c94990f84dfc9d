"""Live pages of the bundled scenes answer as `softcat run` does."""

from __future__ import annotations

from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.simulate import recalled
from softcat_sym.web.description import describe_page
from softcat_sym.web.module import find_wasm_compiler, wasm_module
from softcat_sym.web.page import page_of
from tests.common.javascript import solved_in_node
from tests.common.table import show

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_wasm_compiler() is None, reason="needs a compiler for WebAssembly: the package ziglang"),
]


SCENES = ("coil-spring", "transient-gel", "polymer-thread", "edge-of-rupture")
"""In space, a law of one's own, chains and a refusal; others: `test_web_model`."""


@pytest.mark.parametrize("name", SCENES)
def test_a_page_answers_as_softcat_run(name: str, tmp_path: Path) -> None:
    """At the scene's own values: the largest sag, within the accuracy asked; a page below 400 kB."""
    scene = sc.load_scene(name)
    page = describe_page(scene, name=name)
    module = wasm_module(page.described)
    (tmp_path / "page.wasm").write_bytes(module)
    size = len(page_of(page.data, module).encode())
    own = [{"values": page.data["keys"]}]
    found, run = solved_in_node(page.data, tmp_path / "page.wasm", own, ())[0], recalled(scene)
    sag = max(0.0, -float(run.fields["midpoint"].min()))
    apart = abs(found["sag"] - sag) / max(abs(sag), 1e-12)
    row = [
        f"{size / 1000:.0f}",
        found["verdict"]["outcome"],
        f"{found['sag']:.5g}",
        f"{sag:.5g}",
        f"{apart:.0e}",
        found["milliseconds"],
    ]
    show(f"page of {name}", ("kB", "outcome", "sag", "sag of softcat run", "apart", "ms"), [row])
    assert size <= 400_000
    assert page.data["accuracy"].startswith(f"Of the scene's own values softcat run says: {run.outcome.name}")
    assert not run.outcome.is_success or apart <= scene.run.accuracy
