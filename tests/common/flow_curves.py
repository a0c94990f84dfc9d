"""Flow curves whose law is known."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from softcat_sym.fitting.flow_curve import FlowCurve
from tests.common.draws import draws

RATE = np.geomspace(1e-2, 1e3, 26)

# Law, tau_Y [Pa], k [Pa s^n], n.
MATERIALS = [
    ("bingham", 12.0, 0.5, 1.0),
    ("bingham", 3e4, 7.0, 1.0),
    ("power-law", 0.0, 3.4, 0.3),
    ("power-law", 0.0, 3.4, 1.6),
    ("herschel-bulkley", 12.0, 3.4, 0.43),
    ("herschel-bulkley", 5.0, 1.0, 2.2),
    ("herschel-bulkley", 0.02, 8e-3, 0.6),
]


def curve_of(tau_Y: float, k: float, n: float, noise: float = 0.0, seed: int = 0) -> FlowCurve:
    """A curve with independent relative errors."""
    error = noise * draws(seed).standard_normal(RATE.size)
    return FlowCurve(RATE, (tau_Y + k * RATE**n) * (1 + error))


def write_csv(path: Path, curve: FlowCurve) -> Path:
    pairs = zip(curve.shear_rate.tolist(), curve.shear_stress.tolist(), strict=True)
    rows = "".join(f"{rate!r},{stress!r}\n" for rate, stress in pairs)
    path.write_text(f"shear_rate_1_s,shear_stress_Pa\n{rows}")
    return path
