"""The sum of all drives' power in cells, at places of a grid and wherever one of them may jump."""

from __future__ import annotations

import re

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet, calc, constant
from workbook.book.rows import filled
from workbook.entries.abscissa import Abscissa
from workbook.entries.turn import TURN
from workbook.entries.units import KW, shown
from workbook.machines.machine.bussed import Begin, Bus
from workbook.machines.machine.linked import bussed as linked
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.powered import line
from workbook.machines.machine.stretched import Stretched

OWN = re.compile(r"\[(\w+)\]")
PLACE = "(([ub]+[ue])/2+({x}-[x])*PI()/180)"
"""u at a master angle, by that in the middle of a stretch"""
NEXT = "IF([e]>=360-timing_eps,1,MIN([bus.k.last],[k]+1))"
"""the row behind one: behind the last of the turn its first"""
WITHIN = "(2*({x}+timing_eps-[x])*PI()/180>=[ub]-[ue])*(2*({x}+timing_eps-[x])*PI()/180<[ue]-[ub])*[on]*[dir]"


def breaks_table(sheet: Sheet, bus: Bus) -> None:
    """Declare where the stretches of all drives begin, and by how much the power jumps there."""
    found = bus.jumps
    places, jumps, drawn = [], [], []
    for one in bus.drives:
        shares = f"[power.bus.{bus.row(one)}]"
        for at, on, after, before in linked.begins(one) if isinstance(one, PlacedWork) else begins(one):
            places.append(f"={shares}*MAX(0,{at})")
            up = f"MAX(0,{after})-MAX(0,{before})"
            down = f"MAX(0,0-{after})-MAX(0,0-{before})"
            jumps.append(f"={shares}*{on}*({up})/power_efficiency")
            drawn.append(f"=[alone]-{shares}*{on}*({down})*power_efficiency")
    size = len(found)
    sheet.row += 1
    sheet.table(
        "jumps", "Where power may jump: where stretches of drives begin", size + 1,
        constant("n", "number", "", "", list(range(1, size + 2))),
        calc("at", bus.over.angle, "θ", "°", [*places, "=360+0"], [*(one.at for one in found), TURN], scale=TURN,
             format="0.0##"),
        calc("alone", "from the mains, alone", "", "kW", [*jumps, "=0+0"], [*(shown(one.alone, KW) for one in found),
             0.0],
             scale=shown(bus.size, KW)),
        calc("common", "on the bus", "", "kW", [*drawn, "=0+0"], [*(shown(one.common, KW) for one in found), 0.0],
             scale=shown(bus.size, KW)),
    )  # fmt: skip


def begins(one: Stretched) -> list[Begin]:
    """Return where each stretch of a drive begins on the master shaft, and the power on both sides of that."""
    found, i = [], one.driven.number
    for k in range(1, one.rows + 1):
        x, b, e, on, power = (f"[drive{i}_st.{name}.{k}]" for name in ("x", "b", "e", "on", "pwb"))
        found.append(Begin(f"{x}-({e}-{b})/2", on, power, f"[drive{i}_st.pwe.{k - 1 or one.rows}]"))
    return found


def power_at(bus: Bus, one: Stretched) -> str:
    """Return the formula of a drive's power at the begin of a row: of the stretch that holds behind it."""
    if isinstance(one, PlacedWork):
        return linked.power_at(bus, one)
    i = one.driven.number
    u = PLACE.replace("{x}", "@b@")
    text = f"{WITHIN.replace('{x}', '@b@')}*{one.velocity(u)}*{line(one, u)}"
    own = OWN.sub(rf"[drive{i}_st.\1]", text).replace("@b@", "[b]")
    return f"=IF([power.bus.{bus.row(one)}]=0,0,drive{i}_kilo*SUMPRODUCT({own}))"


def bus_table(sheet: Sheet, bus: Bus) -> None:
    """Declare the power of each drive at all places, and the sums at both ends of what lies between."""
    room, lines = bus.room, bus.lines
    numbers = [one.driven.number for one in bus.drives]
    drives = f"[p{numbers[0]}]:[p{numbers[-1]}]"
    jumps = f"SUMPRODUCT({same('[jumps.at]')}*[jumps.{{1}}])"
    after = f"IF(AND([k]=[bus.k.last],[e]<360-timing_eps),[{{0}}],INDEX([bus.{{0}}],{NEXT})-{jumps})"
    begin = ["=0*[k]", *("=IF([e-1]>=360-timing_eps,[b-1],[e-1])" for _ in range(room - 1))]
    grid = "bus_step*(INT(([b]+timing_eps)/bus_step)+1)"
    beyond = "SMALL([jumps.at],SUMPRODUCT(([jumps.at]<=[b]+timing_eps)*1)+1)"
    c, d, rowed = "[sum]", "[sum_e]", bus.rowed
    above = f"IF(MIN({c},{d})>=0,({c}+{d})/2,IF(MAX({c},{d})<=0,0,MAX({c},{d})^2/(2*ABS({c}-{d}))))"
    sheet.row += 1
    over, places = bus.over, rowed([low for low, _ in lines.spans])
    at = calc("b", over.angle, "θ", "°", begin, places, scale=TURN,
              format="0.0##")  # fmt: skip
    time = calc("time", over.name, over.symbol, over.unit, f"={over.told('[b]')}", list(map(over.shown, places)),
                scale=over.length, format=over.format)  # fmt: skip
    sheet.table(
        "bus", f"Power of the drives over the {over.period}: joined by straight lines", room,
        time if over.measured else at,
        calc("sum", "from the bus", "P", "kW",
             f"=[alone]-SUMPRODUCT(({drives}<0)*(0-{drives}))*power_efficiency", bus.ends(shown(lines.common, KW), 0),
             scale=shown(bus.size, KW), source="of all drives together"),
        calc("alone", "without a common bus", "P", "kW", f"=SUMPRODUCT(({drives}>0)*{drives})/power_efficiency",
             bus.ends(shown(lines.alone, KW), 0), scale=shown(bus.size, KW), source="of those that take"),
        *(calc(f"p{one.driven.number}", f"axis {one.driven.number}: at its motor", "P", "kW", power_at(bus, one),
               shown(np.asarray(values), KW), scale=shown(one.most_power, KW))
          for one, values in zip(bus.drives, bus.power, strict=True)),
        constant("k", "row", "", "", list(range(1, room + 1))),
        *([at] if over.measured else []),
        *(column for one in bus.drives if isinstance(one, PlacedWork) for column in linked.places(bus, one)),
        calc("e", "up to", "", "°", f"=MIN(360,{grid},{beyond})", rowed([high for _, high in lines.spans]),
             scale=TURN, format="0.0##"),
        calc("on", "is no spare row", "", "",
             "=IF([k]=1,1,IF(INDEX([bus.e],MAX([k]-1,1))>=360-timing_eps,0,1))", filled([1 for _ in lines.spans], room),
             format="0"),
        calc("alone_e", "alone, before the next", "", "kW", f"={after.format('alone', 'alone')}",
             bus.ends(shown(lines.alone, KW), 1), scale=shown(bus.size, KW)),
        calc("sum_e", "together, before the next", "", "kW", f"={after.format('sum', 'common')}",
             bus.ends(shown(lines.common, KW), 1), scale=shown(bus.size, KW)),
        calc("above", "above 0, times its width", "", "kW°", f"=[on]*([e]-[b])*{above}",
             filled(shown(np.asarray(lines.areas), KW), room), scale=shown(bus.size, KW)),
    )  # fmt: skip


def same(at_breaks: str) -> str:
    """Return the condition that breaks are at the end of a row; the end of the turn is its begin."""
    return f"(({at_breaks}-IF([e]>=360-timing_eps,0,[e]))^2<=timing_eps^2)"


def lines_chart(over: Abscissa) -> Chart:
    """Return the chart of the power over the cycle."""
    x = "[bus.time]" if over.measured else "[bus.b]"
    lines = (Series("on a common bus", x, "[bus.sum]"),
             Series("each drive alone, from the mains", x, "[bus.alone]", dashed=True))  # fmt: skip
    return Chart(f"Power over the {over.period}", over.title, "P [kW]", lines,
                 f"Power from the mains over {over.cycle}", over.axis(60))  # fmt: skip
