"""Steady motions, found from a guess, and the equations linearised about them."""
