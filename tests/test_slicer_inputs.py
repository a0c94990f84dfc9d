"""A filament given as a slicer's line: its area by hand, the notes, and what contradicts itself."""

from __future__ import annotations

import math
import tomllib
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.fitting.free_parameters import free_parameters, with_values


def scene(**filament: Any) -> sc.Scene:
    """A strand of an ink across 20 mm."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": "20 mm", "density": "1000 kg/m^3", **filament},
            "material": {"law": "elastic", "youngs_modulus": "1 MPa"},
            "run": {"duration": "1 s"},
        }
    )


def by_hand(width: float, height: float, ratio: float, shape: str) -> float:
    """Area [mm^2] by parts: a rectangle; or a rectangle between two half circles."""
    return ratio * (width * height if shape == "rectangle" else (width - height) * height + math.pi * (height / 2) ** 2)


# Thirty: five lines, three flow ratios, two shapes.
LINES = [(0.42, 0.2), (0.45, 0.28), (0.6, 0.3), (0.4, 0.4), (1.2, 0.05)]


@pytest.mark.parametrize("line", LINES)
@pytest.mark.parametrize("ratio", [0.85, 1.0, 1.1])
@pytest.mark.parametrize("shape", ["rectangle", "rounded"])
def test_the_strand_has_the_area_of_the_line(line: tuple[float, float], ratio: float, shape: str) -> None:
    width, height = line
    keys = {"line_width": f"{width} mm", "layer_height": f"{height} mm", "flow_ratio": ratio, "line_shape": shape}
    filament = scene(**keys).filament
    area = by_hand(width, height, ratio, shape)
    assert filament.section == "circle"
    assert math.pi * (1e3 * filament.thickness / 2) ** 2 == pytest.approx(area, rel=1e-12)
    assert filament.width == filament.thickness
    (note,) = filament.notes
    assert f"{width} mm x {height} mm, flow ratio {ratio:g}" in note and f"{shape} line" in note
    assert f"{area:.4g} mm^2: diameter {math.sqrt(4 * area / math.pi):.4g} mm" in note


def test_the_usual_line_is_the_usual_strand() -> None:
    usual = scene(line_width="0.42 mm", layer_height="0.2 mm", nozzle="0.4 mm")
    assert usual.filament.thickness == pytest.approx(0.327e-3, rel=2e-4)
    assert "draw ratio 1.496 =" in usual.notes[1]  # pi 0.2^2/0.084
    # A rounded line as high as wide is a circle.
    assert scene(line_width=4e-4, layer_height=4e-4, line_shape="rounded").filament.thickness == pytest.approx(4e-4)
    assert scene(diameter="0.4 mm", nozzle="0.8 mm").notes[-1].startswith("draw ratio 4 =")


def test_what_follows_from_the_line_follows_again_until_it_is_replaced() -> None:
    usual = scene(line_width="0.42 mm", layer_height="0.2 mm")
    longer = usual.replace({"filament.span": "30 mm", "filament.flow_ratio": 0.9})
    assert longer.filament.thickness == pytest.approx(math.sqrt(0.9) * usual.filament.thickness)
    for key in ("thickness", "diameter"):
        other = usual.replace({f"filament.{key}": "1 mm"})
        assert (other.filament.thickness, other.filament.section, other.filament.line_width) == (1e-3, "circle", None)
    line = {"filament.line_width": "0.42 mm", "filament.layer_height": "0.2 mm"}
    assert sc.load_scene("ink-bridge", line).filament.thickness == usual.filament.thickness
    assert sc.Scene.model_validate(tomllib.loads(usual.to_toml())) == usual
    (free,) = free_parameters(usual, ["filament.thickness"])
    thicker = with_values(usual, [free], [1e-3])
    assert thicker.replace({"filament.span": "30 mm"}).filament.thickness == 1e-3


PAIR = {"line_width": "0.4 mm", "layer_height": "0.2 mm"}


@pytest.mark.parametrize(
    ("filament", "fault"),
    [
        ({"line_width": "0.42 mm"}, "filament.layer_height: missing, but filament.line_width is given"),
        ({"layer_height": "0.2 mm"}, "filament.layer_height: given without filament.line_width"),
        ({"flow_ratio": 0.9, "thickness": "1 mm"}, "filament.flow_ratio: given without filament.line_width"),
        ({"line_shape": "rounded", "diameter": "1 mm"}, "filament.line_shape: given without filament.line_width"),
        ({**PAIR, "thickness": "1 mm"}, "filament.thickness: given twice, here and as filament.line_width"),
        ({**PAIR, "diameter": "1 mm"}, "filament.thickness: given twice, as filament.diameter and filament.line_width"),
        ({**PAIR, "section": "rectangle"}, "filament.section: 'rectangle', but filament.line_width is given"),
        ({**PAIR, "width": "0.2 mm"}, "filament.width: a circle has no width of its own"),
        ({**PAIR, "flow_ratio": 0}, "filament.flow_ratio: 0 is out of range"),
        ({**PAIR, "flow_ratio": "95 %"}, "filament.flow_ratio: '95 %' is not a number"),
        ({**PAIR, "layer_height": "-0.2 mm"}, "filament.layer_height: '-0.2 mm' is negative"),
        ({**PAIR, "line_width": "0.42"}, "filament.line_width: '0.42' has no unit"),
        ({**PAIR, "line_shape": "oval"}, "filament.line_shape: 'oval' is not a name known here"),
        (
            {"line_width": "0.2 mm", "layer_height": "0.4 mm", "line_shape": "rounded"},
            "filament.line_shape: 'rounded', but the line is 200 um wide and 400 um high",
        ),
        ({"line_width": "40 mm", "layer_height": "20 mm"}, "filament.thickness: the diameter, 0.0319154 m, is not"),
        ({"thickness": "1 mm", "nozzle": "0.4 mm"}, "filament.nozzle: given, but the section is a rectangle"),
    ],
)
def test_a_contradiction_is_one_line(filament: dict[str, Any], fault: str) -> None:
    with pytest.raises(SceneError) as refused:
        scene(**filament)
    (said,) = refused.value.faults
    assert str(said).startswith(fault)


def test_groups_are_one_more_way_to_say_it() -> None:
    groups = {"delta": 0.03, "law": "elastic", "duration": 5}
    with pytest.raises(SceneError, match=r"filament.line_width: given twice, here and as groups.delta"):
        sc.Scene.model_validate({"groups": groups, "filament": PAIR})
    assert sc.load_scene("no-yield", {"filament.line_width": "5 mm", "filament.layer_height": "3 mm"}).notes
