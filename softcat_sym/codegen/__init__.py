"""C from a Graph: the filament's own solver as C99, compiled once and kept in a cache; and CasADi's C for any graph."""
