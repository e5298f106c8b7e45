"""Books for workers on other machines: by their paths where these see the files, else as bytes."""

import tempfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from workbook.judging.one import Outcome, Target, verify_one
from workbook.pool import Pool

LOOKED_AT = 20  # files, by which it is seen whether workers see them
LARGEST = 200_000_000  # bytes of a file that is sent


class Sent(NamedTuple):
    """A workbook for another machine: the target, where it lies, and its bytes where the machine does not see it."""

    target: Target
    place: str
    data: bytes | None


def sent(targets: Iterable[Target], as_bytes: bool) -> Iterator[Sent]:
    """Yield workbooks as they are handed out; one that cannot be read goes by its path, and the worker says so."""
    for target in targets:
        place = target.path.absolute()
        yield Sent(target, str(place), content(place) if as_bytes else None)


def content(path: Path) -> bytes | None:
    """Return the bytes of a file, None where it is too large or cannot be read."""
    try:
        return path.read_bytes() if path.is_file() and path.stat().st_size <= LARGEST else None
    except OSError:
        return None


def verify_sent(book: Sent, witnesses: Sequence[str]) -> Outcome:
    """Verify a workbook on another machine; its outcome names it as it was named here."""
    if book.data is None:
        return named(verify_one(Target(Path(book.place), book.target.named), witnesses), book, book.place)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, book.target.path.name)
        path.write_bytes(book.data)
        return named(verify_one(Target(path, book.target.named), witnesses), book, str(path))


def named(outcome: Outcome, book: Sent, place: str) -> Outcome:
    """Return an outcome with the path that a workbook has here."""
    path = book.target.path
    report = replace(outcome.report, path=path) if outcome.report else None
    return replace(outcome, path=path, report=report, reason=outcome.reason.replace(place, str(path)))


def sizes(places: Sequence[str]) -> list[int]:
    """Return how large files are where this runs, −1 for what is not there."""
    return [Path(place).stat().st_size if Path(place).is_file() else -1 for place in places]


def unseen(targets: Sequence[Target], pool: Pool) -> str:
    """Return in a line how many workers do not see the files; nothing where all do."""
    places = [str(one.path.absolute()) for one in targets[:LOOKED_AT]]
    here, there = sizes(places), pool.on_each(sizes, places)
    blind = sum(found != here for found in there.values())
    return f"{blind} of {len(there)} workers do not see these files: books are sent to them" if blind else ""
