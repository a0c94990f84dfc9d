"""The physics of a filament as C text, named by its structure, and kept between processes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import TypeVar

from pydantic import TypeAdapter

from softcat_sym import cache, store
from softcat_sym.codegen.c_text import c_array, number
from softcat_sym.discretization.graph import Recorded
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.unknowns import PER_FIBRE, Shown, Signature, Slot
from softcat_sym.effects.selection import Effects


@dataclass(frozen=True)
class Model:
    """What the C texts of a filament amount to."""

    template: Template = field(repr=False)
    rule: SectionRule | None  # Where the fibres are; None without
    signature: Signature  # Whose fields `observables` computes in this order
    powers: tuple[str, ...]  # What is integrated beside the unknowns
    entries: tuple[tuple[str, str, int], ...]  # Row, column and distance of each entry of the Jacobian

    @property
    def fibres(self) -> int:
        """Points of a section; 0 where it is not resolved."""
        return self.rule.points if self.rule else 0

    @property
    def points(self) -> list[float]:
        """Where they are, as a softcat_filament has it: all of one table, then all of the next."""
        return [float(one) for values in self.rule.tables.values() for one in values] if self.rule else []

    @property
    def plain_slots(self) -> int:
        """Unknowns of a site that no fibre has by itself; they come first."""
        return sum(PER_FIBRE not in slot.name for slot in self.template.signature.slots)

    @property
    def plain_entries(self) -> int:
        """Entries of the Jacobian likewise."""
        return sum(PER_FIBRE not in row + column for row, column, _ in self.template.entries)

    @property
    def rows(self) -> tuple[int, int]:
        """Fields of `observables`, and how many more each fibre has."""
        each = sum(PER_FIBRE in one.name for one in self.template.signature.shown)
        return len(self.template.signature.shown) - each, each

    @property
    def scratch(self) -> int:
        """Doubles per site that `observables` needs."""
        return _per_site(self.template.scratch_shown, self.fibres)

    @property
    def sizes(self) -> dict[str, int]:
        """Numbers of a softcat_model, in its order."""
        return {
            "slots": len(self.slots),
            "sections": sum(slot.section for slot in self.slots),
            "parameters": len(self.parameters),
            "places": len(self.places),
            "scratch": _per_site(self.template.scratch, self.fibres),
            "entries": len(self.entries),
            "powers": len(self.template.powers),
            "moves_in_time": int(self.template.moves),
        }

    @property
    def columns(self) -> dict[str, list[int]]:
        """Tables of a softcat_model, in its order."""
        place = {slot.name: k for k, slot in enumerate(self.slots)}
        return {
            "rate": [place[s.rate] if s.rate else -1 for s in self.slots],
            "differential": [int(s.differential) for s in self.slots],
            "held_first": [int(s.where.first > 0) for s in self.slots],
            "held_last": [int(s.where.behind > 0) for s in self.slots],
            "row": [place[row] for row, _, _ in self.entries],
            "offset": [distance for _, _, distance in self.entries],
            "column": [place[column] for _, column, _ in self.entries],
        }

    @cached_property
    def text(self) -> str:
        """The C file of the rates, their derivatives and the powers, with the number of fibres in it."""
        sizes = {"FIBRES": self.fibres, "SLOTS": len(self.slots), "ENTRIES": len(self.entries)}
        return self._with_tables(_constants(self.rule, sizes | {"SCRATCH": self.template.scratch[0]}))

    @cached_property
    def text_to_take_away(self) -> str:
        """The same for any number of fibres, with the tables of this one."""
        return self._with_tables(self._given(self.template.scratch))

    def _with_tables(self, head: Sequence[str]) -> str:
        tables = [c_array("int", name, list(map(str, numbers))) for name, numbers in self.columns.items()]
        model = self._model(map(str, self.sizes.values()), self.columns)
        return _joined([_HEAD, *head, self.template.functions, "\n".join([*tables, "", model])])

    @cached_property
    def of_any_fibres(self) -> str:
        """The same C file for any number of fibres, which a run is given with what depends on it."""
        functions, empty = self.template.functions, self._model("0" * len(self.sizes), "0" * len(self.columns))
        return _joined([_HEAD, *self._given(self.template.scratch), functions, empty])

    @cached_property
    def observables(self) -> str:
        """The C file of what a run stores, likewise."""
        head = f"#include <stddef.h>\n{_HEAD}"
        return _joined([head, *self._given(self.template.scratch_shown), self.template.observables])

    def _given(self, scratch: tuple[int, int]) -> list[str]:
        """Numbers of fibres, and where they are, as what a run is given; nothing without fibres."""
        if self.rule is None:
            return []
        lines = ["#define FIBRES (filament->fibres)", f"#define SCRATCH {scratch[0]}"]
        for size, plain, count in (
            ("SLOTS", self.plain_slots, len(self.template.signature.slots)),
            ("ENTRIES", self.plain_entries, len(self.template.entries)),
        ):
            lines.append(f"#define {size} ({plain} + {count - plain} * FIBRES)")
        lines += [f"#define fibre_{name} (filament->points + {k} * FIBRES)" for k, name in enumerate(self.rule.tables)]
        return ["\n".join(lines)]

    def _model(self, sizes: Iterable[str], columns: Iterable[str]) -> str:
        moves, powers = self.template.moves, self.template.powers
        functions = ["rates", "jacobian", *(["work", "work_slope"] if powers else ["0", "0"])]
        functions += ["rates_in_time" if moves else "0", "work_in_time" if moves and powers else "0"]
        rows = "".join(f"    {', '.join(row)},\n" for row in (sizes, columns, functions))
        return f"const softcat_model softcat_filament_model = {{\n{rows}}};"

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

    def with_fibres(self, rule: SectionRule | None = None) -> Model:
        """The model with so many fibres; with none where it has no fibres."""
        count = rule.points if rule else 0
        of = self.signature
        slots, shown = _of_fibres(of.slots, count), _of_fibres(of.shown, count)
        zeta = rule.zeta.tolist() if rule and not rule.is_spatial else [0.0] * count
        profiles = {
            name.replace(PER_FIBRE, str(k)): (mean, slope * zeta[k] if PER_FIBRE in name else slope)
            for name, (mean, slope) in of.profiles.items()
            for k in range(count if PER_FIBRE in name else 1)
        }
        # As they are numbered at a site: what each fibre has comes last.
        entries = tuple(
            (row.replace(PER_FIBRE, str(k)), column.replace(PER_FIBRE, str(k)), distance)
            for row, column, distance in sorted(self.entries, key=lambda entry: PER_FIBRE in entry[0] + entry[1])
            for k in range(count if PER_FIBRE in row + column else 1)
        )
        return Model(self, rule, replace(of, slots=slots, shown=shown, profiles=profiles), self.powers, entries)


def _per_site(scratch: tuple[int, int], fibres: int) -> int:
    return scratch[0] + fibres * scratch[1]


def _joined(parts: Sequence[str]) -> str:
    return "\n\n".join(parts) + "\n"


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


def _constants(rule: SectionRule | None, sizes: Mapping[str, int]) -> list[str]:
    """Numbers of what a site has, and where the fibres are; nothing without fibres."""
    if rule is None:
        return []
    tables = [
        c_array("double", f"fibre_{name}", [number(float(one)) for one in values])
        for name, values in rule.tables.items()
    ]
    return ["\n".join([*(f"#define {name} {size}" for name, size in sizes.items()), "", rule.heading, *tables])]


@lru_cache(maxsize=128)
def _recalled(key: str) -> Template:
    """The template of a structure from the cache, read once a process; LookupError if it is not there.

    Another program has others.
    """
    text = store.recall(store.key_of("template", key), cache.TEXTS)
    if text is None:
        raise LookupError(key)
    return _form().validate_json(text)


@lru_cache(maxsize=1)
def _form() -> TypeAdapter[Template]:
    return TypeAdapter(Template)


@dataclass(frozen=True)
class Structure:
    """All filaments that share a C text."""

    key: str  # Hash of all that the text depends on but the program and the fibres
    rule: str  # Where the fibres are; empty without. Two structures are equal if these two are
    effects: tuple[str, ...]  # Names of the effects in force
    recorded: Recorded = field(compare=False)  # One of them


def structure_of(effects: Effects, recorded: Recorded) -> Structure:
    """The structure of a filament."""
    formulation, theory, body = recorded.formulation, recorded.theory, recorded.body
    fibres, terms = theory.fibres, formulation.terms
    key = store.key_of(
        "structure",
        replace(terms, densities=()),
        [one.signature for one in terms.densities],
        formulation.section,
        formulation.closure,
        theory.label,
        [end.holds for end in (recorded.grid.first, recorded.grid.last)],
        body.supports,
        body.profile.nodes is not None,
        body.weighted,
        body.tip_mass,
        body.tip_force,
        body.tip_torque,
        body.natural is not None,
        body.exits is not None,
    )
    return Structure(key, fibres.label if fibres else "", effects.names, recorded)


def signature_of(structure: Structure) -> Signature | None:
    """What a filament computes, by name; None where its C text is not kept."""
    try:
        return _recalled(structure.key).with_fibres(structure.recorded.theory.fibres).signature
    except LookupError:
        return None


@lru_cache(maxsize=128)
def model_for(structure: Structure) -> Model:
    """The C text of a structure, from the cache or else made and kept there."""
    try:
        template = _recalled(structure.key)
    except LookupError:
        # Imported here: what is kept is read without CasADi and SymPy.
        from softcat_sym.codegen.model import template_of
        from softcat_sym.discretization.section_points import one_of

        theory = structure.recorded.theory
        rule = one_of(theory.fibres) if theory.fibres else theory.rule
        template = template_of(structure.recorded.sampled_by(rule), Template)
        store.keep(store.key_of("template", structure.key), _form().dump_json(template), cache.TEXTS)
    return template.with_fibres(structure.recorded.theory.fibres)
