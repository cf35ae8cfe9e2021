"""Work-precision studies: formulation x method x language x tolerance, errors against a reference, times, advice."""
