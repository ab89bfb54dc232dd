"""FRFs to and from the conventions of other packages. None of these is needed unless its function is called.

>>> from jointid.bridges import pyfbs, pyuff, sdynpy  # nothing of theirs is imported
"""
