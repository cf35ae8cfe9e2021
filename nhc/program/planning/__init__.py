"""What each function of a model computes, as plans of nodes."""
