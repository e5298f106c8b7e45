"""Any machine: laws, and the timing diagram of 1 to 24 axes at a single rate, or over any abscissa."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from engine.cams.interpolation import FunctionValues, compose_profile
from engine.motion.profile import CamProfile, profile_of_motion
from engine.timing import Switch
from workbook.book.address import Address
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import group_verdict_column, summary
from workbook.book.declare import FIRST, Book, Quantity, Text
from workbook.book.public_names import names_in, names_sheet, place_names
from workbook.book.sentence import NOTHING, Sentence
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.fields.texts import place_of
from workbook.fields.units import DEGREE, shown
from workbook.law_sheets.library import laws
from workbook.machines.machine import first_sheet, live
from workbook.machines.machine.axes import axes_of, drive_of, laws_of
from workbook.machines.machine.backlash import backlash_sheet, sides_of
from workbook.machines.machine.clearances import clearances_sheet
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.reach import require_mechanisms
from workbook.machines.machine.drive.reducer_load import shaft_of
from workbook.machines.machine.drive.sheet import drive_sheet
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.entries_beside import ClearanceEntry
from workbook.machines.machine.exact import judgement
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.motion_tables import pieces_sheet
from workbook.machines.machine.power import Mains, power_sheet, supply
from workbook.machines.machine.studies import changes
from workbook.machines.machine.studies.results import SCALING
from workbook.machines.machine.switches import switches_sheet
from workbook.machines.machine.timing.cycle import cycle_sheet, exportable
from workbook.machines.machine.timing.sheet import timing_sheet
from workbook.machines.machine.variations import variants
from workbook.machines.machine.vibration import swings_of, vibration_sheet
from workbook.machines.machine.view import MachineView, MovingAxis, moving_axes
from workbook.motion.exported import export_sheet
from workbook.selection.page import catalogue_sheet, selection_sheet
from workbook.selection.pair_selection import PairSelection
from workbook.template import Template, finish
from workbook.template_outputs import CamAxis, CamSwitch

CELLS = cell_tables(__file__)


def declare(given: AnyMachine) -> Book:
    """Declare the book."""
    # a table of contents: a line or two for each sheet, some of them only where there are drives
    book_laws = laws_of(given)
    rows = axes_of(given, book_laws)
    machine = MachineView(given, [row.axis for row in rows])
    book = Book(given.template, given.title, limit=limits(type(given)), print_also=given.print_also)
    drives = {row.axis.number: view for row in rows if (view := drive_of(row))}
    bus = Mains(list(drives.values()), given.power) if drives else None
    abscissa = machine.over
    over = f"a cycle in {abscissa.unit}" if abscissa.measured else "one master shaft, at one rate"
    results, says = pace(machine), NOTHING
    if bus:
        rates = first_sheet.whole_range(drives.values())
        results += [*first_sheet.range_of_rates(rates, len(rows), machine.over), *supply(bus)]
        says = first_sheet.rates_in_words(rates)
        results.append(first_sheet.rate_check(rates.rates, given.per_minute))
    gaps = [ClearanceView(clearance, k, rows) for k, clearance in enumerate(given.clearances, 1)]
    results += first_sheet.least_gap(gaps)
    names = {f"about_{name}" for name in FIGURES.split()}
    figures = [q for q in results if q.name in names]
    more = [q for q in results if q.name not in names]
    sheet = summary_sheet(book, given, f"A machine: the motions of its axes over {over}.", figures, more)
    first_sheet.axes_summary(sheet, machine, drives)
    first_sheet.gaps_summary(sheet, gaps)
    timing_sheet(book, machine, rows)
    switches_sheet(book, machine)
    book.name("axes", axis_name="name")
    for view in drives.values():
        named_drive_sheet(book, view)
    clearances_sheet(book, gaps)
    vibration_sheet(book, swings_of(rows))
    backlash_sheet(book, sides_of(drives.values()))
    if bus:
        power_sheet(book, bus)
    if given.selection.axis is not None:
        shafts = [shaft_of(view) for view in drives.values()]
        number = place_of(given.selection.axis, [shaft.name for shaft in shafts])
        selection_sheet(book, PairSelection(given.selection, given.sizes, shafts, number), given.selection.axis)
    catalogue_sheet(book, given.selection, given.sizes)
    entered = (axis.given for axis in machine.axes)
    book_laws.sheets(book, {axis.name: [p.law for p in axis.phases if p.law] for axis in entered})
    for row in rows:
        cycle_sheet(book, machine, row, len(rows) + len(given.switches) - row.axis.number)
    pieces_sheet(book, rows)
    export_sheet(book, given, [exportable(row) for row in rows])
    link_drives(book, drives)
    judge_axes(book, machine.axes, given.laws.names)
    name_figures(book, machine.axes, given.clearances)
    return finish(book, ("S1", "S3", "S4"), says)


def pace(machine: MachineView) -> list[Quantity]:
    """Return the results of how fast the machine goes; where nothing tells that, of how long its cycle is."""
    over, rate = machine.over, machine.given.per_minute
    if not over.timed:
        return [CELLS["pace"]("about_cycle", over.length, over=over, unit=over.unit)]
    return [CELLS["pace"]("about_rate", rate), CELLS["pace 2"]("about_cycle", machine.time)]


FIGURES = "rate highest reached cycle peak bus_year gap gap_of"
"""results that one comes for, large on the first sheet, some with a sentence on why"""
POINTS = {"at": "theta", "T": "T", "n": "n", "P": "P"}


def named_drive_sheet(book: Book, view: DriveView) -> None:
    """Declare the sheet of a drive, with names of the columns that its samples, Power and Selection look up."""
    drive_sheet(book, view)
    i, names = view.driven.number, POINTS | ({"phi": "phi"} if view.varies else {})
    if view.for_selection:
        names |= {"dir": "dir", "al": "al" if view.varies else "a"}
        names["S"] = "Sm" if view.brakes else "S"
    book.name(f"drive{i}_pt", **{f"drive{i}_{name}": column for name, column in names.items()})
    book.name(f"drive{i}_iv", **{f"drive{i}_up": "dir"})  # 1 forwards, -1 backwards


def link_drives(book: Book, drives: Mapping[int, DriveView]) -> None:
    """Link the axes on the first sheet to their drives, and these to their phases and to what they are chosen by."""
    axes, titles = book.blocks["axes_short"], {sheet.title for sheet in book.sheets}
    for i in drives:
        sheet, phases = book.blocks[f"drive{i}_axis"].sheet, book.blocks[f"axis{i}"]
        axes.sheet.texts.append(Text(axes.row + i - 1, axes.column, "", "link", sheet.title))
        sheet.links = {"Timing": Address("", phases.row, phases.column).a1}
        sheet.links |= {title: "A1" for title in ("Selection", "Catalogue") if title in titles}


NAMES = names_in(__file__)


def name_figures(book: Book, axes: Sequence[MovingAxis], clearances: Sequence[ClearanceEntry]) -> None:
    """Declare the sheet Names: public names of the machine, of its axes and of its clearances."""
    sheet = names_sheet(book)
    place_names(sheet, NAMES["Results"], "machine")
    units = {axis.given.name: (axis.given.unit, *axis.over.rates(axis.given.unit)) for axis in axes}
    for axis in axes:
        i, unit = axis.number, units[axis.given.name]
        place_names(sheet, NAMES["Axis"], f"axis{i}", axis.typed.called, i, unit)
    for n, clearance in enumerate(clearances, 1):
        unit = units[clearance.second if clearance.pairs else clearance.first]
        place_names(sheet, NAMES["Clearance"], f"clear{n}", clearance.called, n, unit)


SEVERAL, DWELL = "several", 1
"""what stands for laws that differ, and the number of the dwell, which spare rows have too"""
LAST = "MAX([axis{0}_taken.no])"
OTHERS = f"SUMPRODUCT(([axis{{0}}_taken.no]<>{DWELL})*([axis{{0}}_taken.no]<>{LAST}))>0"
LAW = f'=IF({OTHERS},"{SEVERAL}",IF({LAST}={DWELL},"{first_sheet.NO_DRIVE}",INDEX(law_code,{LAST})))'


def judge_axes(book: Book, axes: Sequence[MovingAxis], names: Sequence[str]) -> None:
    """Declare the law of all movements of an axis, and whether the checks of its phases and its drive hold."""
    block = book.blocks["axes_short"]
    texts, checks, of_phases = [], [], []
    for axis in axes:
        moving = {names.index(phase.law) for phase in axis.given.phases} - {DWELL - 1}
        texts.append(SEVERAL if len(moving) > 1 else names[moving.pop()] if moving else first_sheet.NO_DRIVE)
        own = (f"axis{axis.number}_", f"drive{axis.number}_")
        checks.append([k for k, (_, q) in enumerate(book.checks, 1) if q.name.startswith(own)])
        of_phases.append([k for k in checks[-1] if book.checks[k - 1][1].name.startswith(own[0])])
    block.sheet.workings(
        block,
        "axes_judged",
        "",
        max(block.columns.values()) + 1,
        group_verdict_column(book, "axes_judged", "its checks", checks),
        CELLS["judge_axes"]("law", texts, formula=[LAW.format(axis.number) for axis in axes]),
    )
    for axis, places in zip(axes, of_phases, strict=True):
        phases = book.blocks[f"axis{axis.number}"]
        column = max(phases.columns.values())
        for q, at in zip(phases_verdict(book, axis, places), (column, FIRST + 2), strict=True):
            phases.sheet.put(q, phases.row - 1, at)


def phases_verdict(book: Book, axis: MovingAxis, places: Sequence[int]) -> tuple[Quantity, Quantity]:
    """Return the verdict of an axis' checks, at such places among all; and its group, or which fails and why."""
    name = f"axis{axis.number}_verdict"
    verdict = group_verdict_column(book, name, "its phases", [list(places)])
    before = f"[checks.nth.{places[0] - 1}]" if places[0] > 1 else "0"
    first, facts = f"MATCH({before}+1,[checks.nth],0)", summary(book)
    rows = [(facts.verdicts[k - 1], book.checks[k - 1][1].label, facts.sentences[k - 1]) for k in places]
    failing = [Sentence(f"{label}: {says}") for verdict, label, says in rows if verdict != "OK"]
    says = failing[0] if failing else axis.given.group or ""
    why = CELLS["phases_verdict"]("{name}_says", says, name=name, verdict=name, first=first, i=axis.number)
    return verdict._replace(name=name), why


def axes(machine: AnyMachine) -> list[CamAxis]:
    """Return the axes of a machine as a controller can take them."""
    cam_axes = []
    for axis in moving_axes(machine, laws(machine.laws)):
        given, repeats = axis.given, axis.given.repeats and axis.closes
        cam = CamAxis(given.name, profile(axis, shown(1.0, axis.unit)), machine.over.unit, given.unit, repeats)
        cam_axes.append(replace(cam, shaft=partial(shaft, axis, machine, cam)) if given.motor else cam)
    return cam_axes


def profile(axis: MovingAxis, y: float) -> CamProfile:
    """Return the motion of an axis, ``y`` of its units (m, rad) as a unit, as late as it is entered."""
    unshifted = profile_of_motion(axis.motion).in_units(axis.over.shown(shown(1.0, DEGREE)), y)
    return unshifted.shifted(axis.typed.shift, axis.motion.lifts_sum * y)


def shaft(axis: MovingAxis, machine: AnyMachine, load: CamAxis) -> CamAxis:
    """Return the angle of the motor's shaft of an axis, in degrees: before the reducer, and where its load is at 0, 0.

    Behind a mechanism whose ratio depends on the position, 0 is where that counts its angle from. Raises ValueError
    where the mechanism cannot bring its load to a position.
    """
    driven = Driven(axis, machine)
    if driven.linkage is None:
        return replace(load, profile=profile(axis, shown(driven.mechanism.ratio, DEGREE)), y_unit="°")
    linkage, degrees = driven.linkage, shown(driven.reducer.ratio, DEGREE)
    angle = compose_profile(
        profile(axis, 1.0), lambda y: FunctionValues(*(degrees * each for each in linkage.shaft(y)))
    )
    return replace(load, profile=angle, y_unit="°")


def switches(machine: AnyMachine) -> list[CamSwitch]:
    """Return the switches of a machine, over the degrees of its master shaft, or the seconds of its cycle."""
    over, cam_switches = machine.over, []
    for switch in machine.switches:
        on = tuple(time.ends for time in switch.on if time.ends)
        cam_switches.append(CamSwitch(switch.name, Switch(switch.name, on, over.length), over.unit))
    return cam_switches


TEMPLATE = Template(
    "machine",
    AnyMachine,
    declare,
    variants,
    require_mechanisms,
    axes=axes,
    scaling=SCALING,
    improving=changes,
    live=live,
    judgement=judgement,
    switches=switches,
)
