"""The command line: one module per verb, imported when the verb is used."""

from nhc.cli.entry import main

__all__ = ["main"]
