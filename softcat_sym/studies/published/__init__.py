"""Published measurements and computations: one record for each case, by subject, with its scene as TOML."""
