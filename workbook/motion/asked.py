"""What an engineer may ask of a motion: how smooth it must be."""

from __future__ import annotations

from typing import Literal, get_args

Smoothness = Literal["velocity", "acceleration", "jerk"]
"""what must be continuous: velocity; acceleration too; jerk too"""
ABOUT = "what must not jump: velocity; acceleration too; jerk too"


def smoothness_for(turn: int) -> str:
    """Return the smoothness whose turn it is: one after the other."""
    words: tuple[str, ...] = get_args(Smoothness)
    return words[turn % len(words)]
