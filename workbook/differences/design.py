"""A workbook or a description as a design: its figures, each by what it is, and the figures of two designs compared."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from workbook.book.declare import Block, Book
from workbook.book.quantity import FAIL, OK, SAYS
from workbook.book.rows import as_rows, is_number
from workbook.entries.machine import Machine
from workbook.judging.carry_over import left_behind
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.structure import check_structure, layout_findings, refuse_cut_cells
from workbook.reading.descriptions import read_machine
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.template_outputs import ExactJudgement
from workbook.templates import TEMPLATES
from workbook.witnesses.agreement import agreed_values, same_value

LONG = 40  # rows of a table of samples or points: those are compared by the results built from them
NAMES = ("name", "axis", "sheet")  # the columns by which the rows of a table are called
# with what names of blocks begin where each axis has its own
NUMBERED = re.compile(r"(axis|cycle|drive)(\d+)(?=_|$)")
# what identifies a figure in another book: its axis, its block without the axis' number, column and row
Key = tuple[str, str, str, str]


class Figure(NamedTuple):
    """An entry, a result or a check: its place in words, its name there, unit and value."""

    place: str
    label: str
    unit: str
    value: Any
    says: str = ""
    key: str = ""  # of an entry, in the description


@dataclass(frozen=True)
class Design:
    """The content of a workbook or a description of a machine."""

    path: Path
    machine: Machine
    book: Book
    # of a workbook, the formulas and texts that are not as generated
    edited: list[str] = field(default_factory=list)
    own: list[str] = field(default_factory=list)  # and what was added to them

    @cached_property
    def axes(self) -> list[str]:
        """The names of the axes, in the order of their numbers."""
        return [str(axis.name) for axis in getattr(self.machine, "axes", [])]

    @cached_property
    def exact(self) -> ExactJudgement:
        """The judgement of the exact engine on it."""
        return TEMPLATES[self.machine.template].judge(self.machine)

    def entries(self) -> dict[Key, Figure]:
        """Return all that was entered."""
        return self._figures("input")

    def results(self) -> dict[Key, Figure]:
        """Return all results but texts in tables, long tables and matrices (the best pairs stand for those)."""
        figures = self._figures("result")
        return {key: figure for key, figure in figures.items() if not key[2] or isinstance(figure.value, int | float)}

    def checks(self) -> dict[Key, Figure]:
        """Return the checks on which the overall verdict rests, with the sentence of each that fails."""
        figures = {}
        for sheet, q in self.book.checks:
            axis, rest = self._axis(q.name)
            says = str(self.book.blocks[f"{q.name}{SAYS}"].quantities[0].value or "")
            figures[axis, rest, "", ""] = Figure(sheet.title, q.label, "", *self.exact.judge(q.name, q.value, says))
        return figures

    def _figures(self, role: str) -> dict[Key, Figure]:
        blocks = [
            block for block in self.book.blocks.values() if role == "input" or (block.size <= LONG and not block.lead)
        ]
        columns = ((block, q) for block in blocks for q in block.quantities if q.role == role)
        figures: dict[Key, Figure] = {}
        for block, q in columns:
            axis, rest = self._axis(block.name)
            rows = rows_of(block, axis) if block.is_table else [""]
            for k, (row, value) in enumerate(zip(rows, as_rows(q.value, block.size, q.name), strict=True)):
                place = f"{block.sheet.title}: {row}" if row else block.sheet.title
                key = q.key.replace(".*", f".{k}")
                figures[axis, rest, q.name if row else "", row] = Figure(place, q.label, q.unit, value, key=key)
        return figures

    def _axis(self, name: str) -> tuple[str, str]:
        """Return the name of the axis that a block belongs to, and the rest of the block's name."""
        if (match := NUMBERED.match(name)) is None:
            return "", name
        number, rest = int(match[2]), f"{match[1]}{name[match.end() :]}"
        if match[1] == "drive" and (held := self.book.blocks.get(f"drive{number}_axis")):
            return str(held.quantities[0].value), rest
        return str(number) if number > len(self.axes) else self.axes[number - 1], rest


def rows_of(block: Block, axis: str) -> list[str]:
    """Return the labels of the rows of a table: their names where each has its own, else their numbers."""
    named = next((q for q in block.quantities if q.name in NAMES), None)
    names = as_rows(named.value, block.size, block.name) if named else [None] * block.size
    counts = Counter(names)
    return [
        name if isinstance(name, str) and name and counts[name] == 1 else f"{axis} row {number}".lstrip()
        for number, name in enumerate(names, 1)
    ]


def read_design(path: Path) -> Design:
    """Read a workbook or a description; raise ReadError or InputError where it is neither."""
    if path.suffix.lower() == ".toml":
        machine = read_machine(path)
        return Design(path, machine, TEMPLATES[machine.template].declare(machine))
    file = open_book(path)
    entries = Entries(file, agreed_values, refuse_cut_cells)
    machine = entries.machine()
    match = Match(file, entries.template.declare(machine))
    report = Report(file.path, entries.template.name, findings=list(layout_findings(match)))
    check_structure(match, report)
    edited = [f"{cell.sheet}!{cell.cell} ({cell.what}): {cell.computed}" for cell in report.findings]
    ours = {pair.address.sheet for pair in match.pairs}
    own = [f"the sheet {title!r}" for title in file.workbook.sheetnames if title not in ours]
    own += [f"{a}: {file.value(a)}" for a in file.contents.formula_cells if a not in match.numbers]
    own += [line.replace(" are not carried over", "") for line in left_behind(match)]
    return Design(path, machine, TEMPLATES[machine.template].declare(machine), edited, own)


EMPTY = (None, "")
# difference of two numbers that are the same: rounding in a file changes the last digits
SMALLEST = 1e-12
SHOWN = 0.005  # per cent, below which the difference of a result is shown as 0.00 %


class Change(NamedTuple):
    """An entry, a result or a check that differs; ``None`` stands for what a side does not have."""

    place: str
    label: str
    unit: str
    old: Any
    new: Any
    worse: bool = False
    says: str = ""
    key: str = ""

    @property
    def difference(self) -> float | None:
        """New less old, of two numbers."""
        return self.new - self.old if is_number(self.old) and is_number(self.new) else None

    @property
    def per_cent(self) -> float | None:
        """The difference over the old value, in per cent; None where that is 0."""
        return None if self.difference is None or not self.old else 100.0 * self.difference / abs(self.old)

    @property
    def is_shown(self) -> bool:
        """Whether the difference is more than a last digit."""
        return self.per_cent is None or abs(self.per_cent) >= SHOWN


@dataclass(frozen=True)
class Differences:
    """All that differs between an old and a new design."""

    entries: list[Change]
    results: list[Change]
    checks: list[Change]
    edited: dict[str, list[str]]
    own: dict[str, list[str]]

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not (self.entries or self.results or self.checks or any(self.edited.values()) or any(self.own.values()))


def compare(old: Design, new: Design) -> Differences:
    """Return the differences of two designs of the same template."""
    return Differences(
        changes(old.entries(), new.entries()),
        changed_results(old, new),
        [] if is_unfinished(old, new) else changes(old.checks(), new.checks()),
        one_sided(old.edited, new.edited),
        one_sided(old.own, new.own),
    )


def is_unfinished(*designs: Design) -> bool:
    """Whether any design is unfinished, and so has no results."""
    return any(design.machine.design.faults for design in designs)


def changed_results(old: Design, new: Design) -> list[Change]:
    """Return the results that differ, where both designs have any."""
    return [] if is_unfinished(old, new) else changes(old.results(), new.results())


def one_sided(old: list[str], new: list[str]) -> dict[str, list[str]]:
    """Return the lines that only the old and only the new side has."""
    return {"old": [line for line in old if line not in new], "new": [line for line in new if line not in old]}


def changes(before: Mapping[Key, Figure], after: Mapping[Key, Figure]) -> list[Change]:
    """Return the figures that differ, in the order of the new book; what only the old has comes last."""
    listed = []
    for key in [*after, *(key for key in before if key not in after)]:
        was, now = before.get(key), after.get(key)
        shown = now or before[key]
        old: Any = was.value if was else None
        new: Any = now.value if now else None
        if not same(old, new):
            more = is_number(old) and is_number(new) and new > old
            worse = new == FAIL if old == OK else more and shown.label.startswith("Use of")
            listed.append(Change(*shown[:3], old, new, worse, now.says if now else "", shown.key))
    return listed


def same(old: Any, other: Any) -> bool:
    """Whether two values are the same; an empty text is an empty cell."""
    return (old in EMPTY and other in EMPTY) or same_value(old, other, SMALLEST)
