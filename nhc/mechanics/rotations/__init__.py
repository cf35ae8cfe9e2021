"""Rotations and turns: quaternions, chains of axes, components along directions."""
