"""Chains and trees of bodies: their equations solved from the leaves to the root."""
