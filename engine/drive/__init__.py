"""Drives: a motor, gears, a mechanism and a load, and their torques and powers over a cycle. SI units.

mechanisms      screw, belt, rollers …; crank-slider, rocker, table of positions; the register of all
chain           stages and parts on shafts; losses by the direction of power; masses on guides, forces, cylinders
motor           limits of a motor, its peak torque against speed, derating
train           a motor, with its brake and gears, a mechanism of any ratio, and the forces of the process
search          extremes, zeros and integrals of curves (powers and sines) and of any functions
cycle           a drivetrain over a motion, cut into intervals in which each quantity has a single formula
results         peaks, RMS torque, energy and mean power of a cycle, exact
limits          reserves against the limits of motor and reducer; the highest rate at which all are met, exact
quadrature      the load at points of a cycle, as the sheets have it
drive_points    the motor at these points; the highest rate by them
"""

from engine.drive.chain import Load, Mechanism, Part, Slide, Stage, cylinder
from engine.drive.drivetrain import Drive
from engine.drive.mechanisms import KINDS
from engine.drive.motor import Motor, derating

__all__ = ["KINDS", "Drive", "Load", "Mechanism", "Motor", "Part", "Slide", "Stage", "cylinder", "derating"]
