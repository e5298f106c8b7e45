"""The functions of a file of declarations, called under a limit of time: results checked, faults in words."""

import math
import numbers
import threading
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from queue import Queue
from typing import Any

import numpy as np

from workbook.errors import ReadError, quoted

SECONDS = 20.0  # that a call may take


class CallError(ReadError):
    """A function of the declarations that cannot be used; its text says where, why and at which inputs."""


def call(function: Callable[..., Any], arguments: Sequence[Any], path: Path, seconds: float | None = None) -> Any:
    """Return the result of a function of the file ``path``; raise CallError where it raises or does not end.

    It runs in a thread of its own, which is left behind where it hangs; ``seconds`` are :data:`SECONDS` by default.
    """
    answers: Queue[tuple[Any, BaseException | None]] = Queue()

    def run() -> None:
        try:
            answers.put((function(*arguments), None))
        except BaseException as error:  # sys.exit() too: it is the user's own code
            answers.put((None, error))

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(limit := SECONDS if seconds is None else seconds)
    if thread.is_alive():
        raise CallError(f"did not end within {limit:g} s")
    result, error = answers.get()
    if error is not None:
        raise CallError(error_text(error, path)) from error
    return result


def error_text(error: BaseException, path: Path) -> str:
    """Return the line of the file at which an error was raised, and its message."""
    if isinstance(error, SyntaxError) and error.lineno:
        return f"line {error.lineno}: {type(error).__name__}: {error.msg}"
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if Path(frame.filename).name == path.name]
    where = f"line {lines[-1]}: " if lines else ""
    return f"{where}{type(error).__name__}: {str(error)[:200]}".rstrip(": ")


def plain_result(value: Any) -> Any:
    """Return a result as a cell holds it: a finite number, a text or a truth value; raise CallError for all else."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        value = value.item()
    if isinstance(value, bool | str):
        return value
    if value is None:
        raise CallError("returned None; expected a number, a text, True or False")
    if not isinstance(value, numbers.Real):
        shape = f"an array of shape {value.shape}" if isinstance(value, np.ndarray) else f"a {type(value).__name__}"
        raise CallError(f"returned {shape}; expected a single number, a text, True or False")
    if not math.isfinite(value):
        raise CallError(f"returned {float(value)}; expected a finite number")
    return float(value)


def block_of(value: Any, rows: int, columns: int) -> list[list[Any]]:
    """Return the result for a range, row by row: a value for all cells, or an array of its shape."""
    try:
        array = np.array(value, dtype=object)
        held = np.broadcast_to(array.reshape(-1, 1) if array.ndim == 1 and columns == 1 else array, (rows, columns))
    except ValueError:
        raise CallError(f"returned {shape_of(value)}; expected a value, or {rows} rows of {columns}") from None
    return [[plain_result(cell) for cell in row] for row in held.tolist()]


def columns_of(value: Any, rows: int, names: Sequence[str]) -> list[list[float]]:
    """Return the columns of a table, each with a finite number for each row."""
    if len(names) == 1 and isinstance(value, np.ndarray) and value.ndim == 1:
        value = [value]
    if isinstance(value, str) or not isinstance(value, Sequence | np.ndarray) or len(value) != len(names):
        raise CallError(f"returned {shape_of(value)}; expected {len(names)} columns: {', '.join(names)}")
    columns = []
    for name, column in zip(names, value, strict=True):
        try:
            held = np.broadcast_to(np.asarray(column, dtype=float), (rows,))
        except (TypeError, ValueError):
            words = f"{shape_of(column)} for the column {name}"
            raise CallError(f"returned {words}; expected a number for each of {rows} rows") from None
        if not np.isfinite(held).all():
            at = int(np.argmin(np.isfinite(held))) + 1
            raise CallError(f"returned {held[at - 1]} in row {at} of the column {name}; expected finite numbers")
        columns.append(held.tolist())
    return columns


def shape_of(value: Any) -> str:
    """Return a result in words: its kind and shape."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    if isinstance(value, list | tuple):
        return f"a {type(value).__name__} of {len(value)}"
    return quoted(value) if value is None or isinstance(value, str | int | float) else f"a {type(value).__name__}"
