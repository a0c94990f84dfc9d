"""A Graph is integrated in time; the Outcome says how that went."""
