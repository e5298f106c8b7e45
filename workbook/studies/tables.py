"""Tables of designs as files: CSV, and Parquet where pyarrow is installed; parts first, then all of them together."""

from __future__ import annotations

import csv
import io
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from workbook.errors import WriteError
from workbook.studies.evaluate import Table

FORMATS = (".csv", ".parquet")
ENDS = ("feasible", "fails", "impossible")
"""the last columns of a table"""
EXTRA = "Parquet wants the package pyarrow: pip install pyarrow; or name the results .csv"


def require_format(path: Path) -> None:
    """Raise WriteError for a suffix that is none, or one whose package is missing."""
    if path.suffix.lower() not in FORMATS:
        raise WriteError(f"{path}: results are written as {' or '.join(FORMATS)}; expected one of these endings")
    if path.suffix.lower() == ".parquet":
        try:
            import pyarrow.parquet  # noqa: F401
        except ImportError as error:
            raise WriteError(f"{path}: {EXTRA}") from error


def columns(labels: list[str], table: Table) -> dict[str, list[Any]]:
    """Return the columns of a table: number, entries, results, whether it is feasible, and why not."""
    found: dict[str, list[Any]] = {"design": list(range(table.begin + 1, table.begin + len(table) + 1))}
    for label, one in zip(labels, table.entries, strict=True):
        found[label] = np.array(list(one.values), dtype=object)[one.places].tolist()
    for name, values in table.results.items():
        found[name] = [None if value != value else value for value in values.tolist()]
    ends = np.where(table.feasible, "yes", "no").tolist(), failing(table), table.reasons.tolist()
    return found | dict(zip(ENDS, ends, strict=True))


def failing(table: Table) -> list[str]:
    """Return the names of the constraints that each design does not keep to."""
    said = np.full(len(table), "", dtype=object)
    for name, fails in table.fails.items():
        said[fails] += f" {name}"
    return [names.lstrip() for names in said]


def part(found: dict[str, list[Any]], suffix: str) -> bytes:
    """Return columns as a part of a file of this suffix, without its head."""
    if suffix == ".parquet":
        return parquet(found)
    said = io.StringIO()
    csv.writer(said, lineterminator="\n").writerows(zip(*found.values(), strict=True))
    return said.getvalue().encode()


def parquet(found: dict[str, list[Any]]) -> bytes:
    """Return columns as a Parquet file."""
    import pyarrow
    import pyarrow.parquet

    said = io.BytesIO()
    pyarrow.parquet.write_table(pyarrow.table(found), said)
    return said.getvalue()


def join(names: Sequence[str], parts: Sequence[Path], path: Path, suffix: str) -> None:
    """Write parts one behind the other into a file, a part at a time."""
    if suffix == ".parquet":
        join_parquet(parts, path)
        return
    with path.open("wb") as file:
        head = io.StringIO()
        csv.writer(head, lineterminator="\n").writerow(names)
        file.write(head.getvalue().encode())
        for one in parts:
            with one.open("rb") as rows:
                shutil.copyfileobj(rows, file)


def join_parquet(parts: Sequence[Path], path: Path) -> None:
    """Write Parquet files into one, of the kinds of number and text that all of them have."""
    import pyarrow
    import pyarrow.parquet

    schemas = [pyarrow.parquet.read_schema(one) for one in parts]
    schema = pyarrow.unify_schemas(schemas, promote_options="permissive")
    with pyarrow.parquet.ParquetWriter(path, schema) as writer:
        for one in parts:
            writer.write_table(pyarrow.parquet.read_table(one).cast(schema))
