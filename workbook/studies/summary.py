"""A summary of designs: their number, the constraints that exclude them, the best of them."""

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from engine.selection.front import front
from workbook.studies.evaluate import Table
from workbook.studies.space import Study

BEST = 20  # designs in the summary of a single objective
WORST = 1e300  # the score of an impossible design


@dataclass(frozen=True)
class Design:
    """A design by its number: what varies, and its results."""

    number: int
    entries: dict[str, Any]
    results: dict[str, Any]


@dataclass
class Summary:
    """Sums over designs; ``scores`` of each only where a search asks for them."""

    designs: int = 0
    impossible: int = 0
    feasible: int = 0
    unranked: int = 0  # how many of these lack a value of an objective
    without: dict[str, int] = field(default_factory=dict)  # how many of them have none of each
    excluded: dict[str, int] = field(default_factory=dict)
    alone: dict[str, int] = field(default_factory=dict)
    """how many designs a constraint excludes that keep to all others"""
    reasons: dict[str, int] = field(default_factory=dict)
    best: list[Design] = field(default_factory=list)
    scores: list[float] = field(default_factory=list)

    @classmethod
    def of_data(cls, data: dict[str, Any]) -> Self:
        """Return the summary that JSON describes; raise TypeError or KeyError for other data."""
        return cls(**data | {"best": [Design(**design) for design in data["best"]]})


MOST_REASONS = 20


def summarise(study: Study, labels: list[str], table: Table, scored: bool = False) -> Summary:
    """Return the summary of the designs of a table."""
    possible, feasible = table.possible, table.feasible
    misses = np.sum([*table.fails.values(), ~possible], axis=0)
    rows = np.flatnonzero(feasible)
    points = goals(study, table.results, rows)
    reasons, counts = np.unique(table.reasons[~possible].astype(str), return_counts=True)
    summary = Summary(
        len(table),
        int((~possible).sum()),
        int(feasible.sum()),
        int((~np.isfinite(points)).any(axis=1).sum()),
        dict(zip(study.goals, (~np.isfinite(points)).sum(axis=0).tolist(), strict=True)),
        {name: int((possible & failed).sum()) for name, failed in table.fails.items()},
        {name: int((possible & failed & (misses == 1)).sum()) for name, failed in table.fails.items()},
        dict(zip(reasons.tolist()[:MOST_REASONS], counts.tolist()[:MOST_REASONS], strict=True)),
    )
    named = list(zip(labels, table.entries, strict=True))
    for row in rows[best_points(points)].tolist():
        entries = {label: plain(entry.values[entry.places[row]]) for label, entry in named}
        results = {name: plain(values[row]) for name, values in table.results.items()}
        summary.best.append(Design(table.begin + row, entries, results))
    if scored:
        summary.scores = scores(study, table).tolist()
    return summary


def goals(study: Study, results: Mapping[str, NDArray[Any]], rows: NDArray[np.intp]) -> NDArray[np.float64]:
    """Return the objectives of designs, a row each, less being better; what has none is worse than all."""
    columns = [way * results[name][rows].astype(np.float64) for name, way in study.goals.items()]
    points = np.column_stack(columns) if columns else np.empty((len(rows), 0))
    return np.where(np.isnan(points), np.inf, points)


def best_points(points: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return the best points: of a single objective :data:`BEST` of them, of several those that none beats."""
    if points.shape[1] == 1:
        order = np.argsort(points[:, 0], kind="stable")[:BEST]
        return np.asarray(order[np.isfinite(points[order, 0])])
    some = np.flatnonzero(np.isfinite(points).all(axis=1))
    return np.asarray(some[front(points[some])]) if points.shape[1] else np.zeros(0, dtype=np.intp)


def scores(study: Study, table: Table) -> NDArray[np.float64]:
    """Return by what a search goes: the objective, or how much is overstepped, worse than any objective."""
    (objective,) = goals(study, table.results, np.arange(len(table))).T
    over = np.sum([*table.fails.values(), ~table.possible], axis=0)
    worse = np.where(table.possible, WORST * (0.5 + over), np.inf)
    return np.where(table.feasible & np.isfinite(objective), objective, worse)


def plain(value: Any) -> Any:
    """Return a value as JSON has it."""
    return value.item() if isinstance(value, np.generic) else value


def merge(study: Study, summaries: Iterable[Summary]) -> Summary:
    """Return the summary of several tables together."""
    whole = Summary()
    for summary in summaries:
        for part in ("designs", "impossible", "feasible", "unranked"):
            setattr(whole, part, getattr(whole, part) + getattr(summary, part))
        for part in ("without", "excluded", "alone", "reasons"):
            sums = Counter(getattr(whole, part))
            sums.update(getattr(summary, part))  # names that count nothing stay
            setattr(whole, part, dict(sums))
        whole.reasons = dict(sorted(whole.reasons.items(), key=lambda each: -each[1])[:MOST_REASONS])
        # equals go by their numbers
        ranked = sorted([*whole.best, *summary.best], key=lambda each: each.number)
        points = np.array([[way * each.results[name] for name, way in study.goals.items()] for each in ranked], float)
        whole.best = [ranked[k] for k in best_points(points.reshape(len(ranked), len(study.goals)))]
    return whole
