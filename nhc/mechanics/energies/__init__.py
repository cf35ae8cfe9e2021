"""The structure of the kinetic energy: the velocity forms that it is made of."""
