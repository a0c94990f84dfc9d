"""From measurements of falling filaments to the constants of their material."""

from __future__ import annotations

STARTS = 4
"""Starts of a fit beside the scene's own values and the closed form."""
