"""The sheets of a derivation, one module per part."""
