"""From the spec to the system: what its names mean, as nodes; forces, and what is drawn."""
