"""What is asked: frozen models, units at this boundary only, TOML; and the bundled scenes."""
