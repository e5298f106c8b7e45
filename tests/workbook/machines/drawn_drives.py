"""Machines as they are built, drawn by number: every mechanism and law, motions from rest to rest and others.

Every third machine hands over at speed and overshoots, or has laws that turn back between their rests. Limits of motor
and reducer lie near to what the drive asks for, so that a verdict that is wrong by little shows.
"""

import random
from itertools import pairwise
from math import cos, pi, radians, sqrt

from engine.drive.mechanisms.variable_ratio import PositionTable
from tests.laws import blended
from tests.workbook.machines.simulated import Simulated
from workbook.errors import InputError
from workbook.law_sheets.library import laws
from workbook.laws.registry import FAMILY
from workbook.machines.machine.mechanism import MECHANISMS
from workbook.machines.machine.view import moving_axes
from workbook.reading.descriptions import make_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
TRIES = 100
SMOOTH = [code for code in FAMILY if code not in ("DWL", "LIN", "OWN", "SPL")]
TURNING_BACK = ("OWN", "SPL")
SIZES = {
    "lead": (5, 60),
    "roller_diameter": (40, 200),
    "pinion_diameter": (20, 100),
    "pulley_diameter": (20, 150),
    "roller_radius": (20, 120),
}
NAMES = ("MC01", "Träger ½", "Cutter's <2> & more", "Ä")
TABLE = 40  # points of a table, at most


def drawn_machine(number, seed="drawn"):
    """The machine of a number, valid and within the reach of its mechanisms."""
    dice = random.Random(f"{seed} {number}")
    for _ in range(TRIES):
        try:
            made = make_machine(TEMPLATE, description(dice, number), str)
            return limited(made, dice) if not made.design.replaced and reached(made) else 1 / 0
        except (InputError, ZeroDivisionError):
            continue
    raise AssertionError(f"{TRIES} machines were drawn of number {number} and none is valid")


def description(dice, number):
    """A description; every third machine with a motion that is not from rest to rest, every fifth with several axes."""
    kinds = list(MECHANISMS)
    count = dice.randint(2, 4) if number % 5 == 4 else 1
    entered = drawn_laws(dice)
    axes = [axis(dice, kinds[(number + k * 5) % len(kinds)], NAMES[k], number % 3 == 2, entered) for k in range(count)]
    sizes = {
        "cycle": 36,
        "law": 4,
        "phases": 8,
        "rotors": 2,
        "positions": TABLE if any(one["mechanism"]["kind"] == "table" for one in axes) else 12,
    }
    return {
        "template": "machine",
        "title": "Drawn",
        "master": {"rate": dice.choice((dice.uniform(5, 40), dice.uniform(40, 240)))},
        "sizes": sizes,
        "laws": entered,
        "axes": axes,
        "power": {"efficiency": dice.uniform(0.8, 1)},
    }


def drawn_laws(dice):
    """The laws of a book: every family, by parameters of its own; a spline and a quadratic one that may turn back."""
    found = {code: {"family": code, **blended(code, dice)} for code in ("LIN", *SMOOTH)}
    inside = [(dice.uniform(0.2, 0.45), dice.uniform(-0.1, 0.5)), (dice.uniform(0.55, 0.8), dice.uniform(0.5, 1.2))]
    found["SPL"] = {"family": "SPL", "points": [{"at": at, "s": s} for at, s in ((0, 0), *inside, (1, 1))]}
    bend = dice.choice((-1, 1)) * dice.uniform(12, 40)  # v = A u (1 − u) + B u² (1 − u): from rest to rest
    level = 6.0 - bend / 2.0
    piece = {"duration": 1.0, "c0": level, "c1": 2.0 * (bend - level), "c2": -3.0 * bend}
    return found | {"OWN": {"family": "OWN", "name": "There and back", "pieces": [piece]}}


def axis(dice, kind, name, passing, entered):
    """An axis with a drive."""
    unit = dice.choice(MECHANISMS[kind].UNITS)
    mechanism, low, high = mechanism_of(dice, kind, unit, passing)
    turns = kind == "press crank" and not passing and dice.random() < 0.7
    phases = [full_turn(dice, entered)] if turns else (handed_over if passing else rest_to_rest)(dice, low, high)
    travels = unit == "mm" or kind == "press crank"
    size = dice.choice((5.0, 50.0, 400.0))

    def some(least, most):
        return dice.choice((0.0, dice.uniform(least, most)))

    load = (
        {
            "mass": dice.uniform(0.5, 80),
            "friction": some(0, 0.4),
            "slope": dice.choice((0.0, 0.0, 90.0, -90.0, dice.uniform(-60, 60))),
            "force": some(-size, size),
        }
        if travels
        else {
            "inertia": dice.uniform(10, 5000),
            "torque": some(-size / 10, size / 10),
            "friction_torque": some(0, size / 10),
        }
    )
    if not travels and dice.random() < 0.5:
        load["arm"] = {"mass": dice.uniform(0.5, 20), "radius": dice.uniform(20, 300), "angle": dice.uniform(-180, 180)}
    windows = [window(dice, size if travels else size / 10) for _ in range(dice.choice((0, 0, 1, 2)))]
    load |= {"viscous": dice.choice((None, dice.uniform(0, 100 if travels else 1))), "windows": windows}
    motor = {
        "inertia": 10 ** dice.uniform(-0.5, 1.5),
        "holding": dice.choice(("motor", "brake")),
        "copper_losses": dice.choice((None, dice.uniform(0.01, 0.4))),
        "rated_torque": 1.0,
        "peak_torque": 1.0,
        "max_speed": 1.0,
    }
    if dice.random() < 0.5:
        motor["brake"] = {"torque": 1e4, "closing": dice.uniform(0, 60), "opening": dice.uniform(0, 60)}
    shaft = dice.choice(("motor", "mechanism"))
    parts = [
        {
            "name": "P",
            "count": 2.0,
            "inertia": dice.uniform(0, 10),
            "shaft": shaft,
            "teeth_driver": 40.0,
            "teeth_driven": 30.0,
        }
    ]
    reducer = {
        "ratio": dice.choice((1.0, dice.uniform(1, 12))),
        "efficiency": dice.choice((1.0, dice.uniform(0.7, 1))),
        "inertia": dice.uniform(0, 2),
        "no_load_torque": some(0, 0.3),
    }
    stages = [stage(dice) for _ in range(dice.choice((0, 0, 1, 2)))]
    return {
        "name": name,
        "group": kind,
        "unit": unit,
        "smoothness": "velocity",
        "phases": phases,
        "mechanism": mechanism,
        "closes": "feed" if turns else "position",
        "load": load,
        "motor": motor,
        "reducer": reducer,
        "stages": stages,
        "parts": parts[: dice.randint(0, 1)],
        "shift": dice.choice((0.0, dice.uniform(-200, 200))),
    }


def stage(dice):
    """A stage between reducer and mechanism, by its ratio or its teeth."""
    losses = {
        "efficiency": dice.choice((1.0, dice.uniform(0.7, 1))),
        "friction_torque": dice.choice((0.0, dice.uniform(0, 1))),
    }
    losses |= {"driver_inertia": dice.uniform(0, 5), "driven_inertia": dice.uniform(0, 20)}
    by_teeth = {"teeth_driver": float(dice.randint(12, 40)), "teeth_driven": float(dice.randint(12, 90))}
    return losses | dice.choice(({"ratio": dice.uniform(0.5, 4)}, by_teeth))


def window(dice, size):
    """A process force."""
    start, resists = dice.uniform(0, 360), dice.choice(("always", "moving"))
    force = dice.uniform(0 if resists == "moving" else -size, size)
    return {"start": start, "stop": (start + dice.uniform(5, 150)) % 360, "force": force, "resists": resists}


def mechanism_of(dice, kind, unit, passing):
    """A mechanism, and the lowest and the highest position of a motion for it: one that passes keeps off the ends."""
    made = {
        "kind": kind,
        "efficiency": dice.choice((1.0, dice.uniform(0.5, 1.0))),
        "method": dice.choice(("physical",) * 4 + ("document",)),
    }
    if kind == "lead screw" or dice.random() < 0.2:
        made["back_efficiency"] = dice.choice((None, dice.uniform(-0.3, made["efficiency"])))
    if kind in ("conveyor", "belt"):
        made["belt_mass"] = dice.uniform(0, 10)
        made["belt_on_bed"] = 0.4 * made["belt_mass"] if made["efficiency"] < 0.8 else None
    near = dice.uniform(0.25, 0.35) if passing else dice.uniform(0.02, 0.3)
    far = dice.uniform(0.6, 0.7) if passing else dice.choice((0.975, dice.uniform(0.4, 0.975)))
    match kind:
        case "crank-slider" | "press crank":
            crank = dice.uniform(15, 120)
            made |= {
                "crank_radius": crank,
                "rod_length": crank * dice.uniform(1.6, 6),
                "offset": dice.choice((0.0, dice.uniform(-0.5, 0.5) * crank)),
            }
            if kind == "press crank":
                return made | {"start_angle": dice.uniform(-180, 180)}, 0.0, dice.uniform(40, 300)
            rod, e = made["rod_length"], made["offset"]
            stroke = sqrt((rod + crank) ** 2 - e**2) - sqrt((rod - crank) ** 2 - e**2)
            made |= {
                "start": near * stroke,
                "zero": dice.choice(("inner", "outer")),
                "branch": dice.choice(("ahead", "behind")),
            }
            return made, 0.0, (far - near) * stroke
        case "rocker":
            size = dice.uniform(30, 150)
            made |= {
                "lever_length": size,
                "link_length": dice.uniform(1.8, 5) * size,
                "offset": dice.uniform(0.6, 1.2) * size,
                "start_angle": dice.uniform(60, 120),
                "slide": dice.choice(("ahead", "behind")),
                "direction": dice.choice(("forward", "backward")),
            }
            return made, 0.0, dice.uniform(0.1, 0.35) * size * dice.choice((-1, 1))
        case "table":
            made["points"], low, high = points(dice)
            return made, low + near * (high - low) if passing else low, low + far * (high - low)
    if size := MECHANISMS[kind].SIZE:
        made[size] = dice.uniform(*SIZES[size])
    return made, 0.0, dice.uniform(20, 400) if unit == "mm" else dice.uniform(20, 200)


def points(dice):
    """Points of a table that rise about evenly, as a crank does, and the ends of their positions."""
    count, turn, height = (
        dice.choice((6, 12, TABLE, dice.randint(6, TABLE))),
        dice.uniform(60, 160),
        dice.uniform(20, 200),
    )
    begin, part = dice.uniform(25, 60), dice.uniform(20, 100)
    angles = [turn * (k + dice.uniform(-0.04, 0.04) * (0 < k < count - 1)) / (count - 1) for k in range(count)]
    places = [height * (cos(radians(begin)) - cos(radians(begin + part * one / turn))) for one in angles]
    if not PositionTable(list(zip(map(radians, angles), places, strict=True))).parabolas.calm.all():
        return points(dice)  # its polynomials are held where they would fall: no parabolas through three points
    return [{"angle": a, "position": y} for a, y in zip(angles, places, strict=True)], 0.0, places[-1]


def edges(dice, count):
    """So many phases in a cycle with rests between some of them: their begins and ends in degrees."""
    widths = [dice.uniform(0.2, 1) for _ in range(count)]
    rests = [dice.choice((0.0, dice.uniform(0.1, 0.8))) for _ in range(count + 1)]
    scale, at, found = 360.0 / (sum(widths) + sum(rests)), 0.0, []
    for rest, width in zip(rests, widths, strict=False):
        found.append((at + rest * scale, min(360.0, at + (rest + width) * scale)))
        at = found[-1][1]
    return found


def rest_to_rest(dice, low, high):
    """Rises and returns, the last to where the first began: at position 0."""
    places = [dice.uniform(low, high) for _ in range(dice.randint(0, 2))]
    places = [*places, high, *(dice.uniform(low, high) for _ in range(dice.randint(0, 1)))]
    found, at = [], 0.0
    for (start, stop), goal in zip(edges(dice, len(places) + 1), [*places, 0.0], strict=True):
        found.append({"start": start, "stop": stop, "lift": goal - at, "law": dice.choice(SMOOTH)})
        at = goal
    return found


def full_turn(dice, entered):
    """One turn of a crank, over most of the cycle."""
    start = dice.choice((0.0, dice.uniform(0, 100)))
    return {"start": start, "stop": dice.uniform(220, 360), "lift": 360.0, "law": dice.choice(SMOOTH)}


def handed_over(dice, low, high):
    """Phases that hand over at speed: a line between curves, rates that are entered, or laws that turn back."""
    span, shape = high - low, dice.randrange(3)
    places = sorted(dice.uniform(0, 360) for _ in range(6))
    places = [places[0], *(max(b, a + 20.0) for a, b in pairwise(places))]
    scale = min(1.0, 360.0 / places[-1])
    places = [place * scale for place in places]

    def phase(k, lift, law, **more):
        return {"start": places[k], "stop": places[k + 1], "lift": lift, "law": law} | more

    up = dice.uniform(0.3, 0.7) * span
    if shape == 0:  # it overshoots: the curve after the line begins at the line's speed
        return [phase(0, up / 2, "PO5"), phase(1, up / 2, "LIN"), phase(2, -up, dice.choice(("PO5", "PO7")))]
    if shape == 1:
        speed = up * 0.001 / radians(places[2] - places[1]) if span else 0.0
        rates = [
            {
                "velocity": dice.uniform(-1.2, 1.2) * speed,
                "acceleration": dice.choice((None, dice.uniform(-1, 1) * speed)),
            }
            for _ in range(2)
        ]
        law = dice.choice(("PO5", "PO7"))
        return [
            phase(0, up, law),
            phase(1, dice.uniform(-0.3, 0.3) * span, law, **rates[0]),
            phase(2, -up, law, **rates[1]),
        ]
    found = [
        phase(0, up, dice.choice(TURNING_BACK)),
        phase(2, dice.uniform(-0.5, 0.5) * up, dice.choice((*TURNING_BACK, "CIC"))),
    ]
    back = -sum(one["lift"] for one in found)
    return [*found, phase(4, back, dice.choice((*TURNING_BACK, "MSN")))]


def reached(made):
    """Whether every mechanism of a changing ratio reaches the positions of its axis, and every motion comes back."""
    for view in moving_axes(made, laws(made.laws)):
        one = Simulated(view, made)
        with_ratio = one.ratio(view.motion.at(one.nodes[0]).y) if view.given.mechanism else None
        if with_ratio is not None and not all(abs(part).max() < 1e9 for part in with_ratio):
            return False
    return True


def limited(made, dice):
    """The same machine with limits near to what each drive asks for by its equation of motion."""
    data, motors = made.model_dump(), []
    for view, entered in zip(moving_axes(made, laws(made.laws)), data["axes"], strict=True):
        asked = Simulated(view, made).results
        rpm = asked["speed"] * 30 / pi

        def near(value):
            return max(value, 1e-3) * dice.choice((dice.uniform(0.97, 1.03), dice.uniform(0.9, 3.0), 10.0))

        motor = {"rated_torque": near(asked["rms"]), "peak_torque": near(asked["peak"]), "max_speed": near(rpm)}
        if dice.random() < 0.3:
            stall, speed = dice.uniform(1, 1.5) * motor["rated_torque"], dice.uniform(0.4, 1) * motor["max_speed"]
            motor |= {"stall_torque": stall, "rated_speed": speed}
        entered["motor"] |= motor
        if dice.random() < 0.3:  # a curve that falls is the catalogue's
            motors.append(fallen(dice, entered["motor"], f"Motor {entered['name']}"))
        if dice.random() < 0.5:
            entered["reducer"] |= {
                "peak_torque": near(asked["output peak"]),
                "mean_torque": near(asked["output mean"]),
                "max_speed": near(rpm),
            }
    return make_machine(TEMPLATE, data | ({"selection": {"motors": motors}} if motors else {}), str)


def fallen(dice, motor, name):
    """The row of the catalogue of a motor whose peak torque falls; it is entered by that name."""
    figures = ("inertia", "rated_torque", "peak_torque", "max_speed", "stall_torque", "rated_speed", "copper_losses")
    knee, end = dice.uniform(0.3, 0.9) * motor["max_speed"], dice.uniform(0.4, 1.0) * motor["peak_torque"]
    row = {figure: motor.pop(figure, None) for figure in figures}
    motor["name"] = name
    return row | {"name": name, "full_torque_to": knee, "end_torque": end}
