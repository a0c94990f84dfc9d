"""A finished block of a sweep as bytes, and back: arrays of NumPy in one archive."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from io import BytesIO
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.study.sweep.member_result import MemberResult

TEXTS: Final = ("outcome", "regime", "message")
NUMBERS: Final = tuple(f.name for f in fields(MemberResult) if f.name not in (*TEXTS, "midpoint", "shapes"))

Columns = dict[str, npt.NDArray[Any]]


def packed(results: Sequence[MemberResult]) -> bytes:
    """Write the results of a block: a column for each variable, ``shapes`` (members, 3, frames, nodes) if kept."""
    columns: Columns = {name: np.array([getattr(one, name) for one in results], dtype=np.str_) for name in TEXTS}
    columns |= {name: np.array([getattr(one, name) for one in results], dtype=float) for name in NUMBERS}
    columns["midpoint"] = np.stack([one.midpoint for one in results])
    known = [one.shapes for one in results if one.shapes is not None]
    if known:
        nothing = np.full_like(known[0], np.nan)
        columns["shapes"] = np.stack([nothing if one.shapes is None else one.shapes for one in results])
    stream = BytesIO()
    np.savez_compressed(stream, allow_pickle=False, **columns)
    return stream.getvalue()


def unpacked(content: bytes) -> Columns:
    """Read the columns of a block."""
    with np.load(BytesIO(content), allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}
