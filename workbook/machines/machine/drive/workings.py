"""The workings of a drive's sheet: the chain in S1's terms, peaks over the cycle, and where it turns round.

A peak is the largest at a point, or where the parabola through that and its neighbours has its top: there the drive is
worked out once more. Where a piece's acceleration only rises or only falls, torques of a constant ratio are largest at
a point itself. Inside a piece of its motion the drive may turn round: friction and losses change sides there.
"""

import numpy as np

from engine.drive.chain import held_factor
from engine.drive.drive_points import Peak
from engine.drive.mechanisms.by_angle import Arm
from engine.drive.quadrature import STANDSTILL
from engine.drive.turning import PARTS
from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.cell_tables import CellTable, cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import LEAST, NOT_ZERO, filled
from workbook.book.sentence import CheckSentence, sentence_formula
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, shown
from workbook.machines.machine.boundary.curves import BENT_FROM, bends_name
from workbook.machines.machine.drive import torques
from workbook.machines.machine.drive.entered import on_shaft
from workbook.machines.machine.drive.peaks import PEAK_UNITS, Key
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.mechanism import BELTED, SCREWS
from workbook.motion.pieces import FROM_START, arguments, at_place, sine_arguments

CELLS = cell_tables(__file__)
PEAK_NAMES = {"T": "motor torque", "S": "output torque", "P": "motor power", "n": "motor speed"}
FULL = "turns round {} times inside pieces and is cut at {}; build with larger sizes.turns and sizes.motion_pieces"
PARABOLA = ("y0", "y", "y1", "a", "b", "s0", "s1")  # the columns of a parabola


def losses(view: DriveView) -> list[Quantity]:
    """Return the rows of the factors of losses: where the load drives, and at rest; of a constant ratio by force."""
    cell = CELLS["losses"]
    driven = view.driven
    reducer, *_, mechanism = driven.mechanism.stages
    document = driven.given.method == "document"
    back = 1.0 / mechanism.efficiency if document else driven.back_efficiency
    held = 1.0 / mechanism.efficiency if document else held_factor(mechanism.efficiency, driven.back_efficiency)
    entered = "2-1/@eta2" if driven.given.kind in SCREWS else "@eta2"  # where none is
    base, i2, faster = driven.axis.base, mechanism.ratio, driven.axis.speed / view.tables.axis.speed
    force, unit = ("N", "m") if base == "m" else ("Nm", "")
    by_force = (
        []
        if view.varies
        else [
            cell("@out2", 1.0 / mechanism.efficiency / i2, force=force, unit=unit),
            cell("@in2", back / i2, unit=unit, scale=1.0 / i2),
            cell("@held2", held / i2, unit=unit),
            cell("@j1i2", driven.mechanism.on_shaft(driven.mechanism.last - 1) * i2, base=base),
            cell("@j0i", driven.at_motor * driven.mechanism.ratio, base=base),
            cell("@spin", shown(driven.mechanism.ratio * faster, KW), base=base),
        ]
    )
    return [
        cell("@out1", 1.0 / reducer.efficiency / reducer.ratio),
        cell("@in1", (1.0 / reducer.efficiency if document else reducer.efficiency) / reducer.ratio),
        cell("@brake", int(driven.holding == "brake")),
        *(torques.brake_workings(view) if view.brakes else ()),
        cell("@back2", back, entered=entered, scale=1.0),
        cell("@hold2", held),
        *by_force,
    ]


def by_travel(view: DriveView) -> str:
    """Return the end of a formula that is multiplied by the load's largest travel over the shaft's angle."""
    if view.slides:
        return "*MAX(MAX([@pt.dx]),0-MIN([@pt.dx]))"
    return "/MIN([@pt.g])" if view.varies else "/@i2"


def inertias(view: DriveView, sizes: list[Quantity]) -> list[Quantity]:
    """Return the rows of the moved mass or inertia, the sizes of the mechanism, and the inertias on both shafts."""
    cell = CELLS["inertias"]
    driven, m, travels = view.driven, view.driven.mechanism, view.driven.travels
    own, moved, by = m.on_shaft(m.last - 1), m.on_shaft(m.last), by_travel(view)
    if travels:
        mass = "@mass+@belt_mass" if driven.given.kind in BELTED else "@mass+0"
        load = CELLS["load that travels"]("@m", moved, mass=mass)
    else:
        load = CELLS["load that turns"]("@m", moved)
    on_it = own + moved * view.travel**2
    of_load = "m (dx/dψ)²" if view.slides else "m/φ'²"
    largest = ", the largest" if driven.train.inertia_varies else ""
    return [
        load,
        *sizes,
        cell("@tau", 1.0 / m.stages[0].ratio),
        cell("@j0", driven.at_motor, on_shaft=on_shaft("motor")),
        cell("@j1", own, on_shaft=on_shaft("mechanism"), own=torques.own(driven)),
        cell("@j_shaft", on_it, by_travel=by, of_load=of_load, largest=largest),
    ]


def resisting(view: DriveView) -> list[Quantity]:
    """Return the rows of the constant load force and of friction."""
    load, size = view.driven.load, view.scales.force
    if view.driven.travels:
        cell = CELLS["load that travels"].sharing(size=size)
        pressing, symbol = ("(@mass+@belt_on_bed)", "(m + m_bed)") if view.driven.has_bed else ("@mass", "m")
        friction = cell("@rub", load.friction, pressing=pressing, pressing_symbol=symbol)
    else:
        cell = CELLS["load that turns"]
        friction = cell("@rub", load.friction, scale=size)
    torque = CELLS["torque"]("@cr", load.torque * view.travel, by_travel=by_travel(view), scale=view.scales.behind)
    return [cell("@steady", load.torque, scale=size), torque, friction]


def workings(sheet: Sheet, view: DriveView, sizes: list[Quantity]) -> None:
    """Declare ratios, inertias, losses and resisting forces, in S1's terms."""
    cell = CELLS["workings"].sharing(**view.parts)
    driven, tables, axis = view.driven, view.tables, view.driven.axis
    still = STANDSTILL * driven.max_geometric_velocity * axis.speed
    cell.begin(sheet)
    sheet.rows(
        cell("@faster", shown(axis.speed, tables.axis.speed)),
        cell("@omega", axis.speed, speed=tables.machine.over.speed),
        *inertias(view, sizes),
        *losses(view),
        *(torques.stage_workings(view) if driven.entered.stages else ()),
        *resisting(view),
        cell("@vmax", driven.max_geometric_velocity),
        cell("@amax", axis.max_acceleration),
        cell("@still", still, scale=max(still, 1e-12)),
        *([cell("@arm", driven.by_angle.moment)] if isinstance(driven.by_angle, Arm) else []),
    )


def peaks_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the peaks, a row for the highest and one for the lowest of each quantity; of speeds, two rows each."""
    found, last = view.peaks.beside_points, view.rows * POINTS
    first = {key: number for number, key in enumerate(found, 1)}
    elsewhere = [f"([@pt.iv]<>[@tops.iv.{first[name, way, 1]}])*" * (rank - 1) for name, way, rank in found]
    at = np.array([peak.at for peak in found.values()])
    near = zip(found, (at[:, None] + (-1, 0, 1)).clip(0, view.load.x.size - 1), strict=True)
    values = [shown(view.peaks.upward(name, 1).flat[k], PEAK_UNITS[name]) for (name, *_), k in near]
    size = max(sizes_of(view)[name] for name, *_ in found)
    columns = [f"[@pt.{name}]" for name, *_ in found]
    cell = CELLS["peaks"].sharing(column=columns, elsewhere=elsewhere, size=size, last=last)
    cell.begin(sheet)
    cell.place(
        sheet,
        cell("what", [peak_name(key, " elsewhere") for key in found]),
        cell("sign", [way for _, way, _ in found]),
        cell("most", [shown(peak.values[1], PEAK_UNITS[name]) for (name, *_), peak in found.items()]),
        cell("at", (at + 1).tolist(), beyond=last + 1),
        *parabolas(cell, values, list(found.values())),
        cell("place", shown(view.at_peaks.load.x.ravel()[: len(found)], DEGREE).tolist()),
    )


def again_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the second look at torques and powers, beside the tops of the first parabolas."""
    beside, found, numbers = view.peaks.beside_points, view.peaks.again, view.peaks.rows
    first = [(name, way, 1) for name, way, _ in found]
    rows = [numbers[key] for key in first]
    units = [PEAK_UNITS[name] for name, *_ in first]
    each = zip(first, found.values(), units, strict=True)
    values = [shown(way * np.array(peak.values), unit) for (_, way, _), peak, unit in each]
    at = [f"INDEX([@pt.theta],[@peaks.at.{row}])" for row in rows]
    size = max(sizes_of(view)[name] for name, *_ in first)
    cell = CELLS["again"].sharing(row=rows, column=[name for name, *_ in first], at=at, size=size)
    cell.place(
        sheet,
        cell("what", [peak_name(key, " again") for key in found]),
        cell("sign", [way for _, way, _ in found]),
        cell("off", [shown(beside[key].second_offset, DEGREE) for key in first]),
        *parabolas(cell, values, list(found.values())),
        cell("place", shown(view.at_peaks.load.x.ravel()[-len(found) :], DEGREE).tolist()),
    )


def parabolas(cell: CellTable, values: list[Array], found: list[Peak]) -> list[Quantity]:
    """Return the columns of parabolas: three values each in the unit of the sheet, the gaps between, the slopes."""
    gaps = shown(np.array([(peak.before, peak.after) for peak in found]), DEGREE)
    slopes = np.divide(np.diff(values), gaps, out=np.zeros(gaps.shape), where=gaps > 0.0)
    columns = np.column_stack([values, gaps, slopes]).T.tolist()
    return [cell(name, column) for name, column in zip(PARABOLA, columns, strict=True)]


def peak_name(key: Key, more: str) -> str:
    """Return the name of a row of peaks; behind rows of rank 2 stands more."""
    name, way, rank = key
    return f"{PEAK_NAMES[name]}, {'highest' if way > 0 else 'lowest'}{more * (rank - 1)}"


def sizes_of(view: DriveView) -> dict[str, float]:
    """Return the scales of the quantities whose peaks are sought."""
    scales = view.scales
    return {"T": scales.torque, "S": scales.behind, "P": scales.power, "n": scales.rpm}


def turns_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the places at which the motion turns round inside a piece."""
    turns = len(view.tables.turns)
    room, at, ends = view.turn_rows, view.tables.pieces.at, view.tables.ends
    bends = f'-2*COUNTIF([{bends_name(ends)}.mode],">={BENT_FROM}")' if ends else ""
    left = f"[{at.pieces}.r.last]-{at.count}-2*COUNT([@windows.start]){bends}"  # intervals, for turns
    cell = CELLS["counts"]
    cell.begin(sheet)
    sheet.rows(
        cell("@turned", turns, axis_turns=view.tables.moves),
        cell("@cut", view.turns_cut, room=room, left=left),
    )
    sheet.row += 1
    CELLS["turns"].place(sheet, *turn_columns(view), blank="[k]>@turned")


def turn_columns(view: DriveView) -> list[Quantity]:
    """Return the columns of the turns: the place beside each, the velocities there, and where the motion turns."""
    cell = CELLS["turns"]
    of, turns, rows, room = view.tables.moves, view.turns, view.tables.pieces, view.turn_rows
    size, spare = view.driven.axis.motion.size, rows.pieces[0]
    pieces = filled([rows.pieces[turn.piece] for turn in turns], room, spare)
    u = np.array(filled([turn.u for turn in turns], room, 0.0))
    v, a, j = (
        filled([getattr(turn, name) for turn in turns], room, float(curve(0.0)))
        for name, curve in zip(("velocity", "acceleration", "jerk"), spare.curves[1:], strict=True)
    )
    at = filled([shown(turn.at, DEGREE) for turn in turns[: view.turns_cut]], room, TURN)
    return [
        cell("q", filled([turn.piece + 1 for turn in turns], room, 1), axis_turns=of),
        cell("again", filled([int(turn.again) for turn in turns], room)),
        cell("after", filled([turn.after for turn in turns], room), axis_turns=of),
        cell("s", filled([turn.share for turn in turns], room), axis_turns=of, half=0.5 / PARTS),
        cell("u", u + LEAST, pieces=rows.at.pieces, not_zero=NOT_ZERO, source=FROM_START),
        *arguments(rows, "", "[q]", sine_arguments(pieces, u)),
        *(
            cell(name, values, unit=rows.at.unit(order), there=at_place(rows, order, "", "[q]"), scale=size(order))
            for order, (name, values) in enumerate((("v", v), ("a", a), ("j", j)), 1)
        ),
        cell("at", at, begin=rows.at.named("at")),
    ]


def turns_check(view: DriveView) -> Quantity:
    """Return the check that the drive is cut wherever it turns round."""
    cell = CELLS["turns_check"].sharing(**view.parts)
    count, cut = len(view.tables.turns), view.turns_cut
    says = CheckSentence(sentence_formula(FULL, "@turned", "@cut"), FULL.format(count, cut))
    return cell("@ok_turned", count == cut, says=says)
