"""SciPy's Radau with a vectorised NumPy right-hand side of the same scheme, told where its Jacobian is zero."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.run import Prepared

# rtol and atol: of those tried, rtol in 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4 and atol/rtol in 1e-3, 1e-2, 1e-1, the pair
# that costs the least with the midpoint of 40 cells within 1e-3 of the converged one.
LOOSEST = {"continual-descent": (1e-2, 1e-4), "arrested-overdamped": (3e-2, 3e-4)}
_NOTHING = 1e-200
_NODE_KINDS = ("x", "y", "u", "v", "a_1")


@dataclass(frozen=True)
class Numbers:
    """A half filament without units, in lengths of L_0 and times of its scale."""

    half_thickness: float
    yield_strain: float
    flow: float
    gravity: float
    ramp: float
    per_cell: Floats
    per_node: Floats
    before: Floats
    behind: Floats
    per_mass: Floats


def numbers_of(nodes: Floats, given: dict[str, float]) -> Numbers:
    """From the node positions X/L_0 and the parameters in SI units, by their names in the scene."""
    length, scale, modulus = given["rest_length"], given["time_scale"], given["youngs_modulus"]
    cell = np.diff(nodes)
    left, right = np.concatenate([[0.0], cell / 2]), np.concatenate([cell / 2, [0.0]])
    node = left + right
    return Numbers(
        half_thickness=given["thickness"] / (2 * length),
        yield_strain=given["yield_stress"] / modulus,
        flow=scale * modulus / given["viscosity"],
        gravity=given["gravity"] * scale**2 / length,
        ramp=given["ramp"] / scale,
        per_cell=1 / cell,
        per_node=1 / node,
        before=left / node,
        behind=right / node,
        per_mass=modulus * scale**2 / (given["density"] * length**2) / node,
    )


def places_of(graph: Graph) -> np.ndarray:
    """Where each state of a graph stands in the blocks x, y, u, v, a_1 (nodes), a_0 (cells), shape (nx,)."""
    cells = graph.grid.cells
    at = np.array(graph.x_where)
    nodes, centres = np.searchsorted(graph.grid.nodes, at - 1e-12), np.searchsorted(graph.grid.centres, at - 1e-12)
    first = {kind: block * (cells + 1) for block, kind in enumerate((*_NODE_KINDS, "a_0"))}
    is_cell = np.array([kind == "a_0" for kind in graph.x_kinds])
    return np.array([first[kind] for kind in graph.x_kinds]) + np.where(is_cell, centres, nodes)


class NumpyFilament:
    """A Bingham half filament, all cells at once, for one state or for many (the last axis is the state).

    The plane of the filament is the complex plane: z = x + i y, so that the force is (Q + i M_X/s) z_X/s. A state is
    z and its rate on nodes (complex, interleaved), a_1 on nodes, a_0 on cells. Cells and nodes go through the flow rule
    in one sweep.
    """

    def __init__(self, numbers: Numbers) -> None:
        self.numbers, self.cells = numbers, len(numbers.per_cell)
        self.size = 6 * (self.cells + 1) - 1

    def start(self, nodes: Floats) -> Floats:
        """Straight, relaxed and at rest, shape (size,)."""
        state = np.zeros(self.size)
        state[: 2 * len(nodes) : 2] = nodes
        return state

    def places(self, of_blocks: npt.NDArray[np.intp]) -> npt.NDArray[np.intp]:
        """Where states stand here, from where they stand in blocks x, y, u, v, a_1, a_0."""
        nodes = np.arange(self.cells + 1)
        pairs = 2 * nodes, 2 * nodes + 1
        firsts = (*pairs, *(pair + 2 * len(nodes) for pair in pairs))
        return np.concatenate([*firsts, np.arange(4 * len(nodes), self.size)])[of_blocks]

    def rates(self, t: float, state: Floats) -> Floats:
        """Rates, shaped as `state`: (size,) or (many, size)."""
        k, n = self.numbers, self.cells
        out = np.empty(state.shape)
        two, four, five = 2 * (n + 1), 4 * (n + 1), 5 * (n + 1)
        out[..., :two] = state[..., two:four]
        z = state[..., :two].view(complex)
        slope = np.ones((*state.shape[:-1], n + 2), complex)
        slope[..., 1:-1] = (z[..., 1:] - z[..., :-1]) * k.per_cell
        turn = slope[..., 1:] * slope[..., :-1].conj()
        theta = np.arctan2(turn.imag, turn.real) * k.per_node
        length = np.abs(slope)
        s = np.empty((*state.shape[:-1], 2 * n + 1))
        s[..., :n] = length[..., 1:-1]
        s[..., n:] = k.before * length[..., :-1] + k.behind * length[..., 1:]
        lever = k.half_thickness / (s * np.sqrt(s))
        S = np.empty((2, *s.shape))
        tension = np.zeros(slope.shape)
        S[0, ..., :n] = np.log(s[..., :n]) - state[..., five:]
        tension[..., 1:-1] = S[0, ..., :n] / s[..., :n]
        S[0, ..., n:] = (k.before * tension[..., :-1] + k.behind * tension[..., 1:]) * s[..., n:]
        S[1, ..., n:] = -lever[..., n:] * theta - state[..., four:five]
        moment = lever[..., n:] * S[1, ..., n:] * (1 / 3)
        S[1, ..., :n] = (moment[..., 1:] + moment[..., :-1]) * 1.5 / lever[..., :n]
        axial = 0.75 * moment * theta / s[..., n:]
        force = np.zeros(slope.shape, complex)
        force.real[..., 1:-1] = tension[..., 1:-1] + axial[..., 1:] + axial[..., :-1]
        force.imag[..., 1:-1] = (moment[..., 1:] - moment[..., :-1]) * k.per_cell / s[..., :n]
        force *= slope / length
        acceleration = out[..., two:four].view(complex)
        np.multiply(force[..., 1:] - force[..., :-1], k.per_mass, out=acceleration)
        acceleration -= 1j * self.gravity(t)
        acceleration[..., 0].real = 0.0
        acceleration[..., -1] = 0.0
        self._flow(S, out[..., five:], out[..., four:five])
        return out

    def _flow(self, S: Floats, mean: Floats, bending: Floats) -> None:
        """Rates of a_0 on cells and a_1 on nodes (2.26, 2.27), without dividing by a stress slope of zero."""
        k, n = self.numbers, self.cells
        a, B = np.abs(S)
        u, w = np.maximum(B + a - k.yield_strain, 0.0), np.maximum(B - a - k.yield_strain, 0.0)
        per = 1 / (B + _NOTHING)
        l, m = np.minimum(u * per, 2.0), w * per  # noqa: E741
        u_c, l_c = u[..., :n], l[..., :n]
        over = l_c * (u_c - 0.5 * B[..., :n] * l_c) - 0.5 * (w * m)[..., :n]
        np.copysign(0.5 * k.flow * over, S[0, ..., :n], out=mean)
        u, w, l, m = u[..., n:], w[..., n:], l[..., n:], m[..., n:]  # noqa: E741
        Bl = B[..., n:] * l
        over = 1.5 * l * (u - 0.5 * Bl - l * (0.5 * u - Bl * (1 / 3))) + w * m * (0.75 - 0.25 * m)
        np.copysign(k.flow * over, S[1, ..., n:], out=bending)

    def gravity(self, t: float) -> float:
        """Quintic smooth step."""
        q = min(max(t / self.numbers.ramp, 0.0), 1.0)
        return self.numbers.gravity * q * q * q * (10 + q * (6 * q - 15))


def pattern_of(filament: NumpyFilament, start: Floats) -> csc_matrix:
    """Where the Jacobian is not zero, found column by column.

    At a state in which every section is bent and yields at both edges but not in the middle: only there does the flow
    of tension depend on the moment and that of bending on the tension.
    """
    flowing = NumpyFilament(replace(filament.numbers, yield_strain=0.02))
    rng = np.random.default_rng(0)
    state = start + rng.uniform(-1e-3, 1e-3, filament.size) / np.max(filament.numbers.per_cell)
    nodes = filament.cells + 1
    state[4 * nodes : 5 * nodes] = rng.uniform(0.05, 0.1, nodes)
    change = flowing.rates(0.0, state + 1e-6 * np.eye(filament.size)) != flowing.rates(0.0, state)
    return csc_matrix(change.T)


class RadauRival:
    """A paper's filament, ready to be solved by SciPy."""

    def __init__(self, prepared: Prepared) -> None:
        nodes = prepared.graph.grid.nodes
        given = dict(zip(prepared.graph.parameters, prepared.p.tolist(), strict=True))
        self._duration = float(prepared.times[-1])
        self.filament = NumpyFilament(numbers_of(nodes, given))
        self.start = self.filament.start(nodes)
        self.pattern = pattern_of(self.filament, self.start)

    def solve(self, rtol: float, atol: float) -> float:
        """Integrate to the end; the midpoint there."""
        found = solve_ivp(
            lambda t, state: self.filament.rates(t, np.ascontiguousarray(state.T)).T,
            (0.0, self._duration),
            self.start,
            method="Radau",
            rtol=rtol,
            atol=atol,
            vectorized=True,
            jac_sparsity=self.pattern,
        )
        if not found.success:
            raise RuntimeError(found.message)
        return float(found.y[1, -1])
