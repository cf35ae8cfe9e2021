"""Where a scene starts: loops closed, velocities completed so that the constraints hold."""
