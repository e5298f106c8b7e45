"""The axes of a machine in short, for its first sheet: travel, greatest rates, and what each drive is used to."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from engine.drive.motor import Reserve
from workbook.book.declare import Quantity, Sheet, calc, result
from workbook.entries.units import PERCENT, RPM, shown

WHOLE = 100.0
"""% of a limit"""
NO_DRIVE, ENTERED, MACHINES = "–", "as entered", "machine's"
NAMED = 'IF({0}motor_name="","' + ENTERED + '",{0}motor_name)'


class Highest(NamedTuple):
    """The highest rate (cycles/min) at which a drive holds all limits, or a word, and the limiting factor.

    ``own`` is the rate that it is sized at, if not the machine's.
    """

    rate: float | str
    limit: str
    own: float | None = None


class InShort(NamedTuple):
    """An axis: its name, travel between its ends and greatest rates.

    Of its drive: the motor's name, or none where its figures are entered, ratio, use, and the scope of the cells; the
    highest rate of one whose sheet has it.
    """

    name: str
    travel: float
    fastest: float
    hardest: float
    reserve: Reserve | None = None
    scope: str = ""
    motor: str = ""
    ratio: float = 1.0
    highest: Highest | None = None


def axes_in_short(sheet: Sheet, axes: Sequence[InShort], travel: str, rates: Sequence[tuple[str, str]]) -> None:
    """Declare a row for each axis of the table ``axes``, its travel and rates in these units; drives where there are.

    ``rates`` are symbols and units of velocity and acceleration.
    A drive's cells are those of :mod:`workbook.drive.motor`, in its scope.
    """
    driven = drives(axes) if any(axis.reserve for axis in axes) else []

    def each(formula: str) -> list[str]:
        return [formula.format(i) for i in range(1, len(axes) + 1)]

    sheet.row += 1
    sheet.table(
        "axes_short", "Axes", len(axes),
        calc("axis", "axis", "", "", each("=[axes.name.{0}]"), [axis.name for axis in axes], align="left"),
        result("travel", "travel", "h", travel, each("=[axes.high.{0}]-[axes.low.{0}]"), [axis.travel for axis in axes],
               "highest less lowest position"),
        result("v", "greatest velocity", *rates[0], each("=[axes.v.{0}]"), [axis.fastest for axis in axes]),
        result("a", "greatest acceleration", *rates[1], each("=[axes.a.{0}]"), [axis.hardest for axis in axes]),
        *driven,
        *(highest_rates(axes) if any(axis.highest for axis in axes) else []),
    )  # fmt: skip


def drives(axes: Sequence[InShort]) -> list[Quantity]:
    """Return the columns on the motors: name, ratio, torque and speed with the share of each limit that is used."""
    peak = "MAX({0}tmax,0-{0}tmin)"

    def column(
        name: str, label: str, symbol: str, unit: str, formula: str, value: Callable[[InShort, Reserve], float | str],
        look: str = "", limit: float = 0.0,
    ) -> Quantity:  # fmt: skip
        texts = [f"={formula.format(a.scope)}" if a.reserve else f'="{NO_DRIVE}"' for a in axes]
        values = [value(a, a.reserve) if a.reserve else NO_DRIVE for a in axes]
        return result(name, label, symbol, unit, texts, values, format=look, align="right", limit=limit)

    return [
        column("motor", "motor", "", "", NAMED, lambda axis, _: axis.motor or ENTERED),
        column("ratio", "ratio of the reducer", "i", "", "{0}i1", lambda axis, _: axis.ratio),
        column("peak", "peak torque", "T_max", "Nm", peak, lambda _, use: use.peak_torque.value),
        column("of_peak", "of the motor's peak", "", "%", f"100*{peak}/{{0}}motor_peak",
               lambda _, use: shown(use.peak_torque.use, PERCENT), "0", WHOLE),
        column("rms", "RMS torque", "T_rms", "Nm", "{0}rms", lambda _, use: use.rms_torque.value),
        column("of_rated", "of its continuous torque", "", "%", "100*{0}rms/{0}continuous",
               lambda _, use: shown(use.rms_torque.use, PERCENT), "0", WHOLE),
        column("speed", "speed", "n_max", "rpm", "{0}speed", lambda _, use: shown(use.speed.value, RPM), "0"),
        column("of_speed", "of the motor's largest", "", "%", "100*{0}speed/{0}motor_nmax",
               lambda _, use: shown(use.speed.use, PERCENT), "0", WHOLE),
    ]  # fmt: skip


def highest_rates(axes: Sequence[InShort]) -> list[Quantity]:
    """Return the columns of the highest rate of each drive, and of the limiting factor."""
    cells = [[f"={a.scope}{name}" if a.highest else f'="{NO_DRIVE}"' for a in axes] for name in ("highest", "binds")]
    values = [a.highest or (NO_DRIVE, NO_DRIVE, NO_DRIVE) for a in axes]
    own = [f'=IF({a.scope}own_rate="","{MACHINES}",{a.scope}own_rate)' if a.highest else f'="{NO_DRIVE}"' for a in axes]
    return [
        result("sized", "sized at", "N", "cycles/min", own, [MACHINES if at is None else at for *_, at in values],
               align="right"),
        result("highest", "highest rate", "N", "cycles/min", cells[0], [rate for rate, *_ in values],
               "within all limits; approximate", format="0.0", align="right"),
        result("binds", "limiting factor", "", "", cells[1], [limit for _, limit, _ in values], align="right"),
    ]  # fmt: skip
