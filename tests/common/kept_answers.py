"""Answers of long studies, kept in the user's cache, so that an interrupted check goes on where it was.

Each has the fingerprint of its question and of all sources that it depends on.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import softcat_sym as sc
from softcat_sym.cache import cache_folder


def kept(question: Sequence[str], sources: str, answer: Callable[[], Any]) -> Any:
    """Look an answer up, or find and keep it."""
    key = hashlib.sha256("\n".join((sources, *question)).encode()).hexdigest()
    path = cache_folder() / "answers" / f"{key}.json"
    if path.is_file():
        return json.loads(path.read_text())
    text = json.dumps(answer())
    path.parent.mkdir(parents=True, exist_ok=True)
    # Another process may be writing the same answer.
    partial = path.with_suffix(f".{os.getpid()}")
    partial.write_text(text)
    partial.replace(path)
    return json.loads(text)


@cache
def fingerprint(study: str) -> str:
    """Fingerprint of the package and of the study's own file."""
    package = Path(sc.__file__).parent
    digest = hashlib.sha256(Path(study).read_bytes())
    for file in sorted(file for file in package.rglob("*") if file.suffix in (".py", ".c", ".h")):
        digest.update(file.read_bytes())
    return digest.hexdigest()
