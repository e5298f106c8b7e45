"""Mutants judged and counted."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from tests.mutation.bench import Bench, Inputs
from tests.mutation.mutants import Mutant
from workbook.judging.verify import Report

ENTERED, VARIED, ELSEWHERE = "at the values entered", "at verify's variations", "only at other valid inputs"


@dataclass(frozen=True)
class Verdict:
    """What is known of one mutant: whether its text gives it away, and where its value does."""

    mutant: Mutant
    by_text: bool
    by_value: str = ""  # one of the three places above, or nowhere

    @property
    def is_harmless(self) -> bool:
        """Whether it computes what the original computes: only a $ is gone, and nothing is copied."""
        return self.mutant.kind == "anchor"

    def found(self, values_only: bool) -> bool:
        """Whether ``verify`` finds it, or would find it by values alone."""
        return self.by_value in (ENTERED, VARIED) or (self.by_text and not values_only)


def examined(bench: Bench, mutants: Iterable[Mutant], elsewhere: list[Inputs]) -> Iterator[Verdict]:
    """Judge each mutant by its own cell; ``elsewhere`` is where to look for those that no variation shows."""
    for mutant in mutants:
        by_text, at = bench.other_shape(mutant), bench.differs_at(mutant)
        if at is None:
            shows = elsewhere and mutant.kind != "anchor" and bench.differs_at(mutant, elsewhere) is not None
            yield Verdict(mutant, by_text, ELSEWHERE if shows else "")
        else:
            yield Verdict(mutant, by_text, VARIED if at else ENTERED)


def survivors(verdicts: Iterable[Verdict], values_only: bool = False) -> list[Verdict]:
    """Return the mutants that are not found and not harmless."""
    return [v for v in verdicts if not v.found(values_only) and not v.is_harmless]


def names_it_first(report: Report, mutant: Mutant) -> bool:
    """Whether the first finding of a report is the mutant's cell."""
    return [(f.sheet, f.cell) for f in report.findings[:1]] == [(mutant.address.sheet, mutant.address.a1)]
