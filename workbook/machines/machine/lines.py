"""The torque of a motor over the acceleration in cells: a line that bends where power turns round, by who drives."""

from __future__ import annotations

from workbook.book.declare import Sheet, calc
from workbook.machines.machine.driven import Driven

ABOUT = (
    "In the direction of motion the torque over the acceleration is a line that bends twice, where power turns round "
    "in the reducer and in the mechanism: where the load resists, and where it drives."
)
FACTORS = {"resists": "1/@eta{0}", "drives": "@back{0}"}
TURNED = {"resists": "@back{0}", "drives": "1/@eta{0}"}


def lines(sheet: Sheet, driven: Driven) -> None:
    """Declare the lines, each by what the load resists with: levels and bends for 1 N or Nm of it."""
    sheet.heading("Workings: the torque over the acceleration", ABOUT)
    for name, way in driven.lines.items():
        w, slopes = f"@{name}", way.slopes
        keep, turned = (one[name].format(1) for one in (FACTORS, TURNED))
        keep2, turned2 = (one[name].format(2) for one in (FACTORS, TURNED))
        sign, slope = ("1", max(slopes)) if name == "resists" else ("(0-1)", max(slopes))

        def line(one: str, other: str) -> str:
            return f"=@j0*@i+{one}/@i1*({other}*@m/@i2+@j1*@i2)"

        sheet.rows(
            calc(f"{w}_b", f"Where the load {name}: torque for 1 of it", "", "", f"={keep}*{keep2}/@i",
                 abs(way.level), scale=abs(way.level)),
            calc(f"{w}_a", "Slope", "A", "Nm/b", line(keep, keep2), slopes[0], scale=slope),
            calc(f"{w}_a1", "between both bends", "A_1", "Nm/b", line(turned, keep2), slopes[1], scale=slope),
            calc(f"{w}_a2", "past both", "A_2", "Nm/b", line(turned, turned2), slopes[2], scale=slope),
            calc(f"{w}_s1", "change at the first", "ΔA_1", "Nm/b", f"=0-{sign}*({w}_a1-{w}_a)", way.steps[0],
                 scale=slope),
            calc(f"{w}_s2", "change at the second", "ΔA_2", "Nm/b", f"=0-{sign}*({w}_a2-{w}_a1)", way.steps[1],
                 scale=slope),
            calc(f"{w}_y", "power turns round in the reducer at", "y_1", "",
                 f"=IF(@m+@j1>0,{keep2}/@i2/({keep2}*@m/@i2+@j1*@i2),0)", way.turns[0]),
            calc(f"{w}_r", "slope behind the reducer", "", "Nm/y", f"={keep2}*@m/@i2+@j1*@i2", way.geared[0]),
            calc(f"{w}_r2", "past both bends", "", "Nm/y", f"={turned2}*@m/@i2+@j1*@i2", way.geared[1]),
        )  # fmt: skip
