"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

from engine.motion.motion import Motion, motionlaw
from engine.motion.phase import MotionValues, Phase

__all__ = ["Motion", "MotionValues", "Phase", "motionlaw"]
