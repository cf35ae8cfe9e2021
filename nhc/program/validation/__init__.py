"""Do the functions of a program compute what the equations say?"""
