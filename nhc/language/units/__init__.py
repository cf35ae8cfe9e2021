"""Units: their dimensions, the check that they fit, and those of what declares none."""
