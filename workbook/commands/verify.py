"""Verify books and report on them; the verdict on a book is cached by its bytes."""

import os
from collections.abc import Sequence
from contextlib import suppress
from datetime import datetime
from pathlib import Path

import typer

from workbook import __version__
from workbook import build as making
from workbook.cluster import pool
from workbook.entries.machine import Machine
from workbook.errors import DISAGREES, TargetError, WriteError
from workbook.file_cache import load_cached, store_cached
from workbook.judging import batch
from workbook.judging.batch import file_digest, file_state
from workbook.judging.report import Report
from workbook.judging.verify import available_witnesses
from workbook.judging.verify import verify as judged
from workbook.pool import cores
from workbook.reports import console, page
from workbook.reports.page import junit as junit_xml
from workbook.reports.page import sarif as as_sarif
from workbook.reports.terminal import ERR, OUT, say, shown
from workbook.text_files import irregular_kind
from workbook.writing.output_files import refuse_same_file
from workbook.writing.stamp import write_stamp

VERDICT = "verdict"
DAILY = "pycel"  # the witness that is asked unless given otherwise


def verify(
    books: Sequence[Path],
    as_json: bool,
    report: Path | None,
    junit: Path | None,
    sarif: Path | None,
    force: bool,
    witnesses: Sequence[str] | None,
    jobs: int | None,
    everything: bool,
    scheduler: str | None = None,
    stamp: bool = False,
    in_place: bool = False,
) -> int:
    """Verify books, print what came of them and write the reports and stamps asked for; return the exit code."""
    page.require_writable(report, (".html", ".htm"), force)
    page.require_writable(junit, (".xml",), force)
    page.require_writable(sarif, (".sarif", ".json"), force)
    refuse_same_file(report, junit, sarif)
    asked = list(dict.fromkeys(witnesses or [DAILY]))  # each once, in the order named
    available_witnesses(asked)
    targets, failed = batch.find_workbooks(books)
    most = min(jobs or cores(), len(targets))
    with pool(most, scheduler) as workers, console.progress(ERR, "Verifying", len(targets)) as bar:
        outcomes = batch.verify_many(targets, asked, workers, lambda outcome: bar(1, outcome.path.name)) + failed
    alone = len(books) == 1 and not os.path.isdir(books[0])
    for outcome in outcomes if alone else ():
        if outcome.report is not None:
            cache_verdict(outcome.sha256, outcome.report)
    console.show(outcomes, OUT, ERR, as_json, alone, everything)
    when = datetime.now().astimezone()
    page.write(report, lambda: page.page(outcomes, when), force)
    page.write(junit, lambda: junit_xml(outcomes, when), force)
    page.write(sarif, lambda: as_sarif(outcomes), force)
    for outcome in outcomes if stamp else ():
        if outcome.report is not None:  # else it is told why there is none
            write_stamped(outcome, in_place, force)
    return batch.exit_code(outcomes)


def write_stamped(outcome: batch.Outcome, in_place: bool, force: bool) -> None:
    """Write a book that agrees with the stamp of its entries, ``-verified`` behind its name unless ``in_place``."""
    path = outcome.path
    if outcome.verdict == "disagrees":
        say(ERR, f"{path}: not stamped: its cells do not agree", "yellow")
        return
    match, *_ = making.read_entered(path)
    target = path if in_place else path.with_name(f"{path.stem}-verified{path.suffix}")
    if outcome.sha256 != digest_of(path):
        raise WriteError(f"{path}: it changed since it was verified; verify it again")
    write_stamp(match.file, match.declared, target, in_place or force)
    say(ERR, f"{target}: stamped")


State = tuple[int, int] | None


def open_finished(book: Path) -> tuple[Machine, State]:
    """Return the entries of a book, and the file's state before; end the command for an unfinished design."""
    before = file_state(book)
    machine, _ = making.read_inputs(book)
    if machine.design.replaced:
        say(ERR, f"{book}: the design is unfinished ({machine.design.faults[0].message}); nothing is exported", "red")
        raise typer.Exit(DISAGREES)
    return machine, before


def verified_header(book: Path, before: State, unverified: bool, fresh: bool = False) -> tuple[str, ...]:
    """Return the header's lines on a book that agrees or is not to be verified; end the command if it disagrees."""
    lines = ["NOT VERIFIED: nobody compared the book with the engine"] if unverified else []
    if not unverified:  # these bytes are verified once, unless ``fresh``
        sha256 = digest_of(book)
        known = load_cached(VERDICT, sha256) if sha256 and not fresh else None
        if not known:
            with ERR.status(shown(f"Verifying {book} …")):
                report = judged(book)
            known = {"findings": len(report.findings), "failing": [check.line for check in report.failing]}
            if sha256 and sha256 == digest_of(book):
                cache_verdict(sha256, report)
        if findings := int(known["findings"]):
            message = f"{findings:,} cells of the book are not what the engine computes"
            say(ERR, f"{book}: {message}; motionbook verify names them, --unverified exports all the same", "red")
            raise typer.Exit(DISAGREES)
        lines += [f"the design FAILS: {line}" for line in known["failing"]]
    for line in lines:
        say(ERR, f"Warning: {line}", "yellow")
    mark = f"made by motionbook {__version__} from {book.name}, SHA-256 {file_digest(book)}"
    if before != file_state(book):
        raise TargetError(f"{book}: it changed while it was read; try again")
    return (mark, *lines)


def cache_verdict(sha256: str, report: Report) -> None:
    """Cache the verdict on a file, if the usual witness answered and none failed."""
    answered = any(ran.name == DAILY and ran.answered for ran in report.witnesses)
    if answered and not any(finding.kind == "witness" for finding in report.findings):
        failing = [check.line for check in report.failing]
        store_cached(VERDICT, sha256, {"findings": len(report.findings), "failing": failing})


def digest_of(book: Path) -> str | None:
    """Return the SHA-256 of a regular file; None of what is none: reading it says why."""
    with suppress(OSError, ValueError):
        return None if irregular_kind(book) else file_digest(book)
    return None
