"""How a program computes the book: settings with which it would show other figures than the formulas have."""

from collections.abc import Iterator

from openpyxl import Workbook

from workbook.judging.report import Finding


def settings(workbook: Workbook) -> Iterator[Finding]:
    """Yield the settings of a file that let formulas go stale, round them, or read them by other rules."""
    held = workbook.calculation
    if held is not None:
        if held.calcMode == "manual":
            yield setting("calculation", "manual", "automatic: else what is shown is not what was entered")
        if held.iterate:
            yield setting("calculation", "iterative", "not iterative: else a cell that depends on itself has a value")
        if held.fullPrecision is False:
            yield setting("calculation", "with the precision as displayed", "with full precision")
    for sheet in workbook.worksheets:
        properties = sheet.sheet_properties
        if properties.transitionEvaluation or properties.transitionEntry:
            yield setting("calculation", "by the rules of Lotus 1-2-3", "by those of Excel", sheet.title)


def setting(what: str, found: str, expected: str, sheet: str = "") -> Finding:
    """Return a finding on the file as a whole, or on one sheet."""
    return Finding(sheet, what, "setting", found, expected, "how the program computes")
