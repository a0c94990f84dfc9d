"""One cell's equations become the system of a whole filament, printed from SymPy to CasADi."""
