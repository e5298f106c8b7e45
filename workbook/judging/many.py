"""Verify many workbooks: files and folders, by a pool of workers, one outcome each. Nothing is written."""

import os
import stat
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from workbook.collector import swept_between
from workbook.exits import AGREES, DISAGREES, FAILS, UNREADABLE
from workbook.judging.one import Outcome, Target, verify_one
from workbook.pool import HERE, Died, Pool
from workbook.reading.files import SUFFIXES
from workbook.visible import visible
from workbook.witnesses.beside import Beside

LARGEST = 200_000_000  # bytes of a file that is sent


class Sent(NamedTuple):
    """A workbook for a machine that may not see the file: its bytes, or None where they cannot be had."""

    target: Target
    place: str
    data: bytes | None


def sent(target: Target) -> Sent:
    """Return a workbook as it is handed out; one that cannot be read goes by its path, and the worker says so."""
    path, data = target.path.absolute(), None
    with suppress(OSError):
        data = path.read_bytes() if path.is_file() and path.stat().st_size <= LARGEST else None
    return Sent(target, str(path), data)


def verify_sent(book: Sent, witnesses: Sequence[str]) -> Outcome:
    """Verify a workbook on another machine; its outcome names it as it was named here."""
    name = book.target.path
    with tempfile.TemporaryDirectory() as folder:
        place = Path(book.place) if book.data is None else Path(folder, name.name)
        if book.data is not None:
            place.write_bytes(book.data)
        outcome = verify_one(Target(place, book.target.named), witnesses)
    report = replace(outcome.report, path=name) if outcome.report else None
    return replace(outcome, path=name, report=report, reason=outcome.reason.replace(str(place), str(name)))


def exit_code(outcomes: Iterable[Outcome]) -> int:
    """Return the gravest: 2 where a file cannot be read or none was verified, 1 where cells of one disagree.

    Else 3 where the cells agree and a design is unfinished or fails its own checks, and 0 where none does.
    """
    verdicts = {outcome.verdict for outcome in outcomes}
    if "unreadable" in verdicts or not verdicts - {"no machine"}:
        return UNREADABLE
    return DISAGREES if "disagrees" in verdicts else FAILS if "fails" in verdicts else AGREES


def find(paths: Sequence[Path]) -> tuple[list[Target], list[Outcome]]:
    """Return the workbooks that ``paths`` name or hold, each once, and what of them cannot be read.

    Lock files (``~$``) and hidden files and folders are passed over; links to folders are not followed.
    """
    targets: dict[Path, Target] = {}
    failed: list[Outcome] = []
    for path in paths:
        if is_folder(path):
            found = list(within(path, failed))
            if not found:
                failed.append(
                    Outcome(path, "unreadable", reason=visible(f"{path}: there is no workbook in this folder"))
                )
        else:
            found = [Target(path, named=True)]
        for target in found:
            key = target.path.absolute()
            if target.named or key not in targets:
                targets[key] = target
    return list(targets.values()), failed


def is_folder(path: Path) -> bool:
    """Whether a path leads to a folder; not where the system cannot tell, as of a name longer than any."""
    try:
        return path.is_dir()
    except OSError:
        return False


def within(folder: Path, failed: list[Outcome]) -> Iterator[Target]:
    """Yield the workbooks in a folder and its folders, in the order of their names."""

    def fail(error: OSError) -> None:
        where = Path(error.filename or folder)
        failed.append(
            Outcome(where, "unreadable", reason=visible(f"{where}: cannot be listed: {error.strerror or error}"))
        )

    for place, folders, files in os.walk(folder, onerror=fail):
        folders[:] = sorted(name for name in folders if not hidden(Path(place, name)))
        for name in sorted(files):
            path = Path(place, name)
            if path.suffix.lower() in SUFFIXES and not name.startswith("~$") and not hidden(path):
                yield Target(path, named=False)


def hidden(path: Path) -> bool:
    """Whether a file or folder is hidden, in the way of Unix or of Windows."""
    try:
        attributes = getattr(path.stat(), "st_file_attributes", 0)  # Windows only
    except OSError:
        attributes = 0
    return path.name.startswith(".") or bool(attributes & stat.FILE_ATTRIBUTE_HIDDEN)


def verify_many(
    targets: Sequence[Target],
    witnesses: Sequence[str] = ("pycel",),
    pool: Pool = HERE,
    done: Callable[[Outcome], object] = lambda outcome: None,
    beside: Beside | None = None,
) -> list[Outcome]:
    """Verify workbooks by a pool; call ``done`` as each is finished.

    The outcomes come in the order of ``targets``. One whose worker dies is tried once more, alone on a fresh worker.
    ``beside`` may be a process that evaluates meanwhile the book that this process verifies.
    """
    outcomes: dict[Target, Outcome] = {}

    def keep(target: Target, outcome: Outcome) -> None:
        outcomes[target] = outcome
        done(outcome)

    if pool is HERE:
        for target in swept_between(targets):
            keep(target, verify_one(target, witnesses, beside))
        return [outcomes[target] for target in targets]
    for target in by_pool(targets, witnesses, pool, keep):
        with pool.alone() as fresh:
            died = by_pool([target], witnesses, fresh, keep)
        if died:
            reason = f"{target.path}: verifying it ended the process (out of memory?)"
            keep(target, Outcome(target.path, "unreadable", reason=visible(reason)))
    return [outcomes[target] for target in targets]


def by_pool(
    targets: Sequence[Target], witnesses: Sequence[str], pool: Pool, keep: Callable[[Target, Outcome], object]
) -> list[Target]:
    """Verify by a pool, and keep what came of each; return those whose worker died."""
    books = map(sent, targets)
    each = pool.each(verify_sent, books, witnesses) if pool.distant else pool.each(verify_one, targets, witnesses)
    died = []
    for book, outcome in each:
        target = book if isinstance(book, Target) else book.target
        if isinstance(outcome, Died):
            died.append(target)
        else:
            keep(target, outcome)
    return died
