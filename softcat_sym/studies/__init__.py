"""Studies: results from many runs together."""
