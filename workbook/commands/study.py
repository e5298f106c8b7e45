"""Study many designs of a machine: results, a page with the front, the book of a design that is picked."""

import json
import time
from dataclasses import asdict
from datetime import datetime
from pathlib import Path
from tempfile import TemporaryDirectory

from workbook.cluster import pool
from workbook.errors import AGREES, DISAGREES, FAILS, InputError, ReadError, WriteError
from workbook.pool import Pool, cores
from workbook.reading.descriptions import read_machine
from workbook.reports import study as page
from workbook.reports.console import progress
from workbook.reports.differences import figure
from workbook.reports.terminal import ERR, OUT, say
from workbook.studies.evaluate import Evaluator, Labels, listed_results, require_names
from workbook.studies.folder import ENDS, Parts, join, read, require_format
from workbook.studies.plan import Plan, read_study
from workbook.studies.run import BookCheck, build_design, measure_pace, run
from workbook.studies.summary import Summary
from workbook.writing.output_files import refuse_existing, replace, write_text

SHORT, LONG = 4.0, 5.0
"""seconds: a study that takes fewer is worked out by this process alone; a longer study is announced"""
UNITS = ((86400.0, "days"), (3600.0, "hours"), (60.0, "minutes"))


def study(
    path: Path,
    output: Path | None,
    scheduler: str | None,
    jobs: int | None,
    resume: bool,
    pick: int | None,
    unverified: bool,
    force: bool,
) -> int:
    """Run a study, or pick a design of a study that was run; return the exit code."""
    plan = read_study(path)
    results = Path(f"{path.stem}.csv") if output is None or pick is not None else output
    require_format(results)
    if pick is not None:
        require_pick(plan, path, output)
    summary = finished_study(plan, results) if pick is not None else None
    if summary is None:
        named = require_names(plan, str(path))
        summary = run_study(plan, results, named, scheduler, jobs, resume, unverified, force)
    if pick is None or not summary.feasible:
        return AGREES if summary.feasible else FAILS
    return pick_design(plan, summary, pick, output or results.with_name(f"{results.stem}-{pick}.xlsx"), force)


def require_pick(plan: Plan, path: Path, book: Path | None) -> None:
    """Raise WriteError or InputError where no design of a study can be picked, or not into this book."""
    if book is not None and book.suffix.lower() != ".xlsx":
        raise WriteError(f"{book}: a design that is picked becomes a workbook; expected .xlsx")
    if not plan.study.goals:
        raise InputError([f"{path}: --pick takes the best, and no objective is told; expected minimise or maximise"])


def pick_design(plan: Plan, summary: Summary, pick: int, book: Path, force: bool) -> int:
    """Build and verify the book of a design among the best, counted from 1; return the exit code."""
    best = len(summary.best)
    if not 1 <= pick <= best:
        raise InputError([f"--pick {pick}: there are {best} best designs; expected 1 to {best}"])
    refuse_existing(book, force)
    with ERR.status("Building and verifying …"):
        judged = build_design(plan, summary.best[pick - 1], book, force)
    say(OUT, f"Built {book.absolute()}")
    return show_judged(judged)


def run_study(
    plan: Plan,
    results: Path,
    named: Labels,
    scheduler: str | None,
    jobs: int | None,
    resume: bool,
    unverified: bool,
    force: bool,
) -> Summary:
    """Run a study to its end, write results, what is known of them, and the page."""
    others = [results.with_suffix(".json"), results.with_suffix(".html")]
    parts = Parts(results, plan.digest, plan.space.size)
    over = force or (resume and parts.mine)  # it was killed when it had written some of them
    for path in (results, *others):
        refuse_existing(path, over)
    begin = time.perf_counter()
    with ERR.status("Measuring how long a design takes …"):
        pace = measure_pace(plan)
    parts.step, seconds = pace.step(plan.space), pace.seconds(plan.space)
    at_once = 1 if seconds < SHORT else jobs or cores()
    with pool(at_once, scheduler) as workers, parts.opened(resume, force):
        for line in announce_duration(plan, seconds, None if scheduler else at_once):
            say(OUT, line)
        summary = run_with_progress(plan, parts, workers)
        names = ["design", *(row.label for row in plan.space.dimensions), *plan.study.names, *ENDS]
        rows = [parts.rows(number) for number in sorted(parts.complete())]
        replace(results, lambda draft: join(names, rows, draft, results.suffix.lower()), over)
    seconds = time.perf_counter() - begin
    text = json.dumps({"digest": plan.digest} | asdict(summary), ensure_ascii=False, indent=1)
    write_text(others[0], f"{text}\n", over)
    judged = None
    if summary.best and not unverified:  # the best's book, where nobody looks
        with TemporaryDirectory() as folder, ERR.status("Verifying the best …"):
            judged = build_design(plan, summary.best[0], Path(folder) / "best.xlsx", False)
    write_text(others[1], page.page(plan, summary, named, judged, datetime.now().astimezone()), over)
    parts.remove()
    show(plan, summary, results, seconds)
    if judged:
        show_judged(judged)
    return summary


def run_with_progress(plan: Plan, parts: Parts, workers: Pool) -> Summary:
    """Run the designs that are missing, with a bar that tells how many a second; return what came of all."""
    started, fresh = time.perf_counter(), 0

    def done(count: int, before: bool) -> None:
        nonlocal fresh
        fresh += 0 if before else count
        bar(count, f"{fresh / max(time.perf_counter() - started, 1e-9):,.0f}/s")

    try:
        with progress(ERR, "Studying", plan.space.size) as bar:
            return run(plan, parts, workers, done)
    except KeyboardInterrupt:
        say(ERR, f"Interrupted. {parts.folder}: {parts.held}")
        raise


def announce_duration(plan: Plan, seconds: float, at_once: int | None) -> list[str]:
    """Return in a line how long a study takes that is not done at once, and which results make it slow."""
    if seconds / (at_once or 1) < LONG:
        return []
    evaluator = Evaluator(plan)
    slow = [name for name in plan.study.names if name in evaluator.usual.slow]
    whys = ((evaluator.from_books, "from a book of each design"), (slow, "of each design by itself"))
    why = next((f"{', '.join(names)}: {words}" for names, words in whys if names), "")
    took = f"{at_once} cores" if at_once and at_once > 1 else "one core"
    lasts = seconds / (at_once or 1)
    size, unit = next((scale for scale in UNITS if lasts >= 2.0 * scale[0]), (1.0, "seconds"))
    message = f"{plan.space.size:,} designs take up to about {lasts / size:,.0f} {unit} on {took}"
    return [f"{message} ({why}; study --results lists what is fast)" if why else message]


def listing(base: Path) -> int:
    """Print which results a study of a machine may ask for: first what is fast."""
    for heading, names in listed_results(read_machine(base)):
        say(OUT, f"{heading}: {len(names):,}", "bold")
        for name, (words, unit) in names:
            say(OUT, f"  {name}  {words}" + (f" [{unit}]" if unit else ""))
    return AGREES


def finished_study(plan: Plan, results: Path) -> Summary | None:
    """Return the summary of a study that was run, also under another name; None if it was not; raise ReadError."""
    own = results.with_suffix(".json")
    for path in (own, *sorted(results.parent.glob("*.json"))):
        if summary := summary_from(plan, path, path == own):
            return summary
    if own.exists():
        message = "results of this study before it or its machine was changed"
        raise ReadError(f"{own}: {message}; run it again with --force, and then pick")
    return None


def summary_from(plan: Plan, path: Path, own: bool) -> Summary | None:
    """Return the summary of a study in a file; None where it is another's, or none."""
    try:
        data = json.loads(read(path) or "{}")
        return Summary.of_data(data) if data.pop("digest", "") == plan.digest else None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        if not own:
            return None
        raise ReadError(f"{path}: no results of a study; delete it, and run the study again") from error


def show(plan: Plan, summary: Summary, results: Path, seconds: float) -> None:
    """Print what came of a study in a few lines."""
    counts = f"{summary.feasible:,} feasible, {summary.impossible:,} impossible"
    say(OUT, f"{summary.designs:,} designs in {seconds:.1f} s: {counts}")
    for line in page.unranked_designs(summary):
        say(OUT, line, "yellow")
    for name, bounds, count, alone in page.excluding(plan, summary):
        line_text = f"{name} ({bounds}) excludes {count:,}, {alone:,} of them alone"
        say(OUT, line_text, "" if summary.feasible else "yellow")
    if not summary.feasible:
        say(OUT, "No design is feasible.", "red")
    for place, design in enumerate(summary.best[:5], 1):
        entries = ", ".join(f"{name} = {figure(value)}" for name, value in design.entries.items())
        goals = ", ".join(f"{name} = {figure(design.results[name])}" for name in plan.study.goals)
        say(OUT, f"{place}. design {design.number + 1}: {goals}; {entries}")
    if len(summary.best) > 5:
        say(OUT, f"and {len(summary.best) - 5} more, on the page")
    say(OUT, f"Wrote {results.absolute()}, and beside it .html and .json")


def show_judged(judged: BookCheck) -> int:
    """Print whether a design's book says what the study states; return the exit code."""
    say(OUT, page.judged_line(judged), "green" if judged.holds else "red")
    return AGREES if judged.holds else DISAGREES
