"""The thesis's formulations, each with its coframe and its Omega."""
