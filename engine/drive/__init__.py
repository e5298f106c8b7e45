"""Drives: a motor, gears, a mechanism and a load, and their torques and powers over a cycle. SI units.

mechanisms      screw, belt, rollers …; crank-slider, rocker, table of positions; the register of all
chain           stages and parts on shafts; losses by the direction of power; masses on guides, forces, cylinders
motor           limits of a motor, its peak torque against speed, derating
drivetrain      a motor, with its brake and gears, a mechanism of any ratio, and the forces of the process
search          extremes, zeros and integrals of curves (powers and sines) and of any functions
cycle           a drivetrain over a motion, cut into intervals in which each quantity has a single formula
results         peaks, RMS torque, energy and mean power of a cycle, exact
limits          a cycle against the limits of motor and reducer, also creeping
quadrature      the load at points of a cycle, as the sheets have it
turning         reversals of a motion inside its pieces, likewise
drive_points    the motor at these points, and by how much its results may be off
limit_use       the rates that hold all limits, by the points, from its rate_estimates
rate_range      the same, exact: their range, the highest, what limits it
backlash, shaped    shocks in a gap; laws of least torque
"""

from engine.drive.chain import Load, Mechanism, Part, Slide, Stage, cylinder
from engine.drive.drivetrain import Drivetrain
from engine.drive.mechanisms import KINDS
from engine.drive.motor import Motor, derating

__all__ = ["KINDS", "Drivetrain", "Load", "Mechanism", "Motor", "Part", "Slide", "Stage", "cylinder", "derating"]
