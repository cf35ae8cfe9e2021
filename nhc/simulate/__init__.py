"""Runs of a scene: emitted models compiled or loaded, integrators beside them, trajectories."""
