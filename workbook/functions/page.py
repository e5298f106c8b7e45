"""The page that shows each function in use: what is entered there, to be changed, and what the engine says of it."""

import math
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field

from engine.drive import Part
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.inverse import inverse
from engine.motion import Motion, Phase
from engine.motion.joining import join_phases
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text, given
from workbook.book.rows import filled
from workbook.fields.paths import get, split
from workbook.fields.types import Model, NotNegative, Number, Share
from workbook.functions.declarations import CODES, FUNCTIONS, TAKES, TEXTS, Argument
from workbook.laws.entries import Laws, as_listed
from workbook.laws.registry import CODES as BASIC
from workbook.laws.registry import FAMILY

CELLS = cell_tables(__file__)
LAW_STEPS, MOTION_STEPS = 100, 120
EMPTY_PIECES, EMPTY_PHASES = 2, 2
WIDTH = 8  # parameters of a phase's law, at most: an own law of a piece
VIA = "VIA"
if TYPE_CHECKING:
    LawCode = str
    RowCode = str
else:
    LawCode = Annotated[Literal[CODES], BeforeValidator(as_listed)]  # a law that the functions know
    # or what prescribes a velocity
    RowCode = Annotated[Literal[(*CODES, VIA)], BeforeValidator(as_listed)]
RANGES = {
    code: f"[{code}.{names[0]}]:[{code}.{names[-1]}]"
    for code, page in FAMILY.items()  # of laws' parameters
    if code in TAKES and (names := [parameter.column for parameter in page.parameters])
}
RANGES["OWN"] = "[OWN.duration.first]:[OWN.phase.last]"
CHOSEN = "".join(f'IF([fn_law.fn_law]="{code}",{cells},' for code, cells in RANGES.items())
P = f"{CHOSEN}0{''.join(')' for _ in RANGES)}"
EXAMPLES = {name: row.get("example", P) for name, row in TEXTS["arguments"].items()}
PIECE = {"duration": "duration", **{f"c{i}": f"c{i}" for i in range(4)}, "amplitude": "P", "omega": "ω", "phase": "φ"}
DERIVATIVES = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}
QUIET = "ISERROR([fn_probe.fn_probe])"  # where the functions do not compute, examples show nothing in place of errors


class ShownPhase(Model):
    """A row of the table of phases."""

    law: RowCode
    duration: Number
    lift: Number = 0.0
    p: Annotated[list[Number], Field(max_length=WIDTH)] = Field(default_factory=list)


class Shaft(Model):
    """A shaft with its inertia, and its speed over that of the reference shaft."""

    inertia: NotNegative
    ratio: Number


class Interval(Model):
    """An interval of a profile: its value and how long it lasts."""

    value: Number
    duration: NotNegative


class PageInputs(Model):
    """Every input of the page."""

    law: LawCode = "MTP"
    xi: Share = 0.3
    s: Share = 0.3
    x: NotNegative = 120.0
    laws: Laws = Laws({code: {"family": code} for code in CODES if code not in BASIC})
    phases: list[ShownPhase]
    shafts: list[Shaft]
    profile: list[Interval]

    @cached_property
    def chosen_law(self) -> Law:
        """The law that is chosen, of the numbers that it takes."""
        page = FAMILY[self.law]
        return page.law_of(page.numbers(self.laws[self.law]))

    @cached_property
    def motion(self) -> Motion:
        """The phases, joined: they take over velocities from straight lines."""
        phases = [Phase(FAMILY[row.law].law_of(row.p), row.lift, row.duration) for row in self.phases]
        return join_phases(phases, periodic=False).motion


EXAMPLE = PageInputs.model_validate(TEXTS["example"])


def declare(shown: PageInputs) -> Book:
    """Declare the book."""
    book = Book("motion-functions", "Motion laws as functions")
    sheet = book.sheet("Functions", 'Motion laws as functions of your own sheets, as in  =MOTION.S("CIC", B7, 0)')
    sheet.texts.append(Text(1, FIRST, book.title, "title"))
    sheet.texts.append(Text(2, FIRST, sheet.purpose, "note"))
    introduction(sheet, shown)
    functions(sheet, shown)
    sheet.chart_row(*(curve(*words, "law") for words in LAW_CURVES), width=4, height=13)
    parameters(sheet, shown)
    motion(sheet, shown)
    sums(sheet, shown)
    samples(sheet, shown)
    sheet.print_columns = 17
    return book


def introduction(sheet: Sheet, shown: PageInputs) -> None:
    """Say how the functions come into another workbook, and whether they compute here; declare what examples take."""
    sheet.heading("In your own workbook")
    for line in (
        "1  Excel 365, 2024 or Excel for the web: open your workbook beside this one.",
        "2  Right-click this tab > Move or Copy > To book: your workbook, Create a copy; the functions come along.",
        "3  Type  =MOTION.  into any cell; the copied sheet may be deleted again.",
        "LibreOffice: install motion.oxt (Tools > Extension Manager), which computes the same file by the same names.",
    ):
        sheet.note(line)
    cell = CELLS["introduction"]
    sheet.rows(cell("fn_works", "yes"), cell("fn_probe", 0.5))
    sheet.heading("Enter for the examples")
    sheet.rows(*(cell(f"fn_{name}", getattr(shown, name)) for name in ("law", "xi", "s", "x")))


def entries(name: str, words: str, values: Iterable[Any], key: str, symbol: str = "", rows: int = 0) -> Quantity:
    """Return a column of entries, of so many rows."""
    column = filled(values, rows, None) if rows else list(values)
    return CELLS["entries"]("{name}", column, name=name, words=words, key=key, symbol=symbol)


def parameters(sheet: Sheet, shown: PageInputs) -> None:
    """Declare the parameters of the laws that take any."""
    laws, pieces = shown.laws, shown.laws["OWN"].pieces
    sheet.heading("Parameters of the laws", "The other laws take none: 0 stands in their place.")
    sheet.note("Where a motion turns round: start, end or, of MTS, none; in a table of phases -1, 1 or 0 too.")
    for code, page in FAMILY.items():
        if code not in TAKES or not page.parameters:
            continue
        entered = laws[code]
        columns = [
            entries(p.column, p.short, [get(entered, split(p.key))], f"laws.{code}.{p.key}")._replace(format="0.0000")
            for p in page.parameters
        ]
        sheet.table(code, f"{code}: {TAKES[code].en}", 1, *columns)
    rows = len(pieces) + EMPTY_PIECES
    columns = [
        entries(name, words, [getattr(piece, name) for piece in pieces], f"laws.OWN.pieces.*.{name}", rows=rows)
        for name, words in PIECE.items()
    ]
    sheet.table("OWN", "OWN: a row a piece of a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ)", rows, *columns)


def functions(sheet: Sheet, shown: PageInputs) -> None:
    """Declare a row a function: how it is called, its result for the entries, what it gives."""
    calls = [f"{f.name}({', '.join(a.shown for a in f.arguments)})" for f in FUNCTIONS]
    formulas = [f"={f.name}({','.join(EXAMPLES[a.name.en] for a in f.arguments)})" for f in FUNCTIONS]
    cell = CELLS["functions"]
    sheet.heading("The functions, each computed for these entries")
    gives = cell("gives", results(shown), formula=formulas)
    cell.place(sheet, cell("call", calls), gives, *cell.of_rows(FUNCTIONS, about="help.en")).quiet = QUIET


def results(shown: PageInputs) -> list[Any]:
    """Return the engine's value of each function for the entries, #NUM! where there is none."""
    chosen, motion = shown.chosen_law, shown.motion.at(shown.x)
    law, k = chosen.evaluate(shown.xi), chosen.coefficients
    xi = "#NUM!" if shown.law == "DWL" else inverse(chosen, shown.s)
    jerk = k.cj if math.isfinite(k.cj) else "#NUM!"
    reduced = math.fsum(Part("", shaft.inertia, speed_ratio=shaft.ratio).reflected for shaft in shown.shafts)
    value, duration = np.array([(place.value, place.duration) for place in shown.profile]).T
    rms = float(np.sqrt(value**2 @ duration / duration.sum()))
    return [*law, xi, k.cv, k.ca, k.ca_rms, jerk, *motion[:3], reduced, rms]


LAW_CURVES = [(word.capitalize(), "xi", name, "ξ", name) for name, word in DERIVATIVES.items()]
RATES = (("y", "position", "y", "POS"), ("y1", "velocity", "y'", "VEL"), ("y2", "acceleration", "y''", "ACC"))
MOTION_CURVES = [(f"{word.capitalize()} of the motion", "x", name, "x", symbol) for name, word, symbol, _ in RATES]


def curve(title: str, x: str, y: str, x_axis: str, y_axis: str, table: str) -> Chart:
    """Return the chart of a column of a sampled table."""
    line = Series(title, f"[{table}.{x}]", f"[{table}.{y}]")
    span = (0.0, 1.0, 0.2) if table == "law" else None
    return Chart(title, x_axis, y_axis, (line,), f"{title} over {x_axis}, sampled in the table below", span)


def motion(sheet: Sheet, shown: PageInputs) -> None:
    """Declare the table of phases, and the charts of the motion."""
    phases, rows = shown.phases, len(shown.phases) + EMPTY_PHASES
    p = [filled(phase.p, WIDTH, None) for phase in phases]
    sheet.heading("A motion of phases", "Empty rows at the end are left out; a law without parameters is as delivered.")
    sheet.note("A curved phase takes the velocity of a straight line LIN beside it. A row VIA, velocity, acceleration")
    sheet.note("prescribes these between two curved phases, or where the motion begins or ends.")
    sheet.note("OWN takes its pieces side by side, each as in its table above; a wider table has room for more.")
    sheet.table(
        "phases",
        "Phases",
        rows,
        given("law", "law", "", "", filled([p.law for p in phases], rows, None), "phases.*.law", align="center"),
        *(
            entries(name, name, [getattr(p, name) for p in phases], f"phases.*.{name}", rows=rows)
            for name in ("duration", "lift")
        ),
        *(
            entries(f"p{i}", f"parameter {i}", values, "phases.*.p.*", rows=rows)
            for i, values in enumerate(zip(*p, strict=True), 1)
        ),
    )
    sheet.chart_row(*(curve(*words, "motion") for words in MOTION_CURVES), width=5, height=13)


def sums(sheet: Sheet, shown: PageInputs) -> None:
    """Declare the shafts and the profile."""
    sheet.heading("Shafts that turn together, and a profile constant in each interval")
    tables = (
        ("shafts", shown.shafts, (("inertia", "inertia", "J", "inertia"), ("ratio", "speed ratio", "ω_i/ω", "ratio"))),
        ("profile", shown.profile, (("value", "value", "", "value"), ("span", "duration", "t", "duration"))),
    )
    for table, rows, columns in tables:
        each = [
            entries(name, words, [getattr(row, key) for row in rows], f"{table}.*.{key}", symbol)
            for name, words, symbol, key in columns
        ]
        sheet.table(table, table.capitalize(), len(rows), *each)


def samples(sheet: Sheet, shown: PageInputs) -> None:
    """Declare what each argument takes, then the sampled law and the sampled motion."""
    arguments: dict[str, Argument] = {a.name.en: a for f in FUNCTIONS for a in f.arguments}
    sheet.heading("The arguments")
    cell = CELLS["arguments"]
    cell.place(sheet, cell("argument", list(arguments)), *cell.of_rows(arguments.values(), takes="help.en"))
    sheet.heading("The sampled law and the sampled motion")
    xi = np.arange(LAW_STEPS + 1) / LAW_STEPS
    x = np.arange(MOTION_STEPS + 1) * shown.motion.total / MOTION_STEPS
    law = [(name, words, name, name.upper()) for name, words in DERIVATIVES.items()]
    declare_samples(
        sheet, "law", "xi", xi, f"[fn_law.fn_law],[xi],{P}", zip(law, shown.chosen_law.evaluate(xi), strict=True)
    )
    declare_samples(
        sheet, "motion", "x", x, f"[x],{EXAMPLES['phases']}", zip(RATES, shown.motion.at(x)[:3], strict=True)
    )


def declare_samples(
    sheet: Sheet, name: str, abscissa: str, x: Array, arguments: str, columns: Iterable[tuple[Sequence[str], Array]]
) -> None:
    """Declare a sampled table over an abscissa: of each column its name, words, symbol and function, and its values."""
    cell = CELLS["samples"].sharing(table=name, arguments=arguments)
    called = [
        cell("{name}", values, name=key, words=words, symbol=symbol, function=function)
        for (key, words, symbol, function), values in columns
    ]
    cell.place(sheet, cell(abscissa, x), *called, cell("k", list(range(len(x))))).quiet = QUIET
