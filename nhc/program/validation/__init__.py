"""Do the functions of a program compute what the equations say?"""

UNDECIDED = "no point was found to look at, or only 40 digits say that it is right"
"""What it means that nothing is known of a function (None)."""
