"""Motor and reducer of a drive: by name from the sheet Catalogue, or as entered; one entry decides, the name."""

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from engine.drive import Motor, derating
from engine.drive.limits import ReducerLimits
from engine.drive.motor import TorqueFall
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Quantity
from workbook.entries.facts import entry_cells, table_of
from workbook.fields.texts import place_of
from workbook.fields.units import KG_CM2, KW, PER_HOUR, RPM, shown, si
from workbook.machines.machine.drive_entries import NEEDED, UNTOLD, AxisMotor, Reducer
from workbook.machines.machine.entries import Axis
from workbook.selection.catalogue import FULL_CYCLES, MotorRow, ReducerRow
from workbook.selection.entries import Limits, Products

if TYPE_CHECKING:
    from workbook.machines.machine.drive.driven import Driven

CELLS = cell_tables(__file__)

P = TypeVar("P", MotorRow, ReducerRow)
LISTED: dict[str, tuple[type[MotorRow | ReducerRow], tuple[str, ...]]] = {
    "motor": (MotorRow, ("inertia", "stall", "rated", "nn", "peak", "nmax", "pcu")),
    "reducer": (ReducerRow, ("i", "eta", "inertia", "t012", "tmax", "full", "fs", "t2n", "nmax")),
}
"""by product, the columns of its catalogue that a drive reads"""
IN_USE = formulas_by_row(__file__, "in use")
"""products, the cells of their figures in use, and these figures; limits are over their reserves"""
UNITS = {"inertia": KG_CM2}  # of these cells, where not that of the figures


def find_product(rows: Sequence[P], name: str) -> tuple[int, P | None]:
    """Return the row, from 1, of the product of a name, and the product; 0 and None where nothing is named."""
    place = place_of(name, [row.name for row in rows])
    return place + 1, rows[place] if place >= 0 else None


class MotorInUse(NamedTuple):
    """The motor that a drive has, in the units of entries but for its inertia, in kg m²; 0 of what is not given.

    ``losses`` are those of its winding at the rated torque, in kW; ``copper`` over the square of the torque (W/(Nm)²).
    """

    row: int
    inertia: float
    rated_torque: float
    peak_torque: float
    max_speed: float
    stall_torque: float
    rated_speed: float
    rated_given: float
    losses: float
    copper: float
    shaft: float = 0.0
    known_mass: float = 0.0

    @property
    def motor(self) -> Motor:
        """The engine's motor."""
        fastest, rated = si(self.max_speed, RPM), si(self.rated_speed, RPM)
        return Motor(self.inertia, self.rated_torque, self.peak_torque, fastest, self.stall_torque, rated)


class ReducerInUse(NamedTuple):
    """The reducer that a drive has, in the units of entries but for its inertia, in kg m²; a limit of 0 is none."""

    row: int
    ratio: float
    efficiency: float
    inertia: float
    no_load_torque: float
    peak_torque: float
    full_cycles: float
    cycle_factor: float
    mean_torque: float
    max_speed: float
    hub: float = 0.0
    known_mass: float = 0.0

    @property
    def limits(self) -> ReducerLimits:
        """The limits of the reducer, infinite where none is entered."""
        peak, mean, fastest = (limit or math.inf for limit in (self.peak_torque, self.mean_torque, self.max_speed))
        full = si(self.full_cycles or FULL_CYCLES, PER_HOUR)
        return ReducerLimits(peak, mean, si(fastest, RPM), full, self.cycle_factor)


def motor_in_use(axis: Axis, products: Products, limits: Limits) -> MotorInUse:
    """Return the motor of an axis, its limits over their reserves. Raises ValueError where it has none."""
    if axis.motor is None:
        raise ValueError(f"{axis.name} has no motor")
    row, found = find_product(products.motors, axis.motor.name)
    given, left = found or axis.motor, left_of(axis.motor)
    inertia, rated, peak, fastest = (float(getattr(given, name)) for name in NEEDED)
    lasting = left / limits.rms_reserve
    stall = max(rated, given.stall_torque or 0.0) * lasting
    speed = given.rated_speed or 0.0
    own = axis.motor.copper_losses
    losses = (given.copper_losses if own is None else own) or 0.0
    highest = rated * lasting, peak / limits.peak_reserve, fastest / limits.speed_reserve
    used = *highest, stall, speed or fastest, speed
    built = (found.shaft or 0.0, found.mass or 0.0) if found else ()
    return MotorInUse(row, si(inertia, KG_CM2), *used, losses, si(losses, KW) / rated**2, *built)


def falling_of(name: str, products: Products, reserve: float) -> TorqueFall:
    """Return how the peak torque of a motor of the catalogue falls, over its reserve; of one entered, not at all."""
    _, found = find_product(products.motors, name)
    if found is None or found.full_torque_to is None or found.end_torque is None:
        return TorqueFall()
    knee, fastest = si(found.full_torque_to, RPM), si(found.max_speed, RPM)
    return TorqueFall.between((knee, found.peak_torque / reserve), (fastest, found.end_torque / reserve))


def left_of(motor: AxisMotor) -> float:
    """Return the share of its rated torque that a motor can give at the temperature around it."""
    if motor.temperature is None:
        return 1.0
    return derating(motor.temperature, motor.limit, motor.rated_at)


def reducer_in_use(axis: Axis, products: Products, limits: Limits) -> ReducerInUse:
    """Return the reducer of an axis, its peak torque over the factor; one of ratio 1 where nothing is entered."""
    row, found = find_product(products.reducers, axis.reducer.name)
    given, used = axis.reducer, found or axis.reducer
    ratio, peak = (found.reduction, found.max_torque) if found else (given.ratio, given.peak_torque)
    return ReducerInUse(
        row,
        ratio,
        used.efficiency,
        si(used.inertia or 0.0, KG_CM2),
        used.no_load_torque or 0.0,
        (peak or 0.0) / limits.torque_factor,
        used.full_cycles or 0.0,
        used.cycle_factor or 1.0,
        used.mean_torque or 0.0,
        used.max_speed or 0.0,
        *((found.hub or 0.0, found.mass or 0.0) if found else ()),
    )


def entries(driven: "Driven", key: str) -> list[Quantity]:
    """Return the entries of motor and reducer, grey where the catalogue's figures count, and of the limits."""
    cell, axis = CELLS["entries"], driven.entered
    rows = list[Quantity]()
    products: dict[str, AxisMotor | Reducer] = {"motor": driven.entered_motor, "reducer": axis.reducer}
    for kind, entered in products.items():
        parts = {"kind": kind, "product": kind.capitalize(), "key": key}
        rows.append(cell("@{kind}_name", entered.name or None, **parts))
        figures = entry_cells(entered, f"{key}.{kind}")
        rows += [q._replace(grey=f"@{kind}_row>0") if q.name.startswith("@own_") else q for q in figures]
    return [*rows, *entry_cells(axis.limits, f"{key}.limits")]


def catalogue_figures(driven: "Driven") -> Iterator[Quantity]:
    """Yield the catalogue's figures of motor and reducer, where a product is named."""
    listed: dict[str, tuple[Sequence[MotorRow | ReducerRow], int]] = {
        "motor": (driven.products.motors, driven.motor_used.row),
        "reducer": (driven.products.reducers, driven.reducer.row),
    }
    for kind, (model, columns) in LISTED.items():
        products, row = listed[kind]
        product = products[row - 1] if row else None
        for column in columns:
            figure = getattr(product, table_of(model)[column].texts["key"]) or 0.0 if product else ""
            yield CELLS["catalogue"]("@listed_{kind}_{column}", figure, kind=kind, column=column)


def figures(driven: "Driven") -> list[Quantity]:
    """Return the figures of motor and reducer: of the catalogue, in use, and the limits, over their reserves."""
    motor, reducer, limits = driven.motor_used, driven.reducer, driven.limits
    cell, lasting = CELLS["figures"], driven.left / limits.rms_reserve
    values = {
        "@stall": motor.stall_torque / lasting,
        "@rated": motor.rated_torque / lasting,
        "@nn_given": motor.rated_given,
        "@peak": motor.peak_torque * limits.peak_reserve,
        "@nmax": motor.max_speed * limits.speed_reserve,
        "@losses": motor.losses,
        "@copper": shown(motor.copper, KW),
        "@derate": driven.left,
        "@reducer_rated": reducer.peak_torque * limits.torque_factor,
        "@mean_most": reducer.mean_torque,
        "@input_most": reducer.max_speed,
    }
    values |= {f"@{name}": getattr(limits, name) for name in Limits.model_fields}
    used = {"motor": motor, "reducer": reducer}
    for product, name, figure in zip(*IN_USE.values(), strict=True):
        values[f"@{name}"] = shown(getattr(used[product], figure), UNITS.get(figure, 1.0))
    return [*catalogue_figures(driven), *(cell(name, values[name]) for name in cell)]


HOT = 'ROUND(MAX(@temperature,@rated_at),9)&" °C; expected less than the limit, "&ROUND(@winding,9)&" °C"'


def checks(called: str) -> list[Quantity]:
    """Return the checks that the motor is named, or entered, and cooler than its winding may get."""
    cell = CELLS["checks"].sharing(called=called)
    return [cell("@ok_told", True, untold=UNTOLD), cell("@ok_cool", True, says=HOT)]
