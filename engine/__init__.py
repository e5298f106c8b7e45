"""The reference for machine motion: laws, motions, timing diagrams and drives in SI units, angles in rad."""

from engine.drive import Drive, Inertia, Load, Motor, Transmission, reflected_inertia
from engine.laws import CATALOGUE, Law, Piece, PieceLaw, law
from engine.motion import Motion, Phase, motionlaw
from engine.timing import Axis, Diagram, Movement, shaft_speed

__all__ = [
    "CATALOGUE",
    "Axis",
    "Diagram",
    "Drive",
    "Inertia",
    "Law",
    "Load",
    "Motion",
    "Motor",
    "Movement",
    "Phase",
    "Piece",
    "PieceLaw",
    "Transmission",
    "law",
    "motionlaw",
    "reflected_inertia",
    "shaft_speed",
]
