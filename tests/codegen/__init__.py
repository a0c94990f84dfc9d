"""Generated C against the graph that it was generated from."""
