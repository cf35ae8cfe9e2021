"""Where expressions may vanish or jump: bounds over boxes, and points that are searched."""
