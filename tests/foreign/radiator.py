"""What a thermoelectric cooler and the radiator of a small satellite should do (tests/foreign/books.py says which)."""

import numpy as np

from workbook.oracle import Oracle

book = Oracle("Radiator")
volts = book.input("Sheet1!B2", unit="V", low=4, high=12)
amperes = book.input("Sheet1!B3", unit="A", low=1, high=4)
pumped = book.input("Sheet1!B5", unit="W", low=8, high=20)
sink = book.input("Sheet1!B7", unit="W/K", low=2, high=10)
bath = book.input("T_B", unit="K", low=280, high=310)
load = book.input("q_D", unit="W", low=0.05, high=0.5)
sigma = book.input("sigma", unit="W/m²K⁴")
earth = book.input("T_earth", unit="K", low=240, high=270)
emissivity = book.input("emiss_out", unit="1", low=0.5, high=0.95)
area = book.input("A_2U", unit="m²", low=0.01, high=0.02)  # of two units
view = book.input("F_earth", unit="1", low=0.1, high=0.5)
solar = book.input("solar", unit="W/m²", low=1301, high=1449)
absorption = book.input("absorp", unit="1", low=0.1, high=0.3)
R_BUS, R_OUT, ALBEDO, LIT = 1 / 0.3, 1 / 0.04, 0.35 * 0.65, 0.65
ANGLES = np.radians(np.arange(90, 190, 10))
BETWEEN = [(260, 265), (265, 270), (265, 270), *[(270, 275)] * 3, *[(275, 280)] * 4]  # K, of rows 4 to 13

sizes = [("B", "A_1U", 1), ("C", None, 2), ("D", "A_3U", 3)]
for column, name, units in sizes:
    if name:
        book.output(name, unit="m²", inputs=[area])(lambda area, n=units: area * n / 2)
    page = f"Radiator Size Study!{column}"
    book.output(f"{page}32", unit="1/m²", inputs=[emissivity, area])(lambda e, a, n=units: (1 - e) / (e * a * n / 2))
    book.output(f"{page}33", unit="1/m²", inputs=[view, area])(lambda f, a, n=units: 1 / (f * a * n / 2))
    book.output(f"{page}34", unit="1/m²", inputs=[view, area])(lambda f, a, n=units: 1 / ((1 - f) * a * n / 2))
for name, value, unit in (("R_bus", R_BUS, "K/W"), ("R_SO", R_OUT, "K/W"), ("albedo", ALBEDO, "1")):
    book.output(name, unit=unit, inputs=[])(lambda value=value: value)
book.output("F_space", unit="1", inputs=[view])(lambda view: 1 - view)


@book.output("Sheet1!B4", unit="ohm")
def resistance(volts, amperes):
    return volts / amperes


@book.output("Sheet1!B6", unit="V")
def seebeck(volts, amperes, pumped):
    """Return S T: at the largest current half of Joule's heat comes back, Q_max = S T I − I² R/2."""
    return (pumped + amperes * volts / 2) / amperes


def cooler(current, volts, amperes, pumped, sink):
    ohms = volts / amperes
    rise = (0.2 + current**2 * ohms) / sink
    fall = (0.2 + current**2 * ohms / 2 - seebeck(volts, amperes, pumped) * current) / (0.08 + pumped / 64.3)
    return rise, fall, 28, rise + fall + 28


book.table("Sheet1!A10:E44", columns=["I", "rise", "fall", "ambient", "load"], of=cooler)


def lost(t, n, bath, load, sigma, earth, emissivity, area, view, solar, absorption):
    """Return the driver's temperature (K), and the heat (W) that a radiator of n units at t (K) has too much."""
    a = area * n / 2
    surface, space, down = (1 - emissivity) / (emissivity * a), 1 / ((1 - view) * a), 1 / (view * a)
    driver = (t / R_BUS + bath / R_OUT + load) / (1 / R_BUS + 1 / R_OUT)
    radiated = sigma * (earth**4 - t**4) / (surface + down) - sigma * t**4 / (surface + space)
    return driver, radiated + (bath - t) / R_OUT + (driver - t) / R_BUS + a * solar * ALBEDO * absorption * view


def studied(t, bath, load, sigma, earth, emissivity, area, view, solar, absorption):
    given = (bath, load, sigma, earth, emissivity, area, view, solar, absorption)
    return lost(t, 2, *given)[0], *(lost(t, n, *given)[1] for n in (1, 2, 3))


def inclined(t, bath, load, sigma, earth, emissivity, area, view, solar, absorption):
    driver, heat = lost(t, 2, bath, load, sigma, earth, emissivity, area, view, solar, absorption)
    return driver, *(heat + absorption * solar * LIT * area * abs(np.cos(angle)) for angle in ANGLES)


def interpolated(degrees, bath, load, sigma, earth, emissivity, area, view, solar, absorption):
    """Return the angle, the sun's heat, and the temperature at which none is too much, between two of the table."""
    given, found = (bath, load, sigma, earth, emissivity, area, view, solar, absorption), []
    for k, (low, high) in enumerate(BETWEEN):
        below, above = inclined(np.array([low, high]), *given)[1 + k]
        found.append(low - below * (high - low) / (above - below))
    sun = np.round(np.abs(solar * LIT * absorption * np.cos(np.radians(degrees))), 2) * area
    return np.radians(degrees), sun, np.array(found)


book.table("Radiator Size Study!G14:K46", columns=["T", "T_D", "1U", "2U", "3U"], of=studied)
book.table("Incident Angle Study!F5:Q37", columns=["T", "T_D", *map(str, range(90, 190, 10))], of=inclined)
book.table("Incident Angle Study!A4:D13", columns=["β", "rad", "W", "K"], of=interpolated, tolerance=1e-7)


@book.output("Radiator Size Study!L24", unit="K", tolerance=1e-7)
def without_sun(bath, load, sigma, earth, emissivity, area, view, solar, absorption):
    given = (bath, load, sigma, earth, emissivity, area, view, solar, absorption)
    return float(interpolated(np.full(10, 90.0), *given)[2][0])
