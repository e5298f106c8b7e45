"""The page that shows each function in use: what is entered there, to be changed, and what the engine says of it."""

import math
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field

from engine.drive import Part
from engine.laws import Law
from engine.laws.inverse import inverse
from engine.motion import Motion, Phase
from engine.motion.joining import join_phases
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text, calc, constant, given, result
from workbook.book.rows import filled
from workbook.fields.paths import get, split
from workbook.fields.types import Model, NotNegative, Number, Share
from workbook.functions.declarations import CODES, FUNCTIONS, TAKES, TEXTS, Argument
from workbook.laws.entries import Laws, as_listed
from workbook.laws.registry import CODES as BASIC
from workbook.laws.registry import FAMILY

LAW_STEPS, MOTION_STEPS = 100, 120
EMPTY_PIECES, EMPTY_PHASES = 2, 2
WIDTH = 8  # parameters of a phase's law, at most: an own law of a piece
VIA = "VIA"
if TYPE_CHECKING:
    LawCode = str
    RowCode = str
else:
    LawCode = Annotated[Literal[CODES], BeforeValidator(as_listed)]  # a law that the functions know
    RowCode = Annotated[Literal[(*CODES, VIA)], BeforeValidator(as_listed)]  # or what prescribes a velocity
LAW, XI, S, X = "[fn_law.fn_law]", "[fn_xi.fn_xi]", "[fn_s.fn_s]", "[fn_x.fn_x]"
RANGES = {
    code: f"[{code}.{names[0]}]:[{code}.{names[-1]}]"
    for code, page in FAMILY.items()  # of laws' parameters
    if code in TAKES and (names := [parameter.column for parameter in page.parameters])
}
RANGES["OWN"] = "[OWN.duration.first]:[OWN.phase.last]"
CHOSEN = "".join(f'IF({LAW}="{code}",{cells},' for code, cells in RANGES.items())
P = f"{CHOSEN}0{''.join(')' for _ in RANGES)}"
PHASES = f"[phases.law.first]:[phases.p{WIDTH}.last]"
ARGUMENTS = {
    "law": LAW, "xi": XI, "s": S, "x": X, "parameters": P, "phases": PHASES, "inertias": "[shafts.inertia]",
    "ratios": "[shafts.ratio]", "values": "[profile.value]", "durations": "[profile.span]", "shift": "0", "cycle": "0",
}  # fmt: skip
PIECE = {"duration": "duration", **{f"c{i}": f"c{i}" for i in range(4)}, "amplitude": "P", "omega": "ω", "phase": "φ"}
DERIVATIVES = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}
PROBE = '=MOTION.S("CUB",0.5,0)'
QUIET = "ISERROR([fn_probe.fn_probe])"  # where the functions do not compute, examples show nothing in place of errors
WORKS = '=IF(ISERROR([fn_probe.fn_probe]),"no: they need Excel 365 or 2024, or LibreOffice with motion.oxt","yes")'


class ShownPhase(Model):
    """A row of the table of phases."""

    law: RowCode
    duration: Number
    lift: Number = 0.0
    p: Annotated[list[Number], Field(max_length=WIDTH)] = Field(default_factory=list)

    @property
    def to_engine_phase(self) -> Phase:
        """The engine's phase."""
        return Phase(FAMILY[self.law].law_of(self.p), self.lift, self.duration)


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
        return join_phases([phase.to_engine_phase for phase in self.phases], periodic=False).motion


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
    sheet.rows(
        result("fn_works", "Do the functions compute here?", "", "", WORKS, "yes", align="center"),
        result("fn_probe", "One of them: the middle of a cubic", "", "", PROBE, 0.5, source="0.5"),
    )
    sheet.heading("Enter for the examples")
    sheet.rows(
        given("fn_law", "Law", "", "", shown.law, "law", align="center", source="its parameters stand below"),
        given("fn_xi", "Share of the rise time", "ξ", "", shown.xi, "xi", source="0 to 1"),
        given("fn_s", "Share of the rise", "s", "", shown.s, "s", source="0 to 1"),
        given("fn_x", "Abscissa of the motion", "x", "", shown.x, "x", source="0 to the sum of its durations"),
    )


def parameters(sheet: Sheet, shown: PageInputs) -> None:
    """Declare the parameters of the laws that take any."""
    laws, pieces = shown.laws, shown.laws["OWN"].pieces
    sheet.heading("Parameters of the laws", "The other laws take none: 0 stands in their place.")
    sheet.note("Where a motion turns round: start, end or, of MTS, none; in a table of phases -1, 1 or 0 too.")
    for code, page in FAMILY.items():
        if code not in TAKES or not page.parameters:
            continue
        entered = laws[code]
        sheet.table(code, f"{code}: {TAKES[code].en}", 1, *(
            given(parameter.column, parameter.short, "", "",
                  [get(entered, split(parameter.key))], f"laws.{code}.{parameter.key}", format="0.0000")
            for parameter in page.parameters
        ))  # fmt: skip
    rows = len(pieces) + EMPTY_PIECES
    sheet.table("OWN", "OWN: a row a piece of a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ)", rows, *(
        given(name, words, "", "",
              filled([getattr(piece, name) for piece in pieces], rows, None), f"laws.OWN.pieces.*.{name}",
              format="General")
        for name, words in PIECE.items()
    ))  # fmt: skip


def functions(sheet: Sheet, shown: PageInputs) -> None:
    """Declare a row a function: how it is called, its result for the entries, what it gives."""
    calls = [f"{f.name}({', '.join(a.shown for a in f.arguments)})" for f in FUNCTIONS]
    formulas = [f"={f.name}({','.join(ARGUMENTS[a.name.en] for a in f.arguments)})" for f in FUNCTIONS]
    sheet.heading("The functions, each computed for these entries")
    sheet.table(
        "functions",
        "In Excel, a range of ξ, s or x gives as many results",
        len(FUNCTIONS),
        constant("call", "function", "", "", calls, align="left"),
        result("gives", "result", "", "", formulas, results(shown), format="0.000000"),
        constant("about", "what it gives", "", "", [f.help.en for f in FUNCTIONS], align="left"),
    ).quiet = QUIET


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

    def entry(name: str, words: str, values: Iterable[Any], key: str) -> Quantity:
        return given(name, words, "", "", filled(values, rows, None), f"phases.*.{key}", format="General")

    sheet.heading("A motion of phases", "Empty rows at the end are left out; a law without parameters is as delivered.")
    sheet.note("A curved phase takes the velocity of a straight line LIN beside it. A row VIA, velocity, acceleration")
    sheet.note("prescribes these between two curved phases, or where the motion begins or ends.")
    sheet.note("OWN takes its pieces side by side, each as in its table above; a wider table has room for more.")
    sheet.table(
        "phases",
        "Phases",
        rows,
        given("law", "law", "", "", filled([p.law for p in phases], rows, None), "phases.*.law", align="center"),
        *(entry(name, name, [getattr(p, name) for p in phases], name) for name in ("duration", "lift")),
        *(entry(f"p{i}", f"parameter {i}", values, "p.*") for i, values in enumerate(zip(*p, strict=True), 1)),
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
        sheet.table(
            table,
            table.capitalize(),
            len(rows),
            *(
                given(
                    name, words, symbol, "", [getattr(row, key) for row in rows], f"{table}.*.{key}", format="General"
                )
                for name, words, symbol, key in columns
            ),
        )


def samples(sheet: Sheet, shown: PageInputs) -> None:
    """Declare what each argument takes, then the sampled law and the sampled motion."""
    arguments: dict[str, Argument] = {a.name.en: a for f in FUNCTIONS for a in f.arguments}
    sheet.heading("The arguments")
    sheet.table(
        "arguments",
        "Bad arguments give the error values of built-in functions: #VALUE!, #NUM!",
        len(arguments),
        constant("argument", "argument", "", "", list(arguments), align="left"),
        constant("takes", "what it takes", "", "", [a.help.en for a in arguments.values()], align="left"),
    )
    sheet.heading("The sampled law and the sampled motion")
    xi, x = np.arange(LAW_STEPS + 1) / LAW_STEPS, np.arange(MOTION_STEPS + 1) * shown.motion.total / MOTION_STEPS
    sheet.table(
        "law",
        "The law",
        LAW_STEPS + 1,
        calc("xi", "share of time", "ξ", "", "=[k]/[law.k.last]", xi),
        *(
            result(name, words, name, "", f"=MOTION.{name.upper()}({LAW},[xi],{P})", values)
            for (name, words), values in zip(DERIVATIVES.items(), shown.chosen_law.evaluate(xi), strict=True)
        ),
        constant("k", "sample", "k", "", list(range(LAW_STEPS + 1))),
    ).quiet = QUIET
    sheet.table(
        "motion",
        "The motion",
        MOTION_STEPS + 1,
        calc("x", "abscissa", "x", "", "=[k]*SUM([phases.duration])/[motion.k.last]", x),
        *(
            result(name, words, symbol, "", f"=MOTION.{key}([x],{PHASES})", values)
            for (name, words, symbol, key), values in zip(RATES, shown.motion.at(x)[:3], strict=True)
        ),
        constant("k", "sample", "k", "", list(range(MOTION_STEPS + 1))),
    ).quiet = QUIET
