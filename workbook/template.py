"""The class of templates, and the parts that every template's book has."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any, Generic, TypeVar

from workbook.book.checks import checks_sheet
from workbook.book.declare import Book
from workbook.book.quantity import Quantity, number_format, sample
from workbook.book.rows import as_rows
from workbook.book.sentence import NOTHING, CheckSentence
from workbook.book.summary import close_summary, more_results, title_blocks
from workbook.book_layout import NAME as LAYOUT
from workbook.book_layout import layout_text
from workbook.entries.machine import Machine
from workbook.fields.paths import key_of
from workbook.law_sheets.library import named_laws
from workbook.template_outputs import NOTHING_JUDGED, CamAxis, CamSwitch, ExactJudgement, Scaling
from workbook.text_files import FOLDER as FOLDER  # known by this module to many

M = TypeVar("M", bound=Machine)


@dataclass(frozen=True, eq=False)
class Template(Generic[M]):
    """A kind of machine: its description's model, the book declared from a description, variations to verify at.

    ``declare_complete`` declares the book of a machine whose entries do; :meth:`declare` that of any.
    """

    name: str
    model: type[M]
    declare_complete: Callable[[M], Book]
    variants: Callable[[M], list[M]]
    # raises EntryError for entries that only the engine can refuse
    check: Callable[[M], None] = lambda machine: None
    # the motions that a controller can be given
    axes: Callable[[M], list[CamAxis]] = lambda machine: []
    # what it is to turn on and off meanwhile
    switches: Callable[[M], list[CamSwitch]] = lambda machine: []
    scaling: Scaling[M] | None = None  # gives results of many designs at once, without a book
    improving: ModuleType | None = None  # of functions that say what would make it faster
    live: ModuleType | None = None  # of functions for the design page, whose figures come in a moment, without a book
    laws: Mapping[str, Any] = field(default_factory=dict)  # of a description that does not say which it has
    # of its book, by the exact engine
    judgement: Callable[[M], ExactJudgement] = lambda machine: NOTHING_JUDGED
    # where the description to begin with lies, and its book, called as the template
    folder: Path = FOLDER

    def judge(self, machine: M) -> ExactJudgement:
        """Return the judgement of the exact engine on the book of a machine: nothing of an unfinished design."""
        return NOTHING_JUDGED if machine.design.replaced else self.judgement(machine)

    def declare(self, machine: M) -> Book:
        """Declare the book of a machine, with its layout; of an unfinished design with what was entered."""
        book = self.declare_complete(machine)
        layout = book.blocks[LAYOUT]
        layout.quantities = tuple(q._replace(value=layout_text(machine, book)) for q in layout.quantities)
        if machine.design.replaced:
            enter_unfinished(book, machine)
        return book

    @property
    def description(self) -> Path:
        """The machine description to begin with."""
        return self.folder / f"{self.name}.toml"

    @property
    def book(self) -> Path:
        """The workbook of that description."""
        return self.folder / f"{self.name}.xlsx"


def finish(book: Book, sources: tuple[str, ...], says: CheckSentence = NOTHING) -> Book:
    """Add what comes when all sheets are there: checks, the verdict on each sheet, contents, titles, sources.

    ``says`` stands on the first sheet behind the verdict.
    """
    more_results(book)
    checks_sheet(book)
    close_summary(book, sources, says)
    title_blocks(book)
    return book


def enter_unfinished(book: Book, machine: Machine) -> None:
    """Put into a book what was entered of an unfinished design; take the values of all formula cells away.

    The engine works with other numbers in place of faulty ones, so that its results are of no use there: what a cell
    says, the entries' own checks among all, a program works out when it opens the book.
    """
    names = {f"laws.{key_of(law.name)}": law.key for law in named_laws(machine.laws)}
    entered = {}
    for key, value in machine.design.replaced.items():
        begin = ".".join(key.split(".")[:2])
        entered[names.get(begin, begin) + key.removeprefix(begin)] = value
    for block in book.blocks.values():
        columns = (as_entered(q, block.size, entered) for q in block.quantities)
        block.quantities = tuple(q if block.is_table else q._replace(value=q.value[0]) for q in columns)
    book.checks = [(sheet, q._replace(value=None)) for sheet, q in book.checks]


def as_entered(q: Quantity, size: int, entered: Mapping[str, Any]) -> Quantity:
    """Return a quantity with a value for each row: as entered by its key, none of a formula, whose look stays."""
    rows = as_rows(q.value, size, q.name)
    if q.formula is not None:
        return q._replace(value=[None for _ in rows], format=number_format(q, sample(q)))
    return q._replace(value=[entered.get(q.key.replace("*", str(i)), value) for i, value in enumerate(rows)])
