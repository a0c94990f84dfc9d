"""Every equation of the theory, module by module."""

from __future__ import annotations

import importlib
import pkgutil

import softcat_sym.equations
from softcat_sym.equations.equation import Equation


def all_equations() -> dict[str, tuple[Equation, ...]]:
    """The ``EQUATIONS`` of every module of :mod:`softcat_sym.equations` that has some, by module name below it.

    Importing them all also completes the table of symbols.
    """
    found: dict[str, tuple[Equation, ...]] = {}
    root = f"{softcat_sym.equations.__name__}."
    for module in pkgutil.walk_packages(softcat_sym.equations.__path__, root):
        equations = getattr(importlib.import_module(module.name), "EQUATIONS", None)
        if equations:
            found[module.name.removeprefix(root)] = equations
    return found
