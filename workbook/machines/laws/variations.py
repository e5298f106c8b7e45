"""Variations of the comparison: laws with other parameters, every one of them drawn in turn."""

from typing import Any

from workbook.laws.variations import SIX, factors, law_for, variations, vary_laws
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws


def variants(machine: MotionLaws) -> list[MotionLaws]:
    """Return six books of the same layout, with other laws drawn and other parameters everywhere."""
    return [MotionLaws.model_validate(data) for data in variations(machine, varied)]


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: one curve to four."""
    k = turn % SIX
    vary_laws(data["laws"], k, factors(k), data["sizes"]["pieces"])
    count = (MOST_CURVES, 1, 3, MOST_CURVES, 2, MOST_CURVES)[k]
    names = ["DWL", *data["laws"]]
    data["comparison"]["curves"] = [{"law": law_for(MOST_CURVES * turn + i, names)} for i in range(count)]
    return data
