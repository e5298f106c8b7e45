"""Tables of a chain: gears and rotating parts as entered, the stages that they make, and the torque through them.

``@i`` is the ratio of motor to load, ``@j0`` the inertia on the motor's shaft, ``@load`` and ``@moved_belt`` what is
moved at the end, ``@method`` how losses are counted; tables ``@gears``, ``@parts``, ``@stages``.
"""

from __future__ import annotations

from collections.abc import Sequence

from engine.drivetrain import Mechanism, Part
from engine.drivetrain.losses import Method
from engine.drivetrain.magnitudes import Magnitudes
from engine.laws.base import Array
from workbook.book.declare import Quantity, Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.drive.entries import ALONE, BORED, SIZED, WHOLE, Gear, PlacedParts
from workbook.drive.losses import loss_factor

CYLINDER = '=IF([inertia]="",PI()/2*[density]*(([diameter]/2/1000)^4-([bore]/2/1000)^4)*[length]/1000,[inertia])'
AT_MOTOR = (
    "=[total]/IF([on]=0,1,INDEX([@stages.to],MAX([on],1))^2"
    '*IF(@method="document",INDEX([@stages.eta_to],MAX([on],1)),1))'
)


def gears_table(sheet: Sheet, gears: Sequence[Gear], rows: int, key: str) -> None:
    """Declare the gears between motor and last element, kept at ``key`` of the description."""
    sheet.table(
        "@gears", "Gears, from the motor on: leave empty what is not there", rows,
        given("name", "gear", "", "", filled([g.name for g in gears], rows, None), f"{key}.*.name"),
        constant("k", "gear", "k", "", list(range(1, rows + 1))),
        given("ratio", "ratio", "N", "",
              filled([g.ratio for g in gears], rows, None), f"{key}.*.ratio", format="0.0##",
              source="speed before / behind"),
        given("efficiency", "efficiency", "η", "",
              filled([g.efficiency for g in gears], rows, None), f"{key}.*.efficiency", format="0.0##"),
    )  # fmt: skip


def parts_table(
    sheet: Sheet, entered: Sequence[PlacedParts], parts: Sequence[Part], machine: Mechanism, method: Method, rows: int,
    key: str,
) -> None:  # fmt: skip
    """Declare the rotating parts: an inertia, or the size of a cylinder; what each weighs at the motor's shaft."""

    def entry(name: str, label: str, symbol: str, unit: str, form: str = "0.0##", source: str = "") -> Quantity:
        values = filled([getattr(p, name) for p in entered], rows, None)
        return given(name, label, symbol, unit, values, f"{key}.*.{name}", format=form, source=source)

    reflected = [machine.at_motor(part.reflected, part.shaft, method) for part in parts]
    sheet.table(
        "@parts", "Rotating parts: enter an inertia, or a cylinder's diameter, length and density", rows,
        entry("name", "part", "", "", ""),
        constant("k", "number", "k", "", list(range(1, rows + 1))),
        entry("count", "count", "", "", "0"),
        entry("inertia", "inertia of one", "J", "kg m²", "General"),
        entry("diameter", "diameter", "d", "mm"),
        entry("length", "length", "L", "mm"),
        entry("density", "density", "ρ", "kg/m³", "0", "steel: 7800"),
        entry("bore", "bore", "d_i", "mm"),
        entry("shaft", "gears before it", "", "", "0", "0: on the motor's shaft"),
        calc("one", "inertia of one", "J", "kg m²",
             CYLINDER, filled([part.inertia for part in parts], rows), source="½ρπ(R⁴ − r⁴)L"),
        calc("total", "of all", "n J", "kg m²", "=[count]*[one]", filled([part.all for part in parts], rows)),
        calc("on", "gears before it", "", "", "=[shaft]+0", filled([p.shaft for p in entered], rows), format="0"),
        result("at_motor", "at the motor", "J*", "kg m²",
               AT_MOTOR, filled(reflected, rows), source="n J/i²; over η as S4"),
        rules=[SIZED, ALONE, BORED, WHOLE],
    )  # fmt: skip


def stages_table(sheet: Sheet, machine: Mechanism, element: str, wheel: str, efficiency: str) -> None:
    """Declare the stages: a row for each gear, then the last element, of a name, ratio and efficiency in formulas."""
    n = machine.last
    shafts = range(1, n + 1)

    def column(entry: str, spare: str, last: str, where: str = "") -> list[str]:
        """Return the formulas of an entry of the gears, ``spare`` where it, or the one of ``where``, is empty."""
        gears = [(f"[@gears.{where or entry}.{k}]", f"[@gears.{entry}.{k}]") for k in range(1, n)]
        return [*(f'=IF({tested}="",{spare},{taken})' for tested, taken in gears), f"={last}"]

    own = [machine.on_shaft(k) for k in shafts]
    sheet.row += 1
    sheet.table(
        "@stages", "Stages, from the motor to the load", n,
        calc("name", "stage", "", "", column("name", '"none"', element, "ratio"), [s.name for s in machine.stages]),
        constant("k", "number", "k", "", list(shafts)),
        calc("ratio", "ratio", "N_k", "",
             column("ratio", "1", wheel), [s.ratio for s in machine.stages], source="of screw or wheel: in rad/m"),
        calc("eta", "efficiency", "η_k", "",
             column("efficiency", "1", efficiency), [s.efficiency for s in machine.stages]),
        calc("to", "motor over this shaft", "i_k", "",
             "=IF([k]=1,[ratio],[ratio]*[to-1])", [machine.ratio_to(k) for k in shafts], source="N_1 … N_k"),
        calc("eta_to", "efficiency up to here", "", "",
             "=IF([k]=1,[eta],[eta]*[eta_to-1])", [machine.efficiency_to(k) for k in shafts]),
        calc("own", "inertia behind it", "J_k", "kg m²",
             "=[end]*(@load+@moved_belt)+SUMPRODUCT(([@parts.on]=[k])*[@parts.total])", own,
             source="of a load that travels: kg"),
        calc("at_motor", "at the motor", "J*", "kg m²",
             "=[own]/[to]^2", [machine.at_motor(j, k) for k, j in enumerate(own, 1)],
             source="J_k/i_k², without losses"),
        constant("end", "the load's (1)", "", "", filled([0 for _ in range(1, n)], n, 1)),
        blank='IF([end]=1,1,INDEX([@gears.ratio],[k]))=""',
    )  # fmt: skip


def through(torques: Sequence[Array], sides: Magnitudes) -> list[Quantity]:
    """Return the columns from the load's force or torque to the torque at the motor's shaft, ``total``, without it.

    In a table with ``base``, what resists at the load, ``acc``, its acceleration, and ``dir``, its direction;
    ``torques`` are the engine's at each shaft, from the motor's to the load's.
    """
    last = len(torques) - 1
    made = [
        calc(f"t{last}", "at the load", "F, T", "N or Nm",
             "=[base]+[@stages.own.last]*[acc]", torques[last], scale=sides.shaft_torque(last),
             source="resists + m a, J ω̇"),
    ]  # fmt: skip
    for k in reversed(range(last)):
        name, column = ("into the mechanism", "total") if k == 0 else (f"behind gear {k}", f"t{k}")
        own = f"[@stages.own.{k}]*@i/[@stages.to.{k}]*[acc]" if k else "@j0*@i*[acc]"
        behind, stage = f"[t{k + 1}]", f"[@stages.{{}}.{k + 1}]"
        factor = loss_factor(behind, "[dir]", stage.format("eta"), "@method")
        made.append(
            calc(column, name, "T*_L" if k == 0 else f"T_{k}", "Nm",
                 f"={factor}*{behind}/{stage.format('ratio')}+{own}", torques[k], scale=sides.shaft_torque(k),
                 source="f T/i + J ω̇"),
        )  # fmt: skip
    return made
