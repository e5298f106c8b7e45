"""Where the motion of a drive is cut: at pieces, where the acceleration turns in one, at edges of process forces."""

from __future__ import annotations

from itertools import chain
from typing import Any

from engine.machine.stationary import HALVED, root_term, septic
from workbook.book.declare import Quantity, Sheet, calc, check, constant, given
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.chain import WINDOWS
from workbook.machines.machine.phases import beyond, goes_beyond
from workbook.machines.machine.stretched import Stretched

ACTS = "(({x}>=[@windows.from])*({x}<[@windows.from]+[@windows.span])+({x}+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: Stretched) -> None:
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
        *([beyond('[stop]=""', over)] if over.measured else []),
    )  # fmt: skip


def windows_check(view: Stretched) -> list[Quantity]:
    """Return the check that process forces end with the cycle, where an entry says how long that is."""
    over, i = view.one.machine.over, view.driven.number
    if not over.measured:
        return []
    row = "MATCH(1,[@windows.beyond],0)"
    last = f"MAX(INDEX([@windows.start],{row}),INDEX([@windows.stop],{row}))"
    name = f'[axes.name.{i}]&" process force "'
    return [check("@ok_windows", f"{view.driven.called}: no process force goes on beyond the cycle",
                  "SUM([@windows.beyond])=0", True, rule=over.rule("axes", i, "forces"),
                  says=goes_beyond(name, row, last, over))]  # fmt: skip


def turns_table(sheet: Sheet, view: Stretched) -> None:
    """Declare where the acceleration turns within a piece."""
    table, room = f"axis{view.driven.number}_pieces", view.room
    c3, c4, c5, d = (held(view, name) for name in ("c3", "c4", "c5", "d"))
    quintic = f"{held(view, 'c6')}=0,{held(view, 'c7')}=0"
    amplitude, om, ph = (held(view, name) for name in ("A", "om", "ph"))
    polynomial = (f"IF({c5}=0,0,[w]/(10*{c5}))", f"IF([w]=0,0,{c3}/[w])", "0", "0")
    places = range(1, view.places_of_piece + 1)
    terms = [0.0 if septic(piece) else root_term(*piece.c[3:6]) for piece in view.pieces]
    inside = f"4*{c4}^2-10*{c3}*{c5}"
    rooted = f"AND({quintic},{inside}>0)" if view.septics else f"{inside}>0"

    def sine(j: int) -> str:
        found = f"((INT({ph}/PI()-0.5+check_zero)+{j}+0.5)*PI()-{ph})/{om}"
        for second in view.one.pieces.sines[1:]:
            other, phase = (held(view, f"{name}{second.mark}") for name in ("A", "ph"))
            of_two = f"IF(ABS({{0}})<1,ATAN2({{0}},SQRT(1-({{0}})^2))/{om},0)"
            share = f"{amplitude}*SIN({ph})/(16*{other}*SIN({phase}-2*{ph}))"
            found = f"IF({other}=0,{found},{of_two.format(share) if j == 1 else 0})"
        return found

    def of_polynomial(j: int) -> str:
        if not view.septics:
            return polynomial[j - 1]
        half = f"IF({c3}=0,1-{HALVED!r},{HALVED!r})*{d}" if j == 1 else "0"
        return view.by_ladder(f"bend{j}", f"IF(AND({quintic}),{polynomial[j - 1]},{half})")

    def found(j: int) -> list[float]:
        return filled([places[j] for places in view.raw], room, view.spare_places[j])

    sheet.table(
        "@turns", "Where the acceleration turns within a piece", room,
        constant("r", "piece", "r", "", list(range(1, room + 1))),
        calc("w", "of its slope's roots", "w", "",
             f"=IF({rooted},0-(2*{c4}+IF({c4}<0-check_zero*SQRT({inside}),0-1,1)*SQRT({inside})),0)",
             filled(terms, room, terms[-1]), scale=max(1e-9, *map(abs, terms))),
        *(calc(f"u{j}", f"place {j}", "u", "rad", f"=IF({amplitude}=0,{of_polynomial(j)},{sine(j)})", found(j - 1),
               scale=1.0)
          for j in places),
        *(calc(f"t{j}", f"place {j}", "θ", "°",
               f"=IF(AND([u{j}]>check_zero*{d},[u{j}]<(1-check_zero)*{d}),"
               f"INDEX([{table}.begin],[r])+DEGREES([u{j}]),360)",
               view.turned[j - 1], source="360: none", format="0.0##", scale=360.0)
          for j in places),
    )  # fmt: skip


def held(view: Stretched, name: str) -> str:
    """Return the formula of a figure of a row's piece; 0 of a power that no motion of the book has."""
    power = int(name[1:]) if name[1:].isdigit() else 0
    return "0" if power >= view.one.pieces.powers else f"INDEX([axis{view.driven.number}_pieces.{name}],[r])"


def breaks_table(sheet: Sheet, view: Stretched) -> None:
    """Declare where a stretch can begin: at pieces, where the acceleration turns in one, at process forces."""
    i, room, over = view.driven.number, view.room, view.one.machine.over
    formulas = [f"=[axis{i}_pieces.begin.{r}]" for r in range(1, room + 1)]
    formulas += [f"=[@turns.t{j}.{r}]" for j in range(1, view.places_of_piece + 1) for r in range(1, room + 1)]
    for n in range(1, WINDOWS + 1):
        for edge in ("start", "stop"):
            told = f"({over.in_degrees(f'[@windows.{edge}.{n}]')}-[axes_taken.late.{i}])"
            formulas.append(f'=IF([@windows.{edge}.{n}]="",360,{told}-360*INT(({told}+timing_eps)/360))')
    late = f"(0-[axes_taken.late.{i}])"
    formulas += [f"={late}-360*INT(({late}+timing_eps)/360)", *(formula for _, formula in view.further), "=360+0"]
    further = [angle for angle, _ in view.further]
    sheet.table(
        "@breaks", "Where a stretch can begin", len(formulas),
        constant("n", "number", "", "", list(range(1, len(formulas) + 1))),
        calc("at", "angle of its phases", "θ", "°", formulas,
             [*view.begins, *chain(*view.turned), *view.edges, view.turn_begin, *further, TURN], scale=360.0,
             format="0.0##"),
    )  # fmt: skip
