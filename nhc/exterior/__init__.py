"""Exterior forms over the expression graph."""

from nhc.exterior.coframe import Coframe, coordinate_coframe, general_coframe
from nhc.exterior.forms import Form, basis_form, d, function_form, interior, one_form, pullback, wedge

__all__ = [
    "Coframe",
    "Form",
    "basis_form",
    "coordinate_coframe",
    "d",
    "function_form",
    "general_coframe",
    "interior",
    "one_form",
    "pullback",
    "wedge",
]
