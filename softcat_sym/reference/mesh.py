"""The mesh of half a filament: a strip of rectangles from midspan to the clamp, and what is known of its nodes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element import NODES, POINTS, Floats, mass_shares, shape_values

Indices = npt.NDArray[np.int32]


@dataclass(frozen=True, slots=True)
class Mesh:
    """How many elements, and where they are short.

    Attributes
    ----------
    along : int
        Elements over half the span.
    through : int
        Elements through the thickness; even, so that the centreline runs along nodes.
    grading : float
        Length of the element at midspan over that of the one at the clamp; lengths in between are geometric.
    """

    along: int = 64
    through: int = 4
    grading: float = 1.0

    def __post_init__(self) -> None:
        """Refuse what is no mesh.

        Raises
        ------
        SoftcatError
            Naming the value.
        """
        if self.along < 1:
            raise SoftcatError(f"mesh of {self.along} elements along the half span: take 1 or more")
        if self.through < 2 or self.through % 2:
            raise SoftcatError(f"mesh of {self.through} elements through the thickness: take an even number, 2 or more")
        if not 0 < self.grading < np.inf:
            raise SoftcatError(f"mesh grading of {self.grading}: take a positive number, 1 for equal elements")

    def edges(self) -> Floats:
        """X/L of the element boundaries, from 0 to 1/2; shape (along + 1,)."""
        exponent = np.linspace(0, 1, self.along) if self.along > 1 else np.zeros(1)
        lengths = self.grading**-exponent
        edges = np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum() / 2
        edges[-1] = 0.5
        return np.asarray(edges)


@dataclass(frozen=True)
class Strip:
    """Nodes and elements of half a filament; lengths over the span, mass over density times span^2 times width.

    Parameters
    ----------
    mesh : Mesh
        How many elements.
    thickness : float
        h0/L.
    """

    mesh: Mesh
    thickness: float

    @cached_property
    def _lattice(self) -> Indices:
        """Node at each place of the half-element lattice, -1 in the middles of elements."""
        lattice = np.full((2 * self.mesh.along + 1, 2 * self.mesh.through + 1), -1, dtype=np.int32)
        taken = np.ones(lattice.shape, dtype=bool)
        taken[1::2, 1::2] = False
        lattice[taken] = np.arange(taken.sum())
        return lattice

    @cached_property
    def position(self) -> Floats:
        """Reference positions X, Y; shape (nodes, 2)."""
        edges = self.mesh.edges()
        columns = np.empty(2 * len(edges) - 1)
        columns[::2], columns[1::2] = edges, (edges[1:] + edges[:-1]) / 2
        # Symmetric to the last bit, so that the centreline lies at 0 and a face has no net height.
        rows = self.thickness * np.arange(-self.mesh.through, self.mesh.through + 1) / (2 * self.mesh.through)
        grid = np.stack(np.meshgrid(columns, rows, indexing="ij"), axis=-1)
        return np.ascontiguousarray(grid[self._lattice >= 0])

    @cached_property
    def corner(self) -> Indices:
        """Nodes of each element, in the order of ``element.NODES``; shape (along x through, 8), column by column."""
        i, j = (a.ravel() for a in np.mgrid[: self.mesh.along, : self.mesh.through])
        x, y = (NODES.astype(int) + 1).T
        return np.ascontiguousarray(self._lattice[2 * i[:, None] + x, 2 * j[:, None] + y])

    @cached_property
    def size(self) -> Floats:
        """Edge lengths of each element; shape (elements, 2)."""
        lengths = np.repeat(np.diff(self.mesh.edges()), self.mesh.through)
        return np.stack([lengths, np.full_like(lengths, self.thickness / self.mesh.through)], axis=1)

    @cached_property
    def mass(self) -> Floats:
        """Lumped mass; shape (nodes,)."""
        shares = self.size.prod(axis=1)[:, None] * mass_shares()
        return np.asarray(np.bincount(self.corner.ravel(), weights=shares.ravel()), dtype=np.float64)

    @cached_property
    def centreline(self) -> Indices:
        """Nodes at Y = 0, from midspan to the clamp; shape (2 along + 1,)."""
        return np.ascontiguousarray(self._lattice[:, self.mesh.through])

    @cached_property
    def midspan(self) -> Indices:
        """Nodes in the plane of symmetry, upwards; shape (2 through + 1,)."""
        return np.ascontiguousarray(self._lattice[0])

    @cached_property
    def face(self) -> Indices:
        """Nodes of the clamped face, upwards; shape (2 through + 1,)."""
        return np.ascontiguousarray(self._lattice[-1])

    @cached_property
    def points(self) -> Floats:
        """Reference positions of the Gauss points; shape (elements, 4, 2)."""
        return np.asarray(np.einsum("pa,eai->epi", shape_values(POINTS), self.position[self.corner]))
