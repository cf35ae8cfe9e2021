"""Long straight code whose statements repeat from one body to the next, as loops."""
