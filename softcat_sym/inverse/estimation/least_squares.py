"""A nonlinear least-squares problem in bounded, scaled unknowns, and the loss that its residuals are charged."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError

Floats = NDArray[np.float64]


class LeastSquares(Protocol):
    """What can be fitted: residuals of m data in k unknowns q.

    An unknown is the logarithm of a positive parameter over its typical value, or a parameter of any sign over its
    typical value: a step of one is a large one in every unknown.
    """

    @property
    def names(self) -> tuple[str, ...]:
        """The k unknowns."""

    @property
    def lower(self) -> Floats:
        """Least possible q, shape (k,), finite."""

    @property
    def upper(self) -> Floats:
        """Largest possible q, shape (k,), finite."""

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error, shape (m,); NaN where the model has no answer."""

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives with respect to q, shape (m, k)."""


def has_answer(problem: LeastSquares, q: Floats) -> bool:
    """Whether the model has an answer, and derivatives, at q: the cheaper question first."""
    if not np.isfinite(problem.residuals(q)).all():
        return False
    return all(bool(np.isfinite(part).all()) for part in problem.linearised(q))


@dataclass(frozen=True)
class Loss:
    """rho in the sum 1/2 sum rho(r^2) that is minimised, with z = (r/scale)^2.

    ``"linear"``: rho = r^2. ``"soft-l1"``: rho = 2 scale^2 (sqrt(1 + z) - 1). ``"cauchy"``: rho = scale^2 log(1 + z).
    Outliers beyond `scale` weigh less (Triggs et al. 2000, section 3; the forms are those of SciPy).

    Attributes
    ----------
    kind : str
        One of the three.
    scale : float
        Residual from which on a point counts as an outlier, in the unit of the residuals.

    Raises
    ------
    SoftcatError
        If the kind is unknown or the scale is not positive.
    """

    kind: Literal["linear", "soft-l1", "cauchy"] = "linear"
    scale: float = 1.0

    def __post_init__(self) -> None:
        if self.kind not in ("linear", "soft-l1", "cauchy"):
            raise SoftcatError(f"no loss {self.kind!r}; accepted: linear, soft-l1, cauchy")
        if not 0 < self.scale < math.inf:
            raise SoftcatError(f"the scale of a loss is {self.scale!r}; accepted: a positive number")

    def value(self, residuals: Floats) -> float:
        """1/2 sum rho(r^2)."""
        if self.kind == "linear":
            return 0.5 * float(residuals @ residuals)
        z = (residuals / self.scale) ** 2
        # Without the difference of nearly equal numbers that small residuals would make.
        rho = 2 * z / (np.sqrt(1 + z) + 1) if self.kind == "soft-l1" else np.log1p(z)
        return 0.5 * self.scale**2 * float(rho.sum())

    def weights(self, residuals: Floats) -> Floats:
        """Weight rho'(r^2) of each squared residual in the gradient, shape (m,), at most one."""
        z = (residuals / self.scale) ** 2
        return {"linear": np.ones_like(z), "soft-l1": 1 / np.sqrt(1 + z), "cauchy": 1 / (1 + z)}[self.kind]

    def slopes(self, residuals: Floats) -> Floats:
        """Derivative rho' + 2 r^2 rho'' of psi(r) = rho'(r^2) r, shape (m,); of Cauchy's outliers negative."""
        z = (residuals / self.scale) ** 2
        if self.kind == "cauchy":
            return np.asarray((1 - z) / (1 + z) ** 2, dtype=np.float64)
        return np.asarray((1 + z) ** -1.5 if self.kind == "soft-l1" else np.ones_like(z), dtype=np.float64)

    def curvatures(self, residuals: Floats) -> Floats:
        """Weight of each squared derivative in the Gauss-Newton Hessian, shape (m,).

        The slopes of psi, cut at zero where the loss of an outlier curves downwards and would make the Hessian
        indefinite.
        """
        return np.maximum(self.slopes(residuals), 0.0)


LINEAR = Loss()


@dataclass(frozen=True, eq=False)
class Fixed:
    """A problem with one unknown held at a value.

    Attributes
    ----------
    whole : LeastSquares
        The problem.
    index : int
        Which unknown is held.
    at : float
        Its q.
    """

    whole: LeastSquares
    index: int
    at: float

    @property
    def names(self) -> tuple[str, ...]:
        """The other unknowns."""
        return tuple(name for k, name in enumerate(self.whole.names) if k != self.index)

    @property
    def lower(self) -> Floats:
        """Least possible q of the others."""
        return np.delete(self.whole.lower, self.index)

    @property
    def upper(self) -> Floats:
        """Largest possible q of the others."""
        return np.delete(self.whole.upper, self.index)

    def filled(self, q: Floats) -> Floats:
        """All unknowns, shape (k,), from the others, shape (k - 1,)."""
        return np.insert(q, self.index, self.at)

    def residuals(self, q: Floats) -> Floats:
        """As of the whole problem."""
        return self.whole.residuals(self.filled(q))

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """As of the whole problem, without the column of the unknown that is held."""
        residuals, jacobian = self.whole.linearised(self.filled(q))
        return residuals, np.delete(jacobian, self.index, axis=1)
