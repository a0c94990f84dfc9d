"""Commands of many parts: what is finished is kept, and the same command goes on from there."""

from __future__ import annotations

import json
import signal
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.cli import figures as figures_command
from tests.cli.in_process import Softcat, sets

BARE = sets(
    "numerics.cells=4", "run.frames=4", "run.duration=0.02 s", 'run.effects=["inertia", "bending", "viscous-stress"]'
)
NAMES = ("cold-honey", "gelatin-strand")


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def stop(*_: object, **__: object) -> Any:
    """What stands in for a computation in which Ctrl-C is pressed."""
    signal.raise_signal(signal.SIGINT)


def never(*_: object, **__: object) -> Any:
    raise AssertionError("it was run again")


def test_prices_that_are_there_are_not_asked_again(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("softcat_sym.scene.bundled_names", lambda: NAMES)
    from softcat_sym.studies import pricing as bundled_pricing

    command = ("effects", "--bundled", "-q", "-o", str(tmp_path), *BARE)
    # Priced once in earnest; the others are that, under another name.
    told = bundled_pricing.price_effects(sc.load_scene(NAMES[0], BARE[1::2]), None, NAMES[0], ["inertia"])

    def price(scene: sc.Scene, _: object, name: str) -> sc.Pricing:
        return replace(told, scene=scene, name=name)

    monkeypatch.setattr(bundled_pricing, "price_effects", lambda *a: price(*a) if a[2] == NAMES[0] else stop())
    done = softcat(*command)
    assert done.status == 130
    assert f"1 scenes are in {tmp_path}: the same command goes on from there" in done.err
    first = (tmp_path / f"effects_{NAMES[0]}.json").read_bytes()

    monkeypatch.setattr(bundled_pricing, "price_effects", lambda *a: price(*a) if a[2] == NAMES[1] else never())
    assert softcat(*command).status == 0
    assert (tmp_path / f"effects_{NAMES[0]}.json").read_bytes() == first
    table = (tmp_path / "pricing.md").read_text()
    assert [line.split("|")[1].strip() for line in table.splitlines()[2:]] == list(NAMES)

    monkeypatch.setattr(bundled_pricing, "price_effects", never)
    assert softcat(*command).status == 0
    assert (tmp_path / "pricing.md").read_text() == table
    # Another scene, a lost picture, or a file of something else: priced again.
    asked: list[str] = []
    monkeypatch.setattr(bundled_pricing, "price_effects", lambda *a: (asked.append(a[2]), price(*a))[1])
    assert softcat(*command, *sets("run.duration=0.03 s")).status == 0
    assert asked == list(NAMES)
    (tmp_path / f"effects_{NAMES[0]}.png").unlink()
    (tmp_path / f"effects_{NAMES[1]}.json").write_text("{}")
    assert softcat(*command, *sets("run.duration=0.03 s")).status == 0
    assert asked == [*NAMES, *NAMES]


def test_interrupted_products_are_none_at_all(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from softcat_sym import generation as products

    export, turns = products.export, []

    def third_time(scene: Any) -> Any:
        turns.append(scene)
        return stop() if len(turns) == 3 else export(scene)

    monkeypatch.setattr(products, "export", third_time)
    done = softcat("generate", "--bundled", "-o", str(tmp_path / "out"))
    assert done.status == 130
    assert done.err.startswith("softcat: interrupted; nothing was written; C texts that were made")
    assert len(turns) == 3
    assert not (tmp_path / "out").exists()


def test_a_product_that_cannot_be_written_leaves_the_others_as_they_were(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from softcat_sym import generation as products

    monkeypatch.setattr(products, "bundled", lambda told: {})
    monkeypatch.setattr(products, "contents", lambda described: {"a/one": "new", "b/two": "new"})
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "one").write_text("old")
    (tmp_path / "b" / "two").mkdir(parents=True)
    with pytest.raises(IsADirectoryError):
        products.write(tmp_path)
    assert (tmp_path / "a" / "one").read_text() == "old"


def test_finished_figures_are_named_with_the_command_for_the_others(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(figures_command._MADE, "2", lambda *_: ({"figure2.csv": b"a,b\n"}, "two"))
    monkeypatch.setitem(figures_command._MADE, "4", stop)
    done = softcat("figures", "--only", "2", "--only", "4", "-o", str(tmp_path / "out"))
    assert done.status == 130
    assert f"figure 2 is written; softcat figures -o {tmp_path / 'out'} --only 4 goes on" in done.err
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["figure2.csv"]
    done = softcat("figures", "--only", "4", "-o", str(tmp_path / "none"))
    assert "nothing was written" in done.err
    assert not (tmp_path / "none").exists()


def test_runs_of_figure_3a_are_kept(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[set[int]] = []

    def study(scene: object, *, kept: Any, progress: object) -> Any:
        seen.append(kept.sound())
        kept.keep(len(seen), json.dumps({"finished": len(seen)}).encode())
        return stop()

    monkeypatch.setattr("softcat_sym.studies.phase.phase_diagram", study)
    for _ in range(2):
        done = softcat("figures", "--only", "3a", "-q", "-o", str(tmp_path))
        assert done.status == 130
        assert f"the same command goes on from {tmp_path}" in done.err
    assert seen == [set(), {1}]
