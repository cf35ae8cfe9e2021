"""Benchmarks: what nhc promises, measured beside its peers.  ``python -m benchmarks`` writes docs/performance.md."""
