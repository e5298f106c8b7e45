"""The sheet Power: what the drives take from the mains and burn in their resistors, each alone and on a common bus."""

from __future__ import annotations

from engine.machine.bus import together
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import total
from workbook.book.sentence import Said
from workbook.entries.units import KW, shown
from workbook.machines.machine.bus_table import breaks_table, bus_table, lines_chart
from workbook.machines.machine.bussed import Bus
from workbook.machines.machine.linked.worked import PlacedWork

KWH = 3.6e6  # J
NOTE = "A drive takes what its motor needs over η; what comes back, times η, goes into its brake resistor."
TOGETHER = "Drives use what others give back; what is left goes into one resistor."
APART = "A drive at a rate of its own has no place in the {}: it is alone."
ROOM = "more places where power may jump than this sheet has rows for; build it with larger sizes.motion_pieces"
CHART_COLUMN = 10


def supply(bus: Bus) -> list[Quantity]:
    """Return what the first sheet tells of all drives: those at a rate of their own are beside the bus."""
    if not bus.drives:
        return []
    hours, beside = bus.entered.hours, "SUMPRODUCT((1-[power.bus])*[power.{}])"
    peak = sum([bus.mains_peak, *(one.mains for one in bus.of(bus.most, shared=False))])
    means = together([bus.common, *bus.of(bus.each, shared=False)])
    return [
        result("about_peak", "Peak power from the mains", "P_max", "kW", f"=bus_mains_peak+{beside.format('peak')}",
               shown(peak, KW), scale=common_floor(bus), source="on a common DC bus"),
        result("about_bus_year", "Energy a year", "E", "kWh", f"=bus_year+{beside.format('mains')}*power_hours",
               shown(means.energy_a_year(hours), KWH), scale=common_floor(bus), source="on a common DC bus"),
        result("about_year", "… each drive alone", "E", "kWh", "=power_year",
               shown(bus.alone.energy_a_year(hours), KWH), scale=floor_of(bus)),
    ]  # fmt: skip


def floor_of(bus: Bus) -> float:
    """Return the size of power below which its rounding is nothing (kW)."""
    return shown(max(1e-3, *(one.driven.scales.power for one in bus.drives)), KW)


def common_floor(bus: Bus) -> float:
    """Return that size on a common bus (kW)."""
    return max(shown(bus.size, KW), floor_of(bus))


def power_sheet(book: Book, bus: Bus) -> None:
    """Declare the sheet, where there are drives."""
    if not bus.drives:
        return
    sheet = book.sheet("Power", "Energy of the drives: from the mains, in brake resistors, over a year.")
    entered = bus.entered
    sheet.heading("Enter", NOTE)
    sheet.rows(
        given("power_efficiency", "Efficiency of a drive", "η", "", entered.efficiency, "power.efficiency",
              format="0.0##", source="between its motor's shaft and the mains"),
        given("power_hours", "Hours of running a year", "", "h", entered.hours, "power.hours", format="0.##"),
    )  # fmt: skip
    sheet.heading("Results: each drive alone")
    sheet.rows(*totals(bus, floor_of(bus)))
    sheet.heading("Results: on a common DC bus", TOGETHER)
    sheet.note(APART.format(bus.over.period))
    sheet.rows(*common(bus, common_floor(bus)))
    sheet.checks(check("power_room", "Power: rows for all places",
                       "MAX([bus.e])>=360-timing_eps", bus.lines.enough, says=Said(f'"{ROOM}"', ROOM)))  # fmt: skip
    sheet.chart(lines_chart(bus.over), column=CHART_COLUMN, row=5, width=9, height=20)
    sheet.row += 1
    drives_table(sheet, bus, floor_of(bus))
    sheet.not_printed_below()
    sheet.print_columns = 18
    breaks_table(sheet, bus)
    bus_table(sheet, bus)


def totals(bus: Bus, floor: float) -> list[Quantity]:
    """Return the results of drives that share no bus."""
    whole = bus.alone
    return [
        result("power_mains", "Mean power from the mains", "P", "kW", f"={total('power.mains')}",
               shown(whole.mains, KW), scale=floor, source="exact, without a common DC bus"),
        result("power_resistors", "Mean power in the brake resistors", "", "kW", f"={total('power.resistor')}",
               shown(whole.resistor, KW), scale=floor),
        result("power_year", "Energy a year", "E", "kWh", "=power_mains*power_hours",
               shown(whole.energy_a_year(bus.entered.hours), KWH), scale=floor),
        result("power_least", "Mean power from the mains if all that comes back is used", "", "kW",
               "=MAX(0,power_mains-power_resistors)", shown(whole.least, KW), scale=floor,
               source="no bus can do better"),
    ]  # fmt: skip


def common(bus: Bus, size: float) -> list[Quantity]:
    """Return the results of drives on a common bus, and by how much they are off at most."""
    found, lines = bus.common, bus.lines
    net = together(bus.of(bus.each, shared=True))
    resistor = max(0.0, -float(lines.common.min()))
    own = "SUMPRODUCT([power.bus]*([power.mains]-[power.resistor]))"
    return [
        result("bus_alone", "Peak power from the mains without the bus", "", "kW",
               "=MAX(MAX([bus.alone]),MAX([bus.alone_e]))", shown(float(lines.alone.max()), KW), scale=size),
        result("bus_mains_peak", "Peak power from the mains", "P_max", "kW",
               "=MAX(0,MAX([bus.sum]),MAX([bus.sum_e]))", shown(bus.mains_peak, KW), scale=size),
        result("bus_mains", "Mean power from the mains", "P", "kW", f"={total('bus.above')}/360",
               shown(found.mains, KW), scale=size),
        result("bus_resistor_peak", "Peak power in the brake resistor", "", "kW",
               "=MAX(0,0-MIN([bus.sum]),0-MIN([bus.sum_e]))", shown(resistor, KW), scale=size),
        result("bus_resistor", "Mean power in the brake resistor", "", "kW",
               "=bus_mains-SUMPRODUCT(([bus.e]-[bus.b])*[bus.on],([bus.sum]+[bus.sum_e])/2)/360",
               shown(found.resistor, KW),
               scale=size),
        result("bus_year", "Energy a year", "E", "kWh", "=bus_mains*power_hours",
               shown(found.energy_a_year(bus.entered.hours), KWH), scale=size, source="of these drives"),
        result("bus_off", "None of these is off by more than", "", "kW", f"={total('power.off')}",
               shown(sum(map(bus.off, bus.drives)), KW), scale=size,
               source="Σ |P''| δ²/8 + |ΔP'| δ/4: straight lines between places"),
        calc("bus_net_off", "Their means are off by", "", "kW",
             f"=ABS(bus_mains-bus_resistor-{own})", shown(abs(found.net - net.net), KW), scale=size,
             source="mains less resistor, beside the exact one"),
        constant("bus_step", "Places of the sum are apart by", "δ", "°", bus.step, source="or less, at every jump"),
    ]  # fmt: skip


def drives_table(sheet: Sheet, bus: Bus, floor: float) -> None:
    """Declare a row for each drive: its energy, mean and peak powers, and what it adds to the error of the sum."""
    drives, each = bus.drives, bus.each
    driven = [one.driven for one in drives]
    scopes = [f"drive{one.number}_" for one in driven]
    scale, peak = max(one.scales.work for one in driven), shown(max(one.most_power for one in drives), KW)
    energies = [one.demand.energy for one in driven]
    tables = ["sec" if isinstance(one, PlacedWork) else "st" for one in drives]

    sheet.table(
        "power", "Drives", len(drives),
        constant("k", "number of the axis", "k", "", [one.number for one in driven]),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in driven],
             [one.entered.name for one in driven], align="left"),
        calc("time", "cycle", "t_c", "s", [f"=60/{scope}rate" for scope in scopes],
             [one.demand.course.time for one in driven]),
        calc("driving", "its motor drives with", "E", "J", [f"={scope}energy+0" for scope in scopes],
             [one.driving for one in energies], scale=scale),
        calc("returned", "comes back to it", "", "J", [f"={scope}returned+0" for scope in scopes],
             [one.regenerated for one in energies], scale=scale),
        result("mains", "mean power from the mains", "P", "kW", "=[driving]/power_efficiency/[time]/1000",
               [shown(one.mains, KW) for one in each], scale=floor),
        result("peak", "peak", "P_max", "kW", [f"={scope}pmax/power_efficiency" for scope in scopes],
               [shown(one.mains, KW) for one in bus.most], scale=peak, source="exact"),
        result("resistor", "mean power in its resistor", "", "kW", "=[returned]*power_efficiency/[time]/1000",
               [shown(one.resistor, KW) for one in each], scale=floor),
        result("burnt", "peak", "", "kW", [f"=0-{scope}pmin*power_efficiency" for scope in scopes],
               [shown(one.resistor, KW) for one in bus.most], scale=peak, source="exact"),
        calc("bus", "on the common bus", "", "", [f'=IF({scope}own_rate="",1,0)' for scope in scopes],
             [int(bus.shares(one)) for one in drives], format="0", source="1: yes"),
        calc("off", "its lines are off by at most", "", "kW",
             [f"=[bus]*MAX([{scope}{table}.off])" for scope, table in zip(scopes, tables, strict=True)],
             [shown(bus.off(one), KW) for one in drives], scale=shown(bus.size, KW)),
    )  # fmt: skip
