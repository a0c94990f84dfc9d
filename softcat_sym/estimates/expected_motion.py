"""The motion that is expected of a filament, or was seen of it: what the estimates of all effects are made from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Motion:
    """Quantities from which the estimates of all effects are computed; lengths are in spans."""

    sag: float  # Largest displacement of the midpoint, from the line between the supports where two hold it
    scale: float  # Largest displacement of any node, the unit of errors
    strain: float  # Largest mean strain of the centreline
    slope: float  # Largest slope against the horizontal
    tension_share: float  # Share of the load that is carried in tension at the largest sag
    swings: float  # Phase of the ringing times its share of the sag
    missed: float  # Change of the midpoint, in scales, if the filament were in equilibrium at every instant
    risen: float  # Share of the largest sag that a suddenly loaded filament would reach by the end of the ramp
    relaxed: float  # Share of the stress that flow relaxes, 0 to 1
    overstress: float  # Largest fibre stress over the yield stress; infinite without one
    flowing_overstress: float  # Mean stress of the flowing filament over the yield stress; infinite without one
    retarded: float  # Change of the midpoint, in scales, if the solid had no viscous stress
    damped: float  # Change of the midpoint, in scales, if the solid had no loss below yield
    sheared: float  # Share of the sag by shear, for a filament that does not flow beyond a yield stress
    folds: float  # Growth of a neck, e-folds
    speed: float  # Largest speed of the midpoint [m/s]
    capillary: float  # Share by which surface tension reduces the sag
    rings_on: bool = False

    def amplified(self, change: float) -> float:
        """Change of the midpoint by a relative change of the sag, with the phase of the ringing; at most 1."""
        return min(1.0, change * self.sag / self.scale * (1 + self.swings))
