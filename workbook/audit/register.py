"""The register of rules, and the audit of a workbook by all of them."""

from dataclasses import dataclass, field

from workbook.audit import patterns, ranges, scales, twins, units, values
from workbook.audit.finding import SURE, Finding, Sure
from workbook.audit.lines import Lines
from workbook.audit.units import Units
from workbook.audit.view import View
from workbook.reading.files import BookFile

OF_LINES = (*patterns.RULES, *ranges.RULES, *values.RULES)
OF_UNITS = (*units.RULES, *scales.RULES, *twins.RULES)
KINDS = {
    "pattern": "a formula that differs from the pattern of its row or column",
    "typed-over": "a number where the cells around have formulas",
    "gap": "an empty cell where the cells around have formulas",
    "dollar": "a $ that its neighbours have not, or lacks what they have",
    "moved-off": "a reference that moves along where it should stay",
    "stuck": "a reference that stays where it should move along",
    "range": "a range that ends early or late, or has a total too",
    "unsorted": "a look-up of the nearest value in what is not sorted",
    "text-number": "a text that looks like a number",
    "blank": "an empty cell that is read as zero",
    "hidden-error": "an error that becomes a number",
    "circular": "a cell that needs its own value",
    "link": "a reference to another file",
    "volatile": "a function that changes by itself, or reads what no trace shows",
    "stale": "a saved value that is not what the formula gives",
    "hidden": "a hidden sheet, row or column that a formula reads",
    "dimension": "units that do not go together",
    "scale": "a conversion of units that is missing, wrong or there twice",
    "drifted": "a copy of a sheet that differs in little",
    "other-value": "the same label with another value",
    "typed-in": "a number in a formula for which there is a cell",
    "unread": "an entry that no formula reads",
}

# from which an entry of the row is not read
CAUSES = frozenset(["pattern", "typed-over", "gap", "link", "volatile"])


@dataclass
class Audit:
    """The result: findings, the surest first, and how many formula cells there are."""

    formulas: int
    findings: list[Finding] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def shown(self, least: Sure = "medium") -> list[Finding]:
        """Return the findings that are at least so sure."""
        return [f for f in self.findings if SURE.index(f.sure) <= SURE.index(least)]


def audit(file: BookFile) -> Audit:
    """Return the findings of all rules in a workbook, of each cell and rule once."""
    view = View(file)
    lines, known = Lines(view), Units(view)
    findings = [finding for rule in OF_LINES for finding in rule(lines)]
    findings += [finding for rule in OF_UNITS for finding in rule(lines, known)]
    each: dict[tuple[object, str], Finding] = {}
    rows = {f.cell[:2] for f in findings if f.rule in CAUSES}
    for finding in sorted(findings, key=lambda f: f.rank):
        if finding.rule != "unread" or finding.cell[:2] not in rows:
            each.setdefault((finding.cell, finding.rule), finding)
    unreadable = sum(not view.contents.formulas.get(cell) for cell in view.contents.failed)
    notes = list(file.notes)
    if unreadable:
        notes.append(f"{unreadable} formulas could not be taken apart; only their pattern was judged")
    return Audit(len(view.forms), list(each.values()), notes)
