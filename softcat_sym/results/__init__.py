"""The result of a run, with its energy audit, regime and verdict."""
