"""The sheet Power: what the drives take from the mains and burn in their resistors, each alone and on a common bus."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from engine.drive.results import MeanBusPower, peak_bus_power, total_bus_power
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, entries_of, result
from workbook.book.rows import total
from workbook.fields.units import KW, shown
from workbook.machines.machine.bus_cuts import BusCuts, cuts_table
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive_entries import PowerEntry

KWH = 3.6e6  # J
NOTE = "A drive takes what its motor needs over η; what comes back, times η, goes into its brake resistor."
TOGETHER = "Drives use what others give back; what is left goes into one resistor. They take no more than each alone."
APART = "A drive at a rate of its own has no place in the {}: it is alone."
CHART_COLUMN = 10
YEAR = '0.0;-0.0;"–"'  # format of the energy of a year: a dash where no hours of running are entered
kw = partial(shown, unit=KW)


class Mains:
    """Powers of drives over one turn (W): of each alone, and of those that run at the machine's rate on a bus.

    A drive ``on_bus`` has 1 there, else 0. Powers at samples of the cycle: ``drawn`` by each, below 0 what comes back,
    their ``sum`` on the bus, and ``apart`` what they take without it.
    """

    def __init__(self, drives: Sequence[DriveView], entered: PowerEntry) -> None:
        self.drives, self.entered, self.over, eta = drives, entered, drives[0].tables.machine.over, entered.efficiency
        self.each = [one.energy.mean_bus_power(one.driven.drive_cycle.time, eta) for one in drives]
        self.alone = total_bus_power(self.each)
        most = [(one.top("P"), -one.top("P", -1)) for one in drives]
        tops = [peak_bus_power(powers, eta) for powers in most]
        self.size = max(1e-3, math.fsum(max(one) for one in tops))  # how large all together grow
        self.mains, self.resistor = np.array(tops).T  # the peaks of each without a bus

        bus = self.on_bus = np.array([float(one.driven.entered.rate is None) for one in drives])
        power = np.array([one.sampled[1] for one in drives])
        self.drawn = bus[:, None] * np.where(power > 0.0, power / eta, power * eta)
        self.sum, self.apart = self.drawn.sum(axis=0), np.maximum(self.drawn, 0.0).sum(axis=0)
        self.weights = np.full(self.sum.size, 1.0 / (self.sum.size - 1))  # in a mean, by the trapezoidal rule
        self.weights[[0, -1]] /= 2.0
        self.cuts = BusCuts(drives, bus, np.array([self.mains, self.resistor]))
        mains, resistor = bus * self.mains, bus * self.resistor
        self.proves = bus * (mains - (resistor.sum() - resistor))  # what the bus takes at least, by a drive's peak
        self.burns = bus * (resistor - (mains.sum() - mains))  # what it burns at least
        self.peak = min(self.cuts.most, max(0.0, float(self.sum.max()), float(self.proves.max())))
        self.burnt_peak = min(self.cuts.most_back, max(0.0, -float(self.sum.min()), float(self.burns.max())))
        self.without = MeanBusPower(*(float(bus @ [one[k] for one in self.each]) for k in (0, 1)))
        self.saved_most = min(*self.without, self.cuts.saved) if bus.sum() > 1.0 else 0.0
        self.saved = min(self.saved_most, float(self.weights @ (self.apart - np.maximum(self.sum, 0.0))))
        self.common = MeanBusPower(*(one - self.saved for one in self.without))


def supply(bus: Mains) -> list[Quantity]:
    """Return the results of all drives for the first sheet; those at a rate of their own are beside the bus."""
    hours, beside, size = bus.entered.hours, "SUMPRODUCT((1-[power.bus])*[power.{}])", kw(bus.size)
    alone = float((1.0 - bus.on_bus) @ bus.mains)
    others = [one for one, on_bus in zip(bus.each, bus.on_bus, strict=True) if not on_bus]
    return [
        result("about_peak", "Peak power from the mains", "P_max", "kW", f"=bus_mains_peak+{beside.format('peak')}",
               kw(bus.peak + alone), "on a common DC bus", scale=size),
        result("about_peak_most", "… at most", "", "kW", f"=bus_mains_most+{beside.format('peak')}",
               kw(bus.cuts.most + alone), "whatever its samples miss", scale=size),
        result("about_bus_year", "Energy a year", "E", "kWh", f"=bus_year+{beside.format('mains')}*power_hours",
               shown(total_bus_power([bus.common, *others]).energy_a_year(hours), KWH), "on a common DC bus",
               scale=size, format=YEAR),
        result("about_year", "… each drive alone", "E", "kWh", "=power_year",
               shown(bus.alone.energy_a_year(hours), KWH), scale=size, format=YEAR),
    ]  # fmt: skip


def power_sheet(book: Book, bus: Mains) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Power", "Energy of the drives: from the mains, in brake resistors, over a year.")
    size, entry = kw(bus.size), entries_of(bus.entered, "power")
    sheet.sizes = {"kW": size, "kWh": size, "J": max(one.scales.work for one in bus.drives)}
    sheet.heading("Enter", NOTE)
    sheet.rows(
        entry("power_eta", "Efficiency of a drive", "η", "", "efficiency", "between its motor's shaft and the mains"),
        entry("power_hours", "Hours of running a year", "", "h", "hours", format="0.##"),
        entry("power_price", "Price of a kWh", "", "", "price", "in any currency", format="0.0###"),
    )
    sheet.heading("Results: each drive alone")
    whole = bus.alone
    sheet.rows(
        result("power_mains", "Mean power from the mains", "P", "kW", f"={total('power.mains')}", kw(whole.mains),
               "from the points, without a common DC bus"),
        result("power_resistors", "Mean power in the brake resistors", "", "kW", f"={total('power.resistor')}",
               kw(whole.resistor)),
        result("power_year", "Energy a year", "E", "kWh", "=power_mains*power_hours",
               shown(whole.energy_a_year(bus.entered.hours), KWH), format=YEAR),
        result("power_least", "Mean power from the mains, all regenerated energy used", "", "kW",
               "=MAX(0,power_mains-power_resistors)", kw(whole.least), "lower bound"),
    )  # fmt: skip
    sheet.heading("Results: on a common DC bus", TOGETHER)
    sheet.note(APART.format(bus.over.period))
    sheet.rows(*common(bus))
    over, x = bus.over, "[bus.time]" if bus.over.measured else "[bus.theta]"
    lines = (Series("on a common bus", x, "[bus.sum]"),
             Series("each drive alone, from the mains", x, "[bus.alone]", dashed=True))  # fmt: skip
    chart = Chart(f"Power over the {over.period}", over.title, "P [kW]", lines,
                  f"Power from the mains over {over.cycle}", over.axis(60))  # fmt: skip
    sheet.chart(chart, column=CHART_COLUMN, row=5, width=9, height=20)
    sheet.row += 1
    drives_table(sheet, bus)
    sheet.not_printed_below()
    sheet.print_columns = 18
    bus_table(sheet, bus)
    cuts_table(sheet, bus.cuts)


def common(bus: Mains) -> list[Quantity]:
    """Return the results of drives on a common bus, with their bounds, and what it saves in a year."""
    found, whole, entered = bus.common, bus.without, bus.entered
    apart = max(float(bus.apart.max()), float((bus.on_bus * bus.mains).max()))
    of_all = "SUMPRODUCT([power.bus]*[power.{}])"
    sampled = "SUMPRODUCT([bus.w],[bus.alone]-[bus.sum]*([bus.sum]>0))"
    year = shown(MeanBusPower(bus.saved, 0.0).energy_a_year(entered.hours), KWH)
    return [
        result("bus_alone", "Peak power from the mains without the bus", "", "kW",
               "=MAX(MAX([bus.alone]),SUMPRODUCT(MAX([power.bus]*[power.peak])))", kw(apart)),
        result("bus_mains_peak", "Peak power from the mains", "P_max", "kW",
               "=MIN(bus_mains_most,MAX(0,MAX([bus.sum]),MAX([power.proves])))", kw(bus.peak),
               "of the samples, and what one drive's peak proves"),
        result("bus_mains_most", "… at most", "", "kW", "=MAX([bus_cuts.most])", kw(bus.cuts.most), "between all cuts"),
        result("bus_resistor_peak", "Peak power in the brake resistor", "", "kW",
               "=MIN(bus_resistor_most,MAX(0,0-MIN([bus.sum]),MAX([power.burns])))", kw(bus.burnt_peak)),
        result("bus_resistor_most", "… at most", "", "kW", "=MAX([bus_cuts.back])", kw(bus.cuts.most_back)),
        result("bus_apart", "Mean power from the mains without the bus", "", "kW", f"={of_all.format('mains')}",
               kw(whole.mains), "from the points of these drives"),
        calc("bus_net", "Mean power lost and used", "", "kW", f"=bus_apart-{of_all.format('resistor')}",
             kw(whole.net), "what no bus can save"),
        result("bus_saved", "Mean power that the bus saves", "", "kW", f"=MIN(bus_saved_most,{sampled})", kw(bus.saved),
               "what drives take of what others return, at the samples"),
        result("bus_saved_most", "… at most", "", "kW",
               "=IF(SUM([power.bus])>1,MIN(bus_apart,bus_apart-bus_net,"
               "SUMPRODUCT([bus_cuts.span],[bus_cuts.both])/360),0)",
               kw(bus.saved_most), "between all cuts the smaller of both sums"),
        result("bus_mains", "Mean power from the mains", "P", "kW", "=bus_apart-bus_saved", kw(found.mains)),
        result("bus_resistor", "Mean power in the brake resistor", "", "kW", "=bus_mains-bus_net", kw(found.resistor)),
        result("bus_year", "Energy a year", "E", "kWh", "=bus_mains*power_hours",
               shown(found.energy_a_year(entered.hours), KWH), "of these drives", format=YEAR),
        result("bus_saved_year", "Energy that the bus saves a year", "", "kWh", "=bus_saved*power_hours", year,
               format=YEAR),
        result("bus_saved_price", "… its price", "", "", "=bus_saved_year*power_price", year * entered.price,
               "in the currency of the price of a kWh", scale=max(1.0, kw(bus.size) * entered.price), format=YEAR),
    ]  # fmt: skip


def drives_table(sheet: Sheet, bus: Mains) -> None:
    """Declare a row for each drive: its energy, mean and peak powers, and what its peak proves of the bus."""
    drives, each = bus.drives, bus.each
    driven = [one.driven for one in drives]
    scopes, powers = ([f"drive{one.number}_{name}" for one in driven] for name in ("", "P"))
    burnt = "(SUMPRODUCT([power.bus]*[power.burnt])-[bus]*[burnt])"
    taken = "(SUMPRODUCT([power.bus]*[power.peak])-[bus]*[peak])"
    sheet.table(
        "power", "Drives", len(drives),
        constant("k", "number of the axis", "k", "", [one.number for one in driven]),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in driven],
             [one.entered.name for one in driven], align="left"),
        calc("time", "cycle", "t_c", "s", [f"=60/{scope}rate" for scope in scopes],
             [one.drive_cycle.time for one in driven]),
        calc("driving", "its motor, driving", "E", "J", [f"={scope}energy+0" for scope in scopes],
             [one.energy.driving for one in drives]),
        calc("returned", "regenerated", "", "J", [f"={scope}returned+0" for scope in scopes],
             [one.energy.regenerated for one in drives]),
        result("mains", "mean power from the mains", "P", "kW", "=[driving]/power_eta/[time]/1000",
               [kw(one.mains) for one in each]),
        result("peak", "peak", "P_max", "kW", [f"={scope}pmax/power_eta" for scope in scopes], kw(bus.mains).tolist()),
        result("resistor", "mean power in its resistor", "", "kW", "=[returned]*power_eta/[time]/1000",
               [kw(one.resistor) for one in each]),
        result("burnt", "peak", "", "kW", [f"=0-{scope}pmin*power_eta" for scope in scopes], kw(bus.resistor).tolist()),
        calc("bus", "on the common bus", "", "", [f'=IF({scope}own_rate="",1,0)' for scope in scopes],
             bus.on_bus.astype(int).tolist(), "1: yes", format="0"),
        calc("proves", "the bus takes at least", "", "kW", f"=[bus]*([peak]-{burnt})", kw(bus.proves).tolist(),
             "its peak less the others' largest regeneration"),
        calc("burns", "the bus burns at least", "", "kW", f"=[bus]*([burnt]-{taken})", kw(bus.burns).tolist()),
        calc("up", "peak over the largest power at a point", "", "",
             [f"=IF(MAX({each})>check_zero*[burnt],[bus]*[peak]/MAX({each}),0)" for each in powers],
             bus.cuts.shares[0], "with 1/η; 0 beside the bus", scale=1.0),
        calc("down", "likewise of what comes back", "", "",
             [f"=IF(0-MIN({each})>check_zero*[peak],0-[bus]*[burnt]/MIN({each}),0)" for each in powers],
             bus.cuts.shares[1], scale=1.0),
        result("year", "alone, a year", "E", "kWh", "=[mains]*power_hours",
               [shown(one.energy_a_year(bus.entered.hours), KWH) for one in each], format=YEAR),
    )  # fmt: skip


def bus_table(sheet: Sheet, bus: Mains) -> None:
    """Declare the power of the bus at the samples of the cycle: each drive's, and their sum."""
    machine, over = bus.drives[0].tables.machine, bus.over
    rows = len(machine.angles)
    columns = [f"d{one.driven.number}" for one in bus.drives]

    draws = ":".join(dict.fromkeys([columns[0], columns[-1]])).join("[]")
    taken = f"=SUMPRODUCT({draws},({draws}>0)*1)" if len(columns) > 1 else f"=MAX(0,{draws})"

    def drawn(row: int, number: int) -> str:
        power = f"[drive{number}_cycle.power.same]"
        return f"=[power.bus.{row}]*MAX({power}/power_eta,{power}*power_eta)"

    time = calc("theta", over.angle, "θ", "°", "=[cycle1.theta.same]", machine.angles, format="0.0##")
    if over.measured:
        shown_at = over.shown(machine.angles)
        time = calc("time", over.name, over.symbol, over.unit, "=[cycle1.time.same]", shown_at, format=over.format)
    sheet.heading("Power over the cycle")
    sheet.table(
        "bus", "The common DC bus at the samples of the cycle", rows, time,
        result("sum", "on a common bus", "P", "kW", f"=SUM([{columns[0]}:{columns[-1]}])", kw(bus.sum)),
        result("alone", "each drive alone, from the mains", "P", "kW", taken, kw(bus.apart)),
        constant("k", "sample", "k", "", list(range(rows))),
        constant("w", "counts", "", "", bus.weights.tolist()),
        *(calc(name, f"axis {one.driven.number}: draws", "P", "kW", drawn(row, one.driven.number),
               kw(bus.drawn[row - 1]), "P/η, or η P that comes back")
          for row, (name, one) in enumerate(zip(columns, bus.drives, strict=True), 1)),
    )  # fmt: skip
