"""What only runs and drivers need beside the functions of a model: what steps must see, watch and hold, and what starts need."""
