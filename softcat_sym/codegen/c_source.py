"""C text by file name, and the hash that names it."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType


@dataclass(frozen=True)
class CSource:
    """C text, complete: what it includes beside the standard library is in it.

    Attributes
    ----------
    files : mapping of str to str
        Text by file name; read only.
    """

    files: Mapping[str, str]

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
