"""Fits of the constants of a law to measurements."""
