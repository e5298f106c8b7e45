"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

from engine.motion.motion import EDGE_TOLERANCE, ZERO_TOLERANCE, Motion, MotionSamples, motionlaw
from engine.motion.phase import Ends, MotionValues, Phase, TimeValues

__all__ = [
    "EDGE_TOLERANCE", "ZERO_TOLERANCE", "Ends", "Motion", "MotionSamples", "MotionValues", "Phase",
    "TimeValues", "motionlaw",
]  # fmt: skip
