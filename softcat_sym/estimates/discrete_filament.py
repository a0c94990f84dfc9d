"""A filament of elastic elements: its shape under load, and its small vibrations about that shape.

Beams of two nodes in space whose angles are small in the frame of their chord (Battini & Pacoste 2002): the nodes may
go and turn anywhere. NumPy solves the equations, as SciPy would take longer to load than the solution takes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

_STEPS = 300
_EXACT = 1e-6
_NEAR, _FARTHEST = 0.03, 0.5
"""Turns of a node in a step [rad], and its displacements over the length."""
_LEAST, _NOISE, _FIRMER = 1e-15, 1e-11, 10.0
"""Shifts of the stiffness over the largest, the first and the most that rounding may need, and the ratio of one to the
next."""

_ROUNDED = 1e-5
"""Of the shift: what rounding leaves of it, a hundred times as much as was seen."""

_SOFT = 1e-9
"""Of the torsional stiffness of an element."""

_ALONG, _UP, _ASIDE, _TWIST = (np.array(places) for places in ([0, 6], [1, 5, 7, 11], [2, 4, 8, 10], [3, 9]))
"""What the nodes of an element do along it, in the plane of its bending, across that, and about it."""
_LINE = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6
_BEAM = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) / 420
_LONGER = np.zeros((6, 6))
_LONGER[1::3, 1::3] = _LONGER[2::3, 2::3] = np.array([[4.0, -1.0], [-1.0, 4.0]]) / 30
"""Slopes within an element lengthen it by half of a.LONGER.a, of its angles a."""


@dataclass(frozen=True)
class Configuration:
    """Places of the nodes and turns of their sections."""

    places: Floats  # shape (nodes, 3); [m]
    turns: Floats  # shape (nodes, 3, 3); Columns are the tangent, the normal in the plane of bending, the binormal

    def moved(self, step: Floats, closing: Floats) -> Configuration:
        """The shape after displacements and turns, shape (nodes, 6).

        What an element moves across itself turns it, as its nodes do about it, and does not lengthen it; by a share of
        what its last node would then miss each node is moved.
        """
        chord, moved = np.diff(self.places, axis=0), np.diff(step[:, :3], axis=0)
        square = np.sum(chord**2, axis=1, keepdims=True)
        twisted = np.sum(chord * (step[:-1, 3:] + step[1:, 3:]), axis=1, keepdims=True) / 2
        turned = turns_by((np.cross(chord, moved) + twisted * chord) / square) @ chord[..., None]
        longer = 1 + np.sum(chord * moved, axis=1, keepdims=True) / square
        places = np.vstack([self.places[:1] + step[:1, :3], longer * turned[..., 0]]).cumsum(axis=0)
        missed = self.places[-1] + step[-1, :3] - places[-1]
        return Configuration(places + closing[:, None] * missed, turns_by(step[:, 3:]) @ self.turns)

    def seen_from(self, other: Configuration) -> Floats:
        """Displacements and turns that lead from another shape to this one, shape (nodes, 6)."""
        return np.hstack([self.places - other.places, _vectors(self.turns @ other.turns.swapaxes(1, 2))])


@dataclass(frozen=True)
class Elements:
    """What is the same in every shape [SI]; n elements between n + 1 nodes."""

    length: Floats  # shape (n,); Of the reference configuration, to which the undeformed section belongs
    relaxed: Floats  # shape (n,); True strain without stress
    axial: Floats  # shape (n,); E A
    pull: Floats  # shape (n,); Axial force of the surface, times the stretch to a power
    pull_power: float
    bending: Floats  # shape (n, 6, 6); Stiffness of the angles at both ends
    natural: Floats  # shape (n, 6); Angles without stress
    mass: Floats  # shape (n,)
    mass_across: Floats  # shape (n,); The same of what moves across its tangent, with the fluid around it
    inertia: Floats  # shape (n,); Of a turn about its length [kg m^2]
    attached: Floats  # shape (n + 1,); Masses on the nodes
    force: Floats  # shape (n + 1, 6); Dead forces and torques
    springs: Floats  # shape (n + 1, 6); Stiffness of what holds the nodes, which is without force in the first shape
    first: Configuration
    closing: Floats  # shape (n + 1,); See :meth:`Configuration.moved`
    free: npt.NDArray[np.int_]  # Numbers of the displacements and turns that nothing holds

    def at_rest(self, shape: Configuration, load: float) -> Configuration | None:
        """The stable equilibrium under a share of the load; None if there is none, or none is found.

        Newton's method, with a part of the mass matrix added where the stiffness is not positive. Forces that turn are
        foreseen by the step before: as a thin filament is much stiffer along itself, those of a shape that is not yet
        in balance are far too large (Magisano, Leonetti & Garcea 2017).
        """
        cells, shift = DeformedElements.of(self, shape), 0.0
        mass, units = self.mass_matrix(cells), np.repeat([float(np.sum(self.length)), 1.0], 3)
        for _ in range(_STEPS):
            firm = self.stiffness(cells) + shift * mass
            largest = _largest_ratio(firm, mass)
            pulled = (self.springs * shape.seen_from(self.first)).flat[self.free]
            missing = load * self.force.flat[self.free] - self._assembled(cells.forces) - pulled
            step = np.zeros(self.force.shape)
            try:
                np.linalg.cholesky(firm)
                step.flat[self.free] = np.linalg.solve(firm, missing)
            except np.linalg.LinAlgError:
                shift = max(_FIRMER * shift, _LEAST * largest)
                continue
            far = float(np.max(np.abs(step) / units))
            stable = shift <= _NOISE * largest
            if far < _EXACT and not stable:
                # What is symmetric does not leave an unstable equilibrium by itself.
                step.flat[self.free] = np.linalg.eigh(firm)[1][:, 0]
                step *= _NEAR / float(np.max(np.abs(step) / units))
            shape = shape.moved(step * min(1.0, _FARTHEST / max(far, _FARTHEST)), self.closing)
            if far < _EXACT and stable:
                return shape
            if not np.all(np.isfinite(shape.places)):
                return None
            cells = DeformedElements.of(self, shape, cells.foreseen(step))
            shift /= _FIRMER ** (3 if _EXACT <= far < _NEAR else 1)
            shift = shift if shift > _LEAST * largest else 0.0
        return None

    def is_strained(self, shape: Configuration) -> bool:
        """Whether a shape would move without load."""
        forces = DeformedElements.of(self, shape).forces
        return float(np.max(np.abs(self._assembled(forces)))) > _EXACT * float(np.max(np.abs(forces)))

    def vibrations(self, cells: DeformedElements) -> tuple[Floats, Floats, Floats, Floats]:
        """Squares of the natural frequencies about a stable equilibrium, from the lowest on, and their modes.

        Returns
        -------
        squares : ndarray, shape (free,)
            [1/s^2]; zero for what turns freely.
        modes : ndarray, shape (free, free)
            In columns, each of unit modal mass.
        strained : ndarray, shape (free,)
            Share of straining in these squares, besides that of forces that turn [1/s^2].
        mass : ndarray, shape (free, free)
        """
        mass, firm = self.mass_matrix(cells), self.stiffness(cells)
        # By the inverse of the stiffness the lowest frequencies are exact, and not the highest.
        shift = _NOISE * _largest_ratio(firm, mass)
        root = np.linalg.inv(np.linalg.cholesky(firm + shift * mass))
        inverse, vectors = np.linalg.eigh(root @ mass @ root.T)
        squares, modes = 1 / inverse[::-1] - shift, (root.T @ vectors / np.sqrt(inverse))[:, ::-1]
        squares[np.abs(squares) < _ROUNDED * shift] = 0.0
        return squares, modes, np.sum(modes * (self.stiffness(cells, by_strain=True) @ modes), axis=0), mass

    def stiffness(self, cells: DeformedElements, *, by_strain: bool = False) -> Floats:
        """Tangent stiffness of what is free; by strain alone it leaves out that of forces as they turn."""
        if by_strain:
            return self._assembled(cells.straining)
        return self._assembled(cells.straining + cells.turning) + np.diag(self.springs.flat[self.free])

    def mass_matrix(self, cells: DeformedElements) -> Floats:
        """Mass matrix of what is free."""
        local, one = np.zeros((len(self.mass), 12, 12)), np.ones_like(cells.length)
        lever = np.stack([one, cells.length, one, cells.length], axis=1)
        beam = self.mass_across[:, None, None] * _BEAM * lever[:, :, None] * lever[:, None, :]
        local[:, _ALONG[:, None], _ALONG] = self.mass[:, None, None] * _LINE
        local[:, _TWIST[:, None], _TWIST] = self.inertia[:, None, None] * _LINE
        local[:, _UP[:, None], _UP] = beam
        local[:, _ASIDE[:, None], _ASIDE] = beam * np.outer([1, -1, 1, -1], [1, -1, 1, -1])
        held = np.outer(self.attached, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]).ravel()[self.free]
        return self._assembled(cells.spread @ local @ cells.spread.swapaxes(1, 2)) + np.diag(held)

    def _assembled(self, parts: Floats) -> Floats:
        """Sums over what is free of what belongs to the nodes of each element, shape (n, 12) or (n, 12, 12)."""
        # What is held is summed in a last row, which is left out.
        size = len(self.free) + 1
        number = np.full(self.force.size, size - 1)
        number[self.free] = np.arange(size - 1)
        rows = np.hstack([number.reshape(-1, 6)[:-1], number.reshape(-1, 6)[1:]])
        if parts.ndim == 2:
            return np.asarray(np.bincount(rows.ravel(), parts.ravel(), size), dtype=np.float64)[:-1]
        places = rows[:, :, None] * size + rows[:, None, :]
        total = np.asarray(np.bincount(places.ravel(), parts.ravel(), size * size), dtype=np.float64)
        return total.reshape(size, size)[:-1, :-1]


@dataclass(frozen=True)
class DeformedElements:
    """Elements of a shape."""

    length: Floats  # shape (n,); Of the chord
    spread: Floats  # shape (n, 12, 12); From the frames of the chords
    forces: Floats  # shape (n, 12); On displacements and turns of both nodes
    straining: Floats  # shape (n, 12, 12); Stiffness by strain, and by forces that turn
    turning: Floats
    stress: Floats  # shape (n,); Axial force times the length at rest, and its change by displacements and turns
    hardening: Floats  # shape (n, 12)

    @classmethod
    def of(cls, own: Elements, shape: Configuration, foreseen: Floats | None = None) -> DeformedElements:
        """Derivatives of the stored energy, by length and angles of each element, and by what its nodes do."""
        frame, length, angles, normals = _frames(shape)
        longer = angles @ _LONGER
        strain = np.log(length / own.length) + np.sum(angles * longer, axis=1) / 2
        surface = own.pull * np.exp(own.pull_power * strain)
        stress = own.length * (own.axial * (strain - own.relaxed) + surface)
        moment = (own.bending @ (angles - own.natural)[..., None])[..., 0]
        slope = np.hstack([1 / length[:, None], longer])
        spread = np.zeros((len(length), 12, 12))
        for n in range(0, 12, 3):
            spread[:, n : n + 3, n : n + 3] = frame
        moves, spins = (part @ spread.swapaxes(1, 2) for part in _moves(length, angles, normals))
        back = moves.swapaxes(1, 2)

        def forces(stress: Floats) -> Floats:
            first = stress[:, None] * slope
            first[:, 1:] += moment
            return np.asarray((back @ first[..., None])[..., 0])

        stiff = own.length * (own.axial + own.pull_power * surface)
        second = stiff[:, None, None] * slope[:, :, None] * slope[:, None, :]
        second[:, 1:, 1:] += own.bending
        turned = stress if foreseen is None else foreseen
        taut = np.zeros_like(second)
        taut[:, 0, 0] = -turned / length**2
        taut[:, 1:, 1:] = turned[:, None, None] * _LONGER
        turning = back @ taut @ moves + _turned(forces(turned), frame[:, :, 0], length, moves, frame @ spins)
        hardening = stiff[:, None] * (slope[:, None, :] @ moves)[:, 0]
        # Between pins a straight filament turns freely about itself: so soft a spring is seen nowhere else.
        about = spread[:, :, 3::6]
        soft = (_SOFT * own.bending[:, 0, 0])[:, None, None] * about @ about.swapaxes(1, 2)
        return cls(length, spread, forces(stress), back @ second @ moves + soft, turning, stress, hardening)

    def foreseen(self, step: Floats) -> Floats:
        """What the axial forces would be after a step, if they were linear in it, shape (n,)."""
        return np.asarray(self.stress + np.sum(self.hardening * np.hstack([step[:-1], step[1:]]), axis=1))


def _largest_ratio(stiffness: Floats, mass: Floats) -> float:
    return float(np.max(np.diag(stiffness) / np.diag(mass)))


def angles_in(shape: Configuration) -> tuple[Floats, Floats]:
    """Lengths of the chords, and the angles between them and their nodes."""
    _, length, angles, _ = _frames(shape)
    return length, angles


def unstrained(length: Floats, angles: Floats) -> Floats:
    """Lengths of elements without strain whose chord and angles are these."""
    return np.asarray(length * np.exp(np.sum(angles @ _LONGER * angles, axis=1) / 2))


def stiffness_of_angles(length: Floats, in_plane: Floats, across: Floats, torsion: Floats, shear: Floats) -> Floats:
    """Stiffness of the angles at both ends, shape (n, 6, 6), by E I about both axes, G J and kappa G A (Timoshenko)."""
    found = np.zeros((len(length), 6, 6))
    found[:, 0::3, 0::3] = (torsion / length)[:, None, None] * np.array([[1.0, -1.0], [-1.0, 1.0]])
    for axis, bent in ((1, across), (2, in_plane)):
        weak = 12 * bent / (shear * length**2)
        own, other = (4 + weak) / (1 + weak) * bent / length, (2 - weak) / (1 + weak) * bent / length
        found[:, axis::3, axis::3] = np.stack([own, other, other, own], axis=1).reshape(-1, 2, 2)
    return found


def _frames(shape: Configuration) -> tuple[Floats, Floats, Floats, Floats]:
    """Frames, lengths, angles of both nodes, and both normals in the frame, shape (n, 3, 2)."""
    first, last, chord = shape.turns[:-1], shape.turns[1:], shape.places[1:] - shape.places[:-1]
    length = np.sqrt(np.sum(chord**2, axis=1))
    along = chord / length[:, None]
    aside = (_skew(along) @ (first[:, :, 1:2] + last[:, :, 1:2]))[..., 0]
    aside /= np.sqrt(np.sum(aside**2, axis=1))[:, None]
    upright = (_skew(aside) @ along[..., None])[..., 0]
    back = np.stack([along, upright, aside], axis=1)
    first, last = back @ first, back @ last
    angles = np.hstack([_vectors(first), _vectors(last)])
    return back.swapaxes(1, 2), length, angles, np.stack([first[:, :, 1], last[:, :, 1]], axis=2)


def _moves(length: Floats, angles: Floats, normals: Floats) -> tuple[Floats, Floats]:
    """What displacements and turns of the nodes, in the frame, do to length and angles, and how they turn the frame."""
    spins, moves = np.zeros((len(length), 3, 12)), np.zeros((len(length), 7, 12))
    # About its tangent the frame turns as the normals do.
    normals = normals / np.sum(normals[:, 1:2], axis=2, keepdims=True)
    spins[:, 0, 2] = np.sum(normals[:, 0], axis=1) / length
    spins[:, 1, 2], spins[:, 2, 1] = 1 / length, -1 / length
    spins[:, :, 6:9] = -spins[:, :, :3]
    spins[:, 0, 3::6], spins[:, 0, 4::6] = normals[:, 1], -normals[:, 0]
    moves[:, 0, 0], moves[:, 0, 6] = -1.0, 1.0
    for at, n in ((1, 3), (4, 9)):
        moves[:, at : at + 3] = -spins
        moves[:, at : at + 3, n : n + 3] += np.eye(3)
        moves[:, at : at + 3] = _by_spin(angles[:, at - 1 : at + 2]) @ moves[:, at : at + 3]
    return moves, spins


def _turned(forces: Floats, along: Floats, length: Floats, moves: Floats, spins: Floats) -> Floats:
    """Stiffness by forces and moments that turn with the frame; what the angles of a node add is of higher order."""
    turning = np.concatenate([-_skew(forces[:, n : n + 3]) @ spins for n in range(0, 12, 3)], axis=1)
    for n in (0, 6):
        force = forces[:, n : n + 3]
        across = force - np.sum(along * force, axis=1, keepdims=True) * along
        turning[:, n : n + 3] -= across[:, :, None] * moves[:, :1] / length[:, None, None]
    return np.asarray((turning + turning.swapaxes(1, 2)) / 2)


def _skew(vectors: Floats) -> Floats:
    """Matrices of the products of vectors with others."""
    found = np.zeros((len(vectors), 3, 3))
    found[:, [2, 0, 1], [1, 2, 0]] = vectors
    found[:, [1, 2, 0], [2, 0, 1]] = -vectors
    return found


def turns_by(vectors: Floats) -> Floats:
    """Matrices of rotation vectors (Rodrigues)."""
    angle, skew = np.sqrt(np.sum(vectors**2, axis=1))[:, None, None] / np.pi, _skew(vectors)
    return np.asarray(np.eye(3) + np.sinc(angle) * skew + np.sinc(angle / 2) ** 2 / 2 * skew @ skew)


def _vectors(turns: Floats) -> Floats:
    """Rotation vectors of matrices, of less than half a turn."""
    vectors = (turns[:, [2, 0, 1], [1, 2, 0]] - turns[:, [1, 2, 0], [2, 0, 1]]) / 2
    sine = np.sqrt(np.sum(vectors**2, axis=1))
    angle = np.arctan2(sine, (turns[:, 0, 0] + turns[:, 1, 1] + turns[:, 2, 2] - 1) / 2)
    return np.asarray(vectors * np.divide(angle, sine, out=np.ones_like(sine), where=sine > 0)[:, None])


def _by_spin(vectors: Floats) -> Floats:
    """Change of rotation vectors by small turns that follow."""
    half = np.maximum(np.sqrt(np.sum(vectors**2, axis=1)), 1e-4)[:, None, None] / 2
    skew = _skew(vectors)
    return np.asarray(np.eye(3) - skew / 2 + (1 - half / np.tan(half)) / (4 * half**2) * skew @ skew)
