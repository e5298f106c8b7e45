"""From a machine description to a workbook file, and the committed templates."""

from __future__ import annotations

import tempfile
from pathlib import Path

from workbook.collector import collector_paused
from workbook.functions import publish
from workbook.machine import Machine
from workbook.reading.carried import not_carried
from workbook.reading.entries import Entries, read_machine, write_machine
from workbook.reading.files import open_book
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing.same import same_book
from workbook.writing.write import refuse_existing, replace, save, to_workbook


def build(machine: Machine, path: Path, overwrite: bool = False) -> None:
    """Write the workbook of ``machine``; raise WriteError where ``path`` exists or cannot be written."""
    refuse_existing(path, overwrite)
    template = TEMPLATES[machine.template]
    with collector_paused():
        book = template.declare(machine)
        save(to_workbook(book, template.model), book, path, overwrite)


def inputs(path: Path) -> tuple[Machine, list[str]]:
    """Return what an engineer entered into a workbook, and in lines what of it is not carried over."""
    file = open_book(path)
    entries = Entries(file)
    machine = entries.machine()
    notes = [f"{cell} holds a formula; its value is taken" for cell in entries.computed]
    return machine, notes + not_carried(file, entries.template.declare(machine), entries.template.name)


def write_inputs(machine: Machine, path: Path, overwrite: bool = False) -> None:
    """Write a machine description, whole or not at all; raise WriteError as :func:`build` does."""
    refuse_existing(path, overwrite)
    replace(path, lambda draft: write_text(draft, write_machine(machine)))


def write_text(path: Path, text: str) -> None:
    """Write UTF-8 with plain line ends on every system."""
    path.write_bytes(text.encode())


def committed() -> list[Path]:
    """Return the committed machine descriptions, several of some templates; the workbook of each lies beside it."""
    return sorted(FOLDER.glob("*.toml"))


def write_templates() -> list[Path]:
    """Generate the workbook of every committed machine description, and the files of the functions."""
    books = [description.with_suffix(".xlsx") for description in committed()]
    for description, book in zip(committed(), books, strict=True):
        build(read_machine(description), book, overwrite=True)
    return [*books, *publish.write_files()]


def stale_templates() -> list[Path]:
    """Return the committed files that today's code would generate differently."""
    books = [description.with_suffix(".xlsx") for description in committed() if stale(description)]
    return books + publish.stale_files()


def stale(description: Path) -> bool:
    """Whether the workbook beside a committed description differs from a fresh one."""
    book = description.with_suffix(".xlsx")
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / book.name
        build(read_machine(description), fresh)
        return not book.exists() or not same_book(fresh, book)
