"""Rules that look at whole expressions: each a function from nodes to equal nodes that cost less."""
