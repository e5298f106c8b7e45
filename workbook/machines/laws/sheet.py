"""The Comparison sheet: curves of up to four laws, and every law with what it costs."""

from typing import NamedTuple

import numpy as np

from engine.laws import Dwell
from engine.laws.inverse import DERIVATIVES, LawJoint, continuity, joint_code, law_joints
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, result
from workbook.book.public_names import names_in, place_names
from workbook.book.rows import LEAST, NOT_ZERO, filled, polynomial
from workbook.law_sheets.library import NamedLaw
from workbook.law_sheets.page import finite
from workbook.laws.sampling import Pieces
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws

CELLS = cell_tables(__file__)

CURVES = range(1, MOST_CURVES + 1)
NAMES = {"s": "Position", "v": "Velocity", "a": "Acceleration", "j": "Jerk"}
VENDORS = "siemens", "twincat", "codesys", "sew"
LEFT, RIGHT, TOP, BELOW = 9, 14, 5, 28  # columns and rows at which the charts begin
COSTS = (
    "C_a,rms²/12: heat in the motor's copper for a pure inertia, against the cubic's, the least possible between two "
    "rests; max |v·a|: the largest power; C_j: what shakes the machine."
)
LOOKED_UP = "cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min"
SPELLED = ",".join(f'"{word}"' for word in DERIVATIVES)
NONE = "–"  # in place of a name
RATES = "v", "a", "j"
ORDERS = {"a": 0, "j": 1}  # of derivatives of the acceleration
SINES = {"a": "+INDEX(piece_P{n},[q])*SIN({x})", "j": "+INDEX(piece_pj{n},[q])*COS({x})"}


class JointRow(NamedTuple):
    """A row of the table of joints: a law, the number of its piece, where that begins, and its row in the stack."""

    law: NamedLaw
    k: int
    at: LawJoint
    row: int  # counted from 1: behind the last piece of a law the dwell's
    first: int  # the row of the law's first piece in the table of joints, counted from 1


class ComparedLaws:
    """The laws of a book, those that are drawn at ``xi``, those compared (all but the dwell), and where pieces meet."""

    def __init__(self, machine: MotionLaws, laws: list[NamedLaw], stack: Pieces) -> None:
        self.entered = [curve.law for curve in machine.comparison.curves]
        self.laws, self.stack, self.sizes = laws, stack, machine.sizes
        chosen = [*self.entered, *(self.entered[0] for _ in range(len(self.entered), MOST_CURVES))]
        known = {law.name: law for law in laws}
        self.curves = [known[name] for name in chosen]
        self.moving = [law for law in laws if not isinstance(law.law, Dwell)]
        self.xi = np.arange(self.sizes.cycle + 1) / self.sizes.cycle
        # the order of each law's continuity at its ends and between them
        self.smooth: list[tuple[int, int]] = []
        # the begin of each piece of each law, and of the rest behind it
        self.joints: list[JointRow] = []
        for law in self.moving:
            pieces = stack.pieces[law.number]
            begun = stack.first[law.number]
            first = len(self.joints) + 1
            joints = law_joints(law.law, pieces)
            self.smooth.append(continuity(joints))
            for k, at in enumerate(joints, 1):
                row = begun + k - 1 if k <= len(pieces) else stack.first[1]
                self.joints.append(JointRow(law, k, at, row, first))

    def least(self, figure: str) -> float:
        """Return the least of a coefficient among the laws whose acceleration does not jump; 0 where there is none."""
        smooth_coefficients = [
            law.law.coefficients for law, orders in zip(self.moving, self.smooth, strict=True) if min(orders) > 1
        ]
        return float(min((getattr(each, figure) for each in smooth_coefficients), default=0.0))


def comparison_sheet(book: Book, view: ComparedLaws) -> None:
    """Declare the sheet: the laws to draw and their curves, the table of all laws, then samples and joints."""
    cell, least = CELLS["curves"], CELLS["least"]
    sheet = book.sheet("Comparison", "Every law of the book side by side: curves, coefficients, and what each costs.")
    sheet.heading("Enter: up to four laws, whose curves are drawn over one another")
    cell.place(
        sheet,
        cell("law", filled(view.entered, MOST_CURVES, None)),
        cell("k", list(range(1, MOST_CURVES + 1))),
        cell("no", [curve.number for curve in view.curves]),
    )
    sheet.heading("Results: the least, of laws whose acceleration does not jump")
    sheet.rows(least("least_loss", view.least("loss")), least("least_va", view.least("va")))
    draw(sheet)
    sheet.heading("The laws, for unit rise and unit time", COSTS)
    costs(sheet, view)
    sheet.not_printed_below()
    sheet.heading("Table of the curves")
    samples(sheet, view)
    sheet.heading("Workings: what jumps where the pieces of a law meet, and against rest at its ends")
    joints_table(sheet, view)
    sheet.widths[FIRST + 1] = 24.0
    sheet.print_columns = 18


def draw(sheet: Sheet) -> None:
    """Place the four charts beside what is entered, and go on below them."""
    for (d, name), column, row in zip(NAMES.items(), (LEFT, RIGHT, LEFT, RIGHT), (TOP, TOP, BELOW, BELOW), strict=True):
        lines = tuple(Series(f"=curve{i}_name", f"[samples{i}.xi]", f"[samples{i}.{d}]") for i in CURVES)
        title = f"{name} {d}(ξ)"
        about = f"{title} of the laws drawn, for unit rise and unit time"
        chart = Chart(title, "ξ = t / t_a", d, lines, about, (0, 1, 0.1))
        sheet.chart(chart, column, row, RIGHT - LEFT, BELOW - TOP)
    sheet.row = BELOW + BELOW - TOP + 1


def costs(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare the table of all laws with their coefficients, costs and continuity."""
    cell, laws = CELLS["costs"], view.moving
    coefficients = [law.law.coefficients for law in laws]
    table = cell.place(
        sheet,
        *cell.of_rows(laws, law="name", family="words"),
        *(cell(name, [finite(getattr(each, name)) for each in coefficients]) for name in LOOKED_UP),
        *cell.of_rows(coefficients, loss="loss", va="va"),
        cell("at_ends", [DERIVATIVES[ends] for ends, _ in view.smooth], derivatives=SPELLED),
        cell("within", [DERIVATIVES[inside] for _, inside in view.smooth], derivatives=SPELLED),
    )
    both = list(zip(coefficients, view.smooth, strict=True))
    sheet.workings(
        table,
        "costs_worked",
        "Workings",
        RIGHT + RIGHT - LEFT + 1,
        *cell.of_rows(laws, no="number"),
        cell("ends", [ends for ends, _ in view.smooth]),
        cell("inside", [inside for _, inside in view.smooth]),
        cell("loss_of", [each.loss if min(orders) > 1 else "∞" for each, orders in both]),
        cell("va_of", [each.va if min(orders) > 1 else "∞" for each, orders in both]),
    )


def names_sheet(book: Book, view: ComparedLaws) -> None:
    """Declare the sheet that says what the laws are called by those who make controllers."""
    cell = CELLS["elsewhere"]
    sheet = book.sheet("Names", "What the laws are called in the libraries of controllers, as far as it is sure.")
    sheet.widths |= dict.fromkeys(range(FIRST + 1, FIRST + 1 + len(VENDORS)), 34.0)
    sheet.heading(
        "Names, with the number there", f"{NONE} where there is none, or none is sure; with parameters as delivered."
    )
    laws = view.moving
    cell.place(
        sheet,
        cell("law", [law.name for law in laws], i=list(range(1, len(laws) + 1))),
        *(cell(vendor, [getattr(law.law.vendors, vendor) or NONE for law in laws]) for vendor in VENDORS),
    )
    sheet.not_printed_below()
    names = names_in(__file__)
    place_names(sheet, names["Results"], "machine")
    for n, law in enumerate(laws, 1):
        place_names(sheet, names["Law"], f"law{n}", law.name, n)


def samples(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare the names and the numbers of the curves, and a table of samples of each."""
    cell, names = CELLS["samples"], filled(view.entered, MOST_CURVES, "")
    sheet.rows(
        *(cell("curve{i}_name", name, i=i) for i, name in zip(CURVES, names, strict=True)),
        *(cell("curve{i}_no", curve.number, i=i) for i, curve in zip(CURVES, view.curves, strict=True)),
    )
    sheet.row += 1
    n, stack = view.sizes.cycle, view.stack
    for i, curve in zip(CURVES, view.curves, strict=True):
        values = dict(zip("svaj", curve.law.evaluate(view.xi), strict=True))
        cell.sharing(i=i).place(
            sheet,
            cell("k", list(range(n + 1))),
            cell("xi", view.xi, i=i),
            *stack.columns(values, "svaj", result),
            *stack.finding(f"curve{i}_no", curve.number, "xi", view.xi),
        )
        sheet.row += 1


def joints_table(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare the table of joints: rates at both ends of each piece, what jumps before it, and what stays smooth."""
    cell, rows, sines = CELLS["joints"], view.joints, 1 + view.stack.second_sine
    cell.place(
        sheet,
        *cell.of_rows(rows, law="law.name", no="law.number", k="k", q="row", d="at.duration"),
        cell("u", [row.at.duration + LEAST for row in rows], not_zero=NOT_ZERO),
        *(cell(name, [row.at.angles[i] for row in rows]) for i, name in enumerate(("x", "x2")[:sines])),
        *(rate(view, i, at_end) for at_end in (False, True) for i, _ in enumerate(RATES)),
        *cell.of_rows(rows, p="at.before"),
        *(
            cell(f"d{name}", [row.at.jump[i] for row in rows], scale=max(abs(row.at.begin[i]) for row in rows))
            for i, name in enumerate(RATES)
        ),
        *cell.of_rows(rows, ca="law.law.coefficients.ca", order="at.order"),
        cell("outer", [int(row.at.outer) for row in rows]),
        cell("code", [joint_code(row.law.number, row.at) for row in rows]),
        *cell.of_rows(rows, first="first"),
    )


def rate(view: ComparedLaws, i: int, at_end: bool) -> Quantity:
    """Return the column of v, a or j at the begin of each piece, or at its end."""
    name, rows = RATES[i], view.joints
    values = [(row.at.end if at_end else row.at.begin)[i] for row in rows]
    formula, size = at_place(name, at_end, view.stack), max(map(abs, values))
    return CELLS["rates"](f"{name}{int(at_end)}", values, formula=formula, scale=size)


def at_place(name: str, at_end: bool, stack: Pieces) -> str:
    """Return the formula of v, a or j at the begin of a piece, or at its end."""
    if name == "v":
        return "=INDEX(piece_v,[q])" + ("+INDEX(piece_dv,[q])" if at_end else "")
    order = ORDERS[name]
    text = f"INDEX(piece_c{order},[q])"
    if at_end:
        text = polynomial(f"INDEX(piece_{'d' * order}ddy,[q],0)", "[u]", stack.room, order)
    for n in ("", "2") if stack.second_sine else ("",):
        text += SINES[name].format(n=n, x=f"[x{n}]" if at_end else f"INDEX(piece_phi{n},[q])")
    return f"={text}"
