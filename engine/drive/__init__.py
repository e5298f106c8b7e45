"""Drives: a motor, gears, a mechanism and a load, and what their motion over a cycle asks of them. SI units.

mechanisms      screw, belt, rollers …; crank-slider, rocker, table of positions; the register of all
chain           stages and parts on shafts; losses by the direction of power; masses on guides, forces, cylinders
motor           its limits, its peak torque over the speed, derating
train           a motor, with its brake and gears, a mechanism of any ratio, and the forces of the process
search          extremes, zeros and integrals, of forces within a piece as powers and sines, and of functions
cycle           a train over a motion, cut into intervals in which nothing changes its formula
results         peaks, RMS torque, energy and mean power of a cycle, exact
limits          how near a cycle comes to the limits of motor and reducer; the highest rate at which all are met, exact
quadrature      a load at points of a cycle, as the sheets have it
drive_points    its motor there; the highest rate by these points
"""

from engine.drive.chain import NEAR, Load, Mechanism, Part, Slide, Stage, cylinder, resisting
from engine.drive.drivetrain import Drive
from engine.drive.mechanisms import KINDS, Kind
from engine.drive.motor import STANDSTILL, LimitCheck, Motor, derating

__all__ = [
    "KINDS", "NEAR", "STANDSTILL", "Drive", "Kind", "LimitCheck", "Load", "Mechanism", "Motor", "Part", "Slide",
    "Stage", "cylinder", "derating", "resisting",
]  # fmt: skip
