"""The Turning sheet: where each law is fastest, and where a tool that reverses turns, both in the time of the law."""

from __future__ import annotations

from collections.abc import Sequence

from engine.flying import SAME_LENGTH
from engine.halving import velocity_halvings
from engine.laws.points import fastest
from workbook.book.declare import Book, Sheet, calc, constant
from workbook.entries.units import MM, shown
from workbook.laws import sampling
from workbook.laws.library import NamedLaw
from workbook.machines.flying.view import Flying

HALVINGS = 30  # the position at a turning point is known to the square of what this leaves


def turning_sheet(book: Book, machine: Flying, laws: Sequence[NamedLaw], pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "Turning", "Workings: where the law is fastest, and where a tool that reverses stands for an instant."
    )
    peaks(sheet, laws)
    turning_points(sheet, machine, pieces)


def peaks(sheet: Sheet, laws: Sequence[NamedLaw]) -> None:
    """Declare where each law is fastest."""
    sheet.heading("Where each law is fastest", "There a drum that slows down is slowest, and waits if it has to.")
    sheet.table(
        "fastest", "The laws by number", len(laws),
        calc("law", "law", "", "",
             [f"=INDEX(law_code,{one.number})" for one in laws], [one.name for one in laws]),
        calc("at", "abscissa", "ξ_v", "",
             [one.own(one.page.fastest) for one in laws],
             [fastest(one.law) if one.family.entry.rises else 0.0 for one in laws]),
    )  # fmt: skip


def turning_points(sheet: Sheet, machine: Flying, pieces: sampling.Pieces) -> None:
    """Declare both turning points: the law gets as fast as v* on its way to its peak, and slows to it after."""
    cut, law = machine.cut, machine.law
    wanted, number, mm = cut.standing_velocity, machine.number, shown(machine.scales.length, MM)
    sides = ((0.0, cut.fastest), (cut.fastest, 1.0))
    found = [velocity_halvings(law, wanted, low, high, HALVINGS, SAME_LENGTH) for low, high in sides]
    positions = [shown(cut.position_at(float(middle[-1])), MM) for _, _, middle in found]
    sheet.heading(
        "Turning points", "Where the tool stands for an instant before it reverses: v(ξ) = v*, found by halving."
    )
    reverse = '=IF(fly_does="reverses",0-fly_v*1000*fly_tm/fly_h1,1)'
    sheet.rows(
        calc("fly_turn_v", "Velocity of the law at which the tool stands", "v*", "",
             reverse, wanted, source="−v_L t_m/h; of a tool that never turns, that of the mean"),
        calc("fly_turn_1", "Position at the first turning point", "", "mm",
             "=fly_v*1000*[turn_1.xi.last]*fly_tm+fly_h1*[turn_1.s.last]", positions[0], scale=mm,
             source="v_L t + h s"),
        calc("fly_turn_2", "Position at the second turning point", "", "mm",
             "=fly_v*1000*[turn_2.xi.last]*fly_tm+fly_h1*[turn_2.s.last]", positions[1], scale=mm,
             source="v_L t + h s"),
    )  # fmt: skip
    tables = (
        ("turn_1", "First turning point: the rise of v halved", "0", "fly_peak", "[v-1]+fly_near<fly_turn_v"),
        ("turn_2", "Second turning point: the fall of v halved", "fly_peak", "1", "[v-1]-fly_near>fly_turn_v"),
    )
    for (name, title, begin, end, before), (low, high, xi) in zip(tables, found, strict=True):
        values = dict(zip("sva", law.evaluate(xi), strict=False))
        sheet.row += 1
        sheet.table(
            name, title, HALVINGS,
            constant("k", "halving", "k", "", list(range(1, HALVINGS + 1))),
            calc("low", "not before", "ξ", "", f"=IF([k]=1,{begin},IF({before},[xi-1],[low-1]))", low),
            calc("high", "not after", "ξ", "", f"=IF([k]=1,{end},IF({before},[high-1],[xi-1]))", high),
            calc("xi", "middle", "ξ", "", "=([low]+[high])/2", xi),
            *pieces.finding("fly_no", "xi", pieces.locate(number, xi)),
            *pieces.columns(values, "sv"),
        )  # fmt: skip
