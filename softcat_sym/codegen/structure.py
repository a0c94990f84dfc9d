"""The physics of a filament as C text, named by its structure, and kept between processes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache
from typing import TypeVar

from softcat_sym import store
from softcat_sym.codegen import library
from softcat_sym.codegen.c_text import c_array, number
from softcat_sym.discretization.assembly import Theory
from softcat_sym.discretization.grid import End, Grid
from softcat_sym.discretization.point_rule import PointRule
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.supports import Body
from softcat_sym.discretization.unknowns import PER_FIBRE, Shown, Signature, Slot
from softcat_sym.effects.choosing import Effects
from softcat_sym.physics.terms import Formulation


@dataclass(frozen=True)
class Model:
    """What the C texts of a filament amount to."""

    text: str  # The C file of its rates, their derivatives and its powers
    observables: str  # The C file of what a run stores
    signature: Signature  # Whose fields `observables` computes in this order
    powers: tuple[str, ...]  # What is integrated beside the unknowns
    entries: tuple[tuple[str, str, int], ...]  # Row, column and distance of each entry of the Jacobian
    scratch: int  # Doubles per site that `observables` needs

    @property
    def slots(self) -> tuple[Slot, ...]:
        """Unknowns of a site."""
        return self.signature.slots

    @property
    def parameters(self) -> tuple[str, ...]:
        """Numbers that a run is given as a whole."""
        return self.signature.parameters

    @property
    def places(self) -> tuple[str, ...]:
        """Numbers that a run is given for each site."""
        return self.signature.places


Names = TypeVar("Names", Slot, Shown)


@dataclass(frozen=True)
class Template:
    """The C texts of a filament before it is known how many fibres it has; what each has is named with a ``#``."""

    functions: str  # C text of its physics
    observables: str  # and of what a run stores
    signature: Signature  # What each fibre shows comes last
    powers: tuple[str, ...]  # As in :class:`Model`
    entries: tuple[tuple[str, str, int], ...]
    # Doubles per site that either text needs, and per site and fibre.
    scratch: tuple[int, int]
    scratch_shown: tuple[int, int]
    moves: bool  # Whether the physics depends on time

    def with_fibres(self, rule: SectionRule | PointRule | None = None) -> Model:
        """The model with so many fibres; with none where it has no fibres."""
        count = rule.points if rule else 0
        of = self.signature
        slots, shown = _of_fibres(of.slots, count), _of_fibres(of.shown, count)
        zeta = rule.zeta.tolist() if isinstance(rule, SectionRule) else [0.0] * count
        profiles = {
            name.replace(PER_FIBRE, str(k)): (mean, slope * zeta[k] if PER_FIBRE in name else slope)
            for name, (mean, slope) in of.profiles.items()
            for k in range(count if PER_FIBRE in name else 1)
        }
        # As they are numbered at a site: what each fibre has comes last.
        entries = [
            (row.replace(PER_FIBRE, str(k)), column.replace(PER_FIBRE, str(k)), distance)
            for row, column, distance in sorted(self.entries, key=lambda entry: PER_FIBRE in entry[0] + entry[1])
            for k in range(count if PER_FIBRE in row + column else 1)
        ]
        each, each_shown = (one[0] + count * one[1] for one in (self.scratch, self.scratch_shown))
        sizes = {"FIBRES": count, "SLOTS": len(slots), "ENTRIES": len(entries), "SCRATCH": self.scratch[0]}
        shown_sizes = {"FIBRES": count, "SLOTS": len(slots), "SCRATCH": self.scratch_shown[0]}
        parts = [_HEAD, *_constants(rule, sizes), self.functions, _tables(self, slots, entries, each)]
        shown_parts = [f"#include <stddef.h>\n{_HEAD}", *_constants(rule, shown_sizes), self.observables]
        signature = replace(of, slots=slots, shown=shown, profiles=profiles)
        text, observables = ("\n\n".join(one) + "\n" for one in (parts, shown_parts))
        return Model(text, observables, signature, self.powers, tuple(entries), each_shown)


def _of_fibres(named: Sequence[Names], count: int) -> tuple[Names, ...]:
    """What each fibre has by the number of each."""
    return tuple(
        replace(one, name=one.name.replace(PER_FIBRE, str(k)))
        for one in named
        for k in range(count if PER_FIBRE in one.name else 1)
    )


_HEAD = """\
#include <math.h>

#include "softcat_model.h\""""


def _constants(rule: SectionRule | PointRule | None, sizes: Mapping[str, int]) -> list[str]:
    """Numbers of what a site has, and where the fibres are; nothing without fibres."""
    if rule is None:
        return []
    tables = [c_array("double", name, [number(float(one)) for one in values]) for name, values in rule.tables.items()]
    return ["\n".join([*(f"#define {name} {size}" for name, size in sizes.items()), "", rule.heading, *tables])]


def _tables(template: Template, slots: Sequence[Slot], entries: Sequence[tuple[str, str, int]], scratch: int) -> str:
    place = {slot.name: k for k, slot in enumerate(slots)}
    columns = {
        "rate": [place[s.rate] if s.rate else -1 for s in slots],
        "differential": [int(s.differential) for s in slots],
        "held_first": [int(s.where.first > 0) for s in slots],
        "held_last": [int(s.where.behind > 0) for s in slots],
        "row": [place[row] for row, _, _ in entries],
        "offset": [distance for _, _, distance in entries],
        "column": [place[column] for _, column, _ in entries],
    }
    lines = [c_array("int", name, [str(one) for one in numbers]) for name, numbers in columns.items()]
    sections, powers = sum(s.section for s in slots), len(template.powers)
    given = len(template.signature.parameters), len(template.signature.places)
    sizes = (len(slots), sections, *given, scratch, len(entries), powers, int(template.moves))
    functions = ["rates", "jacobian", *(["work", "work_slope"] if powers else ["0", "0"])]
    functions += ["rates_in_time" if template.moves else "0", "work_in_time" if template.moves and powers else "0"]
    lines += [
        "",
        "const softcat_model softcat_filament_model = {",
        f"    {', '.join(map(str, sizes))},",
        "    rate, differential, held_first, held_last, row, offset, column,",
        f"    {', '.join(functions)},",
        "};",
    ]
    return "\n".join(lines)


@lru_cache(maxsize=128)
def _recalled(key: str) -> Template:
    """The template of a structure from the cache, read once a process; LookupError if it is not there.

    Another program has others.
    """
    text = library.recall(store.key_of("template", key))
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
        library.keep(store.key_of("template", structure.key), json.dumps(asdict(template)))
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
