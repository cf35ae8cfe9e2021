"""The version, alone in its module so that every floor may name it in what it writes."""

__version__ = "0.1.0"
