"""Linear forms and linear systems over the graph."""
