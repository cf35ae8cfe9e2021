"""The stability laboratory: what a scene's motion and its integration can be trusted with."""
