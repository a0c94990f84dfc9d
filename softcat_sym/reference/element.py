"""The eight-node serendipity rectangle with 2 x 2 Gauss points: shape functions, lumped mass, stiffness, stable step.

Reduced integration frees it of shear and volume locking. Its one spurious mode cannot be shared by two elements, so a
mesh of two or more has none (Zienkiewicz & Taylor, "The Finite Element Method", on the 8-node element with 4 points).
Its mass is lumped after Hinton, Rock & Zienkiewicz (Earthquake Eng. Struct. Dyn. 4, 1976): every share is positive.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

# Corners, then the middles of the edges, on the square of edge 2.
NODES: Floats = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]], dtype=np.float64)
_ROOT = 1 / math.sqrt(3)
POINTS: Floats = np.array([[-_ROOT, -_ROOT], [_ROOT, -_ROOT], [-_ROOT, _ROOT], [_ROOT, _ROOT]])

# Powers of the two coordinates in the serendipity space: no xi^2 eta^2.
_POWERS = np.array([[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2], [2, 1], [1, 2]])

# Elements whose frequency is computed: those with the largest sums of squared frequencies.
_CANDIDATES = 16


def shape_values(at: Floats) -> Floats:
    """Shape functions.

    Parameters
    ----------
    at : ndarray, shape (points, 2)
        Places on the square of edge 2.

    Returns
    -------
    ndarray, shape (points, 8)
        Dimensionless; a row sums to 1.
    """
    return _powers(at[:, :1], 0) * _powers(at[:, 1:], 1) @ _coefficients()


def shape_gradients(at: Floats) -> Floats:
    """Derivatives of the shape functions along the two edges.

    Parameters
    ----------
    at : ndarray, shape (points, 2)
        Places on the square of edge 2.

    Returns
    -------
    ndarray, shape (2, 8, points)
        In the coordinates of the square; multiply by 2/edge length.
    """
    x, y = at[:, :1], at[:, 1:]
    along = _slopes(x, 0) * _powers(y, 1) @ _coefficients()
    across = _powers(x, 0) * _slopes(y, 1) @ _coefficients()
    return np.ascontiguousarray(np.stack([along.T, across.T]))


def mass_shares() -> Floats:
    """Share of the element's mass at each node (HRZ): the consistent diagonal, scaled to the whole.

    Returns
    -------
    ndarray, shape (8,)
        3/76 at corners, 16/76 at the middles of edges.
    """
    gauss, weights = np.polynomial.legendre.leggauss(3)
    at = np.array([[x, y] for x in gauss for y in gauss])
    diagonal = np.array([p * q for p in weights for q in weights]) @ shape_values(at) ** 2
    return np.asarray(diagonal / diagonal.sum())


def plane_stress_moduli(poisson: float) -> Floats:
    """Elastic moduli over E in plane stress, for strains 11, 22 and the engineering shear 12; shape (3, 3)."""
    return np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]]) / (1 - poisson**2)


def largest_frequency(size: Floats, poisson: float, deformation: Floats | None = None) -> float:
    """Upper bound of the largest elastic frequency of a mesh: the largest of any of its elements on its own.

    The eigenvalues of assembled elements lie between those of the elements (Irons & Treharne 1971; Fried 1972), and
    supports only lower the largest.

    Parameters
    ----------
    size : ndarray, shape (elements, 2)
        Reference edge lengths over the span.
    poisson : float
        Poisson's ratio.
    deformation : ndarray, shape (elements, points, 2, 2), optional
        Deformation gradients: a strip that thins is stiffer across, seen from its reference shape.

    Returns
    -------
    float
        In sqrt(E/rho)/L.
    """
    gradient = shape_gradients(POINTS).transpose(2, 0, 1)[None] * (2 / size)[:, None, :, None]
    if deformation is not None:
        # Derivatives in space: F^-T times those in the reference shape.
        gradient = np.swapaxes(np.linalg.inv(deformation), -1, -2) @ gradient
    # The sum of all squared frequencies is proportional to this, whatever the isotropic moduli.
    trace = np.einsum("epia,a->e", gradient**2, 1 / mass_shares())
    gradient = gradient[np.argsort(trace)[-_CANDIDATES:]]
    strain = np.zeros((*gradient.shape[:2], 3, 16))
    strain[..., 0, 0::2] = strain[..., 2, 1::2] = gradient[..., 0, :]
    strain[..., 1, 1::2] = strain[..., 2, 0::2] = gradient[..., 1, :]
    # Per mass: the area cancels between stiffness and mass.
    stiffness = np.einsum("epai,ab,epbj->eij", strain, plane_stress_moduli(poisson), strain, optimize=True)
    lightness = np.repeat(mass_shares(), 2) ** -0.5
    values = np.linalg.eigvalsh(stiffness / len(POINTS) * np.outer(lightness, lightness))
    return math.sqrt(float(values.max()))


def _powers(x: Floats, axis: int) -> Floats:
    """Powers of one coordinate in the serendipity monomials; shape (points, 8)."""
    return np.asarray(x ** _POWERS[:, axis])


def _slopes(x: Floats, axis: int) -> Floats:
    """Derivatives of :func:`_powers`."""
    powers = _POWERS[:, axis]
    return np.asarray(powers * x ** np.maximum(powers - 1, 0))


@cache
def _coefficients() -> Floats:
    """Coefficients of the monomials, a column for each shape function: 1 at its node, 0 at the others."""
    return np.asarray(np.linalg.inv(_powers(NODES[:, :1], 0) * _powers(NODES[:, 1:], 1)), dtype=np.float64)
