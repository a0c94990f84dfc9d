"""How a section is sampled through its thickness, and what its plastic state stands for.

Fibres: one plastic strain at each point of a Gauss rule. Order k: amplitudes of the orthogonal polynomials p_0 ... p_k
(A 1), whose rates are projections by the same kind of rule (A 2). With k + 1 points both are the same.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.equations.section import Section
from softcat_sym.equations.symbols import zeta
from softcat_sym.equations.through_thickness import mean_square, polynomial
from softcat_sym.graph.grid import Floats
from softcat_sym.printing import evaluate


@dataclass(frozen=True)
class SectionRule:
    """Points through the thickness and the states that give them their plastic strain.

    Attributes
    ----------
    zeta, weight : ndarray, shape (points,)
        Material coordinates and weights; the weights sum to one.
    recall : ndarray, shape (points, states)
        Plastic strain at the points of the states.
    project : ndarray, shape (states, points)
        Rates of the states of the rates at the points; ``project @ recall`` is the identity.
    """

    zeta: Floats
    weight: Floats
    recall: Floats
    project: Floats

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.zeta)

    @property
    def label(self) -> str:
        """All of its numbers."""
        return ", ".join(repr(part.tolist()) for part in (self.zeta, self.weight, self.recall, self.project))

    @property
    def states(self) -> int:
        """Number of plastic states of one kind."""
        return int(self.recall.shape[1])


def fibre_rule(section: Section, fibres: int) -> SectionRule:
    """A plastic state for each of the `fibres` points of the section's Gauss rule."""
    nodes, weights = _gauss(section, fibres)
    return SectionRule(nodes, weights, np.eye(fibres), np.eye(fibres))


def order_rule(section: Section, order: int, points: int) -> SectionRule:
    """Amplitudes of p_0 ... p_order, projected with `points` points (at least order + 1)."""
    nodes, weights = _gauss(section, max(points, order + 1))
    values = [np.broadcast_to(evaluate(polynomial(section, n), {zeta: nodes}), nodes.shape) for n in range(order + 1)]
    project = [weights * value / float(mean_square(section, n)) for n, value in enumerate(values)]
    return SectionRule(nodes, weights, np.array(values).T, np.array(project))


def _gauss(section: Section, points: int) -> tuple[Floats, Floats]:
    """Nodes and weights for the width of the section: Legendre's, or Chebyshev's of the second kind for a circle."""
    if section.name == "circle":
        angle = np.arange(points, 0, -1) * np.pi / (points + 1)
        return np.cos(angle), 2 / (points + 1) * np.sin(angle) ** 2
    nodes, weights = np.polynomial.legendre.leggauss(points)
    return nodes, weights / 2
