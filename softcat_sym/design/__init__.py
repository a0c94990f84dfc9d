"""Experiments designed before they are made: what to film, and how far a filament may span."""
