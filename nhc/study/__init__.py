"""Studies of a model: linearisation, charts, stability."""
