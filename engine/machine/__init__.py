"""Drives of a machine over a cycle, exact: nothing here rests on how many samples are taken.

train       a motor, gears, a mechanism of any ratio, and what acts on the load over the cycle
course      a train over a motion, cut into stretches in which nothing changes its formula
demand      peaks, RMS torque, energy of a course
limits      those of motor and reducer, and how near a course comes to each
rate        the highest rate at which all hold
bus         power of several drives, on a common DC bus and without one
searching   extremes and integrals where there is no closed form
"""
