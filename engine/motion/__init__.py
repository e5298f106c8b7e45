"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

from engine.motion.motion import Motion, MotionSamples, motionlaw
from engine.motion.phase import Ends, MotionValues, Phase, TimeValues

__all__ = ["Ends", "Motion", "MotionSamples", "MotionValues", "Phase", "TimeValues", "motionlaw"]
