"""Catalogues of motors and reducers as CSV: one product a line, figures in the units that the column heads name."""

import csv
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

import workbook
from workbook.entries import rules
from workbook.entries.design import numbers_of
from workbook.entries.types import EntryError
from workbook.errors import InputError, ReadError
from workbook.intake import read_text
from workbook.selection.catalogue import MotorRow, ReducerRow
from workbook.visible import found

Row = TypeVar("Row", MotorRow, ReducerRow)
Product = dict[str, Any]
"""what a line of a catalogue says of a product, by entry"""
FOLDER = Path(workbook.__file__).parent.parent.joinpath("templates")
MOTORS, REDUCERS = "motors.csv", "reducers.csv"
TEXTS = ("name", "source")
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")  # Python takes 1_000 and ١٢ too
MOTOR_COLUMNS = {
    "name": "name", "inertia_kgcm2": "inertia", "stall_torque_Nm": "stall_torque", "rated_torque_Nm": "rated_torque",
    "rated_speed_rpm": "rated_speed", "peak_torque_Nm": "peak_torque", "max_speed_rpm": "max_speed",
    "full_torque_to_rpm": "full_torque_to", "torque_at_max_speed_Nm": "end_torque",
    "copper_losses_kW": "copper_losses", "mass_kg": "mass", "cost": "cost", "source": "source",
}  # fmt: skip
REDUCER_COLUMNS = {
    "name": "name", "reduction": "reduction", "efficiency": "efficiency", "inertia_at_input_kgcm2": "inertia",
    "no_load_torque_Nm": "no_load_torque", "max_input_speed_rpm": "max_speed", "max_output_torque_Nm": "max_torque",
    "full_torque_to_cycles_per_h": "full_cycles", "factor_beyond": "cycle_factor",
    "max_mean_torque_Nm": "mean_torque", "mass_kg": "mass", "cost": "cost", "source": "source",
}  # fmt: skip


def read_motors(path: Path) -> list[Product]:
    """Read the entries of a catalogue of motors; raise ReadError, or InputError with a line for each fault."""
    return read(path, MotorRow, MOTOR_COLUMNS)


def read_reducers(path: Path) -> list[Product]:
    """Read the entries of a catalogue of reducers; raise ReadError, or InputError with a line for each fault."""
    return read(path, ReducerRow, REDUCER_COLUMNS)


@cache
def committed_motors() -> list[MotorRow]:
    """Return the motors that come with the templates."""
    return [MotorRow.model_validate(product) for product in read_motors(FOLDER.joinpath(MOTORS))]


@cache
def committed_reducers() -> list[ReducerRow]:
    """Return the reducers that come with the templates."""
    return [ReducerRow.model_validate(product) for product in read_reducers(FOLDER.joinpath(REDUCERS))]


def read(path: Path, model: type[Row], columns: dict[str, str]) -> list[Product]:
    """Read the rows of a CSV file: commas, or semicolons with commas in the numbers.

    A number beyond its bounds, or one that is missing, is an unfinished design's: it is given as it is.
    """
    lines = read_text(path, "a catalogue, a .csv file").splitlines()
    if not lines:
        raise ReadError(f"{path}: the file is empty; expected a head of {', '.join(columns)}")
    separator = ";" if ";" in lines[0] else ","
    table = csv.reader(lines, delimiter=separator)
    faults: list[str] = []
    try:
        head = [cell.strip() for cell in next(table)]
        require_head(path, head, model, columns)
        rows = list(parse(path, table, head, separator, model, columns, faults))
    except csv.Error as error:
        raise ReadError(f"{path}: line {table.line_num}: {error}; expected a catalogue, a .csv file") from error
    if faults:
        raise InputError(faults)
    if not rows:
        raise ReadError(f"{path}: there is no product below the head; expected one a line")
    return rows


def require_head(path: Path, head: list[str], model: type[Row], columns: dict[str, str]) -> None:
    """Raise InputError for a column that is unknown, given twice, or needed and missing."""
    unknown = [name for name in head if name not in columns]
    twice = [name for name in dict.fromkeys(head) if name in columns and head.count(name) > 1]
    needed = [name for name, entry in columns.items() if model.model_fields[entry].is_required()]
    missing = [name for name in needed if name not in head]
    faults = [f"unknown column {found(unknown[0])}{others(unknown)}"] if unknown else []
    faults += [f"column {name} stands there twice" for name in twice]
    faults += [f"column {missing[0]} is missing{others(missing)}"] if missing else []
    if faults:
        raise InputError([f"{path}: line 1: {'; '.join(faults)}; expected one of {', '.join(columns)} in each column"])


def others(found: list[str]) -> str:
    """Return how many more there are than the first."""
    return f" and {len(found) - 1:,} more" if len(found) > 1 else ""


def parse(
    path: Path, table: Any, head: list[str], separator: str, model: type[Row], columns: dict[str, str],
    faults: list[str],
) -> Iterator[Product]:  # fmt: skip
    """Yield what each line says; enter in ``faults`` what is of no use, whatever other numbers would be."""
    names = {entry: column for column, entry in columns.items()}
    for cells in table:
        if not any(cell.strip() for cell in cells):
            continue
        where = f"{path}: line {table.line_num}"
        if len(cells) > len(head):
            faults.append(f"{where}: {len(cells)} cells; expected {len(head)}, as in the head")
            continue
        filled = zip(head, cells, strict=False)  # cells at the end may be missing
        given = {columns[name]: value(cell.strip(), columns[name], separator) for name, cell in filled}
        given = {entry: cell for entry, cell in given.items() if cell is not None}
        try:
            model.model_validate(given)
        except ValidationError as error:
            told = error.errors(include_url=False)
            faults += [f"{where}, {line_of(fault, model, names)}" for fault in told if numbers_of(fault, model) is None]
        yield given


def value(cell: str, entry: str, separator: str) -> Any:
    """Return what a cell holds: nothing, a text, or a number; what is no number stays a text, which no rule takes."""
    if not cell or entry in TEXTS:
        return cell or None
    text = cell.replace(",", ".") if separator == ";" else cell
    return float(text) if NUMBER.fullmatch(text) else cell


def line_of(fault: Any, model: type[Row], names: dict[str, str]) -> str:
    """Return the column, what was found, what is expected."""
    cause = fault.get("ctx", {}).get("error")
    entry = str(fault["loc"][0])
    if isinstance(cause, EntryError):
        return f"column {names[cause.field or entry]}: {cause}"
    expected = rules.expectation(*rules.field_at(model, entry))
    what = "empty" if fault["type"] == "missing" else f"found {found(fault['input'])}"
    return f"column {names[entry]}: {what}; expected {expected}"
