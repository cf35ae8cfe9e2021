"""What is true of a system: integrals, conserved quantities, integrability, kinks."""
