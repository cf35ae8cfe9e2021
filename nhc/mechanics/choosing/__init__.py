"""Which formulation, on which coframe: candidates, measures, and the reason."""
