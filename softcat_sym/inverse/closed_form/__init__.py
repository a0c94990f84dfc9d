"""Modulus and viscosity from what a film shows, without running a model."""
