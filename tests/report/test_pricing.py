"""Chart, tables and files of a pricing: no name on another, every number where it belongs, one line a scene."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from rich.console import Console

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.plotting import style
from softcat_sym.plotting.pricing import (
    document,
    in_short,
    pricing_figure,
    pricing_table,
    print_pricing,
    rows_csv,
    write_pricing,
    write_pricings,
)
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.studies.pricing import EVERYTHING, PricedRun, Pricing, PricingRow, Unpriced

NAMES = tuple(effect.name for effect in REGISTRY)
TIME = np.linspace(0.0, 1.0, 5)


def run_of(change: float, cost: float, outcome: Outcome = Outcome.solved) -> PricedRun:
    """A run whose midpoint ends at -(1 + change) mm, and whose sizes are `cost` times those of the base."""
    names = ("inertia", "bending", "yielding")
    midpoint = -1e-3 * TIME * (1 + change)
    sizes = round(100 * cost), 10, round(1000 * cost)
    return PricedRun(names, TIME, midpoint, *sizes, 0.5 * cost, "cvodes", outcome, "" if outcome.is_success else "why")


BASE = run_of(0.0, 1.0)


def row_of(
    name: str, inside: bool, variant: PricedRun | None, reason: str = "", also: Sequence[str] = ()
) -> PricingRow:
    change = None if variant is None else float(abs(variant.midpoint[-1] + 1e-3) / 1e-3)
    reference = None if variant is None else BASE
    return PricingRow(
        name, inside, tuple(also), variant, reference, 1e-3, change, change and -change, 0.01, "a guess", reason
    )


@pytest.fixture
def pricing() -> Pricing:
    rows = (
        row_of("inertia", True, run_of(0.12, 0.5)),
        row_of("bending", True, run_of(0.5, 0.9, Outcome.no_convergence)),
        row_of("yielding", True, run_of(0.0141, 0.2), also=("fibres",)),
        row_of("thinning", True, run_of(1e-9, 0.98)),
        row_of("shear", False, run_of(0.0201, 5.0)),
        row_of("viscous-stress", False, None, "cannot be had: the law | has none"),
    )
    everything = row_of(EVERYTHING, False, run_of(0.03, 20.0), also=("shear", "fibres"))
    return Pricing("cold-honey", sc.load_scene("cold-honey"), BASE, 40, 3.0, rows, everything)


def crowded(pricing: Pricing) -> Pricing:
    """Every effect at one and the same point."""
    return replace(pricing, rows=tuple(row_of(name, True, run_of(0.01, 0.7)) for name in NAMES))


def wide(pricing: Pricing) -> Pricing:
    """From nothing to a thousandfold in both directions, in one line, with a long title."""
    rows = tuple(row_of(name, k % 2 == 0, run_of(10.0 ** (k - 9), 10.0 ** (k / 3 - 2))) for k, name in enumerate(NAMES))
    return replace(pricing, scene=pricing.scene.replace({"title": "A $10 title " * 12}), rows=rows)


def empty(pricing: Pricing) -> Pricing:
    rows = tuple(row_of(name, True, run_of(0.5, 1.0, Outcome.step_limit)) for name in NAMES)
    nothing = replace(pricing.everything, variant=BASE, change=0.0, also=())
    return replace(pricing, rows=rows, everything=nothing)


def visible_texts(figure: Figure) -> list[Text]:
    with style.styled():
        figure.draw_without_rendering()
    return [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]


@pytest.mark.parametrize("case", [lambda p: p, crowded, wide, empty], ids=["plain", "crowded", "wide", "empty"])
def test_names_lie_on_no_other_name_and_on_no_point(pricing: Pricing, case: Callable[[Pricing], Pricing]) -> None:
    figure = pricing_figure(case(pricing))
    paper = figure.bbox
    for text in visible_texts(figure):
        box = text.get_window_extent()
        assert paper.x0 <= box.x0 and box.x1 <= paper.x1 and paper.y0 <= box.y0 and box.y1 <= paper.y1, text
    main = figure.axes[0]
    boxes = [text.get_window_extent() for text in main.texts]
    points = [line.get_window_extent() for line in main.lines if line.get_marker() != "None"]
    for k, box in enumerate(boxes):
        assert main.bbox.x0 <= box.x0 and box.x1 <= main.bbox.x1
        assert not any(box.overlaps(other) for other in (*boxes[k + 1 :], *points))
    for axes in figure.axes:
        ticks = [tick.get_window_extent() for tick in axes.get_xticklabels() if tick.get_text()]
        assert len(ticks) > 0
        assert not any(one.overlaps(other) for one, other in pairwise(ticks))
    legends = [legend.get_window_extent() for legend in figure.legends]
    things = [
        *legends,
        *(text.get_window_extent() for text in figure.texts),
        *(a.xaxis.label.get_window_extent() for a in figure.axes),
    ]
    for k, one in enumerate(things):
        assert not any(one.overlaps(other) for other in things[k + 1 :])


def test_each_point_is_the_change_against_the_ratio_with_over_without(pricing: Pricing) -> None:
    main, states, instructions = pricing_figure(pricing).axes
    names = [text.get_text() for text in main.texts]
    assert sorted(names) == sorted(["inertia", "yielding", "thinning", "shear", EVERYTHING])
    found = [tuple(float(v[0]) for v in line.get_data()) for line in main.lines if line.get_marker() != "None"]
    # In force: base over variant; put in: variant over base. What is not seen is drawn on the lowest line.
    expected = [(2.0, 0.12), (5.0, 0.0141), (1 / 0.98, 1e-6), (5.0, 0.0201), (20.0, 0.03)]
    np.testing.assert_allclose(found, expected, rtol=1e-6)
    for axes, size in ((states, lambda run: run.states + run.algebraic), (instructions, lambda run: run.instructions)):
        drawn = [float(line.get_xdata()[0]) for line in axes.lines if line.get_marker() != "None"]
        assert drawn[0] == size(BASE) / size(run_of(0.12, 0.5)) and drawn[3] == size(run_of(0.02, 5.0)) / size(BASE)


def test_tables_read_back_exactly(pricing: Pricing) -> None:
    rows = list(csv.DictReader(io.StringIO(rows_csv(pricing).decode())))
    assert [row["effect"] for row in rows] == [*(row.effect for row in pricing.rows), EVERYTHING]
    assert float(rows[0]["change"]) == pricing.rows[0].change
    assert rows[1]["outcome"] == "no_convergence" and rows[1]["own_change"] == ""
    assert rows[2]["also"] == "fibres"
    assert rows[5]["states"] == "" and rows[5]["reason"] == "cannot be had: the law | has none"
    found = document(pricing)
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    assert found["effects"][0]["time_ratio"] == 2.0 and found["effects"][5]["run"] is None
    assert found["base"]["midpoint_largest_m"] == 1e-3


def test_many_scenes_are_a_line_each(pricing: Pricing) -> None:
    lines = pricing_table([pricing, Unpriced("broken", "no | such law")]).splitlines()
    assert len(lines) == 4
    assert all(line.count("|") == lines[0].count("|") for line in lines)
    cells = [cell.strip() for cell in lines[2].split("|")[1:-1]]
    assert cells[0] == "cold-honey" and cells[1] == in_short(pricing)
    assert cells[2] == "inertia 12 %, yielding 1.4 %, thinning less than 0.0001 %"
    assert cells[3] == "× 20"
    assert cells[4].startswith("inertia moves the midpoint by 12 % for 2 times the time, yielding by 1.4 % for 5 times")
    assert "without bending the run ends as no_convergence" in cells[4]
    assert "left out, shear would move it by 2 %" in cells[4]
    assert "not priced" in lines[3]


def test_effects_are_listed_the_shorter_way(pricing: Pricing) -> None:
    assert in_short(pricing) == "all but shear"
    outside = tuple(row_of(name, False, BASE) for name in ("shear", "fibres", "rotary-inertia"))
    assert in_short(replace(pricing, rows=outside)) == "inertia, bending, yielding"


def test_the_table_fits_a_terminal_and_says_why(pricing: Pricing) -> None:
    screen = Console(file=io.StringIO(), width=80, color_system=None)
    print_pricing(pricing, screen)
    written = screen.file.getvalue()  # type: ignore[attr-defined]
    assert "…" not in written and max(map(len, written.splitlines())) <= 80
    for text in ("12 %", "no_convergence; why", "also without fibres", "cannot be had", "inertia moves the midpoint"):
        assert text in written


def test_files_of_one_scene_and_of_many(pricing: Pricing, tmp_path: Path) -> None:
    names = [path.name for path in write_pricing(pricing, tmp_path / "one")]
    assert names == ["effects.json", "effects.csv", "effects.png", "scene.toml"]
    assert sc.load_scene(str(tmp_path / "one" / "scene.toml")) == pricing.scene
    many = [path.name for path in write_pricings(iter([Unpriced("bad", "why"), pricing]), tmp_path / "many")]
    assert many == ["pricing.md", "effects_cold-honey.json", "effects_cold-honey.png"]
    assert (tmp_path / "many" / "pricing.md").read_text() == pricing_table([Unpriced("bad", "why"), pricing])


def test_a_pricing_that_cannot_be_drawn_writes_nothing(
    pricing: Pricing, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(pricing: Pricing) -> bytes:
        raise KeyError("gone")

    monkeypatch.setattr("softcat_sym.plotting.pricing.rows_csv", fail)
    with pytest.raises(KeyError):
        write_pricing(pricing, tmp_path / "out")
    assert not (tmp_path / "out").exists()
