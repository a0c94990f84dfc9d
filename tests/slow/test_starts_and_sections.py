"""Where a filament starts and what its section is: exact equivalences, and the linear beam and bar."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.common.rheology import GEOMETRY, flow_of, scene, solved
from tests.common.table import show
from tests.marks import few

STRESS = 1e4
"""rho g L [Pa] of the scenes below: span 1 m, density 1000 kg/m^3, gravity 10 m/s^2."""
LEVEL = {"gravity": 10.0}
STATIC = {"duration": 1.0, "frames": 2}
UNEVEN = (1.2, 0.9, 1.1)


@pytest.mark.parametrize(
    ("theory", "law", "profile"),
    few(
        [("paper", "maxwell", UNEVEN), ("shear", "newtonian", ()), ("shear", "maxwell", ())],
        ("shear", "newtonian", ()),
    ),
)
def test_a_relaxed_stretch_is_a_thinner_filament(theory: str, law: str, profile: tuple[float, ...]) -> None:
    """Drawn to s0 and relaxed, a filament of h0 is one of h0/sqrt(s0) that was never drawn, to the last digit."""
    material = {"law": law, "viscosity": 2 * STRESS}
    if law == "maxwell":
        material |= {"youngs_modulus": 40 * STRESS}
    flow = "viscous-flow" if law == "maxwell" else "viscous-stress"
    effects = ("inertia", *GEOMETRY, flow, *(("shear",) if theory == "shear" else ()))
    drawn, thickness = 1.5, 0.05
    runs = [
        solved(
            scene(
                material,
                {"thickness": h, "profile": profile},
                effects=effects,
                initial={"stretch": s0},
                run={"duration": 1.0, "frames": 21},
                load=LEVEL,
                cells=16,
                rtol=1e-7,
            )
        )
        for h, s0 in ((thickness, drawn), (thickness / math.sqrt(drawn), 1.0))
    ]
    sags = [data["midpoint"].values for data in runs]
    error = float(np.max(np.abs(sags[0] - sags[1])) / np.max(np.abs(sags[1])))
    rows = [[theory, law, f"{sags[1][-1]:.6f}", f"{error:.1e}"]]
    show("relaxed stretch of 1.5 against a thinner filament", ["theory", "law", "midpoint [m]", "difference/sag"], rows)
    assert error < 1e-5
    assert np.allclose(runs[0]["stretch"].values[0], drawn, rtol=1e-9)


@pytest.mark.parametrize("effects", [GEOMETRY, pytest.param((*GEOMETRY, "shear", "fibres"), marks=pytest.mark.slow)])
def test_an_initial_plastic_bend_is_a_natural_curvature(effects: tuple[str, ...]) -> None:
    """C = -kappa h0/2 and the natural curvature kappa are the same arc of a free end, which is a circle's."""
    curvature, thickness = 1.2, 0.05
    found = []
    for filament, initial in (({}, {"C": [-curvature * thickness / 2]}), ({"curvature": curvature}, {})):
        data = solved(
            scene(
                {"law": "maxwell", "youngs_modulus": 1e6, "viscosity": 1e9},
                {"thickness": thickness, **filament},
                effects=(*effects, "viscous-flow"),
                ends={"left": "clamped", "right": "free"},
                initial=initial,
                load={"gravity": 0.0},
                run={"duration": 1e-3, "frames": 2},
                cells=20,
            )
        )
        x, y = data["x"].values[0], data["y"].values[0]
        found.append(np.array([x - x[0], y]))
    arc = np.linspace(0, 1, found[0].shape[1])
    circle = np.array([np.sin(curvature * arc), 1 - np.cos(curvature * arc)]) / curvature
    between, error = float(np.max(np.abs(found[0] - found[1]))), float(np.max(np.abs(found[0] - circle)))
    show(
        "arc of a free filament [m]",
        ["C against curvature", "against the circle"],
        [[f"{between:.1e}", f"{error:.1e}"]],
    )
    assert between < 1e-8
    assert error < 2e-3


@pytest.mark.slow
def test_elastic_beam_of_every_section() -> None:
    """Sag rho g A L^4/(384 E' I) of a clamped beam, E' = E/(1 - nu^2) for a sheet."""
    for section in ["rectangle", "circle", "sheet"]:
        for effects in [GEOMETRY, (*GEOMETRY, "shear")]:
            thickness, poisson = 0.01, 0.3
            stiff = 1e10
            data = solved(
                scene(
                    {"law": "elastic", "youngs_modulus": stiff, "poisson": poisson},
                    {"thickness": thickness, "section": section},
                    effects=effects,
                    load=LEVEL,
                    run=STATIC,
                    cells=80,
                )
            )
            modulus = stiff / (1 - poisson**2) if section == "sheet" else stiff
            gyration = thickness**2 / (16 if section == "circle" else 12)
            exact = STRESS / (384 * modulus * gyration)
            found = -float(data["midpoint"].values[-1])
            show(
                f"{section}",
                ["sag [m]", "linear beam [m]", "ratio - 1"],
                [[f"{found:.6e}", f"{exact:.6e}", f"{found / exact - 1:+.1e}"]],
            )
            assert found == pytest.approx(exact, rel=2e-3)


@pytest.mark.parametrize("law", few(("newtonian", "maxwell", "bingham", "herschel-bulkley"), "bingham"))
def test_a_drawn_sheet_resists_more(law: str) -> None:
    """Plane strain across the width (von Mises): 2/sqrt(3) sigma_Y, 4/3 eta, (2/sqrt(3))^(n+1) K at the same rate."""
    stretch, time, index = 1.2, 20.0, 0.5
    material: dict[str, object] = {"law": law, "viscosity": 1e4}
    if law != "newtonian":
        material["youngs_modulus"] = 1e6
    if law in ("bingham", "herschel-bulkley"):
        material["yield_stress"] = 500.0
    n = 1.0
    if law == "herschel-bulkley":
        n = index
        material["index"] = index
    found = []
    for section in ("rectangle", "sheet"):
        data = solved(
            scene(
                material,
                {"thickness": 0.05, "section": section},
                effects=(*GEOMETRY, *flow_of(law)),
                ends={"motion": [(0, 0, 0), (time, stretch - 1, 0)]},
                load={"gravity": 0.0},
                run={"duration": time, "frames": 21},
                cells=4,
                rtol=1e-7,
            )
        )
        found.append(float(data["tension"].values[-1, 0]))
    rate = (stretch - 1) / time / stretch
    limit = 500.0 if law in ("bingham", "herschel-bulkley") else 0.0
    plain = limit + 1e4 * rate**n
    factor = 2 / math.sqrt(3)
    wanted = (factor * limit + factor ** (n + 1) * 1e4 * rate**n) / plain
    ratio = found[1] / found[0]
    show(
        f"{law}: sheet over strip",
        ["T ratio", "von Mises", "error"],
        [[f"{ratio:.6f}", f"{wanted:.6f}", f"{ratio / wanted - 1:+.1e}"]],
    )
    assert ratio == pytest.approx(wanted, rel=1e-3)
