"""How large the cache of compiled libraries may grow."""

from __future__ import annotations

import os
import re

from softcat_sym.errors import SoftcatError

VARIABLE = "SOFTCAT_CACHE_LIMIT"
_DEFAULT = "512 MB"
_BYTES = {
    **{"": 1, "b": 1, "kb": 10**3, "mb": 10**6, "gb": 10**9, "tb": 10**12},
    **{"kib": 2**10, "mib": 2**20, "gib": 2**30, "tib": 2**40},
}
_SIZE = re.compile(r"\s*(\d{1,18}(?:\.\d{1,18})?)\s*([a-z]*)\s*", re.ASCII | re.IGNORECASE)


def cache_limit() -> int:
    """Bytes that compiled libraries may take together: SOFTCAT_CACHE_LIMIT, else 512 MB.

    Raises
    ------
    SoftcatError
        If the variable is no size.
    """
    text = os.environ.get(VARIABLE) or _DEFAULT
    found = _SIZE.fullmatch(text)
    factor = _BYTES.get(found[2].lower()) if found else None
    if found is None or factor is None:
        raise SoftcatError(
            f"{VARIABLE} is {text!r}; accepted: a number of bytes, or a size such as '500 MB' or '2 GiB'"
        )
    return int(float(found[1]) * factor)


def size_text(size: float) -> str:
    """A size in bytes as people read it: ``1.3 MB``; powers of ten."""
    for unit, factor in (("GB", 10**9), ("MB", 10**6), ("kB", 10**3)):
        if size >= factor:
            return f"{size / factor:.1f} {unit}"
    return f"{size:.0f} B"
