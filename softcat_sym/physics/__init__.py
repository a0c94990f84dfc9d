"""The mathematics of a soft filament in SymPy: one cross-section, one cell, one node; no numbers, no grid."""
