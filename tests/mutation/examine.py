"""Mutants judged, counted and printed."""

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from tests.mutation.bench import Bench, Inputs
from tests.mutation.equivalence import Equivalence
from tests.mutation.mutants import KINDS, Mutant
from workbook.judging.verify import Report

ENTERED, VARIED, ELSEWHERE = "at the values entered", "at verify's variations", "only at other valid inputs"

HEADINGS = ("Kind", "Mutants", "Found", "Text", "a", "b", "c", "Equal", "Left", "First", "Rate")
NOTES = (
    f"Text: its text gives it away. a, b, c: its value does, {ENTERED}, {VARIED}, {ELSEWHERE} unknown to verify.",
    "Equal: no value gives it away, and a rule proves that none can. Left: neither found nor proven equal.",
    "First: verify names its cell first, of those that all of verify was asked about. Rate: found of found and left.",
)


@dataclass(frozen=True)
class Verdict:
    """What is known of one mutant: whether its text gives it away, where its value does, why it may be harmless."""

    mutant: Mutant
    by_text: bool
    by_value: str = ""  # one of the three places above, or nowhere
    equivalent: str = ""  # the rule that proves it

    def found(self, values_only: bool) -> bool:
        """Whether ``verify`` finds it, or would find it by values alone."""
        return self.by_value in (ENTERED, VARIED) or (self.by_text and not values_only)


def examined(bench: Bench, mutants: Iterable[Mutant], elsewhere: list[Inputs]) -> Iterator[Verdict]:
    """Judge each mutant by its own cell; ``elsewhere`` is where to look for those that no variation shows."""
    rules = Equivalence(bench)
    for mutant in mutants:
        by_text, at = bench.other_shape(mutant), bench.differs_at(mutant)
        if at is not None:
            yield Verdict(mutant, by_text, VARIED if at else ENTERED)
        elif reason := rules.reason(mutant):
            yield Verdict(mutant, by_text, equivalent=reason)
        else:
            shows = elsewhere and bench.differs_at(mutant, elsewhere) is not None
            yield Verdict(mutant, by_text, ELSEWHERE if shows else "")


def names_it_first(report: Report, mutant: Mutant) -> bool:
    """Whether the first finding of a report is the mutant's cell."""
    return [(f.sheet, f.cell) for f in report.findings[:1]] == [(mutant.address.sheet, mutant.address.a1)]


@dataclass
class Tally:
    """The verdicts, and the mutants that all of ``verify`` was asked about."""

    values_only: bool
    verdicts: list[Verdict] = field(default_factory=list)
    whole: list[tuple[Mutant, bool]] = field(default_factory=list)  # with whether its cell was named first

    @property
    def survivors(self) -> list[Verdict]:
        """Mutants that are not found and not proven equivalent."""
        return [v for v in self.verdicts if not v.found(self.values_only) and not v.equivalent]

    @property
    def not_first(self) -> list[Mutant]:
        """Mutants of which ``verify`` names another cell first, or none."""
        return [mutant for mutant, first in self.whole if not first]

    def show(self, console: Console, most: int) -> None:
        """Print the kill rates by kind of mutant, then what survived."""
        table = Table(*HEADINGS, box=SIMPLE_HEAD, padding=0, pad_edge=False)
        for kind in (*KINDS, "all"):
            table.add_row(kind, *self._row(kind))
        console.print(table)
        for words in NOTES:
            console.print(words, highlight=False)
        if self.values_only:
            console.print("Values only: what the text gives away is not counted as found.")
        for reason, count in Counter(v.equivalent for v in self.verdicts if v.equivalent).most_common():
            console.print(f"{count:>6} equivalent: {reason}", highlight=False)
        for verdict in sorted(self.survivors, key=lambda v: not v.by_value)[:most]:
            where = verdict.by_value or "no input is known at which it shows"
            console.print(f"{verdict.mutant}   ({where})", highlight=False, markup=False, soft_wrap=True)
        for mutant in self.not_first:
            console.print(f"Another cell is named first: {mutant}", highlight=False, markup=False, soft_wrap=True)

    def _row(self, kind: str) -> Iterator[str]:
        of = [v for v in self.verdicts if kind in ("all", v.mutant.kind)]
        places, found = Counter(v.by_value for v in of), sum(v.found(self.values_only) for v in of)
        left = sum(kind in ("all", v.mutant.kind) for v in self.survivors)
        firsts = [first for mutant, first in self.whole if kind in ("all", mutant.kind)]
        counts = (len(of), found, sum(v.by_text for v in of), places[ENTERED], places[VARIED], places[ELSEWHERE])
        yield from (f"{n:,}" for n in (*counts, sum(bool(v.equivalent) for v in of), left))
        yield f"{sum(firsts):,}/{len(firsts):,}"
        yield f"{found / (found + left):.2%}" if found + left else "-"
