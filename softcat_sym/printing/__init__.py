"""SymPy expressions become CasADi graphs."""

from softcat_sym.printing.casadi_printer import CellFunction

__all__ = ["CellFunction"]
