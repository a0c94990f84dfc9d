"""Which physics a run holds: one effect a file, each picking its terms from the equations."""

from softcat_sym.effects.choosing import Decision, Effects, choose_effects
from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.registry import REGISTRY

__all__ = ["REGISTRY", "Decision", "Effect", "Effects", "Estimate", "choose_effects"]
