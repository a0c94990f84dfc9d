"""What others have measured or computed: one case a record, by subject, with its scene as TOML."""
