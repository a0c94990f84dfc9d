"""Values of the scene that one filament has of its own, from comments: ``# filament.span = 5 mm``."""

from __future__ import annotations

import re
from difflib import get_close_matches

from softcat_sym.errors import Fault
from softcat_sym.scene.faults import unknown_key
from softcat_sym.scene.units import shown

_DOTTED = re.compile(r"(?P<table>[A-Za-z_]\w*)\.(?P<key>[A-Za-z_]\w*)\b(?P<rest>.*)")
_FORM = "key = value, such as # filament.span = 5 mm"


def overrides_in(text: str) -> tuple[dict[str, str], list[Fault]]:
    """Read the overrides among the comments of a file.

    Parameters
    ----------
    text : str
        The whole file.

    Returns
    -------
    dict of str to str, list of Fault
        By dotted key, and the lines that look like overrides and are none. Values are validated with the scene.
    """
    from softcat_sym.scene.model import known_keys

    tables = {name: keys for name, keys in known_keys().items() if name}
    overrides: dict[str, str] = {}
    faults: list[Fault] = []
    for number, line in enumerate(text.splitlines(), start=1):
        comment = line.strip()
        match = _DOTTED.match(comment.lstrip("#").strip()) if comment.startswith("#") else None
        if match is None:
            continue
        where, table, path = f"line {number}", match["table"], f"{match['table']}.{match['key']}"
        assigned = match["rest"].lstrip().startswith("=")
        # A spreadsheet ends a short line with the separators of its empty cells.
        value = match["rest"].lstrip().removeprefix("=").split(" #")[0].rstrip(",;\t ").lstrip()
        if table not in tables:
            near = get_close_matches(table, tables, n=1, cutoff=0.75)
            # Another program's setting (camera.fps = 60) is a comment; a misspelt one of ours is not.
            if assigned and near:
                faults.append(
                    Fault(where, f"unknown table in {shown(path)} (did you mean '{near[0]}'?)", ", ".join(tables))
                )
        elif match["key"] not in tables[table]:
            unknown = unknown_key(path, tables)
            faults += [Fault(f"{where}, {path}", unknown.found, unknown.accepted)] if assigned else []
        elif not assigned or not value:
            faults.append(Fault(where, f"{shown(comment)} sets nothing", _FORM))
        elif path in overrides:
            faults.append(Fault(where, f"{path} set again", "each key once"))
        else:
            overrides[path] = value
    return overrides, faults
