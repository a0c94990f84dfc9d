"""Which physics a run holds: one effect a file, each picking its terms from the equations."""
