"""From a film of a falling strand to its midpoint, thickness and shapes over time, with standard errors."""
