"""One cell's equations become the system of a whole filament."""

from softcat_sym.graph.assembly import assemble, energy_scale
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import End, Grid, half_span, whole_span

__all__ = ["End", "Graph", "Grid", "assemble", "energy_scale", "half_span", "whole_span"]
