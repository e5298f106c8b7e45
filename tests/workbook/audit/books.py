"""Workbooks as engineers write them, drawn at random: of what people put on sheets, and in what styles."""

import openpyxl
from openpyxl.utils import get_column_letter as letter

LISTS = {  # a sheet of figures one below the other: label, symbol, value or formula of symbols, unit
    "Belt drive": [
        ("Load mass", "m", 42, "kg"), ("Pulley diameter", "D", 80, "mm"), ("Belt speed", "v", 1.5, "m/s"),
        ("Acceleration time", "ta", 0.25, "s"), ("Friction coefficient", "mu", 0.12, "-"),
        ("Efficiency", "eta", 0.92, "-"),
        ("Acceleration", "a", "={v}/{ta}", "m/s²"), ("Friction force", "Fr", "={mu}*{m}*9.81", "N"),
        ("Force at the belt", "F", "={m}*{a}+{Fr}", "N"), ("Torque at the pulley", "T", "={F}*{D}/2/1000/{eta}", "Nm"),
        ("Pulley speed", "n", "={v}*60/(PI()*{D}/1000)", "1/min"), ("Power", "P", "={F}*{v}/1000/{eta}", "kW")],
    "Ball screw": [
        ("Table mass", "m", 180, "kg"), ("Lead", "p", 20, "mm"), ("Motor speed", "n", 1800, "1/min"),
        ("Screw inertia", "Js", 4.2, "kg cm²"), ("Ramp", "ta", 120, "ms"), ("Process force", "Fp", 750, "N"),
        ("Table speed", "v", "={n}/60*{p}/1000", "m/s"), ("Angular speed", "w", "=2*PI()*{n}/60", "rad/s"),
        ("Angular acceleration", "al", "={w}/({ta}/1000)", "rad/s²"),
        ("Table inertia", "Jt", "={m}*({p}/1000/(2*PI()))^2*10000", "kg cm²"),
        ("Total inertia", "J", "={Js}+{Jt}", "kg cm²"),
        ("Acceleration torque", "Ta", "={J}/10000*{al}", "Nm"),
        ("Process torque", "Tp", "={Fp}*{p}/1000/(2*PI())", "Nm"),
        ("Peak torque", "T", "={Ta}+{Tp}", "Nm")],
    "Pump": [
        ("Flow", "Q", 36, "m³/h"), ("Head", "H", 24, "m"), ("Density", "rho", 998, "kg/m³"),
        ("Gravity", "g", 9.81, "m/s²"),
        ("Pump efficiency", "eta", 0.71, "-"), ("Pipe bore", "d", 65, "mm"), ("Flow in SI", "q", "={Q}/3600", "m³/s"),
        ("Velocity", "v", "={q}/(PI()/4*({d}/1000)^2)", "m/s"),
        ("Hydraulic power", "Ph", "={rho}*{g}*{q}*{H}/1000", "kW"),
        ("Shaft power", "P", "={Ph}/{eta}", "kW"), ("Dynamic pressure", "pd", "={rho}/2*{v}^2", "Pa")],
    "Cylinder": [
        ("Piston diameter", "D", 63, "mm"), ("Rod diameter", "d", 20, "mm"), ("Pressure", "p", 6, "bar"),
        ("Stroke", "s", 320, "mm"), ("Time of stroke", "t", 0.8, "s"), ("Piston area", "A", "=PI()/4*{D}^2", "mm²"),
        ("Ring area", "Ar", "=PI()/4*({D}^2-{d}^2)", "mm²"), ("Force out", "F", "={p}*0.1*{A}", "N"),
        ("Force back", "Fb", "={p}*0.1*{Ar}", "N"), ("Mean speed", "v", "={s}/{t}/1000", "m/s"),
        ("Air per stroke", "V", "={A}*{s}/1000000", "l")],
}  # fmt: skip
TABLES = {  # a table: parameters, entered columns (heading, unit, first, step), computed ones, and what is summed up
    "Torque": ([("Inertia", 0.012, "kg m²"), ("Friction torque", 0.8, "Nm")],
        [("Time", "s", 0, 0.05), ("Speed", "1/min", 40, 37)],
        [("Angular speed", "rad/s", "=2*PI()*{c1}/60"), ("Load torque", "Nm", "={p1}+{p0}*{c2}/0.05"),
         ("Power", "W", "={c2}*{c3}")], ["MAX", "MAX", "AVERAGE"]),
    "Bill of motors": ([("Discount", 0.12, "-"), ("Rate of exchange", 1.08, "-")],
        [("Pieces", "", 2, 1), ("Mass", "kg", 4.4, 1.3), ("Unit price", "EUR", 410, 55)],
        [("Total mass", "kg", "={c0}*{c1}"), ("Net price", "EUR", "={c2}*(1-{p0})*{p1}"), ("Sum", "EUR", "={c0}*{c4}")],
        ["SUM", "", "SUM"]),
    "Cable sizing": ([("Resistivity", 0.0178, "Ω mm²/m"), ("Voltage", 400, "V")],
        [("Length", "m", 12, 7), ("Cross-section", "mm²", 1.5, 1), ("Current", "A", 4, 2)],
        [("Resistance", "Ω", "={p0}*{c0}/{c1}"), ("Drop", "V", "={c2}*{c3}*2"),
         ("Share of drop", "%", "={c4}/{p1}*100"),
         ("Verdict", "", '=IF({c5}>3,"too thin","OK")')], ["", "MAX", "MAX"]),
    "Conversions": ([("Diameter", 120, "mm")], [("Speed", "1/min", 100, 150)],
        [("Angular speed", "rad/s", "={c0}*2*PI()/60"), ("Frequency", "Hz", "={c0}/60"),
         ("Surface speed", "m/s", "={c1}*{p0}/2/1000"), ("Surface speed", "m/min", "={c3}*60")], ["MAX", "MAX", "MAX"]),
    "Bolts": ([("Friction factor", 0.16, "-"), ("Yield strength", 640, "N/mm²")],
        [("Nominal diameter", "mm", 6, 2), ("Stress area", "mm²", 20.1, 16.5)],
        [("Preload", "N", "=0.7*{p1}*{c1}"), ("Tightening torque", "Nm", "={p0}*{c2}*{c0}/1000")], ["", "MAX"]),
    "Energy": ([("Hours per shift", 7.5, "h"), ("Price", 0.24, "EUR/kWh")],
        [("Rated power", "kW", 1.1, 0.75), ("Load", "%", 60, 3)],
        [("Mean power", "kW", "={c0}*{c1}/100"), ("Energy", "kWh", "={c2}*{p0}"), ("Cost", "EUR", "={c3}*{p1}")],
        ["SUM", "SUM", "SUM"]),
}  # fmt: skip


class Writer:
    """A sheet with a style: where it begins, where units stand, whether ``$`` are written as people do."""

    def __init__(self, book, title, random):
        self.sheet, self.random = book.create_sheet(title), random
        self.row, self.column = random.choice([1, 1, 2]), random.choice([1, 1, 2])
        self.units = random.choice(["beside", "brackets"])
        self.put(0, title if random.random() < 0.5 else f"{title}: machine {random.randint(100, 999)}")
        self.row += random.choice([1, 2, 2, 3])

    def put(self, offset, value, row=None):
        cell = self.sheet.cell(row or self.row, self.column + offset, value)
        return cell.coordinate

    def varied(self, value):
        return round(value * self.random.uniform(0.6, 1.7), 3) if value > 1 else value


def write_list(book, title, random, values=None):
    """A list of figures, the inputs first, with units beside them or in the labels."""
    writer, places, drawn = Writer(book, title, random), {}, {}
    symbols, gap = random.random() < 0.6, random.random() < 0.4
    for k, (label, symbol, value, unit) in enumerate(LISTS[title.split(" – ")[0]]):
        if gap and isinstance(value, str) and not isinstance(LISTS[title.split(" – ")[0]][k - 1][2], str):
            writer.row += 1
            writer.put(0, "Results")
            writer.row += 1
        writer.put(0, f"{label} [{unit}]" if writer.units == "brackets" and unit != "-" else label)
        at = 1
        if symbols and writer.units == "beside":
            writer.put(at, symbol)
            at += 1
        drawn[symbol] = value if isinstance(value, str) else (values or {}).get(symbol, writer.varied(value))
        places[symbol] = writer.put(at, drawn[symbol].format(**places) if isinstance(value, str) else drawn[symbol])
        if writer.units == "beside":
            writer.put(at + 1, unit)
        writer.row += 1
    return drawn


def write_table(book, title, random):
    """Parameters, a table below them, and what is summed up over it or under it."""
    writer, (parameters, entered, computed, summed) = Writer(book, title, random), TABLES[title]
    places = {}
    for k, (label, value, unit) in enumerate(parameters):
        writer.put(0, label)
        cell = writer.put(1, writer.varied(value))
        writer.put(2, unit)
        places[f"p{k}"] = "$" + cell[0] + "$" + cell[1:]
        writer.row += 1
    writer.row += random.choice([1, 1, 2])
    count, named = random.randint(6, 28), random.random() < 0.6
    above = random.random() < 0.3
    head = writer.row + (2 if above else 0)
    style = random.choice(["brackets", "row"])
    first = head + (2 if style == "row" else 1)
    shift = 1 if named else 0
    if named:
        writer.put(0, random.choice(["Axis", "No.", "Item"]), head)
        for k in range(count):
            writer.put(0, random.choice(["M{:02d}", "Axis {}", "Pos {}"]).format(k + 1), first + k)
    for j, (name, unit, *_) in enumerate([*entered, *computed]):
        writer.put(j + shift, f"{name} [{unit}]" if unit and style == "brackets" else name, head)
        if style == "row":
            writer.put(j + shift, unit or "-", head + 1)
    for k in range(count):
        row = first + k
        columns = {f"c{j}": f"{letter(writer.column + j + shift)}{row}" for j in range(len(entered) + len(computed))}
        for j, (_, unit, start, step) in enumerate(entered):
            jitter = 0 if unit == "s" or start == int(start) == step else random.choice([0, 0.1, 0.2])
            writer.put(j + shift, round(start + step * (k % 9 if unit == "%" else k) + jitter, 4), row)
        for j, (_, _, formula) in enumerate(computed):
            writer.put(len(entered) + j + shift, formula.format(**places, **columns), row)
    total = head - 1 if above else first + count + random.choice([0, 0, 1])
    for j, function in enumerate(summed):
        if function:
            column = letter(writer.column + shift + len(entered) + j)
            writer.put(len(entered) + j + shift, f"={function}({column}{first}:{column}{first + count - 1})", total)
    if shift or above:
        writer.put(0, random.choice(["Total", "Sum", "Result"]), total) if named else None


def write_months(book, random):
    """Figures by months to the right, with sums at both ends."""
    writer, rows = Writer(book, "Energy by months", random), random.randint(4, 9)
    writer.put(0, "Machine")
    for j in range(12):
        writer.put(1 + j, "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec".split()[j])
    writer.put(13, "Year [kWh]")
    first = writer.row + 1
    left, right = letter(writer.column + 1), letter(writer.column + 12)
    for k in range(rows):
        writer.put(0, f"Line {k + 1}", first + k)
        for j in range(12):
            writer.put(1 + j, random.randint(900, 4200), first + k)
        writer.put(13, f"=SUM({left}{first + k}:{right}{first + k})", first + k)
    writer.put(0, "Sum", first + rows)
    for j in range(13):
        column = letter(writer.column + 1 + j)
        writer.put(1 + j, f"=SUM({column}{first}:{column}{first + rows - 1})", first + rows)


def write_axes(book, random):
    """Quantities one below the other, and an axis in each column."""
    writer, axes = Writer(book, "Axes", random), random.randint(4, 9)
    rows = [("Mass [kg]", 20), ("Stroke [m]", 0.4), ("Time [s]", 0.5), ("Speed [m/s]", "=2*{0}{s}/{0}{t}"),
            ("Acceleration [m/s²]", "=4*{0}{s}/{0}{t}^2"), ("Force [N]", "={0}{m}*{0}{a}"),
            ("Peak power [W]", "={0}{f}*{0}{v}")]  # fmt: skip
    writer.put(0, "Quantity")
    at = {name: writer.row + k for k, name in enumerate("mstvaf", 1)}
    for j in range(axes):
        writer.put(1 + j, f"Axis {j + 1}")
    for k, (label, value) in enumerate(rows, 1):
        writer.put(0, label, writer.row + k)
        for j in range(axes):
            column = letter(writer.column + 1 + j)
            here = (
                round(value * random.uniform(0.5, 2), 2) if not isinstance(value, str) else value.format(column, **at)
            )
            writer.put(1 + j, here, writer.row + k)
    writer.put(0, "Largest power [W]", writer.row + 9)
    last = writer.row + 7
    writer.put(1, f"=MAX({letter(writer.column + 1)}{last}:{letter(writer.column + axes)}{last})", writer.row + 9)


def write_grid(book, random):
    """A table of two entries."""
    writer, rows, columns = Writer(book, "Pressure drop", random), random.randint(5, 12), random.randint(4, 8)
    writer.put(0, "Length [m] / flow [l/min]")
    head = writer.row
    for j in range(columns):
        writer.put(1 + j, 5 * (j + 1))
    for k in range(1, rows + 1):
        writer.put(0, 2 * k, head + k)
        for j in range(columns):
            own, top = f"${letter(writer.column)}{head + k}", f"{letter(writer.column + 1 + j)}${head}"
            writer.put(1 + j, f"=0.0042*{own}*{top}^1.75", head + k)


def write_measured(book, random):
    """Measured values with their mean, deviations, and a running sum."""
    writer, count = Writer(book, "Measured", random), random.randint(10, 30)
    for j, text in enumerate(("Sample", "Length [mm]", "Deviation [mm]", "Running sum [mm]", "Mean of 3 [mm]")):
        writer.put(j, text)
    a, b, c = (letter(writer.column + k) for k in (1, 2, 3))
    first, last = writer.row + 1, writer.row + count
    for k in range(first, last + 1):
        writer.put(0, k - first + 1, k)
        writer.put(1, round(random.gauss(50, 0.2), 2), k)
        writer.put(2, f"={a}{k}-${a}${last + 2}", k)
        writer.put(3, f"={b}{k}" if k == first else f"={c}{k - 1}+{b}{k}", k)
        if k >= first + 2:
            writer.put(4, f"=AVERAGE({a}{k - 2}:{a}{k})", k)
    for n, (label, function) in enumerate((("Mean", "AVERAGE"), ("Deviation of all", "STDEV")), 2):
        writer.put(0, label, last + n)
        writer.put(1, f"={function}({a}{first}:{a}{last})", last + n)


def write_selection(book, random):
    """A catalogue, and look-ups in it: the exact name, and the next smaller torque."""
    catalogue, count = Writer(book, "Catalogue", random), random.randint(6, 12)
    for j, text in enumerate(("Torque [Nm]", "Motor", "Inertia [kg cm²]", "Price [EUR]")):
        catalogue.put(j, text)
    first, last = catalogue.row + 1, catalogue.row + count
    for k in range(count):
        for j, value in enumerate((round(1.2 * 1.5**k, 1), f"SM{40 + 10 * k}", round(0.3 * 2**k, 2), 210 + 65 * k)):
            catalogue.put(j, value, first + k)
    a, b, d = (letter(catalogue.column + k) for k in (0, 1, 3))
    writer = Writer(book, "Selection", random)
    for j, text in enumerate(("Axis", "Torque [Nm]", "Motor", "Price [EUR]", "Reserve")):
        writer.put(j, text)
    u, v = letter(writer.column + 1), letter(writer.column + 2)
    torques, names = f"Catalogue!${a}${first}:${a}${last}", f"Catalogue!${b}${first}:${b}${last}"
    for k in range(writer.row + 1, writer.row + random.randint(5, 9)):
        writer.put(0, f"X{k}", k)
        writer.put(1, round(random.uniform(1.3, 12), 1), k)
        writer.put(2, f"=INDEX({names},MATCH({u}{k},{torques},1))", k)
        writer.put(3, f"=VLOOKUP({v}{k},Catalogue!${b}${first}:${d}${last},3,FALSE)", k)
        writer.put(4, f'=IFERROR(INDEX({torques},MATCH({v}{k},{names},0))/{u}{k},"-")', k)


def write_book(random):
    """Some sheets of these kinds; sometimes two lists that are copies of each other."""
    book = openpyxl.Workbook()
    book.remove(book.active)
    for title in random.sample(sorted(LISTS), 2):
        style = random.getstate()
        drawn = write_list(book, title, random)
        if random.random() < 0.3:  # a copy of the sheet, of which an entry or two are another's
            random.setstate(style)
            entries = [k for k, v in drawn.items() if not isinstance(v, str)]
            others = random.sample(entries, 2)
            write_list(book, f"{title} – second", random, {k: drawn[k] for k in entries if k not in others})
    for title in random.sample(sorted(TABLES), 2):
        write_table(book, title, random)
    for write in random.sample([write_months, write_axes, write_grid, write_measured, write_selection], 2):
        write(book, random)
    return book
