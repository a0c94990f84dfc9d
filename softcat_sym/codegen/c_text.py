"""Numbers and tables as C text, and files of it."""

from __future__ import annotations

import hashlib
import math
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

from softcat_sym.errors import PrintingError
from softcat_sym.store import version


def number(value: float) -> str:
    """A double that C reads as the same one."""
    if math.isnan(value):
        raise PrintingError("an expression of the generated code holds a constant that is not a number")
    if math.isinf(value):
        return "HUGE_VAL" if value > 0 else "(-HUGE_VAL)"
    return repr(value) if value >= 0 else f"({value!r})"


def c_array(kind: str, name: str, values: Sequence[str]) -> str:
    """A table of constants."""
    body = textwrap.fill(", ".join(values), 96, initial_indent="    ", subsequent_indent="    ", break_long_words=False)
    return f"static const {kind} {name}[] = {{\n{body}}};"


@dataclass(frozen=True)
class CSource:
    """C text, complete: what it includes beside the standard library is in it."""

    files: Mapping[str, str]  # Text by file name; read only

    def __post_init__(self) -> None:
        object.__setattr__(self, "files", MappingProxyType(dict(sorted(self.files.items()))))

    @cached_property
    def digest(self) -> str:
        """SHA-256 of names and texts, in hexadecimal."""
        parts = [part for name, text in self.files.items() for part in (name, text)]
        # With its length before it, no part can pass for the end of the one before.
        return hashlib.sha256("".join(f"{len(part)}:{part}" for part in parts).encode()).hexdigest()

    @property
    def size(self) -> int:
        """Bytes of text."""
        return sum(len(text.encode()) for text in self.files.values())


VERSIONS = MappingProxyType({package: version(package) for package in ("softcat_sym", "casadi", "sympy")})
