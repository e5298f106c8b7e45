"""The sheet Power: what the drives take from the mains and burn in their resistors on average, exact."""

from __future__ import annotations

from collections.abc import Sequence

from engine.machine.bus import Means, means, together
from workbook.book.declare import Book, calc, constant, given, result
from workbook.entries.units import shown
from workbook.machines.machine.chain import PowerEntry
from workbook.machines.machine.driven import Driven

KWH = 3.6e6  # J
NOTE = "A drive takes what its motor needs over η; what comes back, times η, goes into its brake resistor."


def alone(driven: Driven, efficiency: float) -> Means:
    """Return what a drive without a common DC bus takes and burns."""
    return means(driven.demand.energy, driven.demand.course.time, efficiency)


def power_sheet(book: Book, given_power: PowerEntry, drives: Sequence[Driven]) -> None:
    """Declare the sheet, where there are drives."""
    if not drives:
        return
    sheet = book.sheet("Power", "Energy of the drives: from the mains, in brake resistors, over a year.")
    each = [alone(one, given_power.efficiency) for one in drives]
    whole = together(each)
    floor = max(1e-3, *(one.scales.power for one in drives))
    sheet.heading("Enter", NOTE)
    sheet.rows(
        given("power_efficiency", "Efficiency of a drive", "η", "", given_power.efficiency, "power.efficiency",
              format="0.0##", source="between its motor's shaft and the mains"),
        given("power_hours", "Hours of running a year", "", "h", given_power.hours, "power.hours", format="0.##"),
    )  # fmt: skip
    sheet.heading("Results")
    sheet.rows(
        result("power_mains", "Mean power from the mains, each drive alone", "P", "W", "=SUM([power.mains])",
               whole.mains, scale=floor, source="without a common DC bus"),
        result("power_resistors", "Mean power in the brake resistors", "", "W", "=SUM([power.resistor])",
               whole.resistor, scale=floor),
        result("power_year", "Energy a year", "E", "kWh", "=power_mains*power_hours/1000",
               shown(whole.energy_a_year(given_power.hours), KWH), scale=floor),
        result("power_least", "Mean power from the mains on a common DC bus, at least", "", "W",
               "=MAX(0,power_mains-power_resistors)", whole.least, scale=floor,
               source="if all that comes back is used"),
    )  # fmt: skip
    scopes = [f"drive{one.number}_" for one in drives]
    sheet.table(
        "power", "Drives", len(drives),
        constant("k", "number of the axis", "k", "", [one.number for one in drives]),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in drives],
             [one.entered.name for one in drives], align="left"),
        calc("time", "cycle", "t_c", "s", [f"=60/{scope}rate" for scope in scopes],
             [one.demand.course.time for one in drives]),
        calc("driving", "its motor drives with", "E", "J", [f"={scope}energy+0" for scope in scopes],
             [one.demand.energy.driving for one in drives], scale=max(one.scales.work for one in drives)),
        calc("returned", "comes back to it", "", "J", [f"={scope}returned+0" for scope in scopes],
             [one.demand.energy.regenerated for one in drives], scale=max(one.scales.work for one in drives)),
        result("mains", "mean power from the mains", "P", "W", "=[driving]/power_efficiency/[time]",
               [one.mains for one in each], scale=floor),
        result("resistor", "mean power in its resistor", "", "W", "=[returned]*power_efficiency/[time]",
               [one.resistor for one in each], scale=floor),
    )  # fmt: skip
