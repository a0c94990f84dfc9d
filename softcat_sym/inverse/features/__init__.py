"""What a film of the midpoint shows without any model being run: oscillation, descent, power law."""

from softcat_sym.inverse.features.features import Features, read_features
from softcat_sym.inverse.features.reading import Reading

__all__ = ["Features", "Reading", "read_features"]
