"""The jumps between the phases of a motion."""

from typing import NamedTuple


class Junction(NamedTuple):
    """Where phase ``before`` ends and ``after`` begins, with the jumps (after less before) at ``x``.

    At the wrap of the cycle, ``jump_y`` is what the cycle does not close by: y(end) − y(start).
    """

    x: float
    before: int
    after: int
    jump_y: float
    jump_v: float
    jump_a: float


def junctions(motion, periodic=True):
    """The jumps between the phases in order; of a periodic motion, the wrap last."""
    found = []
    for before in range(len(motion.phases) - (not periodic)):
        after = (before + 1) % len(motion.phases)
        one, other = motion.ends[before].end, motion.ends[after].begin
        jump = other.y - one.y if after > before else one.y - other.y
        x = float(motion.edges[before + 1])
        found.append(Junction(x, before, after, jump, other.y1 - one.y1, other.y2 - one.y2))
    return tuple(found)


def runs_smoothly(motion, periodic=True):
    """Whether velocity nowhere jumps; of a periodic motion, neither from its end to its begin."""
    return all(abs(j.jump_v) <= 1e-9 * motion.peaks.y1 for j in junctions(motion, periodic))
