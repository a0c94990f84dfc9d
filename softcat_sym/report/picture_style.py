"""The styles in which a run's pictures can be asked for."""

from __future__ import annotations

from typing import Final

from softcat_sym.errors import SoftcatError

SCREEN: Final = "screen"
STYLES: Final = {SCREEN: SCREEN, "publication": "column", "column": "column", "page": "page"}
"""What may be asked for, and what it means: pictures for a screen, or for print as wide as a column or a page."""


def picture_style(asked: str) -> str:
    """Read what was asked for, before anything is computed.

    Returns
    -------
    str
        ``screen``, ``column`` or ``page``.

    Raises
    ------
    SoftcatError
        If there is no such style.
    """
    if asked not in STYLES:
        raise SoftcatError(
            f"--style: no style {asked!r}; accepted: screen, publication (or column: 84 mm wide, PDF and PNG), "
            "page (174 mm wide)"
        )
    return STYLES[asked]
