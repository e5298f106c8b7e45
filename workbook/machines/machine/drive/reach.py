"""Whether a mechanism can be, and reaches every position of its axis: by row and amount, in cells."""

from itertools import pairwise

from engine.drive.mechanisms.variable_ratio import Linkage
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import amount, as_shown, figure
from workbook.book.sentence import as_shown_formula as rounding
from workbook.fields.types import DesignError
from workbook.fields.units import MM, shown
from workbook.law_sheets.library import laws
from workbook.machines.machine.drive.driven import FALLS, changing_ratio
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.mechanism import UNSIZED, MechanismEntry, Table
from workbook.machines.machine.view import MovingAxis, moving_axes

CELLS = cell_tables(__file__)

WORDS = " reaches {} {}, {} {} beyond the {}"


def reach_table(sheet: Sheet, view: DriveView, linkage: Linkage) -> None:
    """Declare by how much each phase leaves the reach."""
    i, axis, n = view.driven.number, view.driven.axis, view.tables.rows
    reaches = [axis.motion.reaches[k] for k in axis.entered]
    low, high, *ends = linkage.reach
    unit, size, named = axis.base, axis.motion.size(0), LINKAGES[view.driven.given.kind].ends
    sheet.rows(
        *(
            CELLS["reach_table"]("@{which}_end", name, which=which, label=label, named=named[which])
            for which, label, name in zip(("low", "high"), ("Lowest", "Highest"), ends, strict=True)
        )
    )

    def of(name: str) -> str:
        return f"=IF(INDEX([axis{i}_taken.span],[k])>0,INDEX([axis{i}_steps.{name}],2*[k]),(@low+@high)/2)"

    shows = "*1000" if view.driven.travels else "*180/PI()"
    place, end = (f"IF([under]>=[over],{both})" for both in ("[low],[high]", "@low_end,@high_end"))
    by, mm = rounding(f"MAX(0,[under],[over]){shows}"), view.driven.entered.unit
    says = f'=IF([out]=0,"",[k]&" reaches "&ROUND({place}{shows},9)&" {mm}, "&{by}&" {mm} beyond the "&{end})'
    lows, highs = (filled([reach[k] for reach in reaches], n, (low + high) / 2) for k in (0, 1))
    under, over = [low - end for end in lows], [end - high for end in highs]
    sheet.row += 1
    cell = CELLS["reach"]
    cell.place(
        sheet,
        cell("low", lows, unit=unit, formula=of("low"), scale=size),
        cell("high", highs, unit=unit, formula=of("high"), scale=size),
        cell("under", under, unit=unit, scale=size),
        cell("over", over, unit=unit, scale=size),
        cell("out", 0),
        cell("says", "", formula=says),
    )


def linkage_checks(view: DriveView) -> list[Quantity]:
    """Return the checks of a mechanism whose ratio changes: its sizes, its reach, and that its axis comes back."""
    driven, i, motion = view.driven, view.driven.number, view.driven.axis.motion
    page = LINKAGES[driven.given.kind]
    says = f'[axes.name.{i}]&" row "&INDEX([@reach.says],MATCH(1,[@reach.out],0))'
    travel, ends_at = f"[axes.travel.{i}]", shown(motion.lifts_sum, driven.axis.unit)
    stops = amount(travel, ends_at, "it ends ", f" {driven.entered.unit} from where it begins")
    cell = CELLS["linkage_checks"].sharing(**view.parts)
    return [
        cell("@ok_sized", True, sized=page.sized, unsized=UNSIZED),
        cell("@ok_linked", True, fits=page.fits, holds=page.holds, says=page.wrong),
        cell("@ok_reach", True, within=page.within, says=says),
        cell("@ok_back", motion.closes, says=stops),
    ]


def size_fault(given: MechanismEntry, unit: str) -> str:
    """Return the fault of sizes that do not go together; of a table, the first point that does not rise."""
    if isinstance(given, Table):
        for row, (before, other) in enumerate(pairwise(given.points), 2):
            if other.angle <= before.angle or other.position <= before.position:
                (angle, position), (low, lowest) = ((figure(p.angle), figure(p.position)) for p in (other, before))
                return FALLS.format(row, angle, position, unit, low, lowest, unit)
        return ""
    try:
        _ = changing_ratio(given, MM)
    except ValueError:
        return given.APART
    return ""


def require_mechanisms(machine: AnyMachine) -> None:
    """Raise DesignError for a mechanism that cannot be, or for the first phase that leaves its reach."""
    if not any(axis.mechanism and axis.mechanism.LARGE for axis in machine.axes):
        return
    for axis in moving_axes(machine, laws(machine.laws)):
        given = axis.given.mechanism
        if given is None or not given.LARGE:
            continue
        where, large = f"axes.{axis.number - 1}.mechanism", given.model_dump() | given.LARGE
        if problem := size_fault(given, axis.given.unit):
            raise DesignError(where, problem, large)
        linkage = changing_ratio(given, axis.unit)
        if isinstance(linkage, Linkage) and (problem := beyond_reach(axis, linkage)):
            raise DesignError(where, problem, large)


def beyond_reach(axis: MovingAxis, linkage: Linkage) -> str:
    """Return in words by how much the first phase that leaves a mechanism's reach does so; nothing if none does."""
    for row, k in enumerate(axis.entered, 1):
        errors = [error for y in axis.motion.reaches[k] if (error := linkage.beyond(y))]
        if errors:
            farthest, unit = max(errors, key=lambda error: error.by), axis.given.unit
            place, by = (shown(value, axis.unit) for value in (farthest.position, farthest.by))
            return f"{axis.given.name} row {row}" + WORDS.format(figure(place), unit, as_shown(by), unit, farthest.end)
    return ""
