"""A timing diagram: named axes over one cycle of the master shaft, and what each movement demands (S1)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

from engine.motion import Motion


def shaft_speed(rate: float, cycle: float = 2 * pi) -> float:
    """Return the speed of the master shaft in rad/s for ``rate`` cycles a second: ω = 2π · rate (S1)."""
    if not rate > 0:
        raise ValueError(f"expected a production rate above 0, found {rate:g}")
    return cycle * rate


@dataclass(frozen=True)
class Axis:
    """A named axis: its motion over the cycle (m over rad). A ``feed`` advances every cycle and does not come back."""

    name: str
    motion: Motion
    feed: bool = False

    @property
    def closes(self) -> bool:
        """Whether the cycle ends where it began: in position, or, for a feed, in velocity."""
        wrap = self.motion.junctions()[-1]
        scale = max(abs(p.lift) for p in self.motion.phases)
        steady = abs(wrap.jump_v) <= 1e-9 * (scale / self.motion.total or 1.0)
        return steady and (self.feed or abs(wrap.jump_y) <= 1e-9 * (scale or 1.0))


@dataclass(frozen=True)
class Movement:
    """A phase that moves, in SI: geometric extremes per rad, and time extremes at the production rate.

    y'_max = C_v h/δ and y''_max = C_a h/δ²; ẏ_max = y'_max ω and ÿ_max = y''_max ω²; ÿ_rms over the movement (S1).
    """

    axis: str
    phase: int
    law: str
    lift: float
    start: float
    stop: float
    y1_max: float
    y2_max: float
    v_max: float
    a_max: float
    a_rms: float


class Diagram:
    """Axes over one cycle of the master shaft.

    Raises ValueError for two axes of one name, or an axis whose phases do not fill the cycle.
    """

    def __init__(self, axes: Sequence[Axis], cycle: float = 2 * pi) -> None:
        for i, axis in enumerate(axes):
            if any(other.name == axis.name for other in axes[:i]):
                raise ValueError(f"two axes are named {axis.name!r}; expected a name of its own for each")
            if abs(axis.motion.total - cycle) > 1e-9 * cycle:
                raise ValueError(
                    f"axis {axis.name!r} covers {axis.motion.total:g} rad; expected the cycle, {cycle:g}"
                )
        self.axes, self.cycle = tuple(axes), cycle

    def axis(self, name: str) -> Axis:
        """Return the axis of that name; raise KeyError, listing the names, where there is none."""
        for axis in self.axes:
            if axis.name == name:
                return axis
        raise KeyError(f"no axis is named {name!r}; there are {', '.join(a.name for a in self.axes)}")

    def movements(self, rate: float) -> list[Movement]:
        """Return every movement, axis by axis, at ``rate`` cycles a second."""
        omega = shaft_speed(rate, self.cycle)
        return [
            movement(axis, k, omega)
            for axis in self.axes
            for k, phase in enumerate(axis.motion.phases)
            if phase.lift and phase.law.code != "DWL"
        ]


def movement(axis: Axis, k: int, omega: float) -> Movement:
    """Return the extremes of phase ``k`` of an axis, from its law's coefficients."""
    phase, c = axis.motion.phases[k], axis.motion.phases[k].law.coefficients
    y1 = c.cv * abs(phase.lift) / phase.duration
    y2 = c.ca * abs(phase.lift) / phase.duration**2
    return Movement(
        axis=axis.name,
        phase=k,
        law=phase.law.code,
        lift=phase.lift,
        start=float(axis.motion.edges[k]),
        stop=float(axis.motion.edges[k + 1]),
        y1_max=y1,
        y2_max=y2,
        v_max=y1 * omega,
        a_max=y2 * omega**2,
        a_rms=c.ca_rms * abs(phase.lift) / phase.duration**2 * omega**2,
    )
