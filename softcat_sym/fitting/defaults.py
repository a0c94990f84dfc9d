"""What a fit does unless it is told otherwise; light enough for a command line's help."""

from __future__ import annotations

STARTS = 4
"""Starts beside the scene's own values and the closed form."""

MAX_STARTS = 10_000
"""As many as anybody has waited for: a start takes a tenth of a second at the least."""
