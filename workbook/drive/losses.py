"""The rule of losses in cells; the engine's is :mod:`engine.drive.losses`."""

from __future__ import annotations

from engine.drive import NEAR, STANDSTILL
from workbook.book.declare import Quantity, constant


def standstill() -> Quantity:
    """Return the speed below which a shaft counts as standing: it decides the direction where only a speed is known."""
    return constant("@still", "Standstill: speeds up to", "ω_0", "rad/s",
                    STANDSTILL, format="0E+00", source="then nothing flows back")  # fmt: skip


def nearly() -> Quantity:
    """Return the torque with which a load must drive to count as driving."""
    return constant("@near", "Overhauling torque taken as resisting, up to", "R_0", "N or Nm",
                    NEAR, format="0E+00", source="rounding never decides the losses")  # fmt: skip


def direction(speed: str) -> str:
    """Return the direction of a shaft, 1, −1 or 0, by its speed (rad/s)."""
    return f"IF(ABS({speed})<@still,0,SIGN({speed}))"


def loss_factor(torque: str, direction: str, efficiency: str) -> str:
    """Return f of a stage: 1/η where the torque behind it resists its direction or it stands, η where it drives."""
    return f"IF({torque}*{direction}+@near<0,{efficiency},1/{efficiency})"
