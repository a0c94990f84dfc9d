"""Materials, ends and starts that cannot be: each is one clear error, before anything runs or is written."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError

from .table import show

BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
EYRING = {"s0": "3 kPa", "t0": "2 s"}
GENTLE = [["0 s", "0 m", "0 m"]]


def custom(flow: str, **parameters: object) -> dict[str, object]:
    return {
        "material": {
            "law": "custom",
            "youngs_modulus": "2 MPa",
            "flow": flow,
            "parameters": {**EYRING, **parameters},
        }
    }


def power(index: float) -> dict[str, object]:
    return {"material": {"law": "power-law", "youngs_modulus": "2 MPa", "viscosity": "1 kPa*s", "index": index}}


def moved(*rows: list[str], law: str = "elastic") -> dict[str, object]:
    material = {"law": law, "youngs_modulus": "2 MPa"} | ({"viscosity": "1 kPa*s"} if law == "maxwell" else {})
    return {"material": material, "ends": {"motion": [*GENTLE, *rows]}}


STRING = ["finite-stretch", "thinning", "large-rotation"]
SLACK = {"filament": {**BODY, "rest_length": "0.25 m"}, "material": {"law": "elastic", "youngs_modulus": "2 MPa"}}

BAD: dict[str, tuple[dict[str, object], str, str]] = {
    "not odd": (custom("sigma**2/(s0**2*t0)"), "material.flow", "not odd"),
    "gives work back": (custom("-sigma/(s0*t0)"), "material.flow", "negative dissipation"),
    "decreases": (custom("sin(sigma/s0)/t0"), "material.flow", "decreases"),
    "unknown symbol": (custom("sinh(sigma/s1)/t0 + sigma/(s0*t0)"), "material.flow", "'s1'"),
    "parameter without a unit": (custom("sinh(sigma/s0)/t0", s0=3000), "material.flow", "pure number"),
    "rate of the wrong dimension": (custom("sigma/s0*t0"), "material.flow", "1/s"),
    "import": (custom("__import__('os').system('true')"), "material.flow", "accepted"),
    "attribute": (custom("sigma.__class__"), "material.flow", "accepted"),
    "subscript": (custom("sigma[0]/(s0*t0)"), "material.flow", "accepted"),
    "tower of powers": (custom("9**9**9**9*sigma/(s0*t0)"), "material.flow", "accepted"),
    "index zero": (power(0), "material.index", "out of range"),
    "index negative": (power(-0.5), "material.index", "out of range"),
    "consistency of another index": (power(0.5), "material.viscosity", "Pa"),
    "supports meet": (moved(["0.1 s", "-0.3 m", "0 m"]), "ends.motion", "come within"),
    "beyond what an elastic filament follows": (moved(["9 s", "0.5 m", "0 m"]), "ends.motion", "2.718"),
    "faster than its waves": (moved(["1 ms", "0.1 m", "0 m"], law="maxwell"), "ends.motion", "waves"),
    "time runs back": (moved(["2 s", "1 cm", "0 m"], ["1 s", "0 m", "0 m"]), "ends.motion", "1"),
    "slack string without weight": (
        {**SLACK, "load": {"gravity": "0 m/s^2"}, "run": {"effects": STRING}},
        "load.gravity",
        "slack",
    ),
    "slack string, weight to come": (
        {**SLACK, "load": {"ramp": "0.1 s"}, "run": {"effects": STRING}},
        "load.ramp",
        "slack",
    ),
    "fluid in a turned clamp": (
        {"material": {"law": "newtonian", "viscosity": "1 kPa*s"}, "ends": {"left_angle": "10 deg"}},
        "ends.left_angle",
        "elastic shape",
    ),
    "fluid without its stress": (
        {"material": {"law": "newtonian", "viscosity": "1 kPa*s"}, "run": {"effects": ["inertia", "bending"]}},
        "run.effects",
        "viscous-stress",
    ),
}


def refusal(changes: dict[str, object]) -> str:
    """What is said of a scene; it must be refused before it runs."""
    run = {"duration": "0.2 s", "frames": 11, **changes.get("run", {})}  # type: ignore[dict-item]
    with pytest.raises(SoftcatError) as caught:
        sc.simulate(sc.Scene.model_validate({"filament": BODY, **changes, "run": run}))
    return str(caught.value)


def test_each_is_one_clear_error() -> None:
    rows = []
    for name, (changes, path, word) in BAD.items():
        said = refusal(changes)
        rows.append([name, said.splitlines()[-1].strip()[:110]])
        assert path in said, (name, said)
        assert word in said, (name, said)
        assert "Traceback" not in said
        # One fault for one mistake; an unknown name leaves the parameter that it replaces unused.
        assert said.splitlines()[0].endswith("1 fault"), (name, said)
    show("bad rheology, ends and starts", ["mistake", "what is said"], rows)


def test_a_slack_string_that_could_only_be_pushed_is_not_solved(tmp_path: Path) -> None:
    """A right support that comes back turns a string slack: without weight it has no shape, and no answer is given."""
    scene = sc.Scene.model_validate(
        {
            "filament": BODY,
            "material": {"law": "elastic", "youngs_modulus": "2 MPa"},
            "load": {"gravity": "0 m/s^2"},
            "ends": {"motion": [*GENTLE, ["0.1 s", "-1 cm", "0 m"]]},
            "run": {"duration": "0.2 s", "frames": 11, "effects": STRING},
        }
    )
    done = sc.simulate(scene)
    assert not done.outcome.is_success
    done.save(tmp_path)
    assert tomllib.loads((tmp_path / "scene.toml").read_text(encoding="utf-8"))["ends"]["motion"]
