"""Rigid bodies: how they are declared, and how they are written out as definitions and energies."""
