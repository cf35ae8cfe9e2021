"""The Python back end: plain ``math``, NumPy or JAX."""
