"""One chain from a motor to its load: stages and parts on shafts, loads, losses by the direction of power.

chain      stages, parts on shafts, what hangs on the last one; the torque at each shaft
loads      masses on guides, resisting forces, cylinders
kinds      the mechanisms: lead screw, conveyor, rack and pinion, belt, rotary table, gear train, feed rollers
losses     which way power flows, and what a stage loses of it
drive      a motor on a mechanism: its torque for any motion of the load
motor      its limits, derating
lossless   mean squares in closed form, where nothing is lost
"""

from engine.drivetrain.chain import Load, Mechanism, Part, Stage, reflected_inertia
from engine.drivetrain.drive import Drive, motor_inertia
from engine.drivetrain.kinds import KINDS, Kind
from engine.drivetrain.loads import Slide, cylinder, resisting
from engine.drivetrain.losses import NEAR, STANDSTILL, direction, loss_factor
from engine.drivetrain.motor import LimitCheck, Motor, derating

__all__ = [
    "KINDS",
    "NEAR",
    "STANDSTILL",
    "Drive",
    "Kind",
    "LimitCheck",
    "Load",
    "Mechanism",
    "Motor",
    "Part",
    "Slide",
    "Stage",
    "cylinder",
    "derating",
    "direction",
    "loss_factor",
    "motor_inertia",
    "reflected_inertia",
    "resisting",
]
