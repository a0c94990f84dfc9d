"""Effects, the physics of a run: one file for each effect, which selects its terms of the equations."""
