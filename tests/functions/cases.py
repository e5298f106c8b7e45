"""The cases that both back ends must answer like the engine: all laws, seeded random parameters, edges."""

import math
import random

import numpy as np

from engine.drive import Part
from engine.laws.inverse import inverse
from engine.motion import Phase
from engine.motion.joining import Rates, join_phases
from tests import tiers
from tests.functions.case import NUM, Case
from workbook.functions.addin.motion_functions.library import OWN_WIDTH
from workbook.functions.declarations import CODES, TAKES
from workbook.laws.registry import CODES as BASIC
from workbook.laws.registry import FAMILY

SEED = 20261121
EPSILON = 2.3e-16
CLASSIC = (0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125)
ZERO_STAGES = (
    (0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0),
    (0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25),
    (0.0, 0.0, 0.375, 0.25, 0.375, 0.0, 0.0),
    (0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5),
    (0.0, 0.125, 0.0, 0.75, 0.0625, 0.0, 0.0625),
)
POLYNOMIAL_345 = ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),)
HARMONIC = ((1.0, 0.0, 0.0, 0.0, 0.0, math.pi**2 / 2, math.pi, math.pi / 2),)
PASSED_OVER = ((None,) * 8, (None, *[7.0] * 7), (0.0, *[-7.0] * 7))
STANDS_BETWEEN = tuple((d, c, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0) for d, c in zip(
    (0.1875, 0.1875, 0.25, 0.1875, 0.1875), (14.0, -14.0, 0.0, 14.0, -14.0), strict=True))  # fmt: skip


MORE = {
    "TVP": [(pair,) for pair in ((0.5, 0.5), (0.1, 0.7), (1e-3, 0.999))],
    "MTP": [(durations,) for durations in (CLASSIC, *ZERO_STAGES)],
    "OWN": [POLYNOMIAL_345, HARMONIC, STANDS_BETWEEN],
}
"""parameters of laws at their limits, beside those of their pages"""
RANDOM = {"TVP": 5, "MTP": 5, "OWN": 5}
"""random parameters of a law, where these are more than one"""


def engine_law(code, p):
    """The engine's law of a code with its parameters, given as the functions take them."""
    numbers = [v or 0.0 for row in p for v in row] if isinstance(p, tuple) and code in TAKES else []
    return FAMILY[code].law_of(numbers)


def known(code):
    """Parameters of a law as the functions take them: as delivered, and others; 0 for a law that takes none."""
    page = FAMILY[code]
    if code not in TAKES:
        return [0]
    entered = [page.entries(), *(page.entries.model_validate(one) for one in page.variations)]
    rows = [rowed(code, page.numbers(one)) for one in entered]
    return [0] if not rows[0] else [*rows, *MORE.get(code, [])]


def rowed(code, numbers):
    """Numbers of a law in rows of a range: one row, or of the own law a row a piece."""
    width = OWN_WIDTH if code == "OWN" else len(numbers)
    return tuple(tuple(numbers[i : i + width]) for i in range(0, len(numbers), width or 1))


def drawn(code, draw):
    """Random parameters of a law: its own way where it has one, else between two sets that are known."""
    if code == "OWN":
        return own_law(draw)
    if code == "TVP":
        return (tuple(sorted(draw.uniform(0.01, 0.99) for _ in range(2))),)
    if code == "MTP":
        weights = [draw.random() * (draw.random() > 0.2) + (k in (1, 5)) * 0.05 for k in range(7)]
        return (tuple(w / sum(weights) for w in weights),)
    (one,), (other,) = draw.sample(known(code), 2)
    share = draw.random()
    return (tuple(draw.choice((a, b)) if isinstance(a, str) else share * a + (1.0 - share) * b
                  for a, b in zip(one, other, strict=True)),)  # fmt: skip


def parameters(draw):
    """Laws with parameters in plenty: the known ones, with stages of zero duration, and random ones."""
    for code in CODES:
        taken = known(code)
        yield from ((code, p) for p in taken)
        if taken != [0]:
            yield from ((code, drawn(code, draw)) for _ in range(RANDOM.get(code, 1)))


def own_law(draw):
    """Random pieces; they end anywhere, at any speed."""
    lengths = [draw.random() * (draw.random() > 0.15) + 1e-3 * (k == 0) for k in range(draw.randint(1, 4))]
    return tuple(
        (length / sum(lengths), *(draw.uniform(-20, 20) for _ in range(4)), draw.uniform(-5, 5) * sine,
         draw.uniform(0.5, 20) * sine, draw.uniform(-3, 3) * sine)
        for length in lengths for sine in (draw.randint(0, 1),)
    )  # fmt: skip


def breaks(code, p):
    """Begins of the law's stages, as a spreadsheet sums them up; of a law of one stage, its middle."""
    return list(engine_law(code, p).breaks) or [0.5]


def abscissae(code, p, draw):
    """ξ at the ends, at every break and a hair beside it, between, and at random."""
    inner = [x for x in breaks(code, p) if 0.0 < x < 1.0]
    if code not in BASIC:
        return sorted({0.0, 1.0, draw.choice(inner) - 1e-13, draw.choice(inner), draw.random()})
    sides = [x + side for x in inner for side in (0.0, 1e-13, -1e-13, 1e-6)]
    return sorted({0.0, 1.0, 1e-9, 1 - 1e-9, *(min(x, 1.0) for x in sides), *(draw.random() for _ in range(4))})


def of_laws(draw):
    for code, p in parameters(draw):
        one = engine_law(code, p)
        k = one.coefficients
        jerk = max(abs(float(j)) for j in one.j(np.linspace(0.0, 1.0, 2001)))
        scale = {"S": max(1.0, k.cv), "V": k.cv, "A": k.ca, "J": max(jerk, k.ca)}
        for xi in abscissae(code, p, draw):
            at = one.evaluate(xi)
            for name, value in zip("SVAJ", at, strict=True):
                yield Case(name, (code, xi, p), value, 1e-12 * max(1.0, scale[name]))
        for name, value in (("CV", k.cv), ("CA", k.ca), ("CARMS", k.ca_rms), ("CJ", k.cj)):
            expected, near = (value, 1e-10 * max(1.0, value)) if math.isfinite(value) else (NUM, 0.0)
            yield Case(name, (code, p), expected, near)
        if code != "DWL":
            yield from inverses(code, p, one, draw)


def inverses(code, p, one, draw):
    """ξ at heights of the law; #NUM! where it moves backwards."""
    shares = (0.0, 0.25, 0.5, 1.0, 1e-6, *(draw.random() for _ in range(3))) if code in BASIC else (draw.random(), 1.0)
    for share in shares:
        s = share * max(one.end.s, 0.5)
        try:
            xi = inverse(one, s)
        except ValueError:
            yield Case("XI", (code, s, p), NUM)
            continue
        speed = one.v(xi)
        yield Case("XI", (code, s, p), xi, 1e-12 + 8 * EPSILON / speed if speed > 1e-9 else 1e-12)


def of_phases(draw):
    alone = ([(code, 3.0, 0.0 if code == "DWL" else -7.0, known(code)[-1])] for code in CODES)
    for phases in (exercise(), *alone, *(random_phases(draw) for _ in range(10))):
        yield from of_table(phases, {}, draw)
    for phases, through in (LINE_SPEED, *(handing_over(draw) for _ in range(12))):
        yield from of_table(phases, through, draw)


def of_table(phases, through, draw):
    """A motion of phases, with what is prescribed between them; #NUM! where a law cannot meet what it is asked for."""
    found = join_phases([Phase(engine_law(code, p), lift, d) for code, d, lift, p in phases], through, False)
    motion = found.motion
    rows = [row(*phase, draw) for phase in phases]
    for k, rates in sorted(through.items(), reverse=True):
        rows.insert(k, ("VIA", *rates))
    table = wide(rows)
    edges = [float(x) for x in motion.edges]
    inner = [x + d * xi for x, (code, d, _, p) in zip(edges, phases, strict=False) if code == "OWN"
             for xi in breaks(code, p)]  # fmt: skip
    k = [phase.law.coefficients for phase in motion.phases]
    sizes = [max(abs(phase.scale), 1e-3) for phase in motion.phases]
    high = max(sum(size * max(1.0, one.cv) for size, one in zip(sizes, k, strict=True)), 1.0)
    fast = max(size / d * one.cv for (_, d, _, _), size, one in zip(phases, sizes, k, strict=True)) + 1.0
    steep = max(size / d**2 * one.ca for (_, d, _, _), size, one in zip(phases, sizes, k, strict=True)) + 1.0
    between = [draw.uniform(0.0, motion.total) for _ in range(4)]
    for x in (*edges, *inner, *between, edges[1] - 1e-6 * motion.total):
        at = motion.at(x)
        for name, value, near in (("POS", at.y, high), ("VEL", at.y1, fast), ("ACC", at.y2, steep)):
            yield Case(name, (x, table), NUM if found.faults else value, 1e-10 * near)


LINE_SPEED = (
    [("PO7", 40.0, 30.0, 0), ("LIN", 40.0, 60.0, 0), ("MSN", 60.0, 25.0, 0), ("CUB", 60.0, -60.0, 0)],
    {3: Rates(0.5)},
)
"""rise to line speed, run in step, and on by way of a velocity that only one of its neighbours can have"""


def handing_over(draw):
    """Random phases beside straight lines, and velocities, accelerations and jerks prescribed between them."""
    phases = random_phases(draw)
    for k in range(0, len(phases), draw.choice((2, 3))):
        phases[k] = ("LIN", draw.uniform(0.1, 90.0), draw.uniform(-100.0, 100.0), 0)
    for k, (code, d, lift, _) in enumerate(phases):
        if code in ("OWN", "DHM") and draw.random() < 0.9:
            phases[k] = (draw.choice(("CUB", "PO5", "PO7", "SCV")), d, lift, 0)
    free = [k for k in range(len(phases) + 1) if not any(
        0 <= i < len(phases) and phases[i][0] in ("LIN", "DWL") for i in (k - 1, k))]  # fmt: skip
    wanted = draw.randint(1, 3)
    through = {k: Rates(*(draw.uniform(-1.0, 1.0) for _ in range(wanted))) for k in free if draw.random() < 0.5}
    return phases, {k: rates for k, rates in through.items() if rates.v}


def exercise():
    """S3, exercise 1: dwell, cycloidal rise to 20°, dwell, modified trapezoidal return, dwell."""
    return [("DWL", 60.0, 0.0, 0), ("CIC", 60.0, 20.0, 0), ("DWL", 60.0, 0.0, 0), ("MTP", 60.0, -20.0, (CLASSIC,)),
            ("DWL", 120.0, 0.0, 0)]  # fmt: skip


def random_phases(draw):
    """Code, duration, lift and parameters of one to six phases, each law as likely as the next."""
    found = []
    for _ in range(draw.randint(1, 6)):
        known = list(parameters(draw))
        wanted = draw.choice(sorted({code for code, _ in known}))
        code, p = draw.choice([one for one in known if one[0] == wanted])
        found.append((code, draw.uniform(0.1, 90.0), 0.0 if code == "DWL" else draw.uniform(-100.0, 100.0), p))
    return found


def row(code, duration, lift, p, draw):
    """A phase in cells; around the pieces of an own law some that last for no time."""
    cells = list(p[0]) if p and code != "OWN" else []  # 0: as delivered
    if code == "OWN":
        for piece in (*p, ()):
            cells += [*draw.choice(((), (), *PASSED_OVER)), *piece]
    return (draw.choice((code, code.lower(), f" {code} ")), duration, lift, *cells)


def wide(table, spare=2):
    """The rows filled up with blanks to equal width, and blank rows after them."""
    width = max(len(row) for row in table)
    return tuple(row + (None,) * (width - len(row)) for row in table) + ((None,) * width,) * spare


def of_sums(draw):
    for count in (1, 2, 5):
        j = [draw.uniform(0.0, 2.0) for _ in range(count)]
        i = [draw.uniform(-9.0, 9.0) for _ in range(count)]
        t = [draw.uniform(0.0, 3.0) for _ in range(count)]
        reduced = math.fsum(Part("", one, speed_ratio=turns).reflected for one, turns in zip(j, i, strict=True))
        rms = math.sqrt(math.fsum(v * v * d for v, d in zip(i, t, strict=True)) / math.fsum(t))
        for row in (lambda v: (tuple(v),), lambda v: tuple((x,) for x in v)):
            yield Case("JRED", (row(j), row(i)), reduced, 1e-12 * (1 + reduced))
            yield Case("RMS", (row(i), row(t)), rms, 1e-12 * (1 + rms))


def value_cases():
    """Every case with a value, or the error of a law that has none, from the engine."""
    draw = random.Random(SEED)
    return [*by_day([*of_laws(draw), *of_phases(draw), *of_sums(draw)])]


def by_day(cases):
    """Yield every eighth case of what there are a thousand of, of a law that has points of its own; by night each."""
    many = {"S", "V", "A", "J", "XI", "CV", "CA", "CARMS", "CJ"}
    for k, case in enumerate(cases):
        if tiers.night or k % 8 == 0 or case.function not in many or case.law == "LIN":
            yield case
