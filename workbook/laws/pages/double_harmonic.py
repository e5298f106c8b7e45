"""Double harmonic: two sines, from rest to a reversal."""

from typing import Literal

from engine.laws.double_harmonic import DoubleHarmonic
from workbook.laws.family import LawSheet, Page, PieceRow
from workbook.laws.pages.modified import REVERSAL


class Reversed(LawSheet):
    """The end at which the motion turns round."""

    reversal: Literal["start", "end"] = "end"


ENDS = 'IF(@reversal="end",{0},{1})'
PEAK = "ATAN2(1,SQRT(15))/PI()"
"""where the acceleration at the end at rest is largest: cos πξ = ¼"""
POWER = "675*SQRT(15)*PI()^3/8192"

PAGE = Page(
    source="LCamHdl, D_R_DOUBLE_HARMONIC; saltire.com, cam functions",
    entries=Reversed,
    law=DoubleHarmonic,
    parameters=(REVERSAL,),
    variations=({"reversal": "start"}, {"reversal": "end"}),
    pieces=(
        PieceRow(
            "two sines", "sin⁴(πξ/2), or mirrored", f"={ENDS.format(PEAK, f'1-{PEAK}')}",
            P="=PI()^2/2", omega="=PI()", phi=f"={ENDS.format('PI()/2', '0-3*PI()/2')}",
            P2="=0-PI()^2/2", omega2="=2*PI()", phi2=f"={ENDS.format('PI()/2', '0-5*PI()/2')}",
        ),
        PieceRow(
            "the same", "from where cos πξ = ¼, or mirrored", f"={ENDS.format(f'1-{PEAK}', PEAK)}",
            P="=PI()^2/2", omega="=PI()", phi="=[phi-1]+[omega-1]*[d-1]",
            P2="=0-PI()^2/2", omega2="=2*PI()", phi2="=[phi2-1]+[omega2-1]*[d-1]",
        ),
    ),
    coefficients={
        "cv": ("=3*SQRT(3)*PI()/8", "2π sin³x cos x at x = π/3, x = πξ/2"),
        "ca_max": (f"={ENDS.format('9*PI()^2/16', 'PI()^2')}", "where cos πξ = ¼; at the reversal π²"),
        "ca_min": (f"=0-{ENDS.format('PI()^2', '9*PI()^2/16')}", "the same, of the other end"),
        "ca_rms": ("=PI()^2/2", "of two sines of π²/2 each"),
        "cj": ('="∞"', "the acceleration jumps at the reversal, unless its mirror follows"),
        "va_max": (f"={ENDS.format('PI()^3/4', POWER)}", "at ξ = ½, or where cos πξ = 7/8"),
        "va_min": (f"=0-{ENDS.format(POWER, 'PI()^3/4')}", "the same, of the other end"),
    },
    fastest=f"={ENDS.format('2/3', '1/3')}",
)  # fmt: skip

PAGES = (PAGE,)
