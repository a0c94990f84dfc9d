"""The physics of a filament as C text, named by its structure, and kept between processes."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache

from softcat_sym import cache, store
from softcat_sym.codegen.template import Model, Template
from softcat_sym.discretization.assembly import Theory
from softcat_sym.discretization.grid import End, Grid
from softcat_sym.discretization.supports import Body
from softcat_sym.discretization.unknowns import Shown, Signature, Slot
from softcat_sym.effects.choosing import Effects
from softcat_sym.physics.terms import Formulation


@lru_cache(maxsize=128)
def _recalled(key: str) -> Template:
    """The template of a structure from the cache, read once a process; LookupError if it is not there.

    Another program has others.
    """
    text = store.recall(store.key_of("template", key), cache.TEXTS)
    if text is None:
        raise LookupError(key)
    parts = json.loads(text)
    parts |= {name: tuple(parts[name]) for name in ("powers", "scratch", "scratch_shown")}
    parts["entries"] = tuple((row, column, distance) for row, column, distance in parts["entries"])
    given = parts["signature"]
    given |= {name: tuple(given[name]) for name in ("parameters", "places", "powers")}
    given["slots"] = tuple(Slot(**{**slot, "held": tuple(slot["held"])}) for slot in given["slots"])
    given["shown"] = tuple(Shown(**one) for one in given["shown"])
    given["profiles"] = {name: tuple(parts_of) for name, parts_of in given["profiles"].items()}
    return Template(**{**parts, "signature": Signature(**given)})


@dataclass(frozen=True)
class Structure:
    """All filaments that share a C text."""

    key: str  # Hash of all that the text depends on but the program and the fibres
    rule: str  # Where the fibres are; empty without. Two structures are equal if these two are
    effects: tuple[str, ...]  # Names of the effects in force
    formulation: Formulation = field(compare=False)  # What the filament is recorded from
    theory: Theory = field(compare=False)
    ends: tuple[End, End] = field(compare=False)
    body: Body = field(compare=False)


def structure_of(effects: Effects, grid: Grid, formulation: Formulation, theory: Theory, body: Body) -> Structure:
    """The structure of a filament."""
    ends, fibres, terms = (grid.first, grid.last), theory.fibres, formulation.terms
    key = store.key_of(
        "structure",
        replace(terms, densities=()),
        [one.signature for one in terms.densities],
        formulation.section,
        formulation.closure,
        theory.label,
        [end.name for end in ends],
        body.supports,
        body.profile.nodes is not None,
        body.weighted,
        body.tip_mass,
        body.tip_force,
        body.tip_torque,
        body.natural is not None,
    )
    return Structure(key, fibres.label if fibres else "", effects.names, formulation, theory, ends, body)


def signature_of(structure: Structure) -> Signature | None:
    """What a filament computes, by name; None where its C text is not kept."""
    try:
        return _recalled(structure.key).with_fibres(structure.theory.fibres).signature
    except LookupError:
        return None


@lru_cache(maxsize=128)
def model_for(structure: Structure) -> Model:
    """The C text of a structure, from the cache or else made and kept there."""
    try:
        template = _recalled(structure.key)
    except LookupError:
        template = _made(structure)
        content = json.dumps(asdict(template)).encode()
        store.keep(store.key_of("template", structure.key), content, cache.TEXTS)
    return template.with_fibres(structure.theory.fibres)


def _made(structure: Structure) -> Template:
    # Imported here: what is kept is read without CasADi and SymPy.
    from softcat_sym.codegen.model import template_of
    from softcat_sym.discretization.filament import build
    from softcat_sym.discretization.sampling import one_of
    from softcat_sym.physics.filament import equations_of

    theory = structure.theory
    rule = one_of(theory.fibres) if theory.fibres else theory.rule
    return template_of(build(equations_of(structure.formulation), theory.model, structure.ends, structure.body, rule))
