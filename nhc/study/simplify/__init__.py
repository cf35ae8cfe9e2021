"""Approximate reductions: which terms a scene does not need, measured."""
