"""What jumps where the pieces of a law meet: from the stack of pieces, so from no samples."""

from engine.laws.continuity import code
from engine.laws.piece import POWERS
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.polynomial import LEAST, NOT_ZERO, polynomial
from workbook.machines.laws.view import Compared

RATES = {"v": "velocity", "a": "acceleration", "j": "jerk"}
ORDER = (
    "=IF(COUNTIF([joints.code],8*[no]+{0})>0,0,IF(COUNTIF([joints.code],8*[no]+{0}+1)>0,1,"
    "IF(COUNTIF([joints.code],8*[no]+{0}+2)>0,2,3)))"
)  # the least order of a law's joints: between its pieces, or, of codes that are 4 more, at its ends
PIECE = "=IF([k]>COUNTIF(piece_number,[no]),MATCH(1,piece_number,0),MATCH([no],piece_number,0)+[k]-1)"
"""behind the last piece the dwell's, law 1"""
ORDERS = {"a": 0, "j": 1}  # of derivatives of the acceleration
SINES = {
    "a": "+INDEX(piece_P{n},[q])*SIN({x})",
    "j": "+INDEX(piece_pj{n},[q])*COS({x})",
}
ORDERED = (
    "=IF(ABS([dv])>check_zero*INDEX(law_cv,[no]),0,IF(ABS([da])>check_zero*[ca],1,IF(ABS([dj])>check_zero*[ca],2,3)))"
)


def joints_table(sheet: Sheet, view: Compared) -> None:
    """Declare the table of joints: rates at both ends of each piece, what jumps before it, and what stays smooth."""
    rows = view.joints

    def rate(name: str, i: int, at_end: bool) -> Quantity:
        words = f"{RATES[name]} at its {'end' if at_end else 'begin'}"
        values = [(row.at.end if at_end else row.at.begin)[i] for row in rows]
        formula = at_place(name, at_end, view.stack.second_sine)
        return calc(f"{name}{int(at_end)}", words, f"{name}_{int(at_end)}", "", formula, values,
                    scale=max(map(abs, values)))  # fmt: skip

    sheet.table(
        "joints", "Pieces of each law, and the rest behind it", len(rows),
        calc("law", "law", "", "", "=INDEX(law_code,[no])", [row.one.name for row in rows]),
        constant("no", "number", "", "", [row.one.number for row in rows], format="0"),
        constant("k", "piece", "k", "", [row.k for row in rows], format="0"),
        calc("q", "piece row", "q", "", PIECE, [row.row for row in rows], format="0", source="on the sheet Laws"),
        calc("d", "duration", "d", "", "=INDEX(piece_d,[q])", [row.at.duration for row in rows]),
        calc("u", "its end", "u", "", f"=[d]{NOT_ZERO}", [row.at.duration + LEAST for row in rows],
             source="never 0, so that u⁰ is 1"),
        *(calc(f"x{n}", f"argument of sine{words} at its end", "", "rad",
               f"=INDEX(piece_omega{n},[q])*[u]+INDEX(piece_phi{n},[q])", [row.at.angles[i] for row in rows])
          for i, (n, words) in enumerate((("", ""), ("2", " 2"))[: 1 + view.stack.second_sine])),
        *(rate(name, i, at_end) for at_end in (False, True) for i, name in enumerate(RATES)),
        calc("p", "last before it that lasts", "", "",
             "=IF([k]=1,0,IF([d-1]>0,[k-1],[p-1]))", [row.at.before for row in rows], format="0", source="0: rest"),
        *(calc(f"d{name}", f"jump of {words}", f"Δ{name}", "",
               f"=IF([d]>0,[{name}0]-IF([p]=0,0,INDEX([joints.{name}1],[first]+[p]-1)),0)",
               [row.at.jump[i] for row in rows], scale=max(abs(row.at.begin[i]) for row in rows))
          for i, (name, words) in enumerate(RATES.items())),
        calc("ca", "largest |a| of its law", "C_a", "",
             "=MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))", [row.one.law.coefficients.ca for row in rows]),
        calc("order", "highest continuous derivative", "", "",
             ORDERED, [row.at.order for row in rows], format="0", source="0 s, 1 v, 2 a, 3 j"),
        calc("outer", "is an end of the law", "", "", "=IF(AND([d]>0,OR([p]=0,[k]>COUNTIF(piece_number,[no]))),1,0)",
             [int(row.at.outer) for row in rows], format="0"),
        calc("code", "law, end and order", "", "", "=8*[no]+4*[outer]+[order]",
             [code(row.one.number, row.at) for row in rows], format="0", source="8 · number + 4 at an end + order"),
        calc("first", "row of its law's first piece", "", "", "=MATCH([no],[joints.no],0)", [row.first for row in rows],
             format="0"),
    )  # fmt: skip


def at_place(name: str, at_end: bool, second: bool) -> str:
    """Return the formula of v, a or j at the begin of a piece, or at its end."""
    if name == "v":
        return "=INDEX(piece_v,[q])" + ("+INDEX(piece_dv,[q])" if at_end else "")
    order = ORDERS[name]
    text = f"INDEX(piece_c{order},[q])"
    if at_end:
        text = polynomial(f"INDEX(piece_{'d' * order}ddy,[q],0)", "[u]", POWERS, order)
    for n in ("", "2") if second else ("",):
        text += SINES[name].format(n=n, x=f"[x{n}]" if at_end else f"INDEX(piece_phi{n},[q])")
    return f"={text}"
