"""Runs in C: the source with the integrator inside it, compiled once, loaded and called."""
