"""The rotating parts of a drive, as they are entered: inertias, or sizes of cylinders; teeth of what is geared."""

from __future__ import annotations

from typing import Any

from workbook.book.declare import Sheet, calc, constant, given
from workbook.book.rows import filled
from workbook.drive.entries import ALONE, BORED, GEARED, SIZED
from workbook.entries.units import KG_CM2, shown
from workbook.machines.machine.drive.driven import Driven

TITLE = "Rotating parts: an inertia, or a cylinder's diameter, length and density; teeth of what is geared"
CYLINDER = (
    '=IF([inertia]="",PI()/2*[density]*(([diameter]/2/1000)^4-([bore]/2/1000)^4)*[length]/1000*10000,[inertia]+0)'
)


def parts_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the rotating parts."""
    e, key = driven.entered.parts, f"axes.{driven.number - 1}.parts.*"
    turned = driven.parts

    def entered(name: str) -> list[Any]:
        return filled([getattr(part, name) for part in e], rows, None)

    sheet.row += 1
    sheet.table(
        "@parts", TITLE, rows,
        given("name", "part", "", "", entered("name"), f"{key}.name"),
        constant("k", "number", "k", "", list(range(1, rows + 1))),
        given("count", "count", "", "", entered("count"), f"{key}.count", format="0"),
        given("inertia", "inertia of one", "J", "kg cm²", entered("inertia"), f"{key}.inertia", format="General",
              source="or a cylinder's size"),
        given("shaft", "on the shaft of", "", "", entered("shaft"), f"{key}.shaft", source="motor, or mechanism"),
        given("driver", "teeth of the driver", "n1", "", entered("teeth_driver"), f"{key}.teeth_driver", format="0"),
        given("driven", "teeth of the driven", "n2", "", entered("teeth_driven"), f"{key}.teeth_driven", format="0"),
        given("diameter", "diameter", "d_a", "mm", entered("diameter"), f"{key}.diameter", format="0.0##"),
        given("length", "length", "L", "mm", entered("length"), f"{key}.length", format="0.0##"),
        given("density", "density", "ρ", "kg/m³", entered("density"), f"{key}.density", format="0",
              source="steel: 7800"),
        given("bore", "bore", "d_i", "mm", entered("bore"), f"{key}.bore", format="0.0##"),
        calc("one", "inertia of one", "J", "kg cm²", CYLINDER,
             filled([shown(part.inertia, KG_CM2) for part in turned], rows),
             source="½ρπ(R⁴ − r⁴)L"),
        calc("speed", "speed ratio", "ω_i/ω", "", "=IF(COUNT([driver],[driven])=2,[driver]/[driven],1)",
             filled([part.speed_ratio for part in turned], rows, 1.0), source="n1/n2, over that shaft's"),
        calc("all", "at that shaft", "J*", "kg cm²", "=[count]*[one]*[speed]^2",
             filled([shown(part.reflected, KG_CM2) for part in turned], rows), source="n J (ω_i/ω)²"),
        rules=[SIZED, ALONE, BORED, GEARED],
    )  # fmt: skip


def on_shaft(shaft: str) -> str:
    """Return the formula of the inertia (kg m²) of all parts on a shaft, the motor's or the mechanism's."""
    return f'SUMPRODUCT(([@parts.shaft]="{shaft}")*[@parts.all])/10000'
