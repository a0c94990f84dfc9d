"""A rheometer's flow curve becomes a material."""
