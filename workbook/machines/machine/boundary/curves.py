"""The curves that carry the law of each step out between its ends, in cells, by VDI 2143; the kinds of these ends."""

from collections.abc import Callable
from math import fsum, perm

from engine.laws.ends import BoundaryValues
from engine.motion.handover import Handover
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.machines.machine.boundary.handover import AxisHandover

CELLS = cell_tables(__file__)

HERMITE = {
    2: {5: "[f0]/2", 7: "[f0]/2", 3: "3*[h]-2*[e1]-[f1]"},
    3: {3: "[e1]+[f1]-2*[h]", 5: "10*[h]-6*[e1]-4*[f1]+([g1]-3*[f0])/2"},
    4: {5: "8*[e1]+7*[f1]-15*[h]+(3*[f0]-2*[g1])/2", 7: "35*[w]-15*[x]+5*[z]/2"},
    5: {5: "6*[h]-3*([e1]+[f1])+([g1]-[f0])/2", 7: "39*[x]-84*[w]-7*[z]"},
    6: {7: "70*[w]-34*[x]+13*[z]/2"},
    7: {7: "10*[x]-20*[w]-2*[z]"},
}
"""e_n by the degree, from stroke, v δ and a δ² at both ends; w, x and z are what the begin leaves to be done"""
SEPTIC = 7
LEFT: dict[str, Callable[[BoundaryValues], float]] = {
    "w": lambda at: at.stroke - at.v0 - at.a0 / 2.0,
    "x": lambda at: at.v1 - at.v0 - at.a0,
    "z": lambda at: at.a1 - at.a0,
}
"""of a polynomial of degree 7: what its ends ask for that its first terms do not give"""
WORDS = "begin", "end"


def curves_between_ends(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of the halves of a law of two pulses, and of a polynomial Σ e_n ξⁿ, between their ends."""
    column = handover.columns(CELLS["curves_between_ends"])
    row, *phase = handover.steps()
    early = handover.of(lambda step: step.early, 0)
    return [
        row,
        column("mode", lambda step: step.mode),
        *phase,
        column("d0", lambda step: step.drifts[0], order=1),
        column("d1", lambda step: step.drifts[1], order=1),
        column("split", [first + more for first, more in zip(handover.rows.firsts, early, strict=True)]),
        column("gain", lambda step: step.halves[0] - step.halves[1], order=0),
        column("h1", lambda step: step.halves[1], order=0),
        column("h0", lambda step: step.halves[0], order=0),
        *polynomials(handover),
    ]


def polynomials(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of polynomials: what their ends ask for, coefficients, and the acceleration at both ends."""
    column, powers = handover.columns(CELLS["polynomials"]), handover.rows.powers
    acceleration = "+".join(f"{perm(n, 2)}*[e{n}]" for n in range(2, powers))

    def left(name: str) -> Quantity:
        return column(name, lambda step: LEFT[name](step.hermite) if step.mode == SEPTIC else 0.0, order=0)

    def power(n: int) -> Quantity:
        return column("e{n}", lambda step: step.powers[n], order=0, n=n, hermite=hermite(n, powers))

    def last_acceleration(step: Handover) -> float:
        return fsum(perm(n, 2) * e for n, e in enumerate(step.powers))

    return [
        column("e1", lambda step: step.powers[1], order=0),
        column("f1", lambda step: step.hermite.v1, order=0),
        column("f0", lambda step: step.hermite.a0, order=0),
        column("g1", lambda step: step.hermite.a1, order=0),
        *(left(name) for name in LEFT if powers > SEPTIC),
        *(power(n) for n in range(2, powers)),
        column("b0", lambda step: 2.0 * step.powers[2], order=0),
        column("b1", last_acceleration, order=0, sum_of_powers=acceleration),
    ]


def hermite(n: int, powers: int) -> str:
    """Return the formula of a coefficient, without its =, by the degree of the polynomial."""
    text = "0"
    for degree, formula in HERMITE[n].items():
        if degree < powers:
            text = f"IF([mode]={degree},{formula},{text})"
    return text


def end_kinds(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of rates at both ends, and of their kinds: of what is settled there, else of the law's."""
    column = handover.columns(CELLS["end_kinds"])
    both = list(enumerate(WORDS))

    kinds = [handover.spread([step.kinds[i] for step in handover.handed], "") for i, _ in both]

    def rates(name: str, order: int) -> list[Quantity]:
        values = [[(at.begin, at.end)[i][order] for at in handover.motion.ends] for i, _ in both]
        return [column(name, handover.spread(values[i]), order=order, i=i, end=end) for i, end in both]

    def peaks(figure: Callable[[Handover], float]) -> list[float]:
        return [value or 1.0 for value in handover.of(figure)]

    def has(name: str, kinds: str, i: int) -> Quantity:
        return column(name, lambda step: int(step.kinds[i] in kinds), i=i, end=WORDS[i])

    return [
        handover.steps()[0],
        column("peak1", peaks(lambda step: step.phase.y1_max), order=1),
        column("peak2", peaks(lambda step: step.phase.y2_max), order=2),
        *rates("v{i}", 1),
        *rates("a{i}", 2),
        *(has(name, kinds, i) for i, _ in both for name, kinds in (("moves{i}", "GB"), ("bends{i}", "UB"))),
        *(column("{end}s", kinds[i], i=i, end=end) for i, end in both),
    ]


BENT_FROM = 5  # degree from which on the acceleration of a polynomial may bend


def bends_name(handover: AxisHandover) -> str:
    """Return the name of the table of an axis."""
    return f"{handover.entries}_bends"


def bend_angles(handover: AxisHandover) -> list[float]:
    """Return where the acceleration of each phase bends first, and then where second (°); 360 for none."""
    rows = [step for _, step in handover.phases]
    begins = [phase.start for phase in handover.axis.given.phases]
    spans = [phase.stop - phase.start for phase in handover.axis.given.phases]
    bends = []
    for i in (0, 1):
        shares = [step.bends[i] for step in rows]
        angles = [
            begin + span * share if 0.0 < share < 1.0 else TURN
            for begin, span, share in zip(begins, spans, shares, strict=True)
        ]
        bends += filled(angles, handover.room // 2, TURN)
    return bends


def bends_table(sheet: Sheet, handover: AxisHandover) -> None:
    """Declare where the acceleration of each phase's polynomial is largest or lowest; a drive is cut there.

    The jerk of a polynomial of degree 5, and of degree 7 over ξ (1 − ξ), is A + B ξ + C ξ²: it is 0 at W/C and at A/W,
    W = −(B ± √(B² − 4 A C))/2.
    """
    column = handover.columns(CELLS["bends_table"])
    room = handover.room // 2
    at = handover.rows.at
    phases = [step for _, step in handover.phases]
    size, angles = handover.motion.size(0), bend_angles(handover)

    def e(n: int) -> str:
        return f"INDEX([{at.ends}.e{n}],2*[k])" if n < handover.rows.powers else "0"

    def of(figure: Callable[[Handover], float]) -> list[float]:
        return filled([figure(step) for step in phases], room)

    def power(name: str, quintic: str, septic: str) -> Quantity:
        values = of(lambda step: step.jerk_powers["abc".index(name)])
        return column(name, values, y=at.y, quintic=quintic, septic=septic, scale=100.0 * size)

    CELLS["bends_table"].sharing(i=handover.axis.number).place(
        sheet,
        column("k", list(range(1, room + 1))),
        column("mode", filled([step.mode for step in phases], room, 0)),
        power("a", f"6*{e(3)}", f"24*{e(4)}"),
        power("b", f"24*{e(4)}", f"60*{e(5)}+24*{e(4)}"),
        power("c", f"60*{e(5)}", f"0-210*{e(7)}"),
        column("w", of(lambda step: step.jerk_root), y=at.y, scale=100.0 * size),
        column("x0", of(lambda step: step.bends[0]), scale=1.0),
        column("x1", of(lambda step: step.bends[1]), scale=1.0),
        column("at0", angles[:room], scale=TURN),
        column("at1", angles[room:], scale=TURN),
        blank=f"[mode]<{BENT_FROM}",
    )
