"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

from engine.motion.motion import Motion, MotionSamples, motionlaw
from engine.motion.phase import MotionValues, Phase, PhaseEnds, TimeValues

__all__ = ["Motion", "MotionSamples", "MotionValues", "Phase", "PhaseEnds", "TimeValues", "motionlaw"]
