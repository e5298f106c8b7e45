"""Mechanisms between the gears and the load, and the register of all.

registry        every mechanism by its name; those of constant ratio: screw, conveyor, rack and pinion, belt, rollers
by_angle        loads of a turning axis by its angle: a slide on a crank that turns full circles, a swinging arm
variable_ratio  the shaft's angle over the load's position; what is out of reach, and by how much
slides          a lever that drives a slide through a link: crank-slider, rocker
table           points of shaft angle over position, joined by a curve of fifth degree
"""
