"""The reference for machine motion: laws, motions, timing diagrams and drives in SI units, angles in rad."""

from engine.laws import law
from engine.motion import motionlaw

__all__ = ["law", "motionlaw"]
