"""Which quantity fixes which: the groups as edges of a graph whose nodes are the constants of the material.

A constant is known when a chain of relations joins it to the ground; a relation that closes a ring says something
twice; a constant that no chain reaches is missing.
"""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.errors import Fault
from softcat_sym.scene.laws import CONSTANTS

GROUND = "1"

_WORDS = {"youngs_modulus": "Young's modulus", "viscosity": "the viscosity", "yield_stress": "the yield stress"}

# What each group relates; the ratio of the two comes with the numbers.
RELATES = {
    "G": ("yield_stress", GROUND),
    "eps_Y": ("yield_stress", "youngs_modulus"),
    "E_star": ("youngs_modulus", GROUND),
    "V": ("viscosity", GROUND),
    "B": ("viscosity", GROUND),
    "tau": ("viscosity", "youngs_modulus"),
}


@dataclass(frozen=True, slots=True)
class Relation:
    """``constant = ratio * other``, where the other may be the ground, 1.

    Attributes
    ----------
    path : str
        Dotted path of the key that states it.
    constant, other : str
        Names of material constants, or `GROUND`.
    ratio : float
        SI.
    """

    path: str
    constant: str
    other: str
    ratio: float


def faults_of(relations: list[Relation], law: str) -> list[Fault]:
    """List what is said twice, what the law does not use, and what is missing.

    Parameters
    ----------
    relations : list of Relation
        All that were given.
    law : str
        One of `CONSTANTS`.

    Returns
    -------
    list of Fault
        Empty when every constant of the law is fixed exactly once.
    """
    faults: list[Fault] = []
    tree: list[Relation] = []
    for relation in relations:
        unused = [name for name in (relation.constant, relation.other) if name not in (*CONSTANTS[law], GROUND)]
        if unused:
            # Constants given as such are refused by the material itself.
            if relation.path.startswith("groups."):
                found = f"given, but the law '{law}' has no {unused[0].replace('_', ' ')}"
                faults.append(Fault(relation.path, found, "leaving it out"))
            continue
        ring = _chain(tree, relation.constant, relation.other)
        if ring is None:
            tree.append(relation)
            continue
        names = ", ".join(part.path.removeprefix("groups.") for part in ring)
        own = relation.path.removeprefix("groups.")
        found = f"given twice: {names} and {own} together fix more than there is to fix"
        faults.append(Fault(relation.path, found, "leaving one of them out"))
    loose = [name for name in CONSTANTS[law] if _chain(tree, name, GROUND) is None]
    if loose:
        found = f"missing: nothing fixes {' and '.join(_WORDS[name] for name in loose)}"
        faults.append(Fault("groups", found, f"one more of {', '.join(_ways(loose, relations))}"))
    return faults


def solve(relations: list[Relation]) -> dict[str, float]:
    """Follow the relations from the ground.

    Parameters
    ----------
    relations : list of Relation
        Without rings.

    Returns
    -------
    dict of str to float
        SI value of every constant that a chain reaches.
    """
    values = {GROUND: 1.0}
    for _ in relations:
        for relation in relations:
            if relation.other in values:
                values.setdefault(relation.constant, relation.ratio * values[relation.other])
            elif relation.constant in values:
                values[relation.other] = values[relation.constant] / relation.ratio
    del values[GROUND]
    return values


def _chain(tree: list[Relation], start: str, end: str) -> list[Relation] | None:
    """Return the relations that join two nodes, or None."""
    if start == end:
        return []
    for relation in tree:
        if start in (relation.constant, relation.other):
            beyond = relation.other if start == relation.constant else relation.constant
            rest = _chain([other for other in tree if other is not relation], beyond, end)
            if rest is not None:
                return [relation, *rest]
    return None


def _ways(loose: list[str], relations: list[Relation]) -> list[str]:
    given = {relation.path for relation in relations}
    groups = [f"groups.{key}" for key, pair in RELATES.items() if pair[0] in loose or pair[1] in loose]
    return [path for path in (*groups, *(f"material.{name}" for name in loose)) if path not in given]
