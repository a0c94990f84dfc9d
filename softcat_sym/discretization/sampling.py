"""A section sampled: at its points, or at one that stands for all of them in code that loops over points."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from softcat_sym.discretization.point_rule import POINT_TABLES, PointRule
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.unknowns import PER_FIBRE, Floats


@dataclass(frozen=True)
class OneFibre:
    """One fibre that stands for all of them, for code that loops over fibres."""

    zeta: ca.SX = field(default_factory=lambda: ca.SX.sym("zeta"))  # Symbols of its material coordinate and weight
    weight: ca.SX = field(default_factory=lambda: ca.SX.sym("weight"))
    points: int = 1
    labels: tuple[str, ...] = (PER_FIBRE,)
    recall: Floats = field(default_factory=lambda: np.eye(1))
    project: Floats = field(default_factory=lambda: np.eye(1))

    @property
    def places(self) -> list[tuple[ca.SX, ca.SX]]:
        """Coordinate and weight of the one."""
        return [(self.zeta, self.weight)]


@dataclass(frozen=True)
class OnePoint:
    """One point that stands for all of them, for code that loops over points."""

    symbols: dict[str, ca.SX] = field(default_factory=lambda: {name: ca.SX.sym(name) for name in POINT_TABLES})
    points: int = 1
    labels: tuple[str, ...] = (PER_FIBRE,)

    @property
    def places(self) -> list[dict[str, ca.SX]]:
        """Numbers of the one."""
        return [self.symbols]


Sampling = SectionRule | OneFibre
"""How the section is sampled through its thickness."""

SpatialSampling = PointRule | OnePoint
"""How it is sampled in both directions."""


def one_of(rule: SectionRule | PointRule) -> OneFibre | OnePoint:
    """A fibre, or a point, that stands for all of a rule."""
    return OnePoint() if isinstance(rule, PointRule) else OneFibre()


def point_labels(rule: Sampling | SpatialSampling) -> tuple[str, ...]:
    """What the points of a section are called."""
    return (PER_FIBRE,) if isinstance(rule, (OneFibre, OnePoint)) else tuple(map(str, range(rule.points)))
