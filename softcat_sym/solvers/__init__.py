"""Solvers: time integration and equilibria of a Graph, with an Outcome."""
