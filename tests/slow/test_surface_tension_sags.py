"""What surface tension holds up: sags with and without it, chosen by `auto`, beside those of a prototype.

``python -m pytest -s -m slow tests/slow/test_surface_tension_sags.py`` prints the tables. The prototype was an
independent solver (NumPy; axial force of the surface without its gradient part). Of materials that are not bundled it
fixed moduli, yield stresses and surface tensions; viscosities, densities and times here are orders of magnitude, so
that its sags are comparable to a few tens of per cent only.
"""

from __future__ import annotations

import math
import warnings
from itertools import pairwise

import pytest

import softcat_sym as sc
from softcat_sym.design.critical_span import critical_span
from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.effects.forecast import forecast
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Silence
from tests.common.table import show

pytestmark = pytest.mark.slow

BARE = {"surroundings.surface_tension": "0 N/m"}


def strand(span: str, diameter: str, density: int, tension: str, law: dict[str, str], duration: str) -> sc.Scene:
    """A round strand between clamps, let go within 20 ms, a quick one at once."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": span, "diameter": diameter, "density": f"{density} kg/m^3"},
            "material": law,
            "surroundings": {"surface_tension": tension},
            "load": {"ramp": "20 ms"} if law["law"] == "bingham" else {},
            "run": {"duration": duration, "accuracy": 0.02},
        }
    )


def bingham(modulus: str, limit: str, viscosity: str) -> dict[str, str]:
    return {
        "law": "bingham",
        "youngs_modulus": modulus,
        "shear_yield_stress": limit,
        "shear_viscosity": viscosity,
    }


def liquid(viscosity: str) -> dict[str, str]:
    return {"law": "newtonian", "shear_viscosity": viscosity}


PLURONIC = bingham("60 kPa", "150 Pa", "10 Pa*s")
SCENES: dict[str, tuple[sc.Scene, tuple[float, float]]] = {
    "ink-bridge": (sc.load_scene("ink-bridge"), (0.1688, 0.0276)),
    "Pluronic, 6 mm": (strand("6 mm", "0.41 mm", 1050, "40 mN/m", PLURONIC, "0.5 s"), (0.122, 0.053)),
    "Pluronic, 10 mm": (strand("10 mm", "0.41 mm", 1050, "40 mN/m", PLURONIC, "0.5 s"), (0.737, 0.371)),
    "soft hydrogel": (
        strand("4 mm", "0.41 mm", 1010, "60 mN/m", bingham("3 kPa", "30 Pa", "10 Pa*s"), "1 s"), (0.549, 0.0496),
    ),
    "chocolate": (
        strand("5 mm", "1 mm", 1300, "30 mN/m", bingham("30 kPa", "30 Pa", "3 Pa*s"), "1 s"), (1.82, 0.264),
    ),
    "toothpaste": (sc.load_scene("toothpaste"), (0.657, 0.629)),
    "cold-honey": (sc.load_scene("cold-honey"), (16.76, 16.01)),
    "thin honey": (strand("20 mm", "0.5 mm", 1400, "60 mN/m", liquid("10 Pa*s"), "0.1 s"), (12.6, 3.14)),
    "silicone-thread": (sc.load_scene("silicone-thread"), (29.27, 27.48)),
    "glass fibre": (strand("50 mm", "0.2 mm", 2500, "0.3 N/m", liquid("1 kPa*s"), "0.1 s"), (7.21, 2.45)),
    "polymer melt": (strand("20 mm", "0.2 mm", 780, "28 mN/m", liquid("1 kPa*s"), "1 s"), (3.17, 1.35)),
}  # fmt: skip
KNOWN = ("ink-bridge", "glass fibre", "polymer melt", "thin honey")
"""Of which all numbers are those of the prototype, or matter little."""


def solved(scene: sc.Scene) -> sc.Run:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return recalled(without_estimate(scene), Silence())


def sag_of(run: sc.Run) -> float:
    """In mm; not a number where the run is refused."""
    return -1e3 * run.summary["midpoint_final_m"] if run.outcome.is_success else math.nan


def shown(run: sc.Run) -> str:
    sag = sag_of(run)
    return f"{sag:.4g}" if math.isfinite(sag) else run.outcome.name


def test_sags_with_and_without_surface_tension() -> None:
    rows, runs = [], {}
    for name, (scene, prototype) in SCENES.items():
        bare, pulled = solved(scene.replace(BARE)), solved(scene)
        without, held = sag_of(bare), sag_of(pulled)
        seconds = [f"{run.summary['wall_s']['total']:.1f}" for run in (bare, pulled)]
        own = sorted(set(pulled.summary["effects"]) - set(bare.summary["effects"]))
        foretold = 1 - forecast(scene).capillary
        ours = (name, shown(bare), shown(pulled), f"{held / without:.3f}", f"{foretold:.3f}", *seconds, " ".join(own))
        rows.append((*ours, " -> ".join(f"{sag:g}" for sag in prototype), f"{prototype[1] / prototype[0]:.3f}"))
        runs[name] = without, held, own
    header = ("scene", "without", "with", "ratio", "foretold", "s", "s with", "more effects", "prototype", "its ratio")
    show("Sag [mm]", header, rows)
    for name, (without, held, own) in runs.items():
        assert "surface-tension" in own and not held >= without, name
        assert name not in KNOWN or held == pytest.approx(SCENES[name][1][1], rel=0.1), name


SPANS = {
    3: ("1.8", "1.7"), 4: ("5.7", "5.3"), 5: ("166", "27"), 6: ("323", "111"), 8: ("688", "334"), 10: ("1141", "579"),
    14: ("necks", "1245"), 20: ("necks", "2765"),
}  # fmt: skip
"""Sag of the ink by the prototype [um], without and with; what falls through its necks is not run again."""


def test_spans_of_the_ink() -> None:
    ink, rows, sags = sc.load_scene("ink-bridge"), [], []
    for span, prototype in SPANS.items():
        scene = ink.replace({"filament.span": f"{span} mm"})
        scenes = [scene.replace(BARE), scene] if prototype[0] != "necks" else [scene]
        runs = [solved(one) for one in scenes]
        sags.append(1e3 * sag_of(runs[-1]))
        um = [f"{1e3 * sag_of(run):.4g}" if run.outcome.is_success else run.outcome.name for run in runs]
        seconds = [f"{run.summary['wall_s']['total']:.1f}" for run in runs]
        blank = [""] * (2 - len(runs))
        rows.append((span, *blank, *um, *blank, *seconds, *prototype))
    show("Ink, sag [um]", ("span [mm]", "without", "with", "s", "s with", "prototype", "with"), rows)
    assert all(one < other for one, other in pairwise(sags))
    assert sags == pytest.approx([float(held) for _, held in SPANS.values()], rel=0.1)


def test_critical_spans_of_the_ink() -> None:
    """By how much the gap may widen; where nothing holds it, by (3.12) of sigma_Y + gamma/R."""
    ink, rows = sc.load_scene("ink-bridge"), []
    ink = ink.replace({"numerics.estimate": False})
    d, spans = ink.filament.thickness, {}
    for words, limit, prototype in (("d/4", d / 4, "4.7 -> 5.9"), ("d", d, "6.5 -> 8.4")):
        for scene in (ink.replace(BARE), ink):
            found = critical_span(scene, f"{limit!r} m", within=("3 mm", "20 mm"), exponents=False)
            spans[words, scene is ink] = 1e3 * found.span
        rows.append((f"sag < {words}", *(f"{spans[words, held]:.3g}" for held in (False, True)), prototype))
        assert spans[words, True] > 1.15 * spans[words, False], words
    theory = []
    for scene in (ink.replace(BARE), ink):
        regime = expected_regime(scene, ("viscous-flow", "yielding"))
        theory.append(1e3 * ink.filament.span * (regime.arrest_exact or 0) / (regime.gravity_number or 1))
    rows.append(("(3.12), exact", *(f"{span:.3g}" for span in theory), "21 -> 43"))
    show("Ink, longest span [mm]", ("limit", "without", "with", "prototype"), rows)
