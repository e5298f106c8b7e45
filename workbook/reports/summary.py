"""Many workbooks at once, as the terminal shows them and as JSON for machines."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn
from rich.table import Table

from workbook.judging.one import Outcome
from workbook.reports.console import report_data, show_report
from workbook.reports.junit import line
from workbook.reports.terminal import say, say_data, shown
from workbook.visible import visible

WORST = 3  # findings of each workbook that the terminal shows
WORDS = {
    "agrees": "agrees",
    "fails": "agrees, DESIGN FAILS",
    "disagrees": "DISAGREES",
    "unreadable": "CANNOT BE READ",
    "no machine": "skipped, no machine",
}
SUMS = {
    "agrees": "agree",
    "fails": "agree and fail their own checks",
    "disagrees": "disagree",
    "unreadable": "cannot be read",
    "no machine": "skipped (no machine)",
}
COLOURS = {"agrees": "green", "fails": "red", "disagrees": "red", "unreadable": "red", "no machine": "dim"}


@contextmanager
def progress(console: Console, total: int) -> Iterator[Callable[[Outcome], None]]:
    """Show a bar on a terminal, and nothing elsewhere; give what is to be called for each workbook done."""
    columns = (
        SpinnerColumn(),
        TextColumn("Verifying"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("", total=total)
        yield lambda outcome: bar.update(task, advance=1, description=escape(visible(outcome.path.name)))


def show(
    outcomes: Sequence[Outcome], out: Console, err: Console, as_json: bool, alone: bool, everything: bool = False
) -> None:  # fmt: skip
    """Print a run: in full where one file was named ``alone``, else the summary of all."""
    if not alone:
        if as_json:
            say_data(f"{summary_json(outcomes)}\n")
        else:
            show_summary(outcomes, out)
        return
    for text in outcomes[0].reason.splitlines():
        say(err, text, "red")
    if outcomes[0].report and as_json:
        say_data(f"{json.dumps(report_data(outcomes[0].report), ensure_ascii=False, indent=1)}\n")
    elif outcomes[0].report:
        show_report(outcomes[0].report, out, everything)


def show_summary(outcomes: Sequence[Outcome], console: Console) -> None:
    """Print a table of all workbooks, the worst of what was found in each, and the sums."""
    table = Table("Workbook")
    for heading in ("Formula cells", "Findings"):
        table.add_column(heading, justify="right")
    table.add_column("Verdict", no_wrap=True)
    for o in outcomes:
        cells, found = (f"{o.report.compared:,}", f"{len(o.report.causes):,}") if o.report else ("-", "-")
        table.add_row(shown(str(o.path)), cells, found, shown(WORDS[o.verdict], COLOURS[o.verdict]))
    console.print(table)
    for outcome in outcomes:
        for text in worst(outcome):
            say(console, text)
    say(console, sums(outcomes))


def worst(outcome: Outcome) -> list[str]:
    """Return why a workbook cannot be read, or the worst of its findings, in lines."""
    if outcome.verdict == "unreadable":
        return outcome.reason.splitlines()
    if outcome.report is None:
        return []
    found = [line(finding) for finding in outcome.report.causes]
    found += [check.line for check in outcome.report.failing]
    lines = [f"{outcome.path}: {text}" for text in found[:WORST]]
    more = len(found) - WORST
    return [*lines, f"{outcome.path}: and {more:,} more; verify it alone, or add --report"] if more > 0 else lines


def sums(outcomes: Sequence[Outcome]) -> str:
    """Return the run in one line."""
    compared = sum(o.report.compared for o in outcomes if o.report)
    count = {verdict: sum(o.verdict == verdict for o in outcomes) for verdict in WORDS}
    said = [f"{count[verdict]} {words}" for verdict, words in SUMS.items() if count[verdict]]
    verified = sum(outcome.report is not None for outcome in outcomes)
    return f"{compared:,} formula cells compared in {verified} workbooks: {', '.join(said)}."


def summary_json(outcomes: Sequence[Outcome]) -> str:
    """Return the run as JSON: an object for each file, and the sum of the cells compared."""
    compared = sum(o.report.compared for o in outcomes if o.report)
    return json.dumps({"files": [entry(o) for o in outcomes], "compared": compared}, ensure_ascii=False, indent=1)


def entry(outcome: Outcome) -> dict[str, Any]:
    """Return one workbook's part of the JSON: its report, or the reason why there is none."""
    known: dict[str, Any] = {"file": str(outcome.path), "verdict": outcome.verdict}
    if outcome.report is None:
        return known | {"compared": 0, "findings": [], "reason": outcome.reason}
    known.update(report_data(outcome.report), sha256=outcome.sha256)
    return known
