"""What a fit does unless it is told otherwise; light enough for a command line's help."""

STARTS = 4
"""Starts beside the scene's own values and the closed form."""
