"""The numbered equations of A. Vigneront's thesis (Namur 1977), their errata, and the code that implements them.

``@equation("I.4.9")`` ties a function to a number; the same number stands in emitted comments, LaTeX tags and tests.
``EQUATIONS`` says of every number what it states (corrected), and whether it is implemented, shown by a test, or not needed
(with the reason).  This package is a leaf: it imports nothing else of nhc.
"""
