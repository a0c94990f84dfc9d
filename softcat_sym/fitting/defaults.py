"""Defaults of a fit, without imports that would slow down the command line's help."""

from __future__ import annotations

STARTS = 4
"""Starts beside the scene's own values and the closed form."""

MAX_STARTS = 10_000
"""Largest number of starts; one start takes at least a tenth of a second."""
