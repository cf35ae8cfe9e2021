"""The loop around a Runge-Kutta method in Python: how long steps are, which are taken, what they must not miss."""
