"""A picked design as a book: built, its results compared with the study's, and verified."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbook.build import build
from workbook.errors import InputError
from workbook.judging.compare import TOLERANCE
from workbook.judging.verify import verify
from workbook.studies.evaluate import of_book
from workbook.studies.plan import Plan
from workbook.studies.summary import Design


@dataclass(frozen=True)
class Judged:
    """A design's book: its largest deviation from the study's results, what differs, whether every cell agrees.

    ``failing`` are its checks that FAIL, ``unasked`` those of them that are no constraints of the study.
    """

    deviation: float
    differing: tuple[str, ...]
    failing: tuple[str, ...]
    unasked: tuple[str, ...]
    cells: int
    agrees: bool

    @property
    def holds(self) -> bool:
        """Whether the book says what the study said."""
        return self.agrees and not self.differing and self.failing == self.unasked


def machine_of(plan: Plan, design: Design) -> Any:
    """Return the machine of a design."""
    chosen = {one: design.entries[one.label] for one in plan.space.dimensions}
    machine = plan.machine(chosen)
    if isinstance(machine, str):
        raise InputError([f"design {design.number + 1}: {machine}"])
    return machine


def picked(plan: Plan, design: Design, path: Path, overwrite: bool) -> Judged:
    """Build the book of a design, verify it, and compare it with the study's results."""
    machine = machine_of(plan, design)
    build(machine, path, overwrite)
    book = plan.template.declare(machine)
    # mass and cost of a motor stand in no book
    apart = {name: deviation(value, of_book(book, name)) for name, value in design.results.items()
             if name.partition(".")[0] in book.blocks}  # fmt: skip
    report = verify(path)
    differing = tuple(name for name, value in apart.items() if not value <= TOLERANCE)
    failing = tuple(q.name for _, q in book.checks if q.value != "OK")
    unasked = tuple(filter(plan.study.is_off, failing))
    return Judged(max(apart.values(), default=0.0), differing, failing, unasked, report.compared, report.agrees)


def deviation(one: Any, other: Any) -> float:
    """Return by which share two results differ; texts by all or nothing."""
    if isinstance(one, str) or isinstance(other, str):
        return float(one != other)
    if one == other:
        return 0.0
    return float(abs(one - other) / max(abs(one), abs(other), 1e-12))
