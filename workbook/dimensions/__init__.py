"""Dimensions of cells: the units of inputs run through the formulas, so that what cannot be added is not.

Scale is left aside: m and mm have the same dimension, so have ° and rad, and a factor such as 1000 has none.
"""
