"""The same systems in the hands of other tools."""
