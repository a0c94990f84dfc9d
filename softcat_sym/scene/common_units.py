"""The units that scenes are written in, as pint measures them: pint itself takes half a second to begin."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_LENGTH, _TIME, _MASS, _ANGLE = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
_STRESS, _VISCOSITY, _DENSITY = (1.0, -1.0, -2.0), (1.0, -1.0, -1.0), (1.0, -3.0, 0.0)
_ACCELERATION, _TENSION, _CURVATURE, _FREQUENCY = (0.0, 1.0, -2.0), (1.0, 0.0, -2.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)

_FACTORS: Mapping[tuple[float, float, float], Mapping[str, float]] = {
    _LENGTH: {"m": 1.0, "cm": 0.01, "mm": 0.001, "um": 1e-6, "nm": 1e-9, "km": 1000.0},
    _TIME: {"s": 1.0, "ms": 0.001, "us": 1e-6, "min": 60.0, "h": 3600.0},
    _MASS: {"kg": 1.0, "g": 0.001, "mg": 1e-6},
    _ANGLE: {"rad": 1.0, "deg": 0.017453292519943295},
    _STRESS: {"Pa": 1.0, "mPa": 0.001, "kPa": 1000.0, "MPa": 1e6, "GPa": 1e9},
    _VISCOSITY: {"Pa*s": 1.0, "mPa*s": 0.001, "kPa*s": 1000.0, "MPa*s": 1e6, "GPa*s": 1e9},
    _DENSITY: {"kg/m^3": 1.0, "g/cm^3": 1000.0},
    _ACCELERATION: {"m/s^2": 1.0},
    _TENSION: {"N/m": 1.0, "mN/m": 0.001},
    _CURVATURE: {"1/m": 1.0},
    _FREQUENCY: {"Hz": 1.0, "kHz": 1000.0},
}

COMMON: Mapping[str, tuple[float, tuple[float, float, float]]] = MappingProxyType(
    {unit: (factor, dimension) for dimension, factors in _FACTORS.items() for unit, factor in factors.items()}
)
"""SI value and exponents of kg, m and s of each."""
