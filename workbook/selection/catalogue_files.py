"""Catalogues of motors and reducers as CSV: a product a line, figures in the units that the column heads name."""

import csv
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from workbook.entries.design import fault_line, numbers_of
from workbook.entries.facts import facts_of
from workbook.errors import InputError, ReadError, quoted
from workbook.selection.catalogue import MotorRow, ReducerRow
from workbook.text_files import FOLDER, read_text

Row = TypeVar("Row", MotorRow, ReducerRow)
Product = dict[str, Any]  # what a line of a catalogue says of a product, by entry
TEXTS = ("name", "source")
# Python takes 1_000 and ١٢ too
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


@cache
def columns_of(model: type[BaseModel]) -> dict[str, str]:
    """Return the entries of a product by the heads of their columns, as the table of its facts has them."""
    return {words.head: entry for entry, words in facts_of(model).items()}


def read(model: type[Row], path: Path) -> list[Product]:
    """Read the rows of a CSV file: commas, or semicolons with commas in the numbers.

    A number beyond its bounds, or a missing number, is an unfinished design's: it is given as it is. Raises
    ReadError, or InputError with a line for each fault.
    """
    columns = columns_of(model)
    lines = read_text(path, "a catalogue, a .csv file").splitlines()
    if not lines:
        raise ReadError(f"{path}: the file is empty; expected a head of {', '.join(columns)}")
    separator = ";" if ";" in lines[0] else ","
    table = csv.reader(lines, delimiter=separator)
    faults: list[str] = []
    rows: list[Product] = []
    try:
        head = [cell.strip() for cell in next(table)]
        require_head(path, head, model)
        for cells in table:
            where = f"{path}: line {table.line_num}"
            if not any(cell.strip() for cell in cells):
                continue
            if len(cells) > len(head):
                faults.append(f"{where}: {len(cells)} cells; expected {len(head)}, as in the head")
                continue
            rows.append(product_of(head, cells, columns, separator))
            faults += [f"{where}, {problem}" for problem in useless(model, rows[-1])]
    except csv.Error as error:
        raise ReadError(f"{path}: line {table.line_num}: {error}; expected a catalogue, a .csv file") from error
    if faults:
        raise InputError(faults)
    if not rows:
        raise ReadError(f"{path}: there is no product below the head; expected one a line")
    return rows


def product_of(head: Sequence[str], cells: Sequence[str], columns: Mapping[str, str], separator: str) -> Product:
    """Return the entries of a product from the cells of its line, which may end before its head does."""
    filled = zip(head, cells, strict=False)
    given = {columns[name]: value(cell.strip(), columns[name], separator) for name, cell in filled}
    return {entry: cell for entry, cell in given.items() if cell is not None}


def require_head(path: Path, head: list[str], model: type[Row]) -> None:
    """Raise InputError for a column that is unknown, given twice, or needed and missing."""
    columns = columns_of(model)
    unknown = [name for name in head if name not in columns]
    twice = [name for name in dict.fromkeys(head) if name in columns and head.count(name) > 1]
    needed = [name for name, entry in columns.items() if model.model_fields[entry].is_required()]
    missing = [name for name in needed if name not in head]
    faults = [f"unknown column {quoted(unknown[0])}{others(unknown)}"] if unknown else []
    faults += [f"column {name} stands there twice" for name in twice]
    faults += [f"column {missing[0]} is missing{others(missing)}"] if missing else []
    if faults:
        raise InputError([f"{path}: line 1: {'; '.join(faults)}; expected one of {', '.join(columns)} in each column"])


def others(names: list[str]) -> str:
    """Return in words the number of names beyond the first."""
    return f" and {len(names) - 1:,} more" if len(names) > 1 else ""


def value(cell: str, entry: str, separator: str) -> Any:
    """Return the entry of a cell: None, a text, or a number; a text in place of a number is refused later."""
    if not cell or entry in TEXTS:
        return cell or None
    text = cell.replace(",", ".") if separator == ";" else cell
    return float(text) if NUMBER.fullmatch(text) else cell


def useless(model: type[Row], given: Product) -> Iterator[str]:
    """Yield a sentence for each unusable entry: its column, the given entry, and what is expected."""
    facts = facts_of(model)
    try:
        model.model_validate(given)
    except ValidationError as error:
        for fault in error.errors(include_url=False):
            if numbers_of(fault, model) is None:
                yield fault_line(fault, model, lambda key: f"column {facts[key].head}")


def committed_products(model: type[Row], name: str) -> list[Row]:
    """Return the products of a catalogue that comes with the templates."""
    return [model.model_validate(product) for product in read(model, FOLDER / name)]


read_motors = partial(read, MotorRow)
read_reducers = partial(read, ReducerRow)
committed_motors = cache(partial(committed_products, MotorRow, "motors.csv"))
committed_reducers = cache(partial(committed_products, ReducerRow, "reducers.csv"))
