"""Where a system, its constraints and its coframes are regular."""
