"""How a filament moves, in the few numbers that decide which physics matters: foreseen, or seen in a finished run."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Motion:
    """What the sizes of all effects are computed from; lengths are in spans.

    Attributes
    ----------
    sag : float
        Largest depth of the midpoint below the line between the supports.
    scale : float
        Largest distance of the midpoint from the height of the left support: what an error is measured by.
    strain : float
        Largest mean strain of the centreline.
    slope : float
        Largest slope against the horizontal.
    tension_share : float
        Share of the load that is carried in tension once the filament hangs deepest.
    swings : float
        Phase of the ringing times its share of the sag: how many times a small change of the stiffness is amplified.
    missed : float
        Change of the midpoint, in scales, by a filament that is in balance at every instant.
    risen : float
        Share of the largest sag that a filament loaded at once would have reached by the end of the ramp.
    relaxed : float
        Share of the stress that flow takes away, 0 to 1.
    overstress : float
        Largest fibre stress over the yield stress; infinite without one.
    flowing_overstress : float
        Mean stress of the flowing filament over the yield stress; infinite without one.
    retarded : float
        Change of the midpoint, in scales, by a solid that does not resist the rate of its strain.
    damped : float
        Change of the midpoint, in scales, by a solid that loses nothing below yield.
    sheared : float
        Share of the sag that shear makes, of a filament that does not flow beyond a yield stress.
    folds : float
        Growth of a neck, e-folds.
    capillary : float
        Share of the sag that surface tension would take, or takes.
    rings_on : bool
        Whether it has rung for so long, and to its end, that its height and amplitude are told, and no phase.
    """

    sag: float
    scale: float
    strain: float
    slope: float
    tension_share: float
    swings: float
    missed: float
    risen: float
    relaxed: float
    overstress: float
    flowing_overstress: float
    retarded: float
    damped: float
    sheared: float
    folds: float
    capillary: float
    rings_on: bool = False

    def amplified(self, change: float) -> float:
        """A relative change of the sag as it shows in the midpoint and in the phase of its ringing; 1 at the most."""
        return min(1.0, change * self.sag / self.scale * (1 + self.swings))
