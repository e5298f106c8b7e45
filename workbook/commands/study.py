"""Study many designs of a machine: results, a page with the front, the book of a design that is picked."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict
from datetime import datetime
from pathlib import Path
from tempfile import TemporaryDirectory

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from workbook.build import write_text
from workbook.cluster import pool
from workbook.errors import InputError, ReadError, WriteError
from workbook.exits import AGREES, DISAGREES, FAILS
from workbook.reports import study as page
from workbook.reports.terminal import ERR, OUT, say
from workbook.studies import tables
from workbook.studies.folder import Parts, read
from workbook.studies.judged import Judged, picked
from workbook.studies.named import Named, require_names
from workbook.studies.plan import Plan, read_study
from workbook.studies.run import pieces, run
from workbook.studies.summary import Summary
from workbook.writing.place import refuse_existing, replace


def study(
    path: Path, output: Path | None, scheduler: str | None, jobs: int | None, resume: bool, pick: int | None,
    unverified: bool, force: bool,
) -> int:  # fmt: skip
    """Run a study, or pick a design of one that was run; return the exit code."""
    plan = read_study(path)
    named = require_names(plan, str(path))
    book = output if pick is not None else None
    results = Path(f"{path.stem}.csv") if output is None or book is not None else output
    if book is not None and book.suffix.lower() != ".xlsx":
        raise WriteError(f"{book}: a design that is picked becomes a workbook; expected .xlsx")
    tables.require_format(results)
    if pick is not None and not plan.study.goals:
        raise InputError([f"{path}: --pick takes the best, and no objective is told; expected minimise or maximise"])
    told = results.with_suffix(".json")
    found = known(plan, told) if pick is not None else None
    if found is None:
        found = ran(plan, results, named, scheduler, jobs, resume, unverified, force)
    if pick is None or not found.feasible:
        return AGREES if found.feasible else FAILS
    if not 1 <= pick <= len(found.best):
        raise InputError([f"--pick {pick}: there are {len(found.best)} best designs; expected 1 to {len(found.best)}"])
    target = book or results.with_name(f"{results.stem}-{pick}.xlsx")
    refuse_existing(target, force)
    with ERR.status("Building and verifying …"):
        judged = picked(plan, found.best[pick - 1], target, force)
    say(OUT, f"Built {target.absolute()}")
    return show_judged(judged)


def ran(
    plan: Plan, results: Path, named: Named, scheduler: str | None, jobs: int | None, resume: bool,
    unverified: bool, force: bool,
) -> Summary:  # fmt: skip
    """Run a study to its end, write results, what is known of them, and the page."""
    others = [results.with_suffix(".json"), results.with_suffix(".html")]
    parts = Parts(results, plan.digest, plan.space.size)
    over = force or (resume and parts.mine)  # it was killed when it had written some of them
    for one in (results, *others):
        refuse_existing(one, over)
    begin = time.perf_counter()
    small = plan.space.way.kind != "evolution" and sum(1 for _ in zip(pieces(plan.space), range(2), strict=False)) < 2
    with pool(1 if small and scheduler is None else jobs, scheduler) as workers, parts.opened(resume, force):
        with interruptible(parts), progress(plan.space.size) as done:
            found = run(plan, parts, workers, done)
        names = ["design", *(one.label for one in plan.space.dimensions), *plan.study.names, "feasible", "impossible"]
        rows = [parts.rows(number) for number in sorted(parts.complete())]
        replace(results, lambda draft: tables.join(names, rows, draft, results.suffix.lower()), over)
    seconds = time.perf_counter() - begin
    replace(others[0], lambda draft: write_text(draft, saved(plan, found)), over)
    judged = best_judged(plan, found) if found.best and not unverified else None
    when = datetime.now().astimezone()
    replace(others[1], lambda draft: write_text(draft, page.page(plan, found, named, judged, when)), over)
    parts.remove()
    show(plan, found, results, seconds)
    if judged:
        show_judged(judged)
    return found


def saved(plan: Plan, found: Summary) -> str:
    """Return what is known of a study, as a text that --pick reads."""
    return json.dumps({"digest": plan.digest} | asdict(found), ensure_ascii=False, indent=1) + "\n"


def known(plan: Plan, path: Path) -> Summary | None:
    """Return what is known of a study that was run, None where that was another one, or none."""
    try:
        data = json.loads(read(path) or "{}")
        if data.pop("digest", "") != plan.digest:
            return None
        return Summary.of_json(json.dumps(data))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise ReadError(f"{path}: no results of a study; delete it, and run the study again") from error


def best_judged(plan: Plan, found: Summary) -> Judged:
    """Build and verify the best design where nobody looks."""
    with TemporaryDirectory() as folder, ERR.status("Verifying the best …"):
        return picked(plan, found.best[0], Path(folder) / "best.xlsx", False)


@contextmanager
def interruptible(parts: Parts) -> Iterator[None]:
    """Say what is kept where the work is interrupted from the keyboard."""
    try:
        yield
    except KeyboardInterrupt:
        say(ERR, f"Interrupted. {parts.folder}: {parts.held}")
        raise


@contextmanager
def progress(total: int) -> Iterator[Callable[[int, bool], None]]:
    """Show a bar with rate and remaining time on a terminal, and nothing elsewhere."""
    columns = (TextColumn("Studying"), BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"),
               TimeRemainingColumn())  # fmt: skip
    with Progress(*columns, console=ERR, transient=True, disable=not ERR.is_terminal) as bar:
        task, begin, fresh = bar.add_task("", total=total), time.perf_counter(), [0]

        def done(count: int, before: bool) -> None:
            fresh[0] += 0 if before else count
            rate = fresh[0] / max(time.perf_counter() - begin, 1e-9)
            bar.update(task, advance=count, description=f"{rate:,.0f}/s")

        yield done


def show(plan: Plan, found: Summary, results: Path, seconds: float) -> None:
    """Print what came of a study in a few lines."""
    say(
        OUT,
        f"{found.designs:,} designs in {seconds:.1f} s: {found.feasible:,} feasible, {found.impossible:,} impossible",
    )
    for line in page.exclusions(plan.study, found):
        say(OUT, line, "" if found.feasible else "yellow")
    if not found.feasible:
        say(OUT, "No design is feasible.", "red")
    for place, design in enumerate(found.best[:5], 1):
        entries = ", ".join(f"{name} = {page.figure(value)}" for name, value in design.entries.items())
        goals = ", ".join(f"{name} = {page.figure(design.results[name])}" for name in plan.study.goals)
        say(OUT, f"{place}. design {design.number + 1}: {goals}; {entries}")
    if len(found.best) > 5:
        say(OUT, f"and {len(found.best) - 5} more, on the page")
    say(OUT, f"Wrote {results.absolute()}, and beside it .html and .json")


def show_judged(judged: Judged) -> int:
    """Print whether a design's book says what the study said; return the exit code."""
    say(OUT, page.judged_line(judged), "green" if judged.holds else "red")
    return AGREES if judged.holds else DISAGREES
