"""The component of the add-in: the functions MOTION.* as LibreOffice calls them, and their errors."""

from __future__ import annotations

import struct
from functools import partial
from typing import Callable

import unohelper
from motion_functions.cells import Cells, as_law, motion, pairs, reflected, root_mean_square, single
from motion_functions.law import NUM, Refused
from motion_functions.service import Service
from motionbook import XMotionFunctions

BACKWARDS = 1e-9  # of the mean velocity: a smaller velocity backwards is rounding


def failure(number: int) -> float:
    """Return an error of the spreadsheet: LibreOffice carries its number in the lower half of a NaN."""
    return struct.unpack("<d", struct.pack("<II", number, 0x7FF80000))[0]


def inverse(law: str, s: float, parameters: Cells) -> float:
    """Return the ξ at which a law first reaches s."""
    chosen = as_law(law, parameters)
    if chosen.coefficients.v_min < -BACKWARDS:
        raise Refused(NUM)
    return chosen.xi_at(s)


FUNCTIONS: dict[str, Callable[..., float]] = {
    **{name: partial(lambda n, law, xi, parameters: as_law(law, parameters).at(xi)[n], n)
       for n, name in enumerate(("S", "V", "A", "J"))},
    **{name: partial(lambda n, law, parameters: as_law(law, parameters).coefficients[n], n)
       for n, name in enumerate(("CV", "CA", "CARMS", "CJ"))},  # C_j is infinite, so #NUM!, where a jumps
    **{name: partial(lambda n, x, phases, shift, cycle: motion(phases).later(x, single(shift), single(cycle))[n], n)
       for n, name in enumerate(("POS", "VEL", "ACC"))},
    "XI": inverse,
    "JRED": lambda inertias, ratios: reflected(*pairs(inertias, ratios)),
    "RMS": lambda values, durations: root_mean_square(*pairs(values, durations)),
}  # fmt: skip
"""the functions by the names of their methods; what they take is declared in ``functions.toml``"""


class MotionFunctions(Service, XMotionFunctions):
    """The component, with a method for each of :data:`FUNCTIONS`."""

    NAME = "MOTION"  # the first part of the functions' names, also in the files
    SERVICES = ("com.sun.star.sheet.AddIn", "motionbook.MotionFunctions")

    def __init__(self, context: object) -> None:
        self.context = context


def method(function: Callable[..., float]) -> Callable[..., float]:
    """Return a method that gives the spreadsheet's error where arguments are refused or too large to compute with."""

    def answer(component: MotionFunctions, *arguments: object) -> float:
        try:
            return function(*arguments)
        except Refused as refused:
            return failure(refused.args[0])
        except (ArithmeticError, ValueError):
            return failure(NUM)

    return answer


for name, function in FUNCTIONS.items():
    setattr(MotionFunctions, name, method(function))
g_ImplementationHelper = unohelper.ImplementationHelper()  # noqa: N816 - the name that LibreOffice looks for
g_ImplementationHelper.addImplementation(MotionFunctions, MotionFunctions.NAME, MotionFunctions.SERVICES)
