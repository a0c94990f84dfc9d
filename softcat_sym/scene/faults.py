"""From what pydantic found to faults a user can act on: dotted path, what was found, what is accepted."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches

from pydantic_core import ErrorDetails

from softcat_sym.errors import Fault
from softcat_sym.scene.units import shown


def did_you_mean(found: str, known: Iterable[str]) -> str:
    """Name the nearest known word, or nothing when none is near.

    Parameters
    ----------
    found : str
        The word in the file.
    known : iterable of str
        The words that would do.

    Returns
    -------
    str
        Text to append to a fault, starting with a space, or empty.
    """
    nearest = get_close_matches(found, list(known), n=1, cutoff=0.5)
    return f" (did you mean '{nearest[0]}'?)" if nearest else ""


def unknown_key(path: str, tables: Mapping[str, Sequence[str]]) -> Fault:
    """Build the fault for a key that does not exist.

    Parameters
    ----------
    path : str
        Dotted path of the key.
    tables : mapping of str to sequence of str
        Known keys of every table; ``""`` is the file itself.

    Returns
    -------
    Fault
        With the nearest key of the same table, or the table that has a key of this name.
    """
    table, _, key = path.rpartition(".")
    here = tables.get(table, ())
    hint = did_you_mean(key, here)
    elsewhere = [f"{other}.{key}".lstrip(".") for other, keys in tables.items() if key in keys]
    if elsewhere:
        hint = f" (did you mean '{elsewhere[0]}'?)"
    return Fault(path, f"unknown key{hint}", ", ".join(here))


def fault_of(error: ErrorDetails, tables: Mapping[str, Sequence[str]], accepted: Mapping[str, str]) -> Fault:
    """Translate one pydantic error.

    Parameters
    ----------
    error : dict
        One entry of ``ValidationError.errors()``.
    tables : mapping of str to sequence of str
        Known keys of every table.
    accepted : mapping of str to str
        What each dotted path accepts.

    Returns
    -------
    Fault
        In the words of this package, never pydantic's.
    """
    path = ".".join(str(step) for step in error["loc"])
    context = error.get("ctx", {})
    if "found" in context:
        return Fault(path, str(context["found"]), str(context["accepted"]))
    if error["type"] == "extra_forbidden":
        return unknown_key(path, tables)
    if error["type"] == "missing":
        return Fault(path, "missing", accepted.get(path, ""))
    return Fault(path, f"{shown(error['input'])} is not a table", f"a table [{path}]")
