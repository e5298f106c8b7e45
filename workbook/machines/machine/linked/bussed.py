"""A drive that is worked out place by place on the common DC bus, in cells: its power anywhere by that at nodes."""

from __future__ import annotations

from engine.machine.interpolated import INSIDE
from engine.machine.places import NODES
from workbook.book.declare import Quantity, calc
from workbook.machines.machine.bussed import Begin, Bus
from workbook.machines.machine.linked.worked import PlacedWork

KILO = "drive{}_i1/1000"
"""kW of torque times speed before the reducer"""


def begins(view: PlacedWork) -> list[Begin]:
    """Return where each section begins on the master shaft, and the power on both sides of that."""
    i, n = view.driven.number, len(NODES)
    power = [f"{KILO.format(i)}*[drive{i}_pl.P.{k}]" for k, _ in enumerate(view.at_nodes("power"), 1)]
    firsts, lasts, found = power[::n], power[n - 1 :: n], []
    for k, (after, before) in enumerate(zip(firsts, [lasts[-1], *lasts[:-1]], strict=True), 1):
        at = f"([drive{i}_sec.b.{k}]+[axes_taken.late.{i}])"
        found.append(Begin(f"{at}-360*INT(({at}+timing_eps)/360)", f"[drive{i}_sec.on.{k}]", after, before))
    return found


def places(bus: Bus, view: PlacedWork) -> list[Quantity]:
    """Return the columns of the section in which each line begins, and where in it."""
    i, at = view.driven.number, f"([b]-[axes_taken.late.{view.driven.number}])"
    told = f"({at}-360*INT(({at}+timing_eps)/360))"
    numbers, found = [], []
    for number, place in bus.lines.begins(view.running):
        numbers.append(view.section_rows if number + 1 == len(view.sections) else number + 1)
        found.append(view.interpolated[number].place(place))
    begin, end = (f"INDEX([drive{i}_sec.{name}],[s{i}])" for name in ("b", "e"))
    within = f"MIN({INSIDE!r},2*({told}-{begin})/({end}-{begin})-1)"
    return [
        calc(f"s{i}", f"axis {i}: section", "", "", f"=MATCH({told}+timing_eps,[drive{i}_sec.b],1)",
             bus.rowed(numbers), format="0"),
        calc(f"x{i}", "place in it", "x", "", f"=MAX(0-{INSIDE!r},{within})", bus.rowed(found), scale=1.0,
             source="−1 … 1"),
    ]  # fmt: skip


def power_at(bus: Bus, view: PlacedWork) -> str:
    """Return the formula of its power at the begin of a row."""
    i = view.driven.number
    values = f"SUMPRODUCT(([drive{i}_pl.sec]=[s{i}])*[drive{i}_pl.P]*[drive{i}_pl.inter]/([x{i}]-[drive{i}_pl.t]))"
    weights = f"SUMPRODUCT([drive{i}_rule.inter]/([x{i}]-[drive{i}_rule.x]))"
    return f"=IF([power.bus.{bus.row(view)}]=0,0,{KILO.format(i)}*{values}/{weights})"
