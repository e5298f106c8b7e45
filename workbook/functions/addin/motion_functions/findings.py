"""The findings in a document: gone to, marked over the sheet, their formulas put back; the axis under the cursor."""

from __future__ import annotations

import re
from typing import Any, Callable

import uno
from com.sun.star.awt import Point, Size
from motion_functions.window import Marks, note, within

MARK = "motionbook finding "  # begins the names of the marks
RED, EDGE = 0xC00000, 60  # the colour of a mark; its width in 1/100 mm
AXIS = re.compile(r"drive[0-9]+_axis|axis[0-9]+_name")  # cells with the name of an axis
CELL = re.compile(r"[A-Z]{1,3}[0-9]+")
SPECIAL = re.compile(r'"[^"]*"|\'[^\']*\'|\{[^}]*\}|,')


def spelt(formula: str) -> str:
    """Return a formula of Excel with the separators that the API of Calc takes."""

    def changed(found: re.Match[str]) -> str:
        text = found[0]
        return text.replace(";", "|").replace(",", ";") if text[0] in ",{" else text

    return SPECIAL.sub(changed, formula)


class Findings:
    """The findings of the latest verdict on a document, ``each`` as JSON has it."""

    def __init__(self, document: Any) -> None:
        self.document = document
        self.each: list[dict[str, Any]] = []

    def cell(self, finding: dict[str, Any]) -> Any:
        """Return the cell of a finding; None where it is about none."""
        sheets = self.document.getSheets()
        if not CELL.fullmatch(finding["cell"]) or not sheets.hasByName(finding["sheet"]):
            return None
        return sheets.getByName(finding["sheet"]).getCellRangeByName(finding["cell"])

    def go(self, number: int) -> None:
        """Go to the cell of a finding."""
        cell = self.cell(self.each[number]) if 0 <= number < len(self.each) else None
        if cell is not None:
            self.document.getCurrentController().select(cell)

    def mark(self) -> None:
        """Mark the cells of all findings with an edge, also on protected sheets; one undo takes all away."""
        self.clear()
        cells = [(cell, finding) for finding in self.each if (cell := self.cell(finding)) is not None]

        def draw() -> None:
            for cell, finding in cells:
                self.mark_cell(cell, finding)

        self.unrecorded(draw)
        self.document.getUndoManager().addUndoAction(Marks(lambda: self.unrecorded(draw), self.clear))

    def unrecorded(self, act: Callable[[], None]) -> None:
        """Change the document without an undo of Calc's own: of marks in several layers it makes none that it takes."""
        manager = self.document.getUndoManager()
        manager.lock()
        try:
            act()
        finally:
            manager.unlock()

    def mark_cell(self, cell: Any, finding: dict[str, Any]) -> None:
        """Draw an edge around a cell, over it and not in it, described as what is and what should be there."""
        shape = self.document.createInstance("com.sun.star.drawing.RectangleShape")
        cell.getSpreadsheet().getDrawPage().add(shape)
        at, size = cell.Position, cell.Size
        shape.setPosition(Point(at.X, at.Y))
        shape.setSize(Size(size.Width, size.Height))
        shape.FillStyle = uno.Enum("com.sun.star.drawing.FillStyle", "NONE")
        shape.LineColor, shape.LineWidth, shape.Printable = RED, EDGE, False
        shape.Name, shape.Title, shape.Description = MARK + finding["cell"], "Motion", note(finding)

    def clear(self) -> None:
        """Take all marks away."""
        self.unrecorded(self.take_marks_away)

    def take_marks_away(self) -> None:
        """Remove the shapes and notes that are marks."""
        sheets = self.document.getSheets()
        for sheet in (sheets.getByIndex(i) for i in range(sheets.getCount())):
            page = sheet.getDrawPage()
            shapes = [page.getByIndex(i) for i in range(page.getCount())]
            for shape in (shape for shape in shapes if shape.Name.startswith(MARK)):
                page.remove(shape)

    def selected(self) -> list[Any]:
        """Return the areas of cells that are selected."""
        chosen = self.document.getCurrentSelection()
        if hasattr(chosen, "getRangeAddress"):
            return [chosen.getRangeAddress()]
        return list(getattr(chosen, "RangeAddresses", ()))

    def put_back(self) -> str:
        """Put the formulas back of findings in the selection, of all where it has none; return what came of it."""
        areas = self.selected()
        wrong = [(self.cell(f), f["formula"]) for f in self.each if f.get("formula")]
        wrong = [(cell, formula) for cell, formula in wrong if cell is not None]
        inside = [pair for pair in wrong if any(within(pair[0].getCellAddress(), area) for area in areas)] or wrong
        manager, done, closed = self.document.getUndoManager(), 0, set()
        manager.enterUndoContext("Put back")
        try:
            for cell, formula in inside:
                if cell.getSpreadsheet().isProtected():
                    closed.add(cell.getSpreadsheet().getName())
                    continue
                parser = self.document.createInstance("com.sun.star.sheet.FormulaParser")
                parser.CompileEnglish, parser.FormulaConvention = True, 1  # AddressConvention.XL_A1
                cell.setTokens(parser.parseFormula(spelt(formula), cell.getCellAddress()))
                done += 1
        finally:
            manager.leaveUndoContext()
        rest = f" Left as they are, for they are protected (Tools > Protect Sheet): {', '.join(sorted(closed))}."
        return f"Formulas put back: {done}. Verify again.{rest if closed else ''}"

    def axis(self) -> str:
        """Return the name of the axis on whose sheet the cursor is, or in whose phases; empty where it is in none."""
        controller, names, above = self.document.getCurrentController(), self.document.NamedRanges, []
        sheet = controller.getActiveSheet().getRangeAddress().Sheet
        row = min((area.StartRow for area in self.selected()), default=0)
        for name in filter(AXIS.fullmatch, names.getElementNames()):
            cells = names.getByName(name).getReferredCells()
            at = cells.getRangeAddress() if cells else None
            if at and at.Sheet == sheet:
                place = -1 if name.startswith("drive") else at.StartRow
                above.append((place, cells.getCellByPosition(0, 0).String))
        return max((pair for pair in above if pair[0] <= row), default=(0, ""))[1]
