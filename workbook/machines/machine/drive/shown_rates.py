"""The range of rates of a drive as its sheet shows it."""

import math
from typing import NamedTuple

from engine.drive.rate_estimates import RateRange
from workbook.fields.units import PER_MINUTE, shown

NONE_BINDS, AT_NO_RATE = "none", "at no rate"
"""the words for a highest rate where no limit binds, and where none is held"""


class Rates(NamedTuple):
    """The rates (cycles/min) between which a drive holds all limits, or words, and the limits at either end."""

    low: float | str
    high: float | str
    low_limit: str
    high_limit: str

    @classmethod
    def of(cls, found: RateRange) -> "Rates":
        """Return a range of rates (1/s)."""
        if found.high == 0.0:
            return cls(AT_NO_RATE, AT_NO_RATE, AT_NO_RATE, found.high_limit)
        low, high = (shown(rate, PER_MINUTE) for rate in found[:2])
        return cls(
            low,
            high if math.isfinite(high) else NONE_BINDS,
            found.low_limit or NONE_BINDS,
            found.high_limit or NONE_BINDS,
        )
