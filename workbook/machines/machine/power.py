"""The sheet Power: what the drives take from the mains and burn in their resistors, each alone and on a common bus."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from engine.drive.results import MeanBusPower, peak_bus_power, total_bus_power
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import COLOURS, Chart, Series, colour
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import total
from workbook.entries.facts import entry_cells
from workbook.entries.phase import TURN
from workbook.fields.units import KW, shown
from workbook.machines.machine.bus_cuts import BusCuts, cuts_table
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive_entries import PowerEntry

CELLS = cell_tables(__file__)

KWH, MWH = 3.6e6, 3.6e9  # J
NOTE = "A drive takes what its motor needs over η; what comes back, times η, goes into its brake resistor."
TOGETHER = "On a common DC bus drives use what others give back; a drive at a rate of its own has no place in the {}."
ON_BUS = "of the mains, where the drive's sheet has that of the motor"
CHART_COLUMN, COLUMNS = 11, 17
INK = COLOURS[-1]
OF_BUS = frozenset(
    "power_peak_most bus_alone bus_resistor_most power_mains power_resistors power_year "
    "bus_saved bus_saved_most bus_saved_year bus_saved_price".split()
)
"""results that say something of several drives alone"""
kw = partial(shown, unit=KW)


class Mains:
    """Powers of drives over a turn (W): of each alone, and of those that run at the machine's rate on a bus.

    A drive ``on_bus`` has 1 there, else 0. Powers at samples of the cycle: ``drawn`` by each, below 0 what comes back,
    their ``sum`` on the bus, and ``apart`` what they take without it. ``whole`` are the means of all, with the bus.
    """

    def __init__(self, drives: Sequence[DriveView], entered: PowerEntry) -> None:
        self.drives, self.entered = drives, entered
        self.over, eta = drives[0].tables.machine.over, entered.efficiency
        self.each = [drive.energy.mean_bus_power(drive.driven.drive_cycle.time, eta) for drive in drives]
        self.alone = total_bus_power(self.each)
        most = [(drive.peaks.top("P"), -drive.peaks.top("P", -1)) for drive in drives]
        tops = [peak_bus_power(powers, eta) for powers in most]
        self.size = max(1e-3, math.fsum(max(top) for top in tops))  # how large all together grow
        self.mains, self.resistor = np.array(tops).T  # the peaks of each without a bus

        bus = self.on_bus = np.array([float(drive.driven.entered.rate is None) for drive in drives])
        power = np.array([drive.sampled[1] for drive in drives])
        self.drawn = bus[:, None] * np.where(power > 0.0, power / eta, power * eta)
        self.sum, self.apart = self.drawn.sum(axis=0), np.maximum(self.drawn, 0.0).sum(axis=0)
        # in a mean, by the trapezoidal rule
        self.weights = np.full(self.sum.size, 1.0 / (self.sum.size - 1))
        self.weights[[0, -1]] /= 2.0
        self.cuts = BusCuts(drives, bus, np.array([self.mains, self.resistor]))
        mains, resistor = bus * self.mains, bus * self.resistor
        # what the bus takes at least, by a drive's peak
        self.proves = bus * (mains - (resistor.sum() - resistor))
        self.burns = bus * (resistor - (mains.sum() - mains))  # what it burns at least
        self.peak = min(self.cuts.peak_most, max(0.0, float(self.sum.max()), float(self.proves.max())))
        self.burnt_peak = min(self.cuts.burnt_most, max(0.0, -float(self.sum.min()), float(self.burns.max())))
        self.without = MeanBusPower(*(float(bus @ [powers[k] for powers in self.each]) for k in (0, 1)))
        moved = (math.fsum(self.without) - float(self.cuts.span @ self.cuts.sure) / TURN) / 2.0
        self.saved_most = max(0.0, min(*self.without, moved)) if bus.sum() > 1.0 else 0.0
        self.saved = min(self.saved_most, float(self.weights @ (self.apart - np.maximum(self.sum, 0.0))))
        self.whole = MeanBusPower(*(power - self.saved for power in self.alone))
        self.beside = float((1.0 - bus) @ self.mains)  # the peaks of drives at a rate of their own


def supply(bus: Mains) -> list[Quantity]:
    """Return the results of the sheet Power that the first sheet repeats."""
    size = kw(bus.size)
    year = shown(bus.whole.energy_a_year(bus.entered.hours), MWH)
    cell = CELLS["supply"].sharing(size=size)
    return [cell("about_peak", kw(bus.peak + bus.beside)), cell("about_bus_year", year)]


def power_sheet(book: Book, bus: Mains) -> None:
    """Declare the sheet: a page of results with a row a drive, then the bus sample by sample and its bounds."""
    sheet = book.sheet("Power", "Energy of the drives: from the mains, in brake resistors, over a year.")
    size = kw(bus.size)
    sheet.sizes = {"kW": size, "kWh": size, "J": max(drive.scales.work for drive in bus.drives)}
    sheet.heading("Enter", NOTE)
    sheet.rows(*entry_cells(bus.entered, "power"))
    sheet.heading("Results", TOGETHER.format(bus.over.period))
    every = results(bus)
    printed = [q for q in every if bus.drives[1:] or q.name not in OF_BUS]
    sheet.rows(*printed)
    if bus.on_bus.any():
        sheet.chart(power_chart(bus), CHART_COLUMN, 5, COLUMNS - CHART_COLUMN + 1, 20)
    sheet.row += 1
    drives_table(sheet, bus)
    sheet.not_printed_below()
    sheet.one_page, sheet.print_columns = True, COLUMNS
    sheet.heading("Workings: the common DC bus")
    cell, without, taken = CELLS["on the bus"], bus.without, bus.cuts.bounds[0]
    peaks = OF_ALL.format("peak")
    sheet.rows(
        cell("bus_mains_peak", kw(bus.peak)),
        cell("bus_mains_most", kw(bus.cuts.peak_most), of_all=peaks, between_cuts=taken),
        cell("bus_apart", kw(without.mains), of_all=OF_ALL.format("mains")),
        cell("bus_net", kw(without.net), of_all=OF_ALL.format("resistor")),
        *(q for q in every if q not in printed),
    )
    bus_table(sheet, bus)
    if bus.cuts.meet:
        cuts_table(sheet, bus.cuts)


def power_chart(bus: Mains) -> Chart:
    """Return the chart of what each drive takes of the bus, in the colour of its axis, and of their sum."""
    over, x = bus.over, "[bus.time]" if bus.over.measured else "[bus.theta]"
    numbers = [drive.driven.number for drive, on in zip(bus.drives, bus.on_bus, strict=True) if on]
    lines = [Series(f"=axis{i}_name", x, f"[bus.d{i}]", color=colour(i)) for i in numbers]
    if len(lines) > 1:
        lines.append(Series("all", x, "[bus.sum]", dashed=True, color=INK))
    about = f"Power of each drive, and of all together, on the common bus over {over.cycle}"
    return Chart(f"Power over the {over.period}", over.title, "P [kW]", tuple(lines), about, over.axis(60))


BESIDE = "SUMPRODUCT((1-[on_bus.on])*[power.{}])"  # of drives at a rate of their own
OF_ALL = "SUMPRODUCT([on_bus.on]*[power.{}])"


def results(bus: Mains) -> list[Quantity]:
    """Return the results of all drives: those on the common bus with their bounds, the others beside it."""
    cell = CELLS["results"]
    entered, alone, whole = bus.entered, bus.alone, bus.whole
    apart = max(float(bus.apart.max()), float((bus.on_bus * bus.mains).max()))
    year = shown(MeanBusPower(bus.saved, 0.0).energy_a_year(entered.hours), KWH)
    beside = BESIDE.format("peak")
    of_all, (_, burnt, saved) = OF_ALL.format("burnt"), bus.cuts.bounds
    return [
        cell("power_peak", kw(bus.peak + bus.beside), beside=beside, on_bus=ON_BUS),
        cell("power_peak_most", kw(bus.cuts.peak_most + bus.beside), beside=beside),
        cell("bus_alone", kw(apart + bus.beside), beside=beside),
        cell("bus_resistor_peak", kw(bus.burnt_peak)),
        cell("bus_resistor_most", kw(bus.cuts.burnt_most), of_all=of_all, between_cuts=burnt),
        cell("power_mean", kw(whole.mains)),
        cell("power_mains", kw(alone.mains), total=total("power.mains")),
        cell("power_burnt", kw(whole.resistor)),
        cell("power_resistors", kw(alone.resistor), total=total("power.resistor")),
        cell("bus_saved", kw(bus.saved)),
        cell("bus_saved_most", kw(bus.saved_most), between_cuts=saved),
        cell("power_bus_year", shown(whole.energy_a_year(entered.hours), KWH)),
        cell("power_year", shown(alone.energy_a_year(entered.hours), KWH)),
        cell("bus_saved_year", year),
        cell("bus_saved_price", year * entered.price, scale=max(1.0, kw(bus.size) * entered.price)),
    ]


def drives_table(sheet: Sheet, bus: Mains) -> None:
    """Declare a row for each drive: its energy, mean and peak powers, and what its peak proves of the bus."""
    drives, each = bus.drives, bus.each
    driven = [drive.driven for drive in drives]
    scopes, powers = ([f"drive{drive.number}_{name}" for drive in driven] for name in ("", "P"))
    cell = CELLS["power"].sharing(scope=scopes, number=[drive.number for drive in driven])
    block = cell.place(
        sheet,
        cell("axis", [drive.entered.name for drive in driven]),
        cell("time", [drive.drive_cycle.time for drive in driven]),
        cell("driving", [drive.energy.driving for drive in drives]),
        cell("returned", [drive.energy.regenerated for drive in drives]),
        cell("mains", [kw(power.mains) for power in each]),
        cell("peak", kw(bus.mains).tolist()),
        cell("resistor", [kw(power.resistor) for power in each]),
        cell("burnt", kw(bus.resistor).tolist()),
        cell("year", [shown(power.energy_a_year(bus.entered.hours), KWH) for power in each]),
    )
    cell = CELLS["drives on the bus"].sharing(scope=scopes, powers=powers)
    columns = [
        cell("on", bus.on_bus.astype(int).tolist()),
        cell("proves", kw(bus.proves).tolist()),
        cell("burns", kw(bus.burns).tolist()),
        cell("up", bus.cuts.shares[0], rounding=bus.cuts.share_scales[0]),
        cell("down", bus.cuts.shares[1], rounding=bus.cuts.share_scales[1]),
    ]
    sheet.workings(block, "on_bus", "", COLUMNS + 2, *columns)


def bus_table(sheet: Sheet, bus: Mains) -> None:
    """Declare the power of the bus at the samples of the cycle: each drive's, and their sum."""
    machine, over = bus.drives[0].tables.machine, bus.over
    rows = len(machine.angles)
    columns = [f"d{drive.driven.number}" for drive in bus.drives]

    draws = ":".join(dict.fromkeys([columns[0], columns[-1]])).join("[]")
    taken = f"=SUMPRODUCT({draws},({draws}>0)*1)" if len(columns) > 1 else f"=MAX(0,{draws})"

    time = CELLS["bus_table"]("theta", machine.angles, label=over.angle)
    if over.measured:
        time = CELLS["bus_table"]("time", over.shown(machine.angles), **over.words)
    sheet.heading("Power over the cycle")
    CELLS["bus"].place(
        sheet,
        time,
        CELLS["bus"]("k", list(range(rows))),
        CELLS["bus"]("w", bus.weights.tolist()),
        CELLS["bus"]("sum", kw(bus.sum), first=columns[0], last=columns[-1]),
        CELLS["bus"]("alone", kw(bus.apart), formula=taken),
        *(
            CELLS["bus"]("d{i}", kw(bus.drawn[row]), i=drive.driven.number, row=row + 1)
            for row, drive in enumerate(bus.drives)
        ),
    )
