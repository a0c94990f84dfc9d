"""SymPy expressions become CasADi graphs, or numbers."""

from softcat_sym.printing.casadi_printer import CellFunction
from softcat_sym.printing.numbers import evaluate

__all__ = ["CellFunction", "evaluate"]
