"""Phases in cells: what a row of phases computes from its law's coefficients, and how a sample finds its phase."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from engine.laws.base import Array
from engine.motion import Motion
from workbook.book.declare import Quantity, calc
from workbook.book.rows import filled
from workbook.laws import sampling
from workbook.laws.entries import Laws

LAW_NUMBER = '=IF([law]="",1,MATCH([law],law_code,0))'
CA = "MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))"
VELOCITY = "=IF([span]>0,INDEX(law_cv,[no])*ABS([h])/[span],0)"
ACCELERATION = f"=IF([span]>0,{CA}*ABS([h])/[span]^2,0)"
RMS = "IF([span]>0,INDEX(law_ca_rms,[no])*ABS([h])/[span]^2,0)"
AT_END = "=IF([span]>0,INDEX(law_{0},[no])*[h]/[span]{1},0)"


def kind(given: str) -> str:
    """Return the formula that names a phase: spare where its entry ``given`` is empty, else by law and lift."""
    return f'=IF([{given}]="","spare",IF(OR([law]="DWL",[lift]=0),"dwell",IF([lift]>0,"rise","return")))'


def kinds(laws: Sequence[str], lifts: Sequence[float], rows: int) -> list[str]:
    """Return what each phase is, with the spare rows filled up."""
    used = [
        "dwell" if law == "DWL" or lift == 0 else "rise" if lift > 0 else "return"
        for law, lift in zip(laws, lifts, strict=True)
    ]
    return filled(used, rows, "spare")


def law_numbers(names: Sequence[str], laws: Laws, rows: int) -> list[int]:
    """Return the number of each phase's law, with the spare rows filled up."""
    return filled([laws.number(name) for name in names], rows, 1)


def located(
    motion: Motion, x: Array, pieces: sampling.Pieces, formulas: tuple[str, str, str], sources: tuple[str, str],
    of: str = "", suffix: str = "",
) -> list[Quantity]:  # fmt: skip
    """Return the workings of a sampled motion: phase, ξ, law, piece, and the law's s, v, a.

    ``formulas`` find a sample's phase, its ξ and the number of its law; ``sources`` are the words beside the first
    two. Labels begin with ``of``, names end with ``suffix``.
    """
    index, share = motion.phase_index(x), motion.xi(x)
    numbers = np.array([pieces.number(p.law) for p in motion.phases])[index]
    found = np.empty((pieces.width, len(x)))
    values = {d: np.empty(len(x)) for d in "sva"}
    for k in np.unique(index):
        here = index == k
        found[:, here] = pieces.locate(int(numbers[here][0]), share[here])
        for d, value in zip("sva", motion.phases[k].law.evaluate(share[here]), strict=False):
            values[d][here] = value
    return [
        calc(f"p{suffix}", f"{of}phase", "", "", formulas[0], index + 1, format="0", source=sources[0]),
        calc(f"xi{suffix}", f"{of}abscissa", "ξ", "", formulas[1], share, source=sources[1]),
        calc(f"n{suffix}", f"{of}law", "", "", formulas[2], numbers, format="0"),
        *pieces.finding(f"[n{suffix}]", f"xi{suffix}", found, suffix),
        *pieces.columns(values, "sva", suffix),
    ]  # fmt: skip
