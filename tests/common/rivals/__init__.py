"""What the generated C solver is measured against: written to win, by the means that others have."""
