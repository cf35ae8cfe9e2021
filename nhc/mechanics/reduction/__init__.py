"""The smallest exact model of what a scene needs."""
