"""Studies: what many runs together show."""
