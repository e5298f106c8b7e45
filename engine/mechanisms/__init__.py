"""Mechanisms whose ratio depends on the load's position, and the register of all.

linkage     the angle of a shaft along its load's way; what is out of reach, and by how much
slide, crank_slider, rocker     a lever that drives a slide through a link
table       points, joined by a monotone cubic
registry    every mechanism by its name, those of a constant ratio too
"""
