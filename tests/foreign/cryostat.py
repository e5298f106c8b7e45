"""What the heat loads of a dilution refrigerator's stages should be (tests/foreign/books.py says which workbook)."""

from math import pi

from workbook.oracle import Oracle

book = Oracle("Cryostat")
sigma = book.input("C_SB", unit="W/m²K⁴")
names = ("T_Room", "T_PTC1", "T_PTC2", "T_Still", "T_MC")
ranges = ((280, 300), (35, 60), (2.5, 5), (0.7, 1.5), (0.01, 0.2))
temperatures = [book.input(name, unit="K", low=low, high=high) for name, (low, high) in zip(names, ranges, strict=True)]
FIRST = (10, 30, 50, 70)  # rows in which the stages begin
PLATES = (("F10", "F11", "F12", "F13"), ("F30", "F31", "F32", "F33"), ("F50", "F51", "F52"), ("F70", "F71"))


def number(cell, low, high, unit="", macro=False):
    return book.input(cell, unit=unit, low=low, high=high, macro=macro)


def tube(outer, inner):
    """Return the area (mm²) of a tube's section."""
    return pi * (outer**2 - inner**2) / 4


def wire(diameter):
    """Return the area (mm²) of a wire's section."""
    return pi * diameter**2 / 4


def per_length(area, size):
    """Return what gives an area over a length, in m."""
    return lambda *given: area(*given[:size]) / given[size] / 1000


def conducted(area, size, parts):
    """Return what gives the heat (W) by ``parts`` of an area: A/L ∫λ dT each."""
    one = per_length(area, size)
    return lambda *given: one(*given) * given[size + 1] * (given[size + 2] if parts else 1)


def radiated(constant, hot, cold, outer, inner, *plates):
    """Return the heat (W) between two surfaces: A σ (T_h⁴ − T_c⁴)/(1/ε_1 + 1/ε_2 − 1)."""
    return sum(plates) * constant * (hot**4 - cold**4) / (1 / outer + 1 / inner - 1)


def total(*given):
    """Return the heat (W) of a stage: by cylinder, cable and radiation."""
    return conducted(tube, 2, True)(*given[:5]) + conducted(wire, 1, True)(*given[5:9]) + radiated(*given[9:])


for first, plates, hot, cold in zip(FIRST, PLATES, temperatures[:4], temperatures[1:], strict=True):
    rows = dict(zip(("od", "id", "area", "length", "ratio", "integral", "part", "parts", "power"),
                    (first + k for k in (2, 3, 4, 6, 7, 9, 11, 12, 14)), strict=True))  # fmt: skip
    solid = {
        "B": [number(f"B{rows['od']}", 8, 20, "mm"), number(f"B{rows['id']}", 4, 7.5, "mm")],
        "D": [number(f"D{rows['od']}", 0.05, 0.5, "mm")],
    }
    chains = {}
    for column, sizes in solid.items():
        shape, size = (tube, 2) if column == "B" else (wire, 1)
        length = number(f"{column}{rows['length']}", 100, 500, "mm")
        integral = number(f"{column}{rows['integral']}", 0.01, 5000, "W/m", macro=True)
        parts = number(f"{column}{rows['parts']}", 1, 100, "1")
        chains[column] = chain = [*sizes, length, integral, parts]
        book.output(f"{column}{rows['area']}", unit="mm²", inputs=sizes)(shape)
        book.output(f"{column}{rows['ratio']}", unit="m", inputs=chain[:-2])(per_length(shape, size))
        book.output(f"{column}{rows['part']}", unit="W", inputs=chain[:-1])(conducted(shape, size, False))
        book.output(f"{column}{rows['power']}", unit="W", inputs=chain)(conducted(shape, size, True))
    emissivities = [number(f"F{rows['part']}", 0.01, 0.2, "1"), number(f"F{rows['parts']}", 0.01, 0.2, "1")]
    areas = [book.input(cell, unit="m²") if first > 10 else None for cell in plates]
    given = [sigma, hot, cold, *emissivities, *(one for one in areas if one)]
    if first == 10:  # the areas of its plates are formulas of numbers

        def power(*given):
            return radiated(*given, 0.166, 0.679, 1.218, 0.135)

        def every(*given):
            return total(*given, 0.166, 0.679, 1.218, 0.135)
    else:
        power, every = radiated, total
    book.output(f"F{rows['power']}", unit="W", inputs=given)(power)
    book.output(f"I{rows['power']}", unit="W", inputs=[*chains["B"], *chains["D"], *given])(every)
