"""From a structure to a model that runs: C text, compiler, library."""

from __future__ import annotations

from functools import lru_cache, partial

from softcat_sym.codegen.sites import places_of, sites_of
from softcat_sym.codegen.structure import Structure, model_for
from softcat_sym.graph import Graph
from softcat_sym.solve.c_model import CModel
from softcat_sym.solve.compiled import CompiledFilament


def compile_filament(graph: Graph, structure: Structure) -> CompiledFilament:
    """The compiled form of a filament, from the cache if it has been compiled before.

    Raises
    ------
    SoftcatError
        If the compiler refuses; with its message.
    """
    compiled = compiled_model(structure)
    model = compiled.model
    places = places_of(graph, structure.body, structure.area_power, model.places)
    return CompiledFilament(compiled, sites_of(graph, model.slots), places)


@lru_cache(maxsize=128)
def compiled_model(structure: Structure) -> CModel:
    """The library of a structure, loaded once a process."""
    return CModel(partial(model_for, structure))
