"""The names of the targets, which the command's help lists without loading them."""

TARGETS = ("csv",)
"""each a file in ``targets``, its - an underscore there"""
