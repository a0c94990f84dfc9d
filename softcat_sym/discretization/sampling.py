"""A section sampled: at its points, or at one that stands for all of them in code that loops over points."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.discretization.point_rule import PointRule
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.unknowns import PER_FIBRE, Floats


@dataclass(frozen=True)
class OnePoint:
    """One point that stands for all of them, for code that loops over points."""

    symbols: dict[str, ca.SX]  # Of its place and its weight
    is_spatial: bool
    points: int = 1
    labels: tuple[str, ...] = (PER_FIBRE,)
    is_of_fibres: bool = True

    @property
    def places(self) -> list[dict[str, ca.SX]]:
        """Numbers of the one."""
        return [self.symbols]

    @property
    def recall(self) -> Floats:
        """It has its own states."""
        return np.eye(1)

    project = recall

    @property
    def across(self) -> Floats:
        """Its place through the thickness, over that of the fibre that it stands for."""
        return np.zeros(1) if self.is_spatial else np.ones(1)


Sampling = SectionRule | PointRule | OnePoint
"""How the section is sampled, through its thickness or in both directions."""


def one_of(rule: SectionRule | PointRule) -> OnePoint:
    """A point that stands for all of a rule."""
    return OnePoint({name: ca.SX.sym(name) for name in rule.tables}, rule.is_spatial)


def point_labels(rule: Sampling) -> tuple[str, ...]:
    """What the points of a section are called."""
    return rule.labels if isinstance(rule, OnePoint) else tuple(map(str, range(rule.points)))
