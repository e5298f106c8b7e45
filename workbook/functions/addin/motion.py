"""The component of the add-in: the functions MOTION.* as LibreOffice calls them, and their errors."""

from __future__ import annotations

import struct
from functools import wraps
from typing import Callable

import unohelper
from com.sun.star.lang import XServiceInfo
from motion_functions.cells import Cells, motion, named, pairs
from motion_functions.coefficients import coefficients, monotone
from motion_functions.composed import reflected, root_mean_square
from motion_functions.refused import NUM, Refused
from motionbook import XMotionFunctions

IMPLEMENTATION = "MOTION"  # the first part of the functions' names, also in the files
SERVICES = ("com.sun.star.sheet.AddIn", "motionbook.MotionFunctions")


def failure(number: int) -> float:
    """Return an error of the spreadsheet: LibreOffice carries its number in the lower half of a NaN."""
    return struct.unpack("<d", struct.pack("<II", number, 0x7FF80000))[0]


def answered(function: Callable[..., float]) -> Callable[..., float]:
    """Let a function return the spreadsheet's error where its arguments are refused or too large to compute with."""

    @wraps(function)
    def answer(*arguments: object) -> float:
        try:
            return function(*arguments)
        except Refused as refused:
            return failure(refused.number)
        except (ArithmeticError, ValueError):
            return failure(NUM)

    return answer


class MotionFunctions(unohelper.Base, XMotionFunctions, XServiceInfo):
    """The functions; which they are, and what they take, is declared in ``declared.py``."""

    def __init__(self, context: object) -> None:
        self.context = context

    @answered
    def S(self, law: str, xi: float, parameters: Cells) -> float:
        """Return the position of a law."""
        return named(law, parameters).at(xi)[0]

    @answered
    def V(self, law: str, xi: float, parameters: Cells) -> float:
        """Return the velocity of a law."""
        return named(law, parameters).at(xi)[1]

    @answered
    def A(self, law: str, xi: float, parameters: Cells) -> float:
        """Return the acceleration of a law."""
        return named(law, parameters).at(xi)[2]

    @answered
    def J(self, law: str, xi: float, parameters: Cells) -> float:
        """Return the jerk of a law."""
        return named(law, parameters).at(xi)[3]

    @answered
    def XI(self, law: str, s: float, parameters: Cells) -> float:
        """Return the ξ at which a law first reaches s."""
        found = named(law, parameters)
        if not monotone(found):
            raise Refused(NUM)
        return found.xi_at(s)

    @answered
    def CV(self, law: str, parameters: Cells) -> float:
        """Return C_v of a law."""
        return coefficients(named(law, parameters)).cv

    @answered
    def CA(self, law: str, parameters: Cells) -> float:
        """Return C_a of a law."""
        return coefficients(named(law, parameters)).ca

    @answered
    def CARMS(self, law: str, parameters: Cells) -> float:
        """Return C_a,rms of a law."""
        return coefficients(named(law, parameters)).ca_rms

    @answered
    def CJ(self, law: str, parameters: Cells) -> float:
        """Return C_j of a law; infinite, which is #NUM!, where its acceleration jumps."""
        return coefficients(named(law, parameters)).cj

    @answered
    def POS(self, x: float, phases: Cells) -> float:
        """Return the position of a motion."""
        return motion(phases).at(x)[0]

    @answered
    def VEL(self, x: float, phases: Cells) -> float:
        """Return the velocity of a motion."""
        return motion(phases).at(x)[1]

    @answered
    def ACC(self, x: float, phases: Cells) -> float:
        """Return the acceleration of a motion."""
        return motion(phases).at(x)[2]

    @answered
    def JRED(self, inertias: Cells, ratios: Cells) -> float:
        """Return the reflected inertia."""
        return reflected(*pairs(inertias, ratios))

    @answered
    def RMS(self, values: Cells, durations: Cells) -> float:
        """Return the root mean square."""
        return root_mean_square(*pairs(values, durations))

    def getImplementationName(self) -> str:
        """Return the name that LibreOffice registers."""
        return IMPLEMENTATION

    def supportsService(self, name: str) -> bool:
        """Whether the component is such a service."""
        return name in SERVICES

    def getSupportedServiceNames(self) -> tuple[str, ...]:
        """Return what the component is."""
        return SERVICES


g_ImplementationHelper = unohelper.ImplementationHelper()  # noqa: N816 - the name that LibreOffice looks for
g_ImplementationHelper.addImplementation(MotionFunctions, IMPLEMENTATION, SERVICES)
