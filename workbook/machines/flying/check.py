"""What only the engine can say of the entries of a flying cutter."""

import numpy as np

from engine.flying.tool import LONGER
from engine.laws.inverse import is_monotone
from engine.laws.sections import velocity_extremes
from workbook.book.sentence import figure
from workbook.entries.types import END_TOLERANCE, DesignError
from workbook.entries.units import MM, shown
from workbook.laws.entries import Laws
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.machines.flying.entries import FlyingCutter
from workbook.machines.flying.view import REST, tool_of

LEAST_CV = 1.001  # below, no product is too long to keep moving


def check(machine: FlyingCutter) -> None:
    """Raise DesignError for a law that does not do, and for products that leave no time to re-position."""
    require_law(machine.cutter.law, machine.laws)
    least = shown(LONGER * tool_of(machine.cutter).tool_length, MM)
    for entry, length in (
        ("product_length", machine.cutter.product_length),
        ("lengths.shortest", machine.cutter.lengths.shortest),
    ):
        if length < least:
            said = f"a product of {figure(length)} mm; expected at least {figure(least)} mm"
            raise DesignError(f"cutter.{entry}", said, "length", least + least)


def require_law(code: str, given: Laws) -> None:
    """Raise DesignError unless the law goes from rest at 0 to rest at 1, speeds up once and slows down once."""
    law = laws(given)[code]
    speeds = law.v(velocity_extremes(law))
    top = int(np.argmax(speeds))
    falls = np.diff(speeds)
    rests = max(abs(law.start.v), abs(law.end.v)) <= REST and abs(law.end.s - 1) <= END_TOLERANCE
    once = min(falls[:top].min(initial=0.0), -falls[top:].max(initial=0.0)) >= -REST
    if not (is_monotone(law) and rests and once and law.coefficients.cv >= LEAST_CV):
        raise DesignError("cutter.law", f"the law {code} does not: see its sheet, or Laws", "law", RISING[0])
