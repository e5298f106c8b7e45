"""From a machine description to a workbook file, and the committed templates."""

import re
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.declare import Book
from workbook.book.quantity import OK, SAYS
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.errors import InputError, ReadError, WriteError
from workbook.judging.carry_over import find_additions, not_carried, with_sheet
from workbook.judging.matching import Match
from workbook.judging.structure import refuse_cut_cells
from workbook.pool import collecting_between, collector_paused
from workbook.reading.descriptions import counted_from_1, read_machine, require_possible
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.reading.guard import inspect
from workbook.reading.rows import Refusal
from workbook.template import FOLDER
from workbook.template_outputs import NOTHING_JUDGED, ExactJudgement
from workbook.templates import TEMPLATES
from workbook.witnesses.agreement import agreed_values
from workbook.writing.archive import book_digest, same_book
from workbook.writing.output_files import is_same_file, refuse_existing
from workbook.writing.write import KEPT, NO_ADDITIONS, pack, parts

LARGE = 10_000_000  # bytes of a file: a smaller file is far within the limits of reading
DIGESTS = "books.sha256"  # in the folder of the templates: a line for each workbook, in git or not
COMMITTED = "cutting-machine flying-cutter indexing-overlap motion-composer motion-laws".split()
"""the workbooks that are in git, beside motion-functions; `motionbook templates` builds the others"""
NUMBERED = re.compile(r"\b[Aa]xis (\d+)(?=:|$)")
ELSEWHERE = "another name (-o), or that the file is moved away"


def build(machine: Machine, path: Path, overwrite: bool = False) -> list[str]:
    """Write the workbook of a machine; return a line for each check that fails, by its sheet or by the exact engine.

    Raises WriteError where ``path`` exists or cannot be written, InputError for a machine that the engine refuses.
    """
    return build_keeping(machine, path, None, overwrite).failing


def write_book(
    machine: Machine,
    path: Path,
    overwrite: bool = False,
    old: Match | None = None,
    sheet: Callable[[Book], Worksheet] | None = None,
) -> tuple[Book, list[str]]:
    """Write the workbook of a machine, with what an engineer has added to an old book, and a ``sheet`` for it.

    Returns its declaration, and a line for what of the engineer's own stays behind, and for what its formulas have in
    place of what they had. Raises WriteError where ``path`` exists or cannot be written, or holds work of the
    engineer's own that would be lost, InputError for a machine that the engine refuses.
    """
    refuse_existing(path, overwrite)
    template = TEMPLATES[machine.template]
    require_possible(template, machine, counted_from_1)
    own, left = NO_ADDITIONS, list[str]()
    with collector_paused():
        book = template.declare(machine)
        if old is not None:
            own = find_additions(old, book)
            left = not_carried(old, machine.template, own)
        if sheet is not None:
            own = with_sheet(own, sheet(book))
        is_kept = old is not None and is_same_file(path, old.file.path)
        refuse_loss(path, left if is_kept else own_work(path), is_kept)
        pack(parts(book, type(machine), own=own), path, overwrite, require_readable)
    return book, [*left, *own.remarks]


def own_work(path: Path) -> list[str]:
    """Return a line for each kind of work that an engineer has added to a workbook of ours; of no such file nothing.

    Raises WriteError for a workbook of ours that cannot be read.
    """
    try:
        file = open_book(path)
    except ReadError:
        return []  # nothing is there, or no workbook
    if "book_template" not in file.places or (file.as_built and file.workbook.properties.category != KEPT):
        return []
    try:
        match, machine, _ = read_entered(path)
    except (ReadError, InputError) as error:
        raise WriteError(f"{path}: nobody knows what is your own in it: {error}; expected {ELSEWHERE}") from error
    return not_carried(match, machine.template)


def refuse_loss(path: Path, lost: list[str], is_kept: bool) -> None:
    """Raise InputError, with a line for each kind, where work of an engineer's own in a file would be lost."""
    if lost:
        keep = "" if is_kept else f"--keep {path}, which takes along what it can, or "
        raise InputError([f"{path}: work of your own in it would be lost; expected {keep}{ELSEWHERE}", *lost])


class BookVerdict(NamedTuple):
    """The remarks on a book that is built: a line for each check that fails, and notes."""

    failing: list[str]
    notes: list[str]


def require_readable(draft: Path) -> None:
    """Raise InputError for a workbook that is larger than what verify would read; a small file needs no look."""
    try:
        if (size := draft.stat().st_size) > LARGE:
            with draft.open("rb") as file:
                inspect(file, size)
    except Refusal as refusal:
        raise InputError([f"sizes: too large a workbook to be verified: {refusal}; expected fewer samples"]) from None


def failing_checks(book: Book, exact: ExactJudgement = NOTHING_JUDGED) -> list[str]:
    """Return a line for each check of a book that fails, axes by their names."""
    named = [(q, block.size) for block in book.blocks.values() if block.name == "axes" for q in block.quantities]
    names = [str(name) for q, rows in named if q.name == "name" for name in as_rows(q.value, rows, q.name)]
    lines = []
    for _, check in book.checks:
        verdict, message = exact.judge(check.name, check.value, book.blocks[f"{check.name}{SAYS}"].quantities[0].value)
        label = NUMBERED.sub(lambda match: names[int(match[1]) - 1] if names else match[0], check.label)
        if verdict != OK:
            lines.append(f"{label}: {message}")
    return lines


def read_inputs(path: Path) -> tuple[Machine, list[str]]:
    """Return the entries of an engineer in a workbook, and lines on those that are not carried over."""
    match, machine, notes = read_entered(path)
    return machine, notes + not_carried(match, machine.template)


def read_entered(path: Path) -> tuple[Match, Machine, list[str]]:
    """Return a workbook with what belongs into its cells, what was entered, and lines on entries that are no values."""
    file = open_book(path)
    entries = Entries(file, agreed_values, refuse_cut_cells)
    machine = entries.machine()
    notes = [f"{cell} holds a formula; its value is taken" for cell in entries.computed]
    match = Match(file, entries.template.declare(machine))
    machine.laws.built_as({})
    machine.built_as({})
    machine.verified_at(None)
    return match, machine, notes + entries.beyond


def regenerate(path: Path, output: Path, overwrite: bool = False) -> BookVerdict:
    """Build a workbook anew from what was entered into an old workbook; the notes begin with what is left behind."""
    match, machine, notes = read_entered(path)
    return build_keeping(machine, output, match, overwrite, notes)


def build_keeping(
    machine: Machine, path: Path, old: Match | None, overwrite: bool = False, notes: Sequence[str] = ()
) -> BookVerdict:
    """Write the workbook of a machine, with what an engineer has added to an old book; return the verdict on it.

    That is of its sheets and of the exact engine; of an unfinished design its faults. The notes begin with ``notes``.
    """
    book, left = write_book(machine, path, overwrite, old)
    if faults := machine.design.faults:
        return BookVerdict([f"{counted_from_1(fault.key)}: {fault.sentence}" for fault in faults], [*notes, *left])
    exact = TEMPLATES[machine.template].judge(machine)
    return BookVerdict(failing_checks(book, exact), [*notes, *left, *exact.notes])


def committed_descriptions() -> list[Path]:
    """Return the committed machine descriptions, several of some templates; its workbook, if any, lies beside it."""
    return sorted(FOLDER.glob("*.toml"))


def write_templates() -> list[Path]:
    """Generate the workbook of every committed description, the digests of all, and that of the functions."""
    from workbook.functions import publish  # slow to import, and no other command needs it

    books = [description.with_suffix(".xlsx") for description in committed_descriptions()]
    for book in collecting_between(books):
        write_book(read_machine(book.with_suffix(".toml")), book, overwrite=True)
    lines = [f"{book_digest(book)}  {book.name}\n" for book in books]
    (FOLDER / DIGESTS).write_text("".join(lines), encoding="utf-8", newline="\n")
    publish.write_book()
    return [*books, FOLDER / DIGESTS, publish.BOOK]


def stale_templates() -> list[Path]:
    """Return the files that today's code would generate differently: by digest, and by content where they are there."""
    from workbook.functions import publish

    stale = []
    lines = (FOLDER / DIGESTS).read_text(encoding="utf-8").splitlines() if (FOLDER / DIGESTS).exists() else []
    digests = {name: digest for digest, name in map(str.split, lines)}
    with tempfile.TemporaryDirectory() as folder:
        for description in collecting_between(committed_descriptions()):
            book = description.with_suffix(".xlsx")
            write_book(read_machine(description), fresh := Path(folder) / book.name)
            is_same = same_book(fresh, book) if book.exists() else book.stem not in COMMITTED
            if not is_same or digests.get(book.name) != book_digest(fresh):
                stale.append(book)
    return [*stale, publish.BOOK] if publish.is_stale() else stale
