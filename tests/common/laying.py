"""Strands that a nozzle lays, beside what is known of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

import softcat_sym as sc

Floats = npt.NDArray[np.float64]
RHO, G = 1000.0, 9.81
SLENDER = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "laying"]


def extruded_downwards(cells: int, **numerics: Any) -> sc.Run:
    """A soft elastic strand that a nozzle extrudes downwards, tenfold from its stub."""
    return sc.simulate(
        sc.Scene(
            filament={"span": 0.01, "diameter": 1e-3, "density": RHO},
            material={"law": "maxwell", "youngs_modulus": 1e3, "viscosity": 1e9},
            ends={"left": "free"},
            load={"gravity": G},
            extrusion={"path": [[0.0, 0.0, 0.0]], "speed": 9e-3, "start": 1e-3, "direction": "down"},
            run={"duration": 1.0, "frames": 101, "effects": [*SLENDER, "viscous-flow"]},
            numerics={"cells": cells, "estimate": False, **numerics},
        )
    )


def hanging_bar(run: sc.Run) -> tuple[Floats, Floats]:
    """Length and weight of what is out, over the closed form: E log(s)/s = rho g X from the free end on."""
    out, modulus, area = run.data.extruded_length.values, run.scene.material.youngs_modulus, run.scene.filament.area
    places = np.linspace(0.0, out[-1], 2001)
    load, stretch = RHO * G * places / modulus, np.ones_like(places)
    for _ in range(60):
        stretch = np.exp(load * stretch)  # It converges below a load of 1/e
    lengths = np.concatenate([[0.0], np.cumsum((stretch[1:] + stretch[:-1]) / 2 * np.diff(places))])
    hangs = -run.data.y.values[:, 0] / np.interp(out, places, lengths)
    return hangs, run.data.nozzle_force_y.values / (RHO * G * area * out)


def laid_beam(cells: int, thickness: float = 1e-3, **changes: Any) -> sc.Run:
    """A viscous beam laid at the speed of its flow, of a sag far below its thickness."""
    tables: dict[str, Any] = {
        "filament": {"span": 0.1, "thickness": thickness, "density": RHO},
        "material": {"law": "newtonian", "viscosity": 1e9},
        "load": {"gravity": G},
        "extrusion": {"print_speed": 0.0999, "start": 1e-4},
        "run": {"duration": 1.0, "frames": 101, "effects": [*SLENDER, "viscous-stress"]},
        "numerics": {"cells": cells, "estimate": False},
    }
    made = {name: {**table, **(changes.get(name) or {})} for name, table in tables.items()}
    if changes.get("extrusion", {}) is None:
        made["run"]["effects"] = [one for one in made["run"]["effects"] if one != "laying"]
        del made["extrusion"]
    return sc.simulate(sc.Scene(**made))


def beam_over_law(run: sc.Run) -> Floats:
    """Sag of all inner nodes when the nozzle arrives, over q x^2 (L - x)^3/(72 eta I V)."""
    part, speed = run.scene.filament, run.scene.extrusion.print_speed
    weight, moment = RHO * G * part.area, part.thickness**3 * part.width / 12
    x = run.data.X_node.values[1:-1] - run.data.X_node.values[0]
    law = weight * x**2 * (part.span - x) ** 3 / (72 * run.scene.material.viscosity * moment * speed)
    return np.asarray(-run.data.y.values[-1, 1:-1] / law)
