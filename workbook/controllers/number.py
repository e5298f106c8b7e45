"""The numbers that controllers hold, and how texts write them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array
from workbook.errors import TargetError


@dataclass(frozen=True)
class Number:
    """A kind of number: floating of 64 or 32 bits, or whole steps of 32 bits; ``digits`` that a text of it needs."""

    name: str
    largest: float
    whole: bool = False

    def rounded(self, values: Array, step: float = 1.0) -> Array:
        """Return values as the controller holds them, whole ones in steps of ``step``; raise TargetError beyond it."""
        size = np.abs(values / step if self.whole else values)
        if not np.all(size <= self.largest):
            at = tuple(np.argwhere(~(size <= self.largest))[0])  # of a polynomial, its row and coefficient
            said = f"{values[at]:.6g} is beyond what {self.name} holds; expected smaller ones"
            raise TargetError(f"point {at[0] + 1}: {said}")
        if self.whole:
            return np.asarray(np.round(np.round(values / step) * step, 12))
        return values if self is LREAL else np.asarray(values.astype(np.float32).astype(np.float64))

    def text(self, value: float) -> str:
        """Return the shortest text that is read as this number again."""
        if self.whole:
            return str(round(value))
        return str(np.float32(value)) if self is REAL else repr(float(value))


LREAL = Number("LREAL", 1.7976931348623157e308)
REAL = Number("REAL", 3.4028234663852886e38)
DINT = Number("DINT", 2147483647.0, whole=True)
DINT_IN_REAL = Number("DINT that REAL holds", 16777216.0, whole=True)


def whole(values: Array) -> Array:
    """Return whole numbers of 32 bits; raise TargetError for others."""
    if not np.all((np.abs(values) <= DINT.largest) & (values == np.round(values))):
        raise TargetError("a value is no whole number of 32 bits; expected such")
    return values


def literal(text: str) -> str:
    """Return a number's text as Structured Text writes it: with a point, its exponent after E."""
    mantissa, _, power = text.partition("e")
    pointed = mantissa if "." in mantissa else f"{mantissa}.0"
    return f"{pointed}E{int(power)}" if power else pointed


STEPS = {"°": 1e-5, "mm": 1e-4, "s": 1e-6}
"""what a whole number counts, by unit"""
OTHER_STEP = 1e-4


def step_of(unit: str, reach: float = 0.0, largest: float = DINT.largest) -> float:
    """Return what a whole number counts of a unit; more where so many do not reach that far."""
    step = STEPS.get(unit, OTHER_STEP)
    while reach / step > largest:
        step = float(f"{step * 10.0:.0e}")
    return step
