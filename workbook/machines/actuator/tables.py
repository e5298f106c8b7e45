"""Tables of the sheet Actuator: phases of the motion, gears, rotating parts, stages."""

from __future__ import annotations

from typing import Any

import numpy as np

from workbook.book.declare import Sheet, calc, constant, given, result
from workbook.laws import phases as joined
from workbook.machines.actuator.view import Actuator

CYLINDER = '=IF([inertia]="",PI()/2*[density]*(([diameter]/2/1000)^4-([bore]/2/1000)^4)*[length]/1000,[inertia])'


def filled(values: Any, rows: int, spare: Any = 0.0) -> list[Any]:
    """Return the values of the rows in use, then ``spare`` for each spare row."""
    return [*values, *[spare] * (rows - len(values))]


def motion(sheet: Sheet, machine: Actuator) -> None:
    """Declare the phases: what is entered, what each asks for, and to the right the workings."""
    n, entered, phases = machine.sizes.phases, machine.given.phases, machine.phases
    laws, lifts = [p.law for p in entered], [p.lift for p in entered]
    edges, total = machine.sizing.motion.edges, machine.sizing.motion.total
    h, v, a, torque = machine.lift_scale, machine.speed_scale, machine.acceleration_scale, machine.torque_scale
    si = [p.lift for p in phases]
    speeds = [p.law.coefficients.cv * abs(p.lift) / p.duration for p in phases]
    accelerations = [p.law.coefficients.ca * abs(p.lift) / p.duration**2 for p in phases]
    direction = np.array([m.direction for m in machine.moves])
    used = np.array([1.0] * len(phases) + [0.0] * (n - len(phases)))
    torques = np.array(machine.part_torques).reshape(n, 3)
    sheet.table(
        "phases", "Phases of the motion: fill one row each, in order; S4's profile of thirds is TVP, its break points stand on the sheet TVP", n,
        calc("kind", "phase", "", "", joined.kind("duration"), joined.kinds(laws, lifts, n)),
        given("law", "law", "", "", filled(laws, n, None), "actuator.phases.*.law", choices="=law_code"),
        given("lift", "lift", "h", "mm or °", filled(lifts, n, None), "actuator.phases.*.lift", format="0.0##"),
        given("duration", "duration", "t", "s",
              filled([p.duration for p in entered], n, None), "actuator.phases.*.duration", format="0.0##"),
        result("v", "largest speed", "v", "",
               joined.VELOCITY, filled(speeds, n), scale=v, source="C_v h/t; m/s, or rad/s"),
        result("amax", "largest acceleration", "a", "",
               joined.ACCELERATION, filled(accelerations, n), scale=a, source="C_a h/t²; m/s², or rad/s²"),
        *(result(name, words, symbol, "Nm",
                 f"=INDEX([extremes.torque],3*([k]-1)+{j + 1})", torques[:, j], scale=torque, source=source)
          for j, (name, words, symbol, source) in enumerate((
              ("acc", "torque accelerating", "T_acc", "at the largest a"),
              ("level", "torque uniform", "T_ss", "at a = 0; in a dwell"),
              ("dec", "torque decelerating", "T_dec", "at the lowest a")))),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "", joined.LAW_NUMBER, joined.law_numbers(laws, n), format="0"),
        calc("h", "lift used", "h", "", "=[lift]*act_unit", filled(si, n), scale=h, source="in m, or rad"),
        calc("span", "duration used", "t", "s",
             '=IF([kind]="spare",0,[duration])', filled([p.duration for p in phases], n), scale=total),
        calc("begin", "begins at", "", "s",
             '=IF([kind]="spare",2*act_time,IF([k]=1,0,[begin-1]+[span-1]))', filled(edges[:-1], n, 2 * total),
             scale=total, source="spare rows: out of reach"),
        calc("share", "begins at, of the cycle", "", "",
             "=[begin]/act_time", filled(machine.sizing.motion.shares, n, 2.0), source="what a sample looks up"),
        calc("y0", "position at its begin", "x_0", "",
             "=IF([k]=1,0,[y0-1]+[h-1])", np.cumsum([0.0, *filled(si, n)])[:-1], scale=h,
             source="lifts before, in m or rad"),
        calc("per", "acceleration for a = 1", "h/t²", "",
             "=IF([span]>0,[h]/[span]^2,0)", [m.per for m in machine.moves], scale=a),
        calc("dir", "direction", "", "", '=IF([kind]="spare",0,SIGN([h]))', direction, format="0"),
        calc("base", "resists", "", "N or Nm",
             '=IF([kind]="spare",0,IF([dir]=0,act_hold,act_steady+act_rubbing*[dir]))',
             machine.resisting(direction, used), scale=machine.force_scale),
    )  # fmt: skip


def gears(sheet: Sheet, machine: Actuator) -> None:
    """Declare the gears between motor and last element."""
    n, entered = machine.sizes.gears, machine.given.gears
    sheet.table(
        "gears", "Gears, from the motor on: leave empty what is not there", n,
        given("name", "gear", "", "", filled([g.name for g in entered], n, None), "actuator.gears.*.name"),
        given("ratio", "ratio", "N", "",
              filled([g.ratio for g in entered], n, None), "actuator.gears.*.ratio", format="0.0##",
              source="speed before / behind"),
        given("efficiency", "efficiency", "η", "",
              filled([g.efficiency for g in entered], n, None), "actuator.gears.*.efficiency", format="0.0##"),
    )  # fmt: skip


def parts(sheet: Sheet, machine: Actuator) -> None:
    """Declare the rotating parts: an inertia, or the size of a cylinder."""
    n, entered, m = machine.sizes.rotors, machine.given.parts, machine.mechanism
    fields = {name: filled([getattr(p, name) for p in entered], n, None) for name in ("name", "count", "inertia", "diameter", "length", "density", "bore", "shaft")}  # fmt: skip
    reflected = [m.reflected(p, machine.documented) for p in m.parts[: len(entered)]]

    def entry(name: str, label: str, symbol: str, unit: str, form: str = "0.0##", source: str = "") -> Any:
        return given(name, label, symbol, unit, fields[name], f"actuator.parts.*.{name}", format=form, source=source)

    sheet.table(
        "parts", "Rotating parts: enter an inertia, or a cylinder's diameter, length and density", n,
        given("name", "part", "", "", fields["name"], "actuator.parts.*.name"),
        entry("count", "count", "", "", "0"),
        entry("inertia", "inertia of one", "J", "kg m²", "General"),
        entry("diameter", "diameter", "d", "mm"),
        entry("length", "length", "L", "mm"),
        entry("density", "density", "ρ", "kg/m³", "0", "steel: 7800"),
        entry("bore", "bore", "d_i", "mm"),
        entry("shaft", "gears before it", "", "", "0", "0: on the motor's shaft"),
        calc("one", "inertia of one", "J", "kg m²",
             CYLINDER, filled([p.one for p in entered], n), source="½ρπ(R⁴ − r⁴)L"),
        calc("total", "of all", "n J", "kg m²", "=[count]*[one]", filled([p.count * p.one for p in entered], n)),
        calc("on", "gears before it", "", "", "=[shaft]+0", filled([p.shaft for p in entered], n), format="0"),
        result("at_motor", "at the motor", "J*", "kg m²",
               AT_MOTOR, filled(reflected, n), source="n J/i²; over η as S4"),
    )  # fmt: skip


AT_MOTOR = (
    "=[total]/IF([on]=0,1,INDEX([stages.to],MAX([on],1))^2"
    '*IF(act_method="document",INDEX([stages.eta_to],MAX([on],1)),1))'
)


def stages(sheet: Sheet, machine: Actuator) -> None:
    """Declare the stages: gears, then the last element."""
    m, rows = machine.mechanism, machine.sizes.gears
    n = rows + 1
    own = [m.on_shaft(k) for k in range(1, n + 1)]
    gear = [f"[gears.{{0}}.{k}]" for k in range(1, n)]
    names = [*(g.name for g in machine.given.gears), *["none"] * (rows - len(machine.given.gears)), machine.element]
    sheet.row += 1
    sheet.table(
        "stages", "Stages, from the motor to the load", n,
        calc("name", "stage", "", "", [*(f'=IF({g.format("ratio")}="","none",{g.format("name")})' for g in gear), "=INDEX([mechanisms.element],act_no)"], names),
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("ratio", "ratio", "N_k", "",
             [*(f'=IF({g.format("ratio")}="",1,{g.format("ratio")})' for g in gear), "=act_wheel"],
             [s.ratio for s in m.stages], source="of screw or wheel: in rad/m"),
        calc("eta", "efficiency", "η_k", "", [*(f'=IF({g.format("efficiency")}="",1,{g.format("efficiency")})' for g in gear), "=IF(act_travels=1,act_eta_out,1)"], [s.efficiency for s in m.stages]),
        calc("to", "motor over this shaft", "i_k", "",
             "=IF([k]=1,[ratio],[ratio]*[to-1])", [m.ratio_to(k) for k in range(1, n + 1)], source="N_1 … N_k"),
        calc("eta_to", "efficiency up to here", "", "",
             "=IF([k]=1,[eta],[eta]*[eta_to-1])", [m.efficiency_to(k) for k in range(1, n + 1)]),
        calc("own", "inertia behind it", "J_k", "kg m²",
             "=[end]*(act_load+act_moved_belt)+SUMPRODUCT(([parts.on]=[k])*[parts.total])", own,
             source="of a load that travels: kg"),
        calc("at_motor", "at the motor", "J*", "kg m²",
             "=[own]/[to]^2", [j / m.ratio_to(k) ** 2 for k, j in enumerate(own, 1)], source="J_k/i_k², without losses"),
        constant("end", "the load's (1)", "", "", [0] * rows + [1]),
    )  # fmt: skip
