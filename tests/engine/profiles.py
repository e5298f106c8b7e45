"""S4's move profiles as laws."""

from engine.laws.ramps import TrapezoidalVelocity


def thirds(first=1 / 3, uniform=1 / 3, last=1 / 3):
    """The trapezoid that accelerates, goes on and slows for these shares of its time, e.g. 1/6–2/3–1/6."""
    assert abs(first + uniform + last - 1) < 1e-9
    return TrapezoidalVelocity(first, 1 - last if uniform else first)
