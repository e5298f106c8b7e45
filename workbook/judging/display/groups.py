"""Differences between a file and a fresh build of the same inputs, cells with the same one told in one line."""

from workbook.book.address import Address
from workbook.judging.report import NOTICE, SHOWN, Report


class Differences:
    """Differences of what is shown, by sheet, attribute, and what is expected and held."""

    def __init__(self) -> None:
        self._groups: dict[tuple[str, str, str, str, str, str], tuple[Address, str, int]] = {}

    def add(
        self,
        at: Address,
        attribute: str,
        expected: object,
        held: object,
        what: str,
        misleads: bool,
        cells: int = 1,
        group: str = "",
    ) -> None:
        """Enter a difference of some cells, the first of them ``at``; one that misleads a reader is a finding.

        Cells of one ``group`` are told in one line, such as those of a chart.
        """
        key = at.sheet, SHOWN if misleads else NOTICE, attribute, str(expected), str(held), group
        first, name, count = self._groups.get(key, (at, what, 0))
        self._groups[key] = first, name, count + cells

    def enter(self, report: Report) -> None:
        """Enter all into a report, a line for each group: ``number format: 0.00 → 0%, 12 cells``."""
        for (_, kind, attribute, expected, held, _), (at, what, count) in self._groups.items():
            more = f", {count:,} cells" if count > 1 else ""
            report.say(at, kind, held, expected, f"{attribute} of {what}{more}")
