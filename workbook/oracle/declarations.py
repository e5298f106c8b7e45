"""The content of a file of declarations: inputs with ranges, outputs with functions; values to compare at."""

import inspect
import math
import runpy
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

from scipy.stats import qmc

from workbook.book.rows import is_number
from workbook.errors import ReadError
from workbook.oracle.calls import CallError, call
from workbook.witnesses.calibration import SMALLEST, is_same


@dataclass(eq=False)
class Input:
    """A cell that is varied: a number from ``low`` to ``high``, or one of ``choices``.

    ``cell`` is an address (``Sheet!B4``, or ``B4`` on the first sheet), a defined name, or the label beside it;
    ``macro`` of a cell with a formula that calls a macro, which only Excel runs: a number stands in for it.
    """

    cell: str
    unit: str = ""
    low: float | None = None
    high: float | None = None
    choices: Sequence[Any] = ()
    macro: bool = False


@dataclass(eq=False)
class Output:
    """A cell or range that is compared: ``of`` gives its value of ``inputs``, else of those called like its parameters.

    Of a range it gives a value for all of its cells, or an array. Cells of ``proposed`` functions count as steps.
    """

    cell: str
    of: Callable[..., Any]
    unit: str = ""
    tolerance: float = 1e-9
    source: str = ""
    inputs: Sequence[Input] | None = None
    proposed: bool = False


@dataclass(eq=False)
class Table:
    """A range of which columns are compared: ``of`` returns for each row (1-D array) the columns that are named.

    The first column is handed to ``of`` as an array, before the inputs; the others are compared in their order.
    """

    cells: str
    columns: Sequence[str]
    of: Callable[..., Any]
    tolerance: float = 1e-9


@dataclass(eq=False)
class Oracle:
    """All that is declared of a workbook: inputs also by variables of the file; ``sheets`` to be counted, else all."""

    title: str
    sheets: Sequence[str] = ()
    inputs: list[Input] = field(default_factory=list)
    outputs: list[Output] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
    names: dict[str, Input] = field(default_factory=dict)
    path: Path = Path()

    def input(
        self,
        cell: str,
        unit: str = "",
        low: float | None = None,
        high: float | None = None,
        choices: Sequence[Any] = (),
        macro: bool = False,
    ) -> Input:
        """Declare a cell that is varied; without a range or choices it stays as it is entered."""
        self.inputs.append(Input(cell, unit, low, high, choices, macro))
        return self.inputs[-1]

    def output(
        self,
        cell: str,
        unit: str = "",
        tolerance: float = 1e-9,
        source: str = "",
        inputs: Sequence[Input] | None = None,
        proposed: bool = False,
    ) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        """Declare the decorated function as what gives a cell's or range's value of ``inputs``, to a ``tolerance``."""

        def declare(of: Callable[..., Any]) -> Callable[..., Any]:
            self.outputs.append(Output(cell, of, unit, tolerance, source, inputs, proposed))
            return of

        return declare

    def table(self, cells: str, columns: Sequence[str], of: Callable[..., Any], tolerance: float = 1e-9) -> None:
        """Declare a range whose columns ``of`` gives, an array each."""
        self.tables.append(Table(cells, columns, of, tolerance))

    def arguments(self, output: Output | Table) -> Sequence[Input]:
        """Return the inputs that a function takes: of an output those declared, else by the names of its parameters."""
        if isinstance(output, Output) and output.inputs is not None:
            return output.inputs
        return [self.names[name] for name in parameters(output)]


@cache
def parameters(output: Output | Table) -> list[str]:
    """Return the names of a function's parameters; of a table without the first, its column."""
    return list(inspect.signature(output.of).parameters)[isinstance(output, Table) :]


def load_oracle(path: Path) -> Oracle:
    """Run a file of declarations and return its oracle; raise ReadError where it has none or is incomplete."""
    if not path.is_file():
        raise ReadError(f"{path}: there is no such file; expected declarations in Python")
    try:
        variables = call(runpy.run_path, [str(path)], path)
    except CallError as error:
        raise ReadError(f"{path}: {error}") from error
    if len(oracles := [value for value in variables.values() if isinstance(value, Oracle)]) != 1:
        raise ReadError(f"{path}: {len(oracles)} oracles; expected one, such as pump = Oracle('Pump sizing')")
    oracle = oracles[0]
    oracle.path = path
    oracle.names = {name: value for name, value in variables.items() if isinstance(value, Input)}
    require_inputs(oracle, path)
    if not oracle.outputs and not oracle.tables:
        raise ReadError(f"{path}: no output is declared; expected @{next(iter(variables), 'oracle')}.output(CELL)")
    return oracle


def require_inputs(oracle: Oracle, path: Path) -> None:
    """Raise ReadError for a function with a parameter that is no input of its file."""
    declared: list[Output | Table] = [*oracle.outputs, *oracle.tables]
    for row in declared:
        named = isinstance(row, Output) and row.inputs is not None
        if unknown := [name for name in parameters(row) if name not in oracle.names and not named]:
            expected = ", ".join(oracle.names) or "none is declared"
            raise ReadError(f"{path}: {row.of.__name__}({unknown[0]}): no input is called so; expected {expected}")


# Values of the inputs at which a workbook is compared: as entered, at the ends of ranges, and between


def close(value: Any, expected: Any, allowed: float) -> bool:
    """Whether a value deviates from the expected by no more than is allowed; a text must be the same, an error any."""
    if is_number(value) and is_number(expected):
        return math.isfinite(value) and abs(value - expected) <= allowed + SMALLEST
    return is_same(value, expected)


Case = dict[Input, Any]


def cases(inputs: Sequence[Input], entered: Case, number: int, seed: int = 0) -> list[Case]:
    """Return so many cases, no more: as entered, each range at its ends, pairs of choices, Sobol's sequence.

    Source: A. B. Owen, Scrambled Sobol' and Niederreiter–Xing points, J. Complexity 14 (1998), in scipy.stats.qmc.
    """
    varied = [variable for variable in inputs if options(variable)]
    tried = [entered, *(entered | {first: value} for first in varied for value in options(first))]
    for first, other in combinations([first for first in varied if first.choices], 2):
        tried += [entered | {first: a, other: b} for a in first.choices for b in other.choices]
    if varied and len(tried) < number:
        points = qmc.Sobol(len(varied), scramble=True, seed=seed).random_base2((number - len(tried) - 1).bit_length())
        tried += [
            entered | {key: value_at(key, float(share)) for key, share in zip(varied, point, strict=True)}
            for point in points
        ]
    return tried[:number]


def options(entry: Input) -> Sequence[Any]:
    """Return the choices of an input, or the ends of its range; nothing of an input that stays as it is."""
    if entry.choices:
        return entry.choices
    return [] if entry.low is None or entry.high is None else [entry.low, entry.high]


def value_at(entry: Input, share: float) -> Any:
    """Return the value of an input at a share of its range, from 0 to 1."""
    if entry.choices:
        return entry.choices[min(int(share * len(entry.choices)), len(entry.choices) - 1)]
    low, high = float(entry.low or 0.0), float(entry.high or 0.0)
    return low + share * (high - low)
