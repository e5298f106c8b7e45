"""A mechanism of a constant ratio in cells: its size, and its ratio."""

from __future__ import annotations

from workbook.book.declare import Quantity, Sheet, calc, given
from workbook.machines.machine.chain import BELTED
from workbook.machines.machine.drive.driven import SCREW, Driven

SIZES = {
    "lead screw": ("Lead of the screw", "P"),
    "conveyor": ("Diameter of the roller", "D"),
    "rack and pinion": ("Pitch diameter of the pinion", "D"),
    "belt": ("Pitch diameter of the pulley", "D"),
    "feed rollers": ("Radius of the rollers", "R"),
}
RATIOS = {"lead screw": "=2*PI()/(@size/1000)", "feed rollers": "=1/(@size/1000)"}


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the row of the mechanism's size, if it has one, and of its belt."""
    m, key = driven.given, f"{key}.mechanism"
    label, symbol = SIZES.get(m.kind, ("", ""))
    rows = [given("@size", label, symbol, "mm", m.size, f"{key}.size", format="0.0##")] if label else []
    if m.kind in BELTED:
        rows.append(given("@belt_mass", "Mass of the belt", "m_b", "kg", m.belt, f"{key}.belt", format="0.0##",
                          source="moves with the load; its own weight balances itself"))  # fmt: skip
    return rows


def entered(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare no table of entries: what is entered are single cells."""


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios."""
    travels, m = driven.travels, driven.mechanism
    ratio = RATIOS.get(driven.given.kind, "=2/(@size/1000)") if travels else "=1"
    screw = driven.given.kind == SCREW
    return [
        calc("@i2", "Ratio of the mechanism", "i_2", "rad/m" if travels else "", ratio, m.ratio_from(1),
             source="2π/P" if screw else "1/R of rollers, 2/D of a wheel" if travels else "the load turns with it"),
        calc("@i", "Motor over load", "i", "rad/m" if travels else "", "=@i1*@i2", m.ratio, source="i_1 i_2"),
    ]  # fmt: skip


def table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare nothing more."""
