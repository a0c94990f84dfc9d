"""The mesh of half a filament: lengths, masses, named nodes, and the element it is made of."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element_loop import (
    NODES,
    POINTS,
    Clamp,
    Mesh,
    Strip,
    half_span_supports,
    mass_shares,
    shape_gradients,
    shape_values,
)

GRADED = Strip(Mesh(6, 4, grading=3.0), 0.08)


def quadratic(at: np.ndarray) -> np.ndarray:
    x, y = at.T
    return 2 - x + 3 * y + x * y - 2 * x**2 + y**2 + 0.5 * x**2 * y - x * y**2


def test_shape_functions_hold_every_serendipity_polynomial_and_its_slope() -> None:
    at = np.array([[0.3, -0.7], [-0.9, 0.2], *POINTS])
    x, y = at.T
    nodal = quadratic(NODES)
    assert shape_values(NODES) == pytest.approx(np.eye(8), abs=1e-14)
    assert shape_values(at) @ nodal == pytest.approx(quadratic(at), abs=1e-13)
    slopes = np.einsum("jap,a->jp", shape_gradients(at), nodal)
    assert slopes[0] == pytest.approx(-1 + y - 4 * x + x * y - y**2, abs=1e-13)
    assert slopes[1] == pytest.approx(3 + x + 2 * y + 0.5 * x**2 - 2 * x * y, abs=1e-13)


def test_mass_is_lumped_after_hinton_rock_and_zienkiewicz() -> None:
    assert mass_shares() == pytest.approx([3 / 76] * 4 + [16 / 76] * 4, rel=1e-12)


def test_masses_add_up_to_half_the_filament_about_its_middle() -> None:
    assert GRADED.mass.min() > 0
    assert GRADED.mass.sum() == pytest.approx(0.08 / 2, rel=1e-13)
    assert GRADED.mass @ GRADED.position[:, 1] == pytest.approx(0, abs=1e-17)
    assert Strip(Mesh(6, 4), 0.08).mass @ Strip(Mesh(6, 4), 0.08).position[:, 0] == pytest.approx(0.01, rel=1e-12)


def test_lengths_grow_geometrically_from_the_clamp() -> None:
    lengths = np.diff(Mesh(6, 4, grading=3.0).edges())
    assert lengths.sum() == pytest.approx(0.5, rel=1e-14)
    assert lengths[0] / lengths[-1] == pytest.approx(3.0, rel=1e-12)
    assert lengths[1:] / lengths[:-1] == pytest.approx(3.0 ** (-1 / 5), rel=1e-12)
    assert GRADED.size[:, 0].reshape(6, 4) == pytest.approx(np.tile(lengths[:, None], 4), rel=1e-12)


def test_elements_lie_where_their_nodes_are() -> None:
    corners = GRADED.position[GRADED.corner[:, :4]]
    assert corners.max(axis=1) - corners.min(axis=1) == pytest.approx(GRADED.size, rel=1e-12)
    middle = corners.mean(axis=1)
    expected = middle[:, None] + NODES / 2 * GRADED.size[:, None]
    assert GRADED.position[GRADED.corner] == pytest.approx(expected, abs=1e-15)
    assert GRADED.points == pytest.approx(middle[:, None] + POINTS / 2 * GRADED.size[:, None], abs=1e-15)
    assert len(np.unique(GRADED.corner)) == len(GRADED.position) == 13 * 9 - 24


def test_named_nodes() -> None:
    centre, midspan, face = (GRADED.position[n] for n in (GRADED.centreline, GRADED.midspan, GRADED.face))
    assert np.all(centre[:, 1] == 0)
    assert np.all(np.diff(centre[:, 0]) > 0)
    assert (centre[0, 0], centre[-1, 0]) == (0.0, 0.5)
    assert np.all(midspan[:, 0] == 0)
    assert np.all(face[:, 0] == 0.5)
    assert face[:, 1] == pytest.approx(np.linspace(-0.04, 0.04, 9), abs=1e-16)
    # To the last bit: a face that thins must not lift.
    assert np.all(face[:, 1] == -face[::-1, 1])


def test_supports_hold_symmetry_and_clamp() -> None:
    for clamp, moving in ((Clamp.THINNING, 9), (Clamp.FIXED, 0)):
        supports = half_span_supports(GRADED, clamp)
        assert len(supports.face) == moving
        assert set(np.flatnonzero(supports.held[:, 0])) == {*GRADED.midspan, *GRADED.face}
        assert set(np.flatnonzero(supports.held[:, 1])) == {*GRADED.face}


def test_what_is_no_mesh_is_refused() -> None:
    for values, word in [
        ((0, 4), "along"),
        ((8, 3), "even"),
        ((8, 0), "even"),
        ((8, 2, 0.0), "grading"),
        ((8, 2, np.nan), "grading"),
    ]:
        with pytest.raises(SoftcatError, match=word):
            Mesh(*values)  # type: ignore[arg-type]
