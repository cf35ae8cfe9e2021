"""Chains and trees of bodies: their equations solved from the leaves to the root.

The package is large; those who may need it import it where a system has been found large enough.
"""

FEW = 3
"""Rates up to which both ways, by the dense matrix and along a tree, are written out and compared."""
