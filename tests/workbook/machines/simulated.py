"""The equation of motion of a drive by fine quadrature: a third way to its results, beside the engine and the cells.

From the entries and the motion alone. Of a mechanism whose ratio changes φ' and φ'' follow from its closure,
F(y, ψ) = 0, differentiated twice; of a table from its polynomials of degree 5, by SciPy.
"""

from functools import cached_property
from itertools import pairwise
from math import cos, pi, radians, sin, sqrt, tau
from typing import NamedTuple

import numpy as np
from scipy.interpolate import BPoly

PANELS = 24
"""equal parts of each stretch of the motion, with Gauss's points in each"""
SHARES, WEIGHTS = np.polynomial.legendre.leggauss(6)
ZOOMS, FINE = 4, 33
"""how often the surroundings of a peak are looked at again, and at how many places"""
STEPS = 7200
"""of a cycle, of drives on a bus"""
INSIDE = 1e-7
"""rad: nearer to its end a stretch has the motion of the next, so that no peak is looked for there"""
STILL = 1e-9
"""share of the largest speed: what is slower stands"""
RPM, CM2, MM = pi / 30, 1e-4, 1e-3


def of_closure(f_y, f_psi, f_yy, f_ypsi, f_psipsi):
    """ψ' and ψ'' by y from the derivatives of F(y, ψ) = 0."""
    first = -f_y / f_psi
    return first, -(f_yy + 2.0 * f_ypsi * first + f_psipsi * first**2) / f_psi


def slide_and_lever(x, psi, lever, offset):
    """F = (x − r cos ψ)² + (r sin ψ − e)² − l², differentiated by x and ψ: half of F_x, F_ψ, F_xx, F_xψ, F_ψψ."""
    c, s = lever * np.cos(psi), lever * np.sin(psi)
    return x - c, x * s - offset * c, np.ones_like(x), s, x * c + offset * s


def lever_angle(x, lever, link, offset, side):
    """ψ by the law of cosines; ``side`` 1 or −1 is that of the lever from the line of shaft and slide."""
    d = np.hypot(x, offset)
    return np.arctan2(offset, x) + side * np.arccos(np.clip((lever**2 + d**2 - link**2) / (2.0 * lever * d), -1.0, 1.0))


def rising(first, second):
    """φ' above 0: the shaft turns forward where the load moves forward."""
    way = np.sign(first)
    return way * first, way * second


def crank_slider(given, y):
    """φ' and φ'' (rad/m, rad/m²) of a crank-slider at positions (m)."""
    r, rod, e, start = (
        MM * (getattr(given, name) or 0.0) for name in ("crank_radius", "rod_length", "offset", "start")
    )
    inner, outer = sqrt((rod - r) ** 2 - e**2), sqrt((rod + r) ** 2 - e**2)
    way = -1.0 if given.zero == "outer" else 1.0
    x = (outer if way < 0.0 else inner) + way * (start + y)
    psi = lever_angle(x, r, rod, e, -1.0 if given.branch == "behind" else 1.0)
    first, second = of_closure(*slide_and_lever(x, psi, r, e))
    return rising(way * first, second)


def rocker(given, y):
    """φ' and φ'' of a rocker at positions."""
    r, link, e = (MM * (getattr(given, name) or 0.0) for name in ("lever_length", "link_length", "offset"))
    angle, ahead = radians(given.start_angle or 0.0), -1.0 if given.slide == "behind" else 1.0
    zero = r * cos(angle) + ahead * sqrt(link**2 - (r * sin(angle) - e) ** 2)
    way = -1.0 if given.direction == "backward" else 1.0
    x, side = zero + way * y, np.sign(sin(angle - np.arctan2(e, zero)))
    first, second = of_closure(*slide_and_lever(x, lever_angle(x, r, link, e, side), r, e))
    return rising(way * first, second)


def table(given, unit, y):
    """φ' and φ'' of a table: parabolas through three points give both at each, as the sheet's notes say."""
    angle, place = np.array([(radians(one.angle), unit * one.position) for one in given.points]).T
    slope, bend = np.empty((2, len(place)))
    for k in range(len(place)):
        three = slice(max(0, min(k - 1, len(place) - 3)), None)
        a, b, _ = np.polyfit(angle[three][:3] - angle[k], place[three][:3], min(2, len(place) - 1))
        slope[k], bend[k] = b, 2.0 * a
    found = BPoly.from_derivatives(place, np.column_stack([angle, 1.0 / slope, -bend / slope**3]))
    return found(y, 1), found(y, 2)


def press(given, angle):
    """x' and x'' (m/rad, m/rad²) of a press's slide at angles of its crank (rad)."""
    r, rod, e = (MM * (getattr(given, name) or 0.0) for name in ("crank_radius", "rod_length", "offset"))
    psi = angle + radians(given.start_angle or 0.0)
    x = r * np.cos(psi) + np.sqrt(rod**2 - (r * np.sin(psi) - e) ** 2)
    f_x, f_psi, f_xx, f_xpsi, f_psipsi = slide_and_lever(x, psi, r, e)
    return of_closure(f_psi, f_x, f_psipsi, f_xpsi, f_xx)


class Simulated:
    """An axis of a machine with its drive, at a rate (cycles/min). Speeds in rad/s, torques in Nm, energies in J."""

    def __init__(self, view, machine, rate=None):
        self.given, self.motion, self.machine = view.given, view.motion, machine
        self.rate = rate or view.given.rate or machine.per_minute
        self.speed, self.late = tau * self.rate / 60.0, radians(view.given.shift)
        self.unit = MM if view.given.unit == "mm" else radians(1.0)
        self.begin, self.total = float(view.motion.edges[0]), float(view.motion.total)
        motors, reducers = (
            {row.name: row for row in rows} for rows in (machine.selection.motors, machine.selection.reducers)
        )
        self.motor = motors.get(view.given.motor.name, view.given.motor)
        self.reducer = reducers.get(view.given.reducer.name, view.given.reducer)

    def moved(self, x):
        """Position, velocity and acceleration of the axis (m or rad, s) at places of the motion (rad)."""
        found = self.motion.at(x)
        return found.y, found.y1 * self.speed, found.y2 * self.speed**2

    def load_velocity(self, x):
        """Velocity of the load itself: of a press its slide's."""
        y, v, _ = self.moved(x)
        return press(self.given.mechanism, y)[0] * v if self.given.mechanism.kind == "press crank" else v

    @cached_property
    def stretches(self):
        """Places between which the torque has one smooth formula but where power changes its way: begin and end."""
        cuts = [
            e + s * p.duration
            for e, p in zip(self.motion.edges, self.motion.phases, strict=False)
            for s in (0.0, *p.law.breaks)
        ]
        edges = [radians(edge) - self.late for one in self.given.load.windows for edge in (one.start, one.stop)]
        cuts += [self.begin + (edge - self.begin) % self.total for edge in edges]
        cuts = np.unique([*cuts, self.begin, self.begin + self.total])
        cuts = cuts[np.concatenate([[True], np.diff(cuts) > 3.0 * INSIDE])]
        places = np.concatenate([np.linspace(a, b, 60)[1:-1] for a, b in pairwise(cuts)])
        turns = self.zeros(self.load_velocity, places)
        knots = [one.position * self.unit for one in getattr(self.given.mechanism, "points", [])[1:-1]]
        passed = [self.zeros(lambda x, knot=knot: self.moved(x)[0] - knot, places) for knot in knots]
        cuts = np.unique(np.concatenate([cuts, turns, *passed]))
        return cuts[np.concatenate([[True], np.diff(cuts) > 3.0 * INSIDE])]

    def zeros(self, quantity, places):
        """Where a quantity changes its sign, by bisection between places."""
        v = quantity(places)
        k = np.flatnonzero((v[:-1] * v[1:] < 0.0) & (np.abs(v[:-1]) + np.abs(v[1:]) > 1e-9 * np.abs(v).max()))
        low, high = places[k], places[k + 1]
        for _ in range(50 if k.size else 0):
            middle = (low + high) / 2.0
            same = quantity(middle) * v[k] > 0.0
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return low

    @cached_property
    def nodes(self):
        """Gauss's points of every stretch, a row each, and their shares of the cycle."""
        ends = np.array([np.linspace(a, b, PANELS + 1) for a, b in pairwise(self.stretches)])
        middle, half = (ends[:, 1:] + ends[:, :-1]) / 2.0, np.diff(ends) / 2.0
        rows = len(ends)
        return (
            (middle[..., None] + half[..., None] * SHARES).reshape(rows, -1),
            (half[..., None] * WEIGHTS).reshape(rows, -1) / self.total,
        )

    @cached_property
    def dwells(self):
        """Of each stretch whether the axis stands there, and for how long (s), across the end of the cycle too."""
        v, width = np.abs(self.moved(self.nodes[0])[1]).max(axis=1), np.diff(self.stretches) / self.speed
        still = v <= STILL * v.max()
        if still.all():
            return still, np.full(len(width), width.sum())
        first = int(np.argmin(still))
        lasts, run = np.zeros(len(width)), []
        for k in [(first + n) % len(width) for n in range(len(width) + 1)]:
            if still[k]:
                run.append(k)
            else:
                lasts[run], run = width[run].sum(), []
        return still, lasts

    @cached_property
    def losses(self):
        """Efficiencies forward and backward of reducer and mechanism."""
        m, reducer = self.given.mechanism, self.reducer
        back = m.efficiency if m.kind != "lead screw" else 2.0 - 1.0 / m.efficiency
        back = back if m.back_efficiency is None else m.back_efficiency
        return (reducer.efficiency, reducer.efficiency), (m.efficiency, back)

    def through(self, torque, way, losses):
        """A torque behind a stage times what is lost in it."""
        eta, back = losses
        if self.given.mechanism.method == "document":
            return torque / eta
        held = 0.0 if back <= 0.0 else 1.0 / eta
        return torque * np.where(torque * way < 0.0, back, np.where(way == 0.0, held, 1.0 / eta))

    def ratio(self, y):
        """φ' and φ'' of the mechanism's shaft by the position of the axis."""
        m, one = self.given.mechanism, np.ones_like(y)
        match m.kind:
            case "crank-slider":
                return crank_slider(m, y)
            case "rocker":
                return rocker(m, y)
            case "table":
                return table(m, self.unit, y)
            case "lead screw":
                return tau / (MM * m.lead) * one, 0.0 * one
            case "feed rollers":
                return one / (MM * m.roller_radius), 0.0 * one
            case "conveyor" | "rack and pinion" | "belt":
                return 2.0 * one / (MM * m.size), 0.0 * one
        return one, 0.0 * one

    def force(self, x, way):
        """What drives the axis (N or Nm) at places of stretches (rows), in the direction of each."""
        load, m, g = self.given.load, self.given.mechanism, self.machine.gravity
        y, v, a = self.moved(x)
        travels = self.given.unit == "mm" or m.kind == "press crank"
        slope, of_slide = radians(load.slope), (np.ones_like(y), np.zeros_like(y))
        if m.kind == "press crank":
            of_slide = press(m, y)
        first, second = of_slide
        side = way * np.sign(first)  # of the load's own direction
        steady = load.force + load.mass * g * sin(slope) if travels else load.torque
        rubs = load.mass + (getattr(m, "belt_on_bed", None) or 0.0)
        rubbing = load.friction * rubs * g * abs(cos(slope)) if travels else load.friction_torque
        middle = x[:, x.shape[1] // 2][:, None] if x.ndim == 2 else x
        for one in load.windows:
            begin, last = radians(one.start) - self.late, radians((one.stop - one.start) % 360.0) or tau
            acts = (middle - begin) % self.total < last
            steady = steady + np.where(acts & (one.resists == "always"), one.force, 0.0)
            rubbing = rubbing + np.where(acts & (one.resists == "moving"), one.force, 0.0)
        mass = load.mass + (getattr(m, "belt_mass", None) or 0.0) if travels else CM2 * load.inertia
        force = mass * (first * a + second * v**2) + (load.viscous or 0.0) * first * v + steady + rubbing * side
        arm = load.arm
        weight = arm.mass * g * MM * arm.radius * np.cos(y + radians(arm.angle)) if arm else 0.0
        return first * force + weight

    @cached_property
    def inertias(self):
        """What turns with the motor's shaft and with the mechanism's (kg m²)."""
        found = [CM2 * (self.motor.inertia + self.reducer.inertia), 0.0]
        for part in self.given.parts:
            outer, hole = ((MM * (size or 0.0) / 2.0) ** 4 for size in (part.diameter, part.bore))
            own = pi / 2.0 * (part.density or 0.0) * (outer - hole) * MM * (part.length or 0.0)
            own = own if part.inertia is None else CM2 * part.inertia
            geared = part.teeth_driver / part.teeth_driven if part.teeth_driver and part.teeth_driven else 1.0
            found[part.shaft == "mechanism"] += part.count * own * geared**2
        return found

    def shaft(self, x, still, dwell):
        """Speed (rad/s), torque (Nm) and power (W) of the motor, and the torque behind the reducer, at places."""
        motor, reducer = self.given.motor, self.reducer
        y, v, a = self.moved(x)
        way = np.where(still, 0.0, np.sign(v))
        first, second = self.ratio(y)
        turning = second * v**2 + first * a
        at_motor, at_mechanism = self.inertias
        before, behind = self.losses
        output = self.through(self.force(x, way), way, behind) / first + at_mechanism * turning
        turned = first * v
        for stage in reversed(self.given.stages):
            losses = stage.efficiency, stage.efficiency if stage.back_efficiency is None else stage.back_efficiency
            driven = output + CM2 * stage.driven_inertia * turning + stage.friction_torque * way
            by_teeth = (stage.teeth_driven or 1.0) / (stage.teeth_driver or 1.0)
            ratio = stage.ratio or by_teeth
            turned, turning = ratio * turned, ratio * turning
            output = self.through(driven, way, losses) / ratio + CM2 * stage.driver_inertia * turning
        torque = self.through(output, way, before) / reducer.ratio + at_motor * reducer.ratio * turning
        brake = motor.brake
        least = MM * (brake.closing + brake.opening) if brake else 0.0
        held = (motor.holding == "brake") & still & (dwell >= least - 1e-9)
        torque = np.where(held, 0.0, torque) + reducer.no_load_torque * way
        speed, copper = reducer.ratio * turned, 1e3 * (self.motor.copper_losses or 0.0) / self.motor.rated_torque**2
        return speed, torque, torque * (speed + copper * torque), output

    def power_at(self, x):
        """Power of the motor (W) at angles of the master shaft (rad)."""
        place = self.begin + (x - self.late - self.begin) % self.total
        k = np.clip(np.searchsorted(self.stretches, place, side="right") - 1, 0, len(self.stretches) - 2)
        still, dwell = self.dwells
        return self.shaft(place, still[k], dwell[k])[2]

    @cached_property
    def values(self):
        """The same at all nodes."""
        return self.shaft(self.nodes[0], *(column[:, None] for column in self.dwells))

    def mean(self, values):
        """Mean over the cycle."""
        return float((values * self.nodes[1]).sum())

    def top(self, quantity):
        """The largest value of a quantity of :meth:`shaft`, searched more and more closely about those at the nodes."""
        found = quantity(*self.values)
        best = -np.inf
        for row in np.argsort(found.max(axis=1))[-4:]:
            k = int(found[row].argmax())
            inner = [self.stretches[row] + INSIDE, *self.nodes[0][row], self.stretches[row + 1] - INSIDE]
            low, high = inner[k], inner[k + 2]
            still, dwell = (column[row : row + 1, None] for column in self.dwells)
            for _ in range(ZOOMS):
                x = np.linspace(low, high, FINE)
                values = quantity(*self.shaft(x[None, :], still, dwell))[0]
                k = int(values.argmax())
                low, high = x[max(k - 1, 0)], x[min(k + 1, FINE - 1)]
            best = max(best, float(values.max()))
        return best

    @cached_property
    def results(self):
        """All results by name."""
        speed, torque, power, output = self.values
        fast = np.abs(speed)
        mean = self.mean(fast)
        time = self.total / self.speed
        return {
            "rms": sqrt(self.mean(torque**2)),
            "peak": max(self.top(lambda w, t, p, s: t), self.top(lambda w, t, p, s: -t)),
            "speed": self.top(lambda w, t, p, s: np.abs(w)),
            "mean speed": mean,
            "power": self.top(lambda w, t, p, s: p),
            "back power": max(0.0, self.top(lambda w, t, p, s: -p)),
            "driving": self.mean(np.maximum(power, 0.0)) * time,
            "returned": self.mean(np.maximum(-power, 0.0)) * time,
            "output peak": max(self.top(lambda w, t, p, s: s), self.top(lambda w, t, p, s: -s)),
            "output mean": (self.mean(fast * np.abs(output) ** 3) / mean) ** (1.0 / 3.0) if mean else 0.0,
        }


class Bus(NamedTuple):
    """Power of drives on a common DC bus (W): the highest and the mean from the mains, and into the resistor."""

    peak: float
    mean: float
    burnt_peak: float
    burnt: float


def bus_of(drives, efficiency):
    """What drives at one rate take together, at even steps and close beside all begins of their stretches."""
    edges = np.concatenate([(one.stretches + one.late - one.begin) % one.total + one.begin for one in drives])
    close = np.concatenate([edges - 1e-6, edges + 1e-6])  # closer, rounding mixes both sides
    even = (np.arange(STEPS) + 0.5) * tau / STEPS
    power = np.array([one.power_at(np.concatenate([even, close])) for one in drives])
    both = np.where(power > 0.0, power / efficiency, power * efficiency).sum(axis=0)
    mains, back = np.maximum(both, 0.0), np.maximum(-both, 0.0)
    return Bus(mains.max(), mains[:STEPS].mean(), back.max(), back[:STEPS].mean())
