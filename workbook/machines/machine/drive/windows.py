"""The process forces over the cycle: what is entered, and which act at an angle of the master shaft."""

from __future__ import annotations

from typing import Any

from workbook.book.declare import Quantity, Sheet, calc, check, constant, given
from workbook.book.rows import filled
from workbook.book.sentence import first_text
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.chain import WINDOWS
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.timing.phases import beyond

ACTS = "(({x}>=[@windows.from])*({x}<[@windows.from]+[@windows.span])+({x}+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: DriveView) -> None:
    """Declare the process forces over the cycle."""
    entered, unit = view.driven.axis.typed.load.windows, "N" if view.driven.travels else "Nm"
    found, over = view.driven.windows, view.one.machine.over
    turned = view.driven.entered.load.windows
    until = f"MIN(360,{over.in_degrees('[stop]')})" if over.measured else "[stop]"

    def entry(name: str) -> list[Any]:
        return filled([getattr(w, name) for w in entered], WINDOWS, None)

    spans = [shown((w.end - w.begin), DEGREE) for w in found]
    sheet.row += 1
    sheet.table(
        "@windows", "Process forces over the cycle: leave spare rows empty", WINDOWS,
        constant("k", "number", "k", "", list(range(1, WINDOWS + 1))),
        given("start", "from", "", over.unit, entry("start"), f"{key}.load.windows.*.start", format=over.format),
        given("stop", "to", "", over.unit, entry("stop"), f"{key}.load.windows.*.stop", format=over.format,
              source=over.entered_of),
        given("force", "force", "", unit, entry("force"), f"{key}.load.windows.*.force", format="0.0##"),
        given("resists", "resists", "", "", entry("resists"), f"{key}.load.windows.*.resists",
              source="always, or moving"),
        calc("from", "from", "", "°", f"={over.in_degrees('[start]')}+0", filled([w.start for w in turned], WINDOWS),
             format="0.0##"),
        calc("span", "for", "", "°",
             f"={until}-{over.in_degrees('[start]')}+IF([stop]+0<[start]+0,360,0)",
             filled([span + (360 if span < 0 else 0) for span in spans], WINDOWS), format="0.0##"),
        calc("always", "always", "", unit, '=IF([resists]="moving",0,[force]+0)',
             filled([w.load.torque for w in found], WINDOWS)),
        calc("moving", "against motion", "", unit, '=IF([resists]="moving",[force]+0,0)',
             filled([w.load.friction for w in found], WINDOWS)),
        *edges(view),
        *([beyond(over)] if over.measured else []),
    )  # fmt: skip


def windows_check(view: DriveView) -> list[Quantity]:
    """Return the check that process forces end with the cycle, where an entry says how long that is."""
    over, i = view.one.machine.over, view.driven.number
    if not over.measured:
        return []
    words = "[@windows.beyond]"
    row = first_text(words)
    return [check("@ok_windows", f"{view.driven.called}: no process force goes on beyond the cycle",
                  f'COUNTIF({words},"?*")=0', True, rule=over.rule("axes", i, "forces"),
                  says=f'[axes.name.{i}]&" process force "&{row}&" "&INDEX({words},{row})')]  # fmt: skip


def edges(view: DriveView) -> list[Quantity]:
    """Return the columns of where a force begins and ends, in degrees of the motion as its phases tell it."""
    late = f"[axes_taken.late.{view.driven.number}]"
    begins, ends = view.edges[::2], view.edges[1::2]

    def edge(name: str, label: str, at: str, values: list[float]) -> Quantity:
        told = f"({at}-{late})"
        return calc(name, label, "θ", "°", f'=IF([start]="",360,{told}-360*INT(({told}+timing_eps)/360))', values,
                    scale=360.0, format="0.0##", source="of its phases; 360 if spare")  # fmt: skip

    return [edge("b", "begins at", "[from]", begins), edge("e", "ends at", "([from]+[span])", ends)]


def acting(angle: str, column: str) -> str:
    """Return the formula of what acts at an angle of the master shaft, of a column of the process forces."""
    return f"SUMPRODUCT({ACTS.format(x=angle)}*[@windows.{column}])"
