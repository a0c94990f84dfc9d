"""C text from a Graph: the filament's own solver, and CasADi's for any graph."""
