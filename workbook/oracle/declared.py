"""What a file of declarations says of a workbook: inputs with ranges, outputs with the functions that give them."""

import inspect
import runpy
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from workbook.errors import ReadError


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
    """A cell that is compared: ``of`` gives its value of ``inputs``, else of those called like its parameters."""

    cell: str
    of: Callable[..., Any]
    unit: str = ""
    tolerance: float = 1e-9
    source: str = ""
    inputs: Sequence[Input] | None = None


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

    def input(
        self, cell: str, unit: str = "", low: float | None = None, high: float | None = None,
        choices: Sequence[Any] = (), macro: bool = False,
    ) -> Input:  # fmt: skip
        """Declare a cell that is varied; without a range or choices it stays as it is entered."""
        self.inputs.append(Input(cell, unit, low, high, choices, macro))
        return self.inputs[-1]

    def output(
        self, cell: str, unit: str = "", tolerance: float = 1e-9, source: str = "",
        inputs: Sequence[Input] | None = None,
    ) -> Callable[[Callable[..., Any]], Callable[..., Any]]:  # fmt: skip
        """Declare the decorated function as what gives a cell's value of ``inputs``, to a relative ``tolerance``."""

        def declare(of: Callable[..., Any]) -> Callable[..., Any]:
            self.outputs.append(Output(cell, of, unit, tolerance, source, inputs))
            return of

        return declare

    def table(self, cells: str, columns: Sequence[str], of: Callable[..., Any], tolerance: float = 1e-9) -> None:
        """Declare a range whose columns ``of`` gives, an array each."""
        self.tables.append(Table(cells, columns, of, tolerance))

    def arguments(self, one: Output | Table) -> Sequence[Input]:
        """Return the inputs that a function takes: of an output those declared, else by the names of its parameters."""
        if isinstance(one, Output) and one.inputs is not None:
            return one.inputs
        return [self.names[name] for name in parameters(one)]


@cache
def parameters(one: Output | Table) -> list[str]:
    """Return the names of a function's parameters; of a table without the first, its column."""
    return list(inspect.signature(one.of).parameters)[isinstance(one, Table) :]


def load(path: Path) -> Oracle:
    """Run a file of declarations and return its oracle; raise ReadError where it has none or is incomplete."""
    if not path.is_file():
        raise ReadError(f"{path}: there is no such file; expected declarations in Python")
    try:
        found = runpy.run_path(str(path))
    except Exception as error:
        raise ReadError(f"{path}: {type(error).__name__}: {error}") from error
    oracles = [value for value in found.values() if isinstance(value, Oracle)]
    if len(oracles) != 1:
        raise ReadError(f"{path}: {len(oracles)} oracles; expected one, such as pump = Oracle('Pump sizing')")
    oracle = oracles[0]
    oracle.names = {name: value for name, value in found.items() if isinstance(value, Input)}
    declared: list[Output | Table] = [*oracle.outputs, *oracle.tables]
    for one in declared:
        named = isinstance(one, Output) and one.inputs is not None
        unknown = [name for name in parameters(one) if name not in oracle.names and not named]
        if unknown:
            expected = ", ".join(oracle.names) or "none is declared"
            raise ReadError(f"{path}: {one.of.__name__}({unknown[0]}): no input is called so; expected {expected}")
    if not oracle.outputs and not oracle.tables:
        raise ReadError(f"{path}: no output is declared; expected @{next(iter(found), 'oracle')}.output(CELL)")
    return oracle
