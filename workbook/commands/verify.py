"""Verify books, and report on them."""

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from workbook.cluster import cores, pool
from workbook.commands.trusted import keep
from workbook.judging import many
from workbook.judging.verify import present
from workbook.reports import console, page
from workbook.reports.servers import junit as junit_xml
from workbook.reports.servers import sarif as as_sarif
from workbook.reports.terminal import ERR, OUT
from workbook.witnesses.beside import Beside
from workbook.writing.place import refuse_one_for_two


def verify(
    books: Sequence[Path], as_json: bool, report: Path | None, junit: Path | None, sarif: Path | None, force: bool,
    witnesses: Sequence[str] | None, jobs: int | None, everything: bool, beside: Beside | None = None,
    scheduler: str | None = None,
) -> int:  # fmt: skip
    """Verify books, print what came of them and write the reports asked for; return the exit code."""
    page.ready(report, (".html", ".htm"), force)
    page.ready(junit, (".xml",), force)
    page.ready(sarif, (".sarif", ".json"), force)
    refuse_one_for_two(report, junit, sarif)
    asked = list(dict.fromkeys(witnesses or ["pycel"]))  # each once, in the order named
    present(asked)
    targets, failed = many.find(books)
    most = min(jobs or cores(), len(targets))
    with pool(most, scheduler) as workers, console.progress(ERR, len(targets)) as done:
        outcomes = many.verify_many(targets, asked, workers, done, beside) + failed
    alone = len(books) == 1 and not many.is_folder(books[0])
    for one in outcomes if alone else ():
        if one.report is not None:
            keep(one.sha256, one.report)
    console.show(outcomes, OUT, ERR, as_json, alone, everything)
    when = datetime.now().astimezone()
    page.write(report, lambda: page.page(outcomes, when), force)
    page.write(junit, lambda: junit_xml(outcomes, when), force)
    page.write(sarif, lambda: as_sarif(outcomes), force)
    return many.exit_code(outcomes)
