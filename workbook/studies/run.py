"""A study from its first part to its last, worked out by a pool in parts of measured size; the book of a design."""

import pickle
import time
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from workbook.book.quantity import OK
from workbook.build import write_book
from workbook.errors import InputError, MotionbookError
from workbook.judging.comparison import TOLERANCE
from workbook.judging.verify import verify
from workbook.pool import Pool, WorkerDied
from workbook.studies.evaluate import Evaluator, book_value
from workbook.studies.folder import Parts, part_bytes
from workbook.studies.plan import Plan
from workbook.studies.space import Shares, Space
from workbook.studies.summary import Design, Summary, merge, summarise

POPULATION = 15  # designs of a generation for each range, scipy's own figure
DIED = "the workers that tried them died (out of memory?); --resume tries them again"
TARGET = 2.0  # seconds that a part takes, about: progress moves, and little is lost where the work is interrupted
MOST = 10.0
MOST_ROWS = 20_000
TOGETHER = 24  # designs worked out together to measure the time of another


class Pace(NamedTuple):
    """Seconds for designs that differ only in what scales: what comes first, and for each at most."""

    first: float
    each: float

    def seconds(self, space: Space) -> float:
        """Return how long all designs take in sequence, at most (s)."""
        return space.size * (self.each + self.first / space.inner)

    def step(self, space: Space) -> int:
        """Return how many designs a part has: as many as take :data:`TARGET`; a whole group up to :data:`MOST` s."""
        inner = space.inner
        rows = int(min(MOST_ROWS, max(1.0, TARGET / max(self.each + self.first / inner, 1e-9))))
        if rows >= inner:
            return rows - rows % inner
        return inner if self.first + self.each * inner <= MOST and inner <= MOST_ROWS else rows


def measure_pace(plan: Plan) -> Pace:
    """Return how long designs of a study take, measured at a few of them before it begins."""
    evaluator, space = Evaluator(plan, thorough=True), plan.space
    alone = max(time_designs(evaluator, space, number, number + 1) for number in {0, space.size // 2, space.size - 1})
    count = min(TOGETHER, space.inner, space.size)
    if not evaluator.swift or count == 1:
        return Pace(0.0, alone)
    known, together = time_designs(evaluator, space, 0, 1), time_designs(evaluator, space, 0, count)
    each = max(0.0, together - known) / (count - 1)
    return Pace(max(0.0, alone - each), each)


def time_designs(evaluator: Evaluator, space: Space, begin: int, end: int) -> float:
    """Return how long some designs take (s); of a search, as many in the middle of all ranges."""
    middle = np.full((end - begin, len(space.dimensions)), 0.5)
    columns = space.shared(middle) if space.way.kind == "evolution" else space.columns(begin, end)
    begun = time.perf_counter()
    evaluator.table(begin, columns)
    return time.perf_counter() - begun


class Piece(NamedTuple):
    """A part of the designs: its number, the first design and the first behind it; of a search, where they are."""

    number: int
    begin: int
    end: int
    shares: Shares | None = None


def pieces(designs: range, number: int = 0, shares: Shares | None = None) -> Iterator[Piece]:
    """Yield the parts of designs, as many each as the range has for its step, numbered from ``number`` on."""
    for n, begin in enumerate(designs, number):
        end = min(begin + designs.step, designs.stop)
        some = None if shares is None else shares[begin - designs.start : end - designs.start]
        yield Piece(n, begin, end, some)


@lru_cache(maxsize=2)
def evaluator(plan: bytes) -> Evaluator:
    """Return the evaluator of a pickled plan, built once in a process."""
    return Evaluator(pickle.loads(plan))


def work_out(piece: Piece, plan: bytes, suffix: str) -> tuple[bytes, Summary]:
    """Return the rows of a part that is worked out, and what is known of them."""
    judge = evaluator(plan)
    study, space = judge.plan.study, judge.plan.space
    columns = space.columns(piece.begin, piece.end) if piece.shares is None else space.shared(piece.shares)
    table = judge.table(piece.begin, columns)
    labels = [dimension.label for dimension in space.dimensions]
    return part_bytes(labels, table, suffix), summarise(study, labels, table, scored=piece.shares is not None)


def run(plan: Plan, parts: Parts, pool: Pool, report: Callable[[int, bool], object]) -> Summary:
    """Work out what is not there yet of a study, and keep it; return what is known of all of it.

    ``report`` is called with the number of designs as they are done, and whether they were there before.
    """
    sent, there = pickle.dumps(plan), parts.complete()
    for number in there:
        report(parts.summary(number).designs, True)

    def run_and_store(wanted: Iterable[Piece]) -> list[Piece]:
        """Work out and keep pieces; return those whose worker died."""
        died = []
        for piece, done in pool.each(work_out, wanted, sent, parts.suffix):
            if isinstance(done, WorkerDied):
                died.append(piece)
                continue
            parts.keep(piece.number, *done)
            report(piece.end - piece.begin, False)
        return died

    def run_missing(wanted: Iterable[Piece]) -> None:
        """Work out and keep what is not there yet; what a worker died of is tried again, a piece at a time."""
        for piece in run_and_store(piece for piece in wanted if piece.number not in there):
            if run_and_store([piece]):
                raise MotionbookError(f"designs {piece.begin + 1:,} to {piece.end:,}: {DIED}")

    if plan.space.way.kind == "evolution":
        evolve(plan.space, parts, run_missing)
    else:
        run_missing(pieces(range(0, plan.space.size, parts.step)))
    return merge(plan.study, map(parts.summary, sorted(parts.complete())))


def evolve(space: Space, parts: Parts, run_missing: Callable[[Iterable[Piece]], None]) -> None:
    """Search by differential evolution, a generation at a time; what was tried before is not tried again.

    Source: R. Storn, K. Price, J. Global Optimization 11 (1997) 341–359, in scipy.optimize.
    """
    from scipy.optimize import differential_evolution

    ranges = len(space.dimensions)
    rounds = max(0, space.size // (POPULATION * ranges) - 1)
    begun = [0, 0]  # designs and parts so far

    def scores_of(_: object, population: Iterable[Any]) -> list[float]:
        shares = np.array(list(population)).reshape(-1, ranges)
        generation = list(pieces(range(begun[0], begun[0] + len(shares), parts.step), begun[1], shares))
        begun[0], begun[1] = generation[-1].end, generation[-1].number + 1
        run_missing(generation)
        return [score for piece in generation for score in parts.summary(piece.number).scores]

    differential_evolution(  # asks nothing of a single design: generations are worked out as a whole
        len,
        [(0.0, 1.0)] * ranges,
        maxiter=rounds,
        popsize=POPULATION,
        rng=space.way.seed,
        polish=False,
        updating="deferred",
        workers=scores_of,
        tol=1e-9,
        init="latinhypercube",
    )


class BookCheck(NamedTuple):
    """A design's book: its largest deviation from the study's results, what differs, whether every cell agrees.

    ``failing`` are its checks that FAIL, ``unasked`` those of them that are no constraints of the study.
    """

    deviation: float
    differing: tuple[str, ...]
    failing: tuple[str, ...]
    unasked: tuple[str, ...]
    cells: int
    agrees: bool

    @property
    def holds(self) -> bool:
        """Return whether the book agrees with the study."""
        return self.agrees and not self.differing and self.failing == self.unasked


def machine_of(plan: Plan, design: Design) -> Any:
    """Return the machine of a design."""
    machine = plan.machine({dimension: design.entries[dimension.label] for dimension in plan.space.dimensions})
    if isinstance(machine, str):
        raise InputError([f"design {design.number + 1}: {machine}"])
    return machine


def build_design(plan: Plan, design: Design, path: Path, overwrite: bool) -> BookCheck:
    """Build the book of a design, verify it, and compare it with the study's results."""
    book, _ = write_book(machine := machine_of(plan, design), path, overwrite)
    # mass and cost of a motor stand in no book
    apart = {
        name: deviation(value, book_value(book, name))
        for name, value in design.results.items()
        if name.partition(".")[0] in book.blocks
    }
    report = verify(path)
    differing = tuple(name for name, value in apart.items() if not value <= TOLERANCE)
    exact = plan.template.judge(machine)
    failing = tuple(q.name for _, q in book.checks if exact.judge(q.name, q.value, "")[0] != OK)
    unasked = tuple(filter(plan.study.is_off, failing))
    most = max(apart.values(), default=0.0)
    return BookCheck(most, differing, failing, unasked, report.compared, report.agrees)


def deviation(value: Any, other: Any) -> float:
    """Return by which share two results differ; texts by all or nothing."""
    if isinstance(value, str) or isinstance(other, str) or value == other:
        return float(value != other)
    return float(abs(value - other) / max(abs(value), abs(other), 1e-12))
