"""One cell's equations become the system of a whole filament."""

from softcat_sym.graph.assembly import assemble
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import End, Grid, half_span, whole_span
from softcat_sym.graph.instant import energy_scale

__all__ = ["End", "Graph", "Grid", "assemble", "energy_scale", "half_span", "whole_span"]
