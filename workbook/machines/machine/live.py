"""The figures of a machine's axes while it is edited: pieces of the motion, charts, use of limits, the highest rate."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from engine.drive.motor import LimitCheck
from engine.laws.base import Array
from engine.motion.profile import CamProfile, profile_of_motion
from engine.selection.pair_matrix import PairMatrix
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, PER_HOUR, RPM, shown, si
from workbook.machines.machine.axes import axes_of, drive_of
from workbook.machines.machine.drive.reducer_load import shaft_of
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive_entries import NEEDED
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.view import MovingAxis
from workbook.selection.catalogue import MotorRow
from workbook.selection.pair_selection import PairSelection, engine_motors
from workbook.template_outputs import LIMITS, SIZES

POWERS = 9  # of the polynomial that stands for a piece with sines: to a millionth of the lift
NODES = 0.5 - 0.5 * np.cos(np.pi * (np.arange(24) + 0.5) / 24)  # at which it is fitted
ORDERS = (("v", "velocity"), ("a", "acceleration"), ("j", "jerk"))
USES = {  # of each limit by its name in the engine: its key and label, and the kind of its line
    "RMS torque": ("rms", "RMS"), "peak torque": ("peak", "peak"), "motor speed": ("speed", "speed"),
    "torque below the curve": ("curve", "curve"), "reducer peak torque": ("reducer_peak", "reducer peak"),
    "reducer mean torque": ("reducer_mean", "reducer mean"), "reducer input speed": ("reducer_speed", "reducer speed"),
}  # fmt: skip

OWN = (*NEEDED, "stall_torque", "rated_speed")  # entries of a motor
COMES_TO = ("rms", "peak", "speed", "inertia_ratio", "verdict")


def axis_figures(machine: AnyMachine) -> list[dict[str, Any]]:
    """Return the figures of each axis, in the units of its entries."""
    figures = []
    for tables in axes_of(machine):
        axis = tables.axis
        x = machine.over.shown(tables.machine.angles)
        each: dict[str, Any] = {
            "pieces": list(phase_pieces(axis)),
            "start": shown(float(axis.at(np.zeros(1)).y[0]), axis.unit),
            "charts": list(motion_charts(axis, x, tables.machine.samples)),
            "use": [],
        }
        view = drive_of(tables)
        figures.append(each if view is None else each | driven(view, x, each["charts"]))
    return figures


def gap_figures(machine: AnyMachine) -> list[dict[str, Any]]:
    """Return of each clearance the gap over the cycle and the least of it, by closed forms, in its unit."""
    rows, over = axes_of(machine), machine.over
    figures = []
    for k, entry in enumerate(machine.clearances, 1):
        gap = ClearanceView(entry, k, rows)
        angles = np.unique(np.concatenate([rows[0].machine.angles, gap.angles, [gap.place]]))
        drawn = chart(f"gap{k}", entry.name, gap.unit, over.shown(angles), gap.gaps(angles), over.unit)
        least = {"least": gap.exact, "at": over.shown(gap.place), "need": entry.least, "ok": gap.is_left}
        figures.append({"name": entry.name, "unit": gap.unit, "x": drawn["x"], "y": drawn["y"]} | least)
    return figures


def product_figures(machine: AnyMachine, of_motors: bool) -> dict[str, Any]:
    """Return the use of each motor behind the first axis' reducer, or of each reducer with its motor, by its name."""
    view = next(filter(None, map(drive_of, axes_of(machine))))
    choice = PairSelection(machine.selection, machine.sizes, [shaft_of(view)])
    pairs, names = choice.behind_own, choice.motors.names
    if not of_motors:
        entered, row = view.driven.entered_motor, view.driven.motor_used.row
        motors = machine.selection.motors
        known = {key: getattr(entered, key) for key in MotorRow.model_fields if key in OWN}
        own = motors[row - 1] if row else MotorRow.model_validate({"name": "own"} | known)
        motor = engine_motors([own]).derated(view.driven.left)
        rate = si(choice.shaft.values["cycles"], PER_HOUR)
        beside, names = choice.shaft.values["beside"], choice.reducers.names
        pairs = PairMatrix(choice.load, motor, choice.reducers, beside, choice.requirements, rate)
    motors_of = pairs.motors
    uses = pairs.uses, pairs.peak / motors_of.peak_torque[:, None], pairs.speed / motors_of.max_speed[:, None]
    columns = [np.broadcast_to(use, pairs.rms.shape).ravel().tolist() for use in (*uses, pairs.inertia_ratio)]
    figures = zip(*columns, pairs.verdicts.ravel().tolist(), strict=True)
    return {name: dict(zip(COMES_TO, each, strict=True)) for name, each in zip(names, figures, strict=True)}


def phase_pieces(axis: MovingAxis) -> Iterator[list[dict[str, Any]]]:
    """Yield for each phase as entered the pieces [from, to] of its motion in shares: s = Σ x_k u^k, u from 0 to 1."""
    profile, edges = profile_of_motion(axis.motion), axis.motion.edges
    for k in axis.entered:
        begin, end, lift = float(edges[k]), float(edges[k + 1]), axis.motion.phases[k].lift
        inside = [e for e in profile.edges.tolist() if begin + 1e-9 < e < end - 1e-9]
        breaks = [begin, *inside, end]
        first = float(profile.at(np.array([begin])).y[0])
        if not lift or end <= begin:
            yield [{"from": 0.0, "to": 1.0, "x": [0.0]}]
            continue
        yield [
            {
                "from": (low - begin) / (end - begin),
                "to": (high - begin) / (end - begin),
                "x": polynomial(profile, low, high, first, lift),
            }
            for low, high in pairwise(breaks)
        ]


def polynomial(profile: CamProfile, low: float, high: float, first: float, lift: float) -> list[float]:
    """Return the coefficients of a piece in shares of its length and of the lift."""
    y = (profile.at(low + NODES * (high - low)).y - first) / lift
    fitted = np.polynomial.Polynomial.fit(NODES, y, POWERS, domain=[0.0, 1.0]).convert()
    return [round(float(c), 9) for c in fitted.coef]


def motion_charts(axis: MovingAxis, x: Array, samples: Array) -> Iterator[dict[str, Any]]:
    """Yield the charts of velocity, acceleration and jerk over the cycle."""
    rates = axis.at(samples)[1:]
    units, symbols = axis.over.rates(axis.typed.unit), axis.over.symbols[1:]
    for n, ((key, title), unit, symbol) in enumerate(zip(ORDERS, units, symbols, strict=True), 1):
        y = axis.rate(rates[n - 1] * axis.speed**n)
        yield chart(key, f"{title} {symbol}", unit, x, y, axis.over.unit)


def chart(key: str, title: str, unit: str, x: Array, y: Array, x_title: str, **more: Any) -> dict[str, Any]:
    """Return a chart as the page has it, its numbers to six digits."""
    lines = {"x": to_six_digits(x), "y": to_six_digits(y), "limits": [], "points": []}
    titles = {"key": key, "title": title, "quantity": key, "unit": unit, "x_title": x_title}
    return titles | lines | more


def to_six_digits(values: Array) -> list[float]:
    """Return numbers as the page has them."""
    return [float(f"{value:.6g}") for value in values.tolist()]


def driven(view: DriveView, x: Array, charts: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the figures of a drive: charts of torque and power too, the use of limits, the highest rate."""
    torque, power = view.sampled
    over, motor, checks = view.driven.axis.over.unit, view.driven.motor, view.limit_checks
    if not motor.falling.fall:
        checks = {name: check for name, check in checks.items() if name != "torque below the curve"}
    limits = [*torque_limits(motor.peak_torque, "peak", "peak")]
    mean = float(motor.continuous(view.points.mean_speed))
    rms = {"y": view.points.rms_torque, "label": f"RMS {view.points.rms_torque:.3g} Nm"}
    fastest = shown(motor.max_speed, RPM)
    speed = [{"value": way * fastest, "label": "speed", "kind": "speed"} for way in (1, -1) if math.isfinite(fastest)]
    rpm = shown(np.broadcast_to(view.points.speed, view.points.torque.shape).ravel(), RPM)
    charts = [
        *charts,
        chart("T", "motor torque T", "Nm", x, torque, over, limits=limits),
        chart("P", "motor power P", "kW", x, shown(power, KW), over),
        chart(
            "Tn",
            "torque against speed",
            "Nm",
            rpm,
            view.points.torque.ravel(),
            "rpm",
            limits=[*limits, *torque_limits(mean, "continuous", "continuous"), *speed],
            points=[{"x": shown(view.points.mean_speed, RPM), **rms}],
            at=places(view),
        ),
    ]
    rates = view.rates
    return {
        "charts": charts,
        "use": [use for name, check in checks.items() if (use := limit_use(name, check))],
        "highest": rates.high if isinstance(rates.high, float) else None,
        "reason": rates.high_limit,
        "power": {
            "sampled": [round(p, 3) for p in power.tolist()],
            "peak": view.peaks.top("P"),
            "low": -view.peaks.top("P", -1),
        },
        "own_rate": view.driven.entered.rate is not None,
    }


def places(view: DriveView) -> list[float]:
    """Return where in the cycle each point of a drive is, in the unit of places."""
    axis = view.driven.axis
    later = shown(view.load.x.ravel() + axis.shifted.shift, DEGREE)
    return to_six_digits(axis.over.shown(np.where(later > TURN, later % TURN, later)))


def torque_limits(value: float, label: str, kind: str) -> Iterator[dict[str, Any]]:
    """Yield the lines of a limit of torque, of both signs; none where it is without."""
    if math.isfinite(value):
        yield from ({"value": way * value, "label": label, "kind": kind} for way in (1, -1))


def limit_use(name: str, check: LimitCheck) -> dict[str, Any] | None:
    """Return the use of a limit; None of one that is infinite."""
    if not math.isfinite(check.limit):
        return None
    key, label = USES[name]
    unit = LIMITS[name][1]
    value, limit = (shown(size, SIZES.get(unit, 1.0)) for size in (check.value, check.limit))
    words = f"{value:.4g} of {limit:.4g} {unit}"
    return {"key": key, "label": label, "value": check.use, "may": 1, "is": words, "ok": check.ok}
