"""The Comparison sheet: curves of up to four laws, and every law with what it costs."""

from engine.laws.inverse import DERIVATIVES, joint_code
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, calc, constant, given, result
from workbook.book.rows import LEAST, NOT_ZERO, filled, polynomial
from workbook.law_sheets.page import finite
from workbook.laws.sampling import Pieces
from workbook.machines.laws.entries import MOST_CURVES
from workbook.machines.laws.view import ComparedLaws

CURVES = range(1, MOST_CURVES + 1)
NAMES = {"s": "Position", "v": "Velocity", "a": "Acceleration", "j": "Jerk"}
VENDORS = {"siemens": "Siemens LCamHdl", "twincat": "TwinCAT", "codesys": "CODESYS", "sew": "SEW MOVI-C"}
LEFT, RIGHT, TOP, BELOW = 9, 14, 5, 28  # columns and rows at which the charts begin
COSTS = (
    "C_a,rms²/12: heat in the motor's copper for a pure inertia, against the cubic's, the least possible between two "
    "rests; max |v·a|: the largest power; C_j: what shakes the machine."
)
NONE = "–"  # in place of a name
SPELLED = ",".join(f'"{word}"' for word in DERIVATIVES)
RATES = {"v": "velocity", "a": "acceleration", "j": "jerk"}
ORDER = (
    "=IF(COUNTIF([joints.code],8*[no]+{0})>0,0,IF(COUNTIF([joints.code],8*[no]+{0}+1)>0,1,"
    "IF(COUNTIF([joints.code],8*[no]+{0}+2)>0,2,3)))"
)  # the least order of a law's joints: between its pieces, or, of codes that are 4 more, at its ends
PIECE = "=IF([k]>COUNTIF(piece_number,[no]),MATCH(1,piece_number,0),MATCH([no],piece_number,0)+[k]-1)"
"""behind the last piece the dwell's, law 1"""
ORDERS = {"a": 0, "j": 1}  # of derivatives of the acceleration
SINES = {"a": "+INDEX(piece_P{n},[q])*SIN({x})", "j": "+INDEX(piece_pj{n},[q])*COS({x})"}
ORDERED = (
    "=IF(ABS([dv])>check_zero*INDEX(law_cv,[no]),0,IF(ABS([da])>check_zero*[ca],1,IF(ABS([dj])>check_zero*[ca],2,3)))"
)


def comparison_sheet(book: Book, view: ComparedLaws) -> None:
    """Declare the sheet: the laws to draw and their curves, the table of all laws, then samples and joints."""
    sheet = book.sheet("Comparison", "Every law of the book side by side: curves, coefficients, and what each costs.")
    sheet.heading("Enter: up to four laws, whose curves are drawn over one another")
    sheet.table(
        "curves", "One law each row; leave spare rows empty", MOST_CURVES,
        given("law", "law", "", "",
              filled(view.entered, MOST_CURVES, None), "comparison.curves.*.law", choices="=law_code"),
        constant("k", "curve", "k", "", list(range(1, MOST_CURVES + 1))),
        calc("no", "number", "", "", '=MATCH(IF([law]="",[curves.law.first],[law]),law_code,0)',
             [one.number for one in view.curves], "of a spare row that of the first", format="0"),
    )  # fmt: skip
    sheet.heading("Results: the least, of laws whose acceleration does not jump")
    sheet.rows(
        *(result(f"least_{name}", f"Least {words}", "", "",
                 f"=MIN([costs_worked.{name}_of])", view.least(name), source, format="0.0000")
          for name, words, source in (("loss", "copper loss", "C_a,rms² / 12"), ("va", "largest power", "max |v·a|"))),
    )  # fmt: skip
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
        sheet.chart(Chart(title, "ξ = t / t_a", d, lines, about, (0, 1, 0.1)), column, row, RIGHT - LEFT, BELOW - TOP)
    sheet.row = BELOW + BELOW - TOP + 1


def costs(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare the table of all laws with their coefficients, costs and continuity."""
    laws, found = view.moving, [one.law.coefficients for one in view.moving]

    def of(name: str, label: str, symbol: str, source: str = "") -> Quantity:
        values = [finite(getattr(each, name)) for each in found]
        return result(name, label, symbol, "", f"=INDEX(law_{name},[no])", values, source, format="0.0000")

    table = sheet.table(
        "costs", "Laws, in the order of the sheet Laws", len(laws),
        calc("law", "law", "", "", "=INDEX(law_code,[no])", [one.name for one in laws]),
        calc("family", "family", "", "", "=INDEX(law_name,[no])", [one.words for one in laws], align="left"),
        of("cv", "velocity", "C_v"),
        of("ca_max", "acceleration", "C_a+"),
        of("ca_min", "deceleration", "C_a−"),
        of("ca_rms", "RMS acceleration", "C_a,rms"),
        of("cj", "jerk", "C_j"),
        of("va_max", "largest v·a", "max(v·a)"),
        of("va_min", "lowest v·a", "min(v·a)"),
        result("loss", "copper loss", "", "",
               "=[ca_rms]^2/12", [each.loss for each in found], "C_a,rms² / 12", format="0.0000"),
        result("va", "largest power", "max |v·a|", "",
               "=MAX([va_max],-[va_min])", [each.va for each in found], format="0.0000"),
        result("at_ends", "continuous at its ends", "", "",
               f"=CHOOSE([ends]+1,{SPELLED})", [DERIVATIVES[ends] for ends, _ in view.smooth], "against rest"),
        result("within", "and between them", "", "",
               f"=CHOOSE([inside]+1,{SPELLED})", [DERIVATIVES[inside] for _, inside in view.smooth]),
    )  # fmt: skip
    sheet.workings(
        table, "costs_worked", "Workings", RIGHT + RIGHT - LEFT + 1,
        constant("no", "number", "", "", [one.number for one in laws], format="0"),
        calc("ends", "order at its ends", "", "", ORDER.format(4), [ends for ends, _ in view.smooth],
             "highest continuous derivative", format="0"),
        calc("inside", "order between them", "", "", ORDER.format(0), [inside for _, inside in view.smooth],
             format="0"),
        *(calc(f"{name}_of", f"{words}, if it does not jump", "", "", f'=IF(MIN([ends],[inside])>1,[{name}],"∞")',
               [getattr(one, name) if min(orders) > 1 else "∞" for one, orders in zip(found, view.smooth, strict=True)],
               format="0.0000")
          for name, words in (("loss", "copper loss"), ("va", "largest power"))),
    )  # fmt: skip


def names_sheet(book: Book, view: ComparedLaws) -> None:
    """Declare the sheet that says what the laws are called by those who make controllers."""
    sheet = book.sheet("Names", "What the laws are called in the libraries of controllers, as far as it is sure.")
    sheet.widths |= dict.fromkeys(range(FIRST + 1, FIRST + 1 + len(VENDORS)), 34.0)
    sheet.heading(
        "Names, with the number there", f"{NONE} where there is none, or none is sure; with parameters as delivered."
    )
    sheet.table(
        "elsewhere", "Laws", len(view.moving),
        calc("law", "law", "", "",
             [f"=[costs.law.{i}]" for i in range(1, len(view.moving) + 1)], [one.name for one in view.moving]),
        *(constant(name, label, "", "", [getattr(one.law.vendors, name) or NONE for one in view.moving], align="left")
          for name, label in VENDORS.items()),
    )  # fmt: skip


def samples(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare what the curves are called and the numbers by which they are found, and each sampled in a table."""
    sheet.rows(
        *(calc(f"curve{i}_name", f"Name of curve {i}", "", "",
               f'=IF([curves.law.{i}]="","",INDEX(law_code,curve{i}_no))', name, align="center")
          for i, name in zip(CURVES, filled(view.entered, MOST_CURVES, ""), strict=True)),
        *(calc(f"curve{i}_no", f"Number of its law, of curve {i}", "", "", f"=[curves.no.{i}]", one.number, format="0")
          for i, one in zip(CURVES, view.curves, strict=True)),
    )  # fmt: skip
    sheet.row += 1
    n, stack = view.sizes.cycle, view.stack
    for i, one in zip(CURVES, view.curves, strict=True):
        values = dict(zip("svaj", one.law.evaluate(view.xi), strict=True))
        sheet.table(
            f"samples{i}", f"Curve {i} over ξ = t / t_a", n + 1,
            constant("k", "sample", "k", "", list(range(n + 1))),
            calc("xi", "abscissa", "ξ", "", f"=[k]/[samples{i}.k.last]", view.xi, "k / N", format="0.0000"),
            *stack.columns(values, "svaj", result),
            *stack.finding(f"curve{i}_no", one.number, "xi", view.xi),
        )  # fmt: skip
        sheet.row += 1


def joints_table(sheet: Sheet, view: ComparedLaws) -> None:
    """Declare the table of joints: rates at both ends of each piece, what jumps before it, and what stays smooth."""
    rows = view.joints

    def rate(name: str, i: int, at_end: bool) -> Quantity:
        words = f"{RATES[name]} at its {'end' if at_end else 'begin'}"
        values = [(row.at.end if at_end else row.at.begin)[i] for row in rows]
        formula = at_place(name, at_end, view.stack)
        return calc(
            f"{name}{int(at_end)}", words, f"{name}_{int(at_end)}", "", formula, values, scale=max(map(abs, values))
        )

    sheet.table(
        "joints", "Pieces of each law, and the rest behind it", len(rows),
        calc("law", "law", "", "", "=INDEX(law_code,[no])", [row.law.name for row in rows]),
        constant("no", "number", "", "", [row.law.number for row in rows], format="0"),
        constant("k", "piece", "k", "", [row.k for row in rows], format="0"),
        calc("q", "piece row", "q", "", PIECE, [row.row for row in rows], "on the sheet Laws", format="0"),
        calc("d", "duration", "d", "", "=INDEX(piece_d,[q])", [row.at.duration for row in rows]),
        calc("u", "its end", "u", "", f"=[d]{NOT_ZERO}", [row.at.duration + LEAST for row in rows],
             "never 0, so that u⁰ is 1"),
        *(calc(f"x{n}", f"argument of sine{words} at its end", "", "rad",
               f"=INDEX(piece_omega{n},[q])*[u]+INDEX(piece_phi{n},[q])", [row.at.angles[i] for row in rows])
          for i, (n, words) in enumerate((("", ""), ("2", " 2"))[: 1 + view.stack.second_sine])),
        *(rate(name, i, at_end) for at_end in (False, True) for i, name in enumerate(RATES)),
        calc("p", "last before it that lasts", "", "",
             "=IF([k]=1,0,IF([d-1]>0,[k-1],[p-1]))", [row.at.before for row in rows], "0: rest", format="0"),
        *(calc(f"d{name}", f"jump of {words}", f"Δ{name}", "",
               f"=IF([d]>0,[{name}0]-IF([p]=0,0,INDEX([joints.{name}1],[first]+[p]-1)),0)",
               [row.at.jump[i] for row in rows], scale=max(abs(row.at.begin[i]) for row in rows))
          for i, (name, words) in enumerate(RATES.items())),
        calc("ca", "largest |a| of its law", "C_a", "",
             "=MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))", [row.law.law.coefficients.ca for row in rows]),
        calc("order", "highest continuous derivative", "", "",
             ORDERED, [row.at.order for row in rows], "0 s, 1 v, 2 a, 3 j", format="0"),
        calc("outer", "is an end of the law", "", "", "=IF(AND([d]>0,OR([p]=0,[k]>COUNTIF(piece_number,[no]))),1,0)",
             [int(row.at.outer) for row in rows], format="0"),
        calc("code", "law, end and order", "", "", "=8*[no]+4*[outer]+[order]",
             [joint_code(row.law.number, row.at) for row in rows], "8 · number + 4 at an end + order", format="0"),
        calc("first", "row of its law's first piece", "", "", "=MATCH([no],[joints.no],0)", [row.first for row in rows],
             format="0"),
    )  # fmt: skip


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
