"""Which physics a run holds: one effect a file, each picking its terms from the equations."""

from softcat_sym.effects.choosing import REGISTRY, Effects, choose_effects
from softcat_sym.effects.effect import Effect, Estimate

__all__ = ["REGISTRY", "Effect", "Effects", "Estimate", "choose_effects"]
