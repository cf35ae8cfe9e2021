"""Expressions of a spec: words, syntax trees, the names that they may use, exact numbers."""
