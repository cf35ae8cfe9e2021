"""Exact answers from random points of prime fields: identities, ranks, signs, degrees."""
