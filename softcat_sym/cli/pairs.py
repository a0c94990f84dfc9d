"""Two values and a unit on the command line: ``5:50 mm``."""

from __future__ import annotations

import re

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"


def read_pair(text: str) -> tuple[str, str] | None:
    """Split ``low:high unit``; a lower value without a unit has that of the upper one. None if it is no pair."""
    ends = [end.strip() for end in text.split(":")]
    if len(ends) != 2 or not all(ends):
        return None
    low, high = ends
    unit = re.sub(rf"^{_NUMBER}\s*", "", high)
    return (f"{low} {unit}".strip() if re.fullmatch(_NUMBER, low) else low, high)
