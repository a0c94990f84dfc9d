"""Nonlinear least squares: optimum, what is known, and how well; no filament is needed."""
