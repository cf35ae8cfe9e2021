"""Agreement of the formulations: what each claims of the motion, and certificates that the claims are the same."""
