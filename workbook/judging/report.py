"""The report of ``verify`` on a workbook: findings, notices, counts, and the book's own verdict."""

import math
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from workbook.book.address import Address
from workbook.book.quantity import OK
from workbook.judging.matching import Pair
from workbook.template_outputs import ExactJudgement

LAYOUT = "layout"  # the kind of rows and columns that were put into tables, or are gone
# the kinds of findings, causes before what follows from them
ORDER = (
    f"{LAYOUT} missing replaced formula changed name setting function unread error value follows saved shown witness"
).split()
CAUSES = ORDER[:7]  # the kinds from which wrong values follow elsewhere
FOLLOWS = "follows"  # the kind of what is wrong only because of other cells
# what may be read otherwise; what is reworded or gone and misleads nobody
SHOWN, NOTICE = "shown", "notice"


@dataclass(frozen=True)
class Finding:
    """One cell that is not what it should be; ``why`` it could not be evaluated, where that is known."""

    sheet: str
    cell: str
    kind: str
    computed: Any
    expected: Any
    what: str = ""
    deviation: float = math.inf  # relative to the greatest value of the column
    witness: str = ""
    why: str = ""


@dataclass
class WitnessRun:
    """A witness that was asked, and what came of the declared formula cells, each counted once."""

    name: str
    version: str | None
    compared: int = 0  # and agree
    at_fault: int = 0  # by what this witness computes, or by what the file holds
    unfinished: int = 0  # the engine has no value for these
    why: str = ""  # it computed none

    @property
    def absent(self) -> bool:
        """Whether the witness is not on this machine."""
        return self.version is None

    @property
    def answered(self) -> bool:
        """Whether it was asked, and stated what cells compute."""
        return not (self.absent or self.why)


@dataclass(frozen=True)
class Check:
    """A check of the machine's own: where it stands, what it is about, its verdict; where it fails and by how much."""

    sheet: str
    cell: str
    what: str
    found: str
    says: str = ""
    name: str = ""  # its own, in the book's declaration

    def judged(self, exact: ExactJudgement) -> "Check":
        """Return it as the exact engine judges it too."""
        value, says = exact.judge(self.name, self.found, self.says)
        return replace(self, found=value, says=says)

    @property
    def holds(self) -> bool:
        """Whether the check says OK."""
        return self.found == OK

    @property
    def line(self) -> str:
        """The check in a line."""
        message = f": {self.says}" if self.says else ""
        return f"{self.sheet}!{self.cell} ({self.what}): {self.found}{message}"


@dataclass
class Report:
    """The report of ``verify`` on a workbook; ``declared`` counts the formula cells that it should have."""

    path: Path
    template: str
    compared: int = 0
    declared: int = 0
    findings: list[Finding] = field(default_factory=list)
    notices: list[Finding] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    deviations: dict[str, float] = field(default_factory=dict)  # the largest of each sheet
    cells: dict[str, int] = field(default_factory=dict)  # declared formula cells of each sheet
    witnesses: list[WitnessRun] = field(default_factory=list)
    # of findings' cells, where no cell has moved
    formulas: dict[tuple[str, str], str] = field(default_factory=dict)
    own: list[str] = field(default_factory=list)  # formula cells that belong to nothing declared
    not_evaluated: int = 0  # of these
    notes: list[str] = field(default_factory=list)

    @property
    def agrees(self) -> bool:
        """Whether every formula cell computes what the engine computes, and shows it."""
        return not self.findings

    @property
    def causes(self) -> list[Finding]:
        """The findings without those that only follow from others; all where no cause is known."""
        return [f for f in self.findings if f.kind != FOLLOWS] or self.findings

    @property
    def findings_words(self) -> str:
        """The number of findings, and of the cells that follow from them, in words."""
        causes = len(self.causes)
        words, them = ("1 finding", "it") if causes == 1 else (f"{causes:,} findings", "them")
        more = len(self.findings) - causes
        return f"{words}; {more:,} cells are wrong only because of {them}" if more else words

    @property
    def failing(self) -> list[Check]:
        """The machine's own checks that do not hold."""
        return [check for check in self.checks if not check.holds]

    @property
    def unfinished(self) -> int:
        """The number of declared formula cells without a value, as the design is not finished."""
        return max((w.unfinished for w in self.witnesses), default=0)

    @property
    def holds(self) -> bool:
        """Whether the design is finished and passes its own checks."""
        return not self.failing and not self.unfinished

    @property
    def own_words(self) -> str:
        """The number of formulas that are the engineer's own; nothing where there are none."""
        return f"{len(self.own):,} formulas of your own, not checked" if self.own else ""

    @property
    def witness(self) -> str:
        """The witnesses that answered, with their versions."""
        return ", ".join(f"{w.name} {w.version}" for w in self.witnesses if w.answered)

    def tells(self, ran: WitnessRun) -> bool:
        """Whether a finding says that a witness could not answer."""
        return any(f.kind == "witness" and f.cell == ran.name for f in self.findings)

    def add(
        self,
        pair: Pair,
        kind: str,
        computed: Any,
        expected: Any,
        deviation: float = math.inf,
        by: str = "",
        why: str = "",
    ) -> None:
        """Enter a finding on a declared cell."""
        at, what = pair.address, pair.what
        finding = Finding(at.sheet, at.a1, kind, computed, expected, what, deviation, by, why)
        self.findings.append(finding)

    def add_at(self, at: Address, kind: str, value: Any, expected: Any, what: str) -> None:
        """Enter a finding, or a notice, on what stands at an address."""
        entry = Finding(at.sheet, at.a1, kind, value, expected, what)
        (self.notices if kind == NOTICE else self.findings).append(entry)
