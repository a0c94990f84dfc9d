"""Evaluations of a forward model that outlive an interruption."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from softcat_sym.inverse.forward.frozen_filament import FrozenFilament
from softcat_sym.solve.keeping import Arrays, Form, kept, packed, unpacked
from softcat_sym.solve.starting import Start

_FORM: Form[Arrays] = Form(packed, unpacked)
_X, _Z = "start x", "start z"


class KeptEvaluations:
    """Each evaluation with where it left the filament: the start of the next is followed from there.

    Parameters
    ----------
    filament : FrozenFilament
        That is evaluated.
    texts : tuple of str
        All that decides its numbers but the unknowns.
    """

    def __init__(self, filament: FrozenFilament, texts: tuple[str, ...]) -> None:
        self._filament, self._texts = filament, texts
        self._first = filament.near

    def of(self, what: tuple[str | bytes, ...], compute: Callable[[], Arrays]) -> Arrays:
        """Return an evaluation, from where it is kept if it is.

        Parameters
        ----------
        what : tuple of str or bytes
            Which evaluation.
        compute : callable
            What makes it.
        """

        def evaluated() -> Arrays:
            arrays, near = compute(), self._filament.near
            return arrays if near is None else {**arrays, _X: near.x, _Z: near.z}

        found = kept(lambda: ("evaluation", *self._texts, *what), evaluated, _FORM)
        self._filament.near = Start(np.asarray(found[_X]), np.asarray(found[_Z])) if _X in found else None
        return found

    def aside(self, compute: Callable[[], int]) -> int:
        """Compute something from where the filament was at first, whatever was evaluated since, and leave no trace."""
        near, self._filament.near = self._filament.near, self._first
        try:
            return compute()
        finally:
            self._filament.near = near
