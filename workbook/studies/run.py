"""A study from its first part to its last: parts are worked out by a pool, and kept as they come."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from workbook.errors import MotionbookError
from workbook.pool import Died, Pool
from workbook.studies import tables
from workbook.studies.evaluate import Evaluator
from workbook.studies.folder import Parts
from workbook.studies.plan import Plan
from workbook.studies.space import Shares, Space
from workbook.studies.summary import Summary, merged, summed

POPULATION = 15  # designs of a generation for each range, scipy's own figure


@dataclass(frozen=True)
class Piece:
    """A part of the designs: its number, the first design and the one behind the last; of a search, where they are."""

    number: int
    begin: int
    end: int
    shares: Shares | None = None


@dataclass(frozen=True)
class Done:
    """A part that is worked out."""

    rows: bytes
    summary: Summary


@lru_cache(maxsize=2)
def evaluator(plan: bytes) -> Evaluator:
    """Return what works a plan out, once in a process."""
    return Evaluator(pickle.loads(plan))


def work(piece: Piece, plan: bytes, suffix: str) -> Done:
    """Work a part out."""
    one = evaluator(plan)
    study, space = one.plan.study, one.plan.space
    columns = space.columns(piece.begin, piece.end) if piece.shares is None else space.shared(piece.shares)
    table = one.table(piece.begin, columns)
    labels = [dimension.label for dimension in space.dimensions]
    rows = tables.part(tables.columns(labels, table), suffix)
    return Done(rows, summed(study, labels, table, scored=piece.shares is not None))


def pieces(space: Space, step: int) -> Iterator[Piece]:
    """Yield the parts of all designs, of so many each."""
    for number, begin in enumerate(range(0, space.size, step)):
        yield Piece(number, begin, min(begin + step, space.size))


def run(plan: Plan, parts: Parts, pool: Pool, told: Callable[[int, bool], object]) -> Summary:
    """Work out what is not there yet of a study, and keep it; return what is known of all of it.

    ``told`` is called with the number of designs as they are done, and whether they were there before.
    """
    running = Running(plan, parts, pool, told)
    if plan.space.way.kind == "evolution":
        running.evolve()
    else:
        running.do(pieces(plan.space, parts.step))
    return merged(plan.study, (parts.summary(number) for number in sorted(parts.complete())))


class Running:
    """A study while it runs."""

    def __init__(self, plan: Plan, parts: Parts, pool: Pool, told: Callable[[int, bool], object]) -> None:
        self.plan, self.parts, self.pool, self.told = plan, parts, pool, told
        self.sent = pickle.dumps(plan)
        self.there = parts.complete()

    def do(self, wanted: Iterable[Piece]) -> None:
        """Work out and keep what is not there yet; what a worker died of is tried again, a piece at a time."""
        again = self._kept(self._missing(wanted))
        for piece in again:
            if self._kept([piece]):
                raise MotionbookError(f"designs {piece.begin + 1:,} to {piece.end:,}: {DIED}")

    def _kept(self, wanted: Iterable[Piece]) -> list[Piece]:
        """Work out and keep pieces; return those whose worker died."""
        died = []
        for piece, done in self.pool.each(work, wanted, self.sent, self.parts.suffix):
            if isinstance(done, Died):
                died.append(piece)
                continue
            self.parts.keep(piece.number, done.rows, done.summary)
            self.told(piece.end - piece.begin, False)
        return died

    def _missing(self, wanted: Iterable[Piece]) -> Iterator[Piece]:
        for piece in wanted:
            if piece.number in self.there:
                self.told(piece.end - piece.begin, True)
            else:
                yield piece

    def evolve(self) -> None:
        """Search by differential evolution, a generation at a time; what was tried before is not tried again.

        Source: R. Storn, K. Price, J. Global Optimization 11 (1997) 341–359, in scipy.optimize.
        """
        from scipy.optimize import differential_evolution

        space = self.plan.space
        ranges = len(space.dimensions)
        rounds = max(0, space.size // (POPULATION * ranges) - 1)
        begun = [0, 0]  # designs and parts so far

        def tried(_: object, population: Iterable[Any]) -> list[float]:
            shares = np.array(list(population)).reshape(-1, ranges)
            generation = list(parted(shares, begun[0], begun[1], self.parts.step))
            begun[0], begun[1] = generation[-1].end, generation[-1].number + 1
            self.do(generation)
            return [score for piece in generation for score in self.parts.summary(piece.number).scores]

        differential_evolution(
            nothing, [(0.0, 1.0)] * ranges, maxiter=rounds, popsize=POPULATION, rng=space.way.seed, polish=False,
            updating="deferred", workers=tried, tol=1e-9, init="latinhypercube",
        )  # fmt: skip


DIED = "the workers that tried them died (out of memory?); --resume tries them again"


def nothing(_: Sequence[float]) -> float:
    """Stand for the function that is searched: generations are worked out as a whole."""
    raise NotImplementedError


def parted(shares: Shares, begin: int, number: int, step: int) -> Iterator[Piece]:
    """Yield the parts of a generation, of so many designs each."""
    for at in range(0, len(shares), step):
        some = shares[at : at + step]
        yield Piece(number, begin + at, begin + at + len(some), some)
        number += 1
