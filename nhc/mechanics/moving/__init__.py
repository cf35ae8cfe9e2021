"""Moving axes: the vectors behind the components that a spec writes, and equations on the axes where they are short."""
