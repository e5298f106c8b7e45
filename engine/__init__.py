"""The reference for machine motion: laws, motions, timing diagrams and drives in SI units, angles in rad."""

from engine.drive import KINDS, Drive, Load, Mechanism, Motor, Part, Slide, Stage
from engine.laws import CATALOGUE, Law, Piece, PieceLaw, law
from engine.motion import Motion, Phase, motionlaw
from engine.timing import shaft_speed

__all__ = [
    "CATALOGUE", "KINDS", "Drive", "Law", "Load", "Mechanism", "Motion", "Motor", "Part",
    "Phase", "Piece", "PieceLaw", "Slide", "Stage", "law", "motionlaw", "shaft_speed",
]  # fmt: skip
