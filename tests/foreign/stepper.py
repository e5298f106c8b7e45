"""What a calculator of stepper motors' torque over speed should compute (tests/foreign/books.py says which)."""

from math import pi, sqrt

import numpy as np

from workbook.oracle import Oracle

book = Oracle("Stepper motor", sheets=["Calculation Reference"])
sheet = "Calculation Reference"
voltage = book.input(f"{sheet}!B2", unit="V", low=12, high=60)
step = book.input(f"{sheet}!B3", unit="°", choices=[0.9, 1.8])
resistance = book.input(f"{sheet}!B4", unit="ohm", low=0.5, high=4)
rated = book.input(f"{sheet}!B5", unit="A", low=1, high=3)
current = book.input(f"{sheet}!B6", unit="A", low=0.5, high=3)
inductance = book.input(f"{sheet}!B7", unit="mH", low=0.8, high=6)
torque = book.input(f"{sheet}!B8", unit="N*cm", low=20, high=80)
cycle = book.input(f"{sheet}!B9", choices=[4, 8])

teeth = book.input("UI!C6", choices=[16, 20, 32])
ratio = book.input("UI!C7", low=0.5, high=3)
acceleration = book.input("UI!C9", unit="mm/s^2", low=2000, high=50000)
mass = book.input("UI!C10", unit="g", low=100, high=1000)
PITCH = 2  # mm of the belt
INERTIA = [82, 84.5, 68, 68, 34, 84.5, 35, 68, 85, 57]  # g cm² of the rotors in rows 14 to 23


def coil(turns, voltage, step, resistance, rated, current, inductance, torque, cycle):
    """Return the columns over the turns in a second: a coil's impedance is √(R² + X²)."""
    frequency = turns * 360 / step / cycle
    reactance = 2 * pi * frequency * inductance / 1000
    impedance = np.hypot(reactance, resistance)
    one_coil = torque / (100 * sqrt(2))  # Nm
    generated = 2 * pi * turns * one_coil / rated
    available = np.maximum(voltage - generated, 0)
    possible = available / impedance
    actual = np.minimum(possible, current)
    one = actual / rated * one_coil
    return (frequency, reactance, impedance, generated, available, possible, actual, actual / rated, one,
            one * sqrt(2))  # fmt: skip


book.table(f"{sheet}!D2:N25", columns=["rps", "f", "X", "Z", "V_gen", "V", "I_max", "I", "share", "T1", "T2"], of=coil)


@book.output("UI!C11", unit="N-cm")
def required(teeth, ratio, acceleration, mass):
    """m a r / i, in N cm."""
    return mass / 1000 * acceleration / 1000 * teeth * PITCH / (2 * pi) / ratio / 10


@book.output("UI!E6", unit="mm")
def radius(teeth):
    return teeth * PITCH / (2 * pi)


def speed(turns, teeth, ratio):
    return (turns * teeth * PITCH / ratio,)


book.table("UI!P3:Q102", columns=["rps", "mm/s"], of=speed)


def of_rotor(inertia):
    """Return what gives the torque J α of a rotor, in N cm; the motor turns i times as fast as the pulley."""
    return lambda teeth, ratio, a: inertia * 1e-7 * ratio * a / (teeth * PITCH / (2 * pi)) * 100


for row, inertia in enumerate(INERTIA, 14):
    book.output(f"UI!N{row}", inputs=[teeth, ratio, acceleration])(of_rotor(inertia))
