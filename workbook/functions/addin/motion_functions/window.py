"""The window of the menu *Motion*, the question for a file, and marks as what an undo takes back."""

from __future__ import annotations

from typing import Any, Callable

import unohelper
from com.sun.star.awt import XItemListener, XTopWindowListener
from com.sun.star.document import XUndoAction
from com.sun.star.ui.dialogs.TemplateDescription import FILESAVE_AUTOEXTENSION


class Marks(unohelper.Base, XUndoAction):
    """The marks of findings as what an undo takes back."""

    def __init__(self, redo: Callable[[], None], undo: Callable[[], None]) -> None:
        self.Title, self.redo, self.undo = "Mark findings", redo, undo


class Window(unohelper.Base, XItemListener, XTopWindowListener):
    """The window beside a document: a sentence, and a list of which a click goes to a cell."""

    def __init__(
        self, make: Callable[[str], Any], parent: Any, go: Callable[[int], None], closed: Callable[[], None]
    ) -> None:
        model = make("com.sun.star.awt.UnoControlDialogModel")
        model.Title, model.Width, model.Height, model.PositionX, model.PositionY = "Motion", 300, 170, 20, 60
        for kind, name, top, high in (("FixedText", "says", 4, 34), ("ListBox", "list", 40, 126)):
            part = model.createInstance("com.sun.star.awt.UnoControl" + kind + "Model")
            part.PositionX, part.PositionY, part.Width, part.Height = 4, top, 292, high
            if kind == "FixedText":
                part.MultiLine = True
            model.insertByName(name, part)
        self.go, self.closed, self.dialog = go, closed, make("com.sun.star.awt.UnoControlDialog")
        self.dialog.setModel(model)
        self.dialog.createPeer(make("com.sun.star.awt.Toolkit"), parent)
        self.list = self.dialog.getControl("list")
        self.list.addItemListener(self)
        self.dialog.addTopWindowListener(self)

    def show(self, says: str, lines: list[str]) -> None:
        """Show a sentence and lines below it."""
        self.dialog.getModel().getByName("says").Label = says
        self.dialog.getModel().getByName("list").StringItemList = tuple(lines)
        if not self.dialog.isVisible():
            self.dialog.setVisible(True)

    def itemStateChanged(self, event: Any) -> None:
        """Go to the cell of the line that is chosen."""
        self.go(event.Selected)

    def windowClosing(self, event: object) -> None:
        """Hide it; the next command shows it again."""
        self.dialog.setVisible(False)
        self.closed()

    def ignored(self, event: object) -> None:
        """Do nothing about an event of the window."""

    disposing = windowOpened = windowClosed = windowMinimized = windowNormalized = ignored
    windowActivated = windowDeactivated = ignored


def within(cell: Any, area: Any) -> bool:
    """Whether a cell is in an area."""
    rows, columns = area.StartRow <= cell.Row <= area.EndRow, area.StartColumn <= cell.Column <= area.EndColumn
    return bool(cell.Sheet == area.Sheet and rows and columns)


def line(finding: dict[str, Any]) -> str:
    """Return a finding in a line."""
    what = finding["what"] or finding["kind"]
    return f"{finding['sheet']}!{finding['cell']}  {what}: {finding['computed']}; expected {finding['expected']}"


def note(finding: dict[str, Any]) -> str:
    """Return the note on a finding."""
    formula = f"\nformula: {finding['formula']}" if finding.get("formula") else ""
    return f"is: {finding['computed']}\nshould be: {finding['expected']}{formula}"


def ask_file(make: Callable[[str], Any], name: str, kinds: dict[str, str]) -> tuple[str, str]:
    """Return the URL of a file to write and its kind, of kinds with suffixes; empty where none is chosen."""
    picker = make("com.sun.star.ui.dialogs.FilePicker")
    picker.initialize((FILESAVE_AUTOEXTENSION,))
    for kind, suffix in kinds.items():
        picker.appendFilter(kind, "*" + suffix)
    picker.setDefaultName(name)
    return (picker.getFiles()[0], picker.getCurrentFilter()) if picker.execute() else ("", "")


def certificate(table: dict[str, Any]) -> str:
    """Return the certificate of a cam table in a sentence: by how much it is off, under the rule that is worst."""
    rules = list(table["rules"].values())
    worst = {word: max((rule[word] for rule in rules), key=lambda error: error["largest"]) for word in rules[0]}
    errors = (f"{word} {error['largest']:.3g} {error['unit']}" for word, error in worst.items())
    return f"{table['axis']}, {table['points']} points, read back and rebuilt: off by at most {', '.join(errors)}."
