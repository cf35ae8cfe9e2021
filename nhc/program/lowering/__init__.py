"""From plans of nodes to the statements of the intermediate representation."""
