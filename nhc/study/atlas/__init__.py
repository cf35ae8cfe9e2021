"""Where methods fail: one scenario per module, each with the naive way and nhc's way measured side by side."""
