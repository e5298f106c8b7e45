"""The sheet Power: what the drives take from the mains and burn in their resistors, each alone and on a common bus."""

from engine.drive.results import together
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import total
from workbook.book.sentence import amount
from workbook.entries.units import KW, shown
from workbook.machines.machine.power.view import FINE, LEAST, Mains

KWH = 3.6e6  # J
NOTE = "A drive takes what its motor needs over η; what comes back, times η, goes into its brake resistor."
TOGETHER = "Drives use what others give back; what is left goes into one resistor."
APART = "A drive at a rate of its own has no place in the {}: it is alone."
CHART_COLUMN = 10
YEAR = '0.0;-0.0;"–"'
"""format of the energy of a year: a dash where no hours of running are entered"""


def supply(bus: Mains) -> list[Quantity]:
    """Return what the first sheet tells of all drives: those at a rate of their own are beside the bus."""
    if not bus.drives:
        return []
    hours, beside = bus.entered.hours, "SUMPRODUCT((1-[power.bus])*[power.{}])"
    alone = 1.0 - bus.on_bus
    peak = bus.peak + float(alone @ bus.tops[0])
    others = [one for one, is_alone in zip(bus.each, alone, strict=True) if is_alone]
    size = shown(bus.size, KW)
    return [
        result("about_peak", "Peak power from the mains", "P_max", "kW", f"=bus_mains_peak+{beside.format('peak')}",
               shown(peak, KW), scale=size, source="on a common DC bus"),
        result("about_peak_off", "… may be higher by", "", "kW", "=bus_off+0", shown(bus.missed, KW),
               scale=size, source="between samples"),
        result("about_bus_year", "Energy a year", "E", "kWh", f"=bus_year+{beside.format('mains')}*power_hours",
               shown(together([bus.common, *others]).energy_a_year(hours), KWH), scale=size, format=YEAR,
               source="on a common DC bus"),
        result("about_year", "… each drive alone", "E", "kWh", "=power_year",
               shown(bus.alone.energy_a_year(hours), KWH), scale=size, format=YEAR),
    ]  # fmt: skip


def power_sheet(book: Book, bus: Mains) -> None:
    """Declare the sheet, where there are drives."""
    if not bus.drives:
        return
    sheet = book.sheet("Power", "Energy of the drives: from the mains, in brake resistors, over a year.")
    entered = bus.entered
    sheet.heading("Enter", NOTE)
    sheet.rows(
        given("power_eta", "Efficiency of a drive", "η", "", entered.efficiency, "power.efficiency",
              format="0.0##", source="between its motor's shaft and the mains"),
        given("power_hours", "Hours of running a year", "", "h", entered.hours, "power.hours", format="0.##"),
    )  # fmt: skip
    sheet.heading("Results: each drive alone")
    sheet.rows(*totals(bus))
    sheet.heading("Results: on a common DC bus", TOGETHER)
    sheet.note(APART.format(bus.over.period))
    sheet.rows(*common(bus))
    sheet.checks(check("bus_fine", "Power: peak power of the bus is known to 5 %",
                       f"bus_off<={FINE}*MAX(bus_mains_peak,bus_resistor_peak)+{shown(LEAST, KW)}",
                       bus.fine, "it may be higher by less",
                       says=amount("bus_off", shown(bus.missed, KW), "it may be higher by ",
                                   " kW: build the book with more samples, sizes.cycle")))  # fmt: skip
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


def totals(bus: Mains) -> list[Quantity]:
    """Return the results of drives that share no bus."""
    whole, size = bus.alone, shown(bus.size, KW)
    return [
        result("power_mains", "Mean power from the mains", "P", "kW", f"={total('power.mains')}",
               shown(whole.mains, KW), scale=size, source="from the points, without a common DC bus"),
        result("power_resistors", "Mean power in the brake resistors", "", "kW", f"={total('power.resistor')}",
               shown(whole.resistor, KW), scale=size),
        result("power_year", "Energy a year", "E", "kWh", "=power_mains*power_hours",
               shown(whole.energy_a_year(bus.entered.hours), KWH), scale=size, format=YEAR),
        result("power_least", "Mean power from the mains, all regenerated energy used", "", "kW",
               "=MAX(0,power_mains-power_resistors)", shown(whole.least, KW), scale=size,
               source="lower bound"),
    ]  # fmt: skip


def common(bus: Mains) -> list[Quantity]:
    """Return the results of drives on a common bus, and how far they may be off."""
    found, size = bus.common, shown(bus.size, KW)
    apart = max(float(bus.apart.max()), float((bus.on_bus * bus.tops[0]).max()))
    one = "SUMPRODUCT([power.bus]*[power.mains])"
    added = "SUMPRODUCT([power.bus]*[power.{}])"
    sampled = "SUMPRODUCT([bus.w],[bus.sum],([bus.sum]>0)*1)"
    return [
        result("bus_alone", "Peak power from the mains without the bus", "", "kW",
               "=MAX(MAX([bus.alone]),SUMPRODUCT(MAX([power.bus]*[power.peak])))", shown(apart, KW),
               scale=size),
        result("bus_mains_peak", "Peak power from the mains", "P_max", "kW",
               "=MAX(0,MAX([bus.sum]),MAX([power.proves]))", shown(bus.peak, KW), scale=size,
               source="of the samples, and what one drive's peak proves"),
        calc("bus_net", "Mean power lost and used", "", "kW",
             "=SUMPRODUCT([power.bus]*([power.mains]-[power.resistor]))", shown(bus.net, KW), scale=size,
             source="from the points"),
        result("bus_mains", "Mean power from the mains", "P", "kW",
               f"=IF(SUM([power.bus])=1,{one},MAX(0,bus_net,{sampled}))", shown(found.mains, KW), scale=size,
               source="of one drive from its points, of more from the samples"),
        result("bus_resistor_peak", "Peak power in the brake resistor", "", "kW",
               "=MAX(0,0-MIN([bus.sum]),MAX([power.burns]))", shown(bus.burnt_peak, KW), scale=size),
        result("bus_resistor", "Mean power in the brake resistor", "", "kW", "=bus_mains-bus_net",
               shown(found.resistor, KW), scale=size, source="mains less losses and use"),
        result("bus_year", "Energy a year", "E", "kWh", "=bus_mains*power_hours",
               shown(found.energy_a_year(bus.entered.hours), KWH), scale=size, format=YEAR, source="of these drives"),
        calc("bus_most", "The peaks may be higher by, as the drives' peaks add up", "", "kW",
             f"=MAX({added.format('peak')}-bus_mains_peak,{added.format('burnt')}-bus_resistor_peak)",
             shown(bus.added, KW), scale=size, source="0 of one drive"),
        result("bus_off", "The peaks may be higher by", "", "kW", f"=MAX(0,MIN(bus_most,{total('power.off')}))",
               shown(bus.missed, KW), scale=size, source="what the samples miss of the drives' peaks, if less"),
        calc("bus_net_off", "Error of the mean power of the samples", "", "kW",
             "=ABS(SUMPRODUCT([bus.w],[bus.sum])-bus_net)", shown(abs(float(bus.weights @ bus.sum) - bus.net), KW),
             scale=size,
             source="beside that of the points"),
    ]  # fmt: skip


def drives_table(sheet: Sheet, bus: Mains) -> None:
    """Declare a row for each drive: its energy, mean and peak powers, and what its peak proves of the bus."""
    drives, each, size = bus.drives, bus.each, shown(bus.size, KW)
    driven = [one.driven for one in drives]
    scopes = [f"drive{one.number}_" for one in driven]
    work = max(one.scales.work for one in drives)
    burnt = "(SUMPRODUCT([power.bus]*[power.burnt])-[bus]*[burnt])"
    taken = "(SUMPRODUCT([power.bus]*[power.peak])-[bus]*[peak])"
    proves, burns = bus.proved
    sheet.table(
        "power", "Drives", len(drives),
        constant("k", "number of the axis", "k", "", [one.number for one in driven]),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in driven],
             [one.entered.name for one in driven], align="left"),
        calc("time", "cycle", "t_c", "s", [f"=60/{scope}rate" for scope in scopes],
             [one.drive_cycle.time for one in driven]),
        calc("driving", "its motor, driving", "E", "J", [f"={scope}energy+0" for scope in scopes],
             [one.energy[0] for one in drives], scale=work),
        calc("returned", "regenerated", "", "J", [f"={scope}returned+0" for scope in scopes],
             [one.energy[1] for one in drives], scale=work),
        result("mains", "mean power from the mains", "P", "kW", "=[driving]/power_eta/[time]/1000",
               [shown(one.mains, KW) for one in each], scale=size),
        result("peak", "peak", "P_max", "kW", [f"={scope}pmax/power_eta" for scope in scopes],
               shown(bus.tops[0], KW).tolist(), scale=size),
        result("resistor", "mean power in its resistor", "", "kW", "=[returned]*power_eta/[time]/1000",
               [shown(one.resistor, KW) for one in each], scale=size),
        result("burnt", "peak", "", "kW", [f"=0-{scope}pmin*power_eta" for scope in scopes],
               shown(bus.tops[1], KW).tolist(), scale=size),
        calc("bus", "on the common bus", "", "", [f'=IF({scope}own_rate="",1,0)' for scope in scopes],
             bus.on_bus.astype(int).tolist(), format="0", source="1: yes"),
        calc("proves", "the bus takes at least", "", "kW", f"=[bus]*([peak]-{burnt})", shown(proves, KW).tolist(),
             scale=size, source="its peak less the others' largest regeneration"),
        calc("burns", "the bus burns at least", "", "kW", f"=[bus]*([burnt]-{taken})", shown(burns, KW).tolist(),
             scale=size),
        calc("off", "the samples miss", "", "kW",
             [f"=[bus]*MAX([peak]-MAX([bus.d{one.number}]),[burnt]+MIN([bus.d{one.number}]))" for one in driven],
             shown(bus.off, KW).tolist(), scale=size, source="of its peaks"),
    )  # fmt: skip


def bus_table(sheet: Sheet, bus: Mains) -> None:
    """Declare the power of the bus at the samples of the cycle: each drive's, and their sum."""
    machine, size = bus.drives[0].one.machine, shown(bus.size, KW)
    over, rows = bus.over, len(machine.angles)
    columns = [f"d{one.driven.number}" for one in bus.drives]

    draws = ":".join(dict.fromkeys([columns[0], columns[-1]])).join("[]")
    taken = f"=SUMPRODUCT({draws},({draws}>0)*1)" if len(columns) > 1 else f"=MAX(0,{draws})"

    def drawn(row: int, number: int) -> str:
        power = f"[drive{number}_cycle.power.same]"
        return f"=[power.bus.{row}]*MAX({power}/power_eta,{power}*power_eta)"

    time = calc("time", over.name, over.symbol, over.unit, "=[cycle1.time.same]", over.shown(machine.angles),
                format=over.format) if over.measured else \
        calc("theta", over.angle, "θ", "°", "=[cycle1.theta.same]", machine.angles, format="0.0##")  # fmt: skip
    sheet.heading("Power over the cycle")
    sheet.table(
        "bus", "The common DC bus at the samples of the cycle", rows,
        time,
        result("sum", "on a common bus", "P", "kW", f"=SUM([{columns[0]}:{columns[-1]}])", shown(bus.sum, KW),
               scale=size),
        result("alone", "each drive alone, from the mains", "P", "kW",
               taken, shown(bus.apart, KW),
               scale=size),
        constant("k", "sample", "k", "", list(range(rows))),
        constant("w", "counts", "", "", bus.weights.tolist()),
        *(calc(name, f"axis {one.driven.number}: draws", "P", "kW", drawn(row, one.driven.number),
               shown(bus.drawn[row - 1], KW), scale=size, source="P/η, or η P that comes back")
          for row, (name, one) in enumerate(zip(columns, bus.drives, strict=True), 1)),
    )  # fmt: skip
