"""The generated C of a scene's filament beside the interpreted graph of the same filament."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from softcat_sym.codegen.c_model import Model, model_for
from softcat_sym.codegen.sites import Sites, places_in_rows, sites_of
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.initial_state import starting_state
from softcat_sym.solvers.solution import Start
from softcat_sym.solvers.solve import assembled
from tests.common.c_values import CModel, Values

AMPLITUDES = {"x": 0.002, "y": 0.05, "u": 0.1, "v": 0.1, "psi": 0.05, "omega": 0.1}
"""Of states beside the straight filament, in rest lengths and time scales; strains move by a thousandth."""
STRAIN = 1e-3


@dataclass(frozen=True)
class Pair:
    """A graph and the C of its structure."""

    graph: Graph
    model: Model
    p: Floats
    places: Floats
    sites: Sites
    start: Start

    @cached_property
    def compiled(self) -> CModel:
        """The text as machine code."""
        return CModel(self.model.text)

    def in_c(self, t: float, x: Floats, z: Floats) -> Values:
        """What the C says; unknowns are the graph's x, then z."""
        found = self.compiled.at(t, self.sites.state(x, z), self.p, self.places)
        every = np.concatenate([self.sites.x, self.sites.z])
        return Values(found.rates[every], found.jacobian[np.ix_(every, every)], found.powers, found.slopes[:, every])

    def interpreted(self, t: float, x: Floats, z: Floats) -> Values:
        """What the graph says."""
        rates, jacobian, powers, slopes = (np.asarray(one) for one in self._function(t, x, z, self.p))
        return Values(rates.ravel(), jacobian, powers.ravel(), slopes)

    @cached_property
    def _function(self) -> ca.Function:
        of = self.graph.symbolic
        rates, unknowns = ca.vertcat(of.ode, of.alg), ca.vertcat(of.x, of.z)
        outputs = [rates, ca.jacobian(rates, unknowns), of.quad, ca.jacobian(of.quad, unknowns)]
        return ca.Function("interpreted", of.inputs, outputs)

    def state(self, seed: int) -> tuple[float, Floats, Floats]:
        """A time and an admissible state: from rest smoothly bent, stretched and set in motion, with a little noise."""
        of, rng = self.graph, np.random.default_rng(seed)
        found = []
        for start, layout in ((self.start.x, of.differential), (self.start.z, of.algebraic)):
            at, size = layout.where, np.array([AMPLITUDES.get(kind, STRAIN) for kind in layout.kinds])
            bent = size * np.cos(3 * at + rng.uniform(0, 3)) * (1 - 4 * at**2) if len(layout) else np.zeros(0)
            found.append(start + bent + rng.normal(size=len(layout)) * 1e-4 / of.grid.cells)
        return float(rng.uniform(0.2, 3)), found[0], found[1]


def pair_of(scene: Scene) -> Pair:
    """Assemble a scene's filament, and make its C."""
    filament = assembled(scene, choose_effects(scene))
    graph, model = filament.graph, model_for(filament.structure)
    p = np.ascontiguousarray(graph.vector(parameter_values(scene)))
    start = starting_state(scene, graph, p, filament.at_rest) or Start(graph.start, graph.straight)
    return Pair(graph, model, p, places_in_rows(graph), sites_of(graph, model.slots), start)


def differences(pair: Pair, seeds: range, other: Pair | None = None) -> dict[str, float]:
    """Largest difference of each result, over the largest value of its kind of unknown."""
    in_c, kinds = (other or pair).in_c, np.array((*pair.graph.differential.kinds, *pair.graph.algebraic.kinds))
    worst = dict.fromkeys(("rates", "jacobian", "powers", "slopes"), 0.0)
    for seed in seeds:
        at = pair.state(seed)
        found, wanted = in_c(*at), pair.interpreted(*at)
        for name in worst:
            one, exact = getattr(found, name), getattr(wanted, name)
            assert np.all(np.isfinite(exact)), f"{name} of a state that is not admissible"
            assert np.all(np.isfinite(one)), name
            groups = [kinds == kind for kind in dict.fromkeys(kinds)]
            rows = groups if name in ("rates", "jacobian") else [np.arange(len(one)) == k for k in range(len(one))]
            scales = [float(np.max(np.abs(exact[row]))) or 1.0 for row in rows]
            largest = [float(np.max(np.abs(one[row] - exact[row]))) for row in rows]
            worst[name] = max(worst[name], *np.divide(largest, scales))
    return worst
