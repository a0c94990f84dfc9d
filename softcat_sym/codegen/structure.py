"""What the C text of a filament depends on: its equations, ends and supports, but no number and not the grid."""

from __future__ import annotations

import hashlib
import secrets
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import lru_cache
from types import FunctionType

from softcat_sym.codegen.kept_model import template_kept
from softcat_sym.codegen.model_text import Model, Template, template_of
from softcat_sym.codegen.recording import record
from softcat_sym.effects import Effects
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph import End, Graph
from softcat_sym.graph.body import Body
from softcat_sym.graph.discretisation import Discretisation
from softcat_sym.scene import Scene

_PROCESS = secrets.token_hex()


@dataclass(frozen=True)
class Structure:
    """All filaments that share a C text.

    Attributes
    ----------
    key : str
        Hash of all that the text depends on but the program and the fibres.
    rule : str
        Where the fibres are; empty without. Two structures are equal if these two are.
    effects : tuple of str
        Names of the effects in force.
    equations, theory, ends, body
        What the filament is recorded from.
    """

    key: str
    rule: str
    effects: tuple[str, ...]
    equations: FilamentEquations = field(compare=False)
    theory: Discretisation = field(compare=False)
    ends: tuple[End, End] = field(compare=False)
    body: Body = field(compare=False)

    @property
    def area_power(self) -> int:
        """With which the area of the section goes with its thickness."""
        return self.equations.shape.area_power


def structure_of(
    scene: Scene, effects: Effects, graph: Graph, equations: FilamentEquations, theory: Discretisation, body: Body
) -> Structure:
    """The structure of a scene's filament.

    Parameters
    ----------
    scene, effects
        What is asked, and the physics in force.
    graph, equations, theory, body
        What it became.
    """
    ends, fibres = (graph.grid.first, graph.grid.last), theory.fibres
    parts: tuple[object, ...] = (
        effects.terms(),
        equations.shape.name,
        scene.run.closure,
        fibres.theory.label if fibres else theory.label,
        tuple(end.name for end in ends),
        body.supports,
        body.profile.nodes is not None,
        body.weighted,
    )
    if effects.terms().shaking != 1:
        parts = (*parts, effects.terms().shaking)
    rule = fibres.rule.label if fibres else ""
    return Structure(_digest(parts), rule, effects.names, equations, theory, ends, body)


def _digest(parts: tuple[object, ...]) -> str:
    """Hash of what parts say of themselves; where that is an address, it means nothing to another process."""
    text = "\n".join(repr(_named(part)) for part in parts)
    return hashlib.sha256(f"{_PROCESS} {text}".encode() if " at 0x" in text else text.encode()).hexdigest()


def _named(part: object) -> object:
    """A part in which functions are called by module and name, where these say which: a closure's do not."""
    if isinstance(part, FunctionType) and "<" not in part.__qualname__:
        return f"{part.__module__}.{part.__qualname__}"
    if isinstance(part, tuple):
        return tuple(_named(one) for one in part)
    if is_dataclass(part) and not isinstance(part, type):
        return type(part).__name__, *((one.name, _named(getattr(part, one.name))) for one in fields(part))
    return part


@lru_cache(maxsize=128)
def model_for(structure: Structure) -> Model:
    """The C text of a structure.

    Raises
    ------
    PrintingError
        If it has none.
    """
    fibres = structure.theory.fibres
    return _template(replace(structure, rule="")).with_fibres(fibres.rule if fibres else None)


@lru_cache(maxsize=128)
def _template(structure: Structure) -> Template:
    """Read once a process, and made once a machine."""

    def made() -> Template:
        return template_of(record(structure.equations, structure.theory, structure.ends, structure.body))

    return template_kept(structure.key, made)
