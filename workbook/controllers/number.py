"""The numbers that controllers hold, how texts write them, and the comments that tell what whole ones count."""

import re
from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array
from workbook.errors import TargetError

NUMBER = r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?"
STANDS = re.compile(rf"the axis stands at ({NUMBER}) ")
LARGEST = 1e9  # of a step
TOLD = re.compile(r"one step is (\S{1,30}) (?:\S{1,30}) of x and (\S{1,30}) (?:\S{1,30}) of y")


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


def literal(value: float, number: Number = LREAL) -> str:
    """Return a number's text as Structured Text writes it: with a point, its exponent after E."""
    mantissa, _, power = number.text(value).partition("e")
    pointed = mantissa if "." in mantissa else f"{mantissa}.0"
    return f"{pointed}E{int(power)}" if power else pointed


STEPS = {"°": 1e-5, "mm": 1e-4, "s": 1e-6}  # what a whole number counts, by unit
OTHER_STEP = 1e-4


def step_of(unit: str, reach: float = 0.0, largest: float = DINT.largest) -> float:
    """Return what a whole number counts of a unit; more where so many do not reach that far."""
    step = STEPS.get(unit, OTHER_STEP)
    while reach / step > largest:
        step = float(f"{step * 10.0:.0e}")
    return step


def counts(steps: tuple[float, float], units: tuple[str, str]) -> str:
    """Return the comment that says what a whole number of x and of y counts."""
    (x, y), (one, other) = steps, (unit.replace(" ", "_") for unit in units)
    return f"one step is {LREAL.text(x)} {one} of x and {LREAL.text(y)} {other} of y"


def read_counts(text: str) -> tuple[float, float]:
    """Return what whole numbers of a file count; 1 where its comment does not say."""
    found = TOLD.search(text)
    if found is None:
        return 1.0, 1.0
    x, y = (float(told) if re.fullmatch(NUMBER, told) else 0.0 for told in found.groups())
    if not (0.0 < x <= LARGEST and 0.0 < y <= LARGEST):
        raise TargetError(f"one step is {found[1]} of x and {found[2]} of y; expected numbers above 0, up to 1e9")
    return x, y


def stands(offset: float, unit: str) -> str:
    """Return the comment that says where the axis is when a cam that begins at 0 begins."""
    return f"the cam begins at y = 0; the axis stands at {LREAL.text(offset)} {unit} there"


def read_stand(text: str) -> float:
    """Return where the axis is when its cam begins; 0 where the comment does not say."""
    found = STANDS.search(text)
    return float(found[1]) if found else 0.0
