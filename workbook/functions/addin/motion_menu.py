"""The menu *Motion* of Calc: the document in memory verified by motionbook in a process of its own, and its findings.

A copy goes into a temporary folder; nothing is written beside the document, and no macro of it is run.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
import threading
from typing import Any, Callable

import uno
import unohelper
from com.sun.star.awt import Point, Size
from com.sun.star.beans import PropertyValue
from com.sun.star.frame import XDispatch, XDispatchProvider
from com.sun.star.lang import XInitialization, XServiceInfo
from motion_functions.window import Call, Marks, Window, line, note, within
from motionbook_python import PYTHON

IMPLEMENTATION = "motionbook.Menu"
SERVICES = ("com.sun.star.frame.ProtocolHandler",)
XLSX = "Calc MS Excel 2007 XML"
MARK = "motionbook finding "  # begins the names of the marks
RED, EDGE = 0xC00000, 60  # the colour of a mark; its width in 1/100 mm
MOST = 2000  # findings that are listed and marked
CELL = re.compile(r"[A-Z]{1,3}[0-9]+")
ABSENT = "motionbook does not answer. Install it as its README says, write this add-in anew by: motionbook addin"
OF_CALC = ("PYTHONPATH", "PYTHONHOME", "LD_LIBRARY_PATH", "URE_BOOTSTRAP", "UNO_PATH")  # no business of another Python
SPECIAL = re.compile(r'"[^"]*"|\'[^\']*\'|\{[^}]*\}|,')


def prop(name: str, value: object) -> PropertyValue:
    """Return a named value."""
    made = PropertyValue()
    made.Name, made.Value = name, value
    return made


def spelt(formula: str) -> str:
    """Return a formula of Excel with the separators that the API of Calc takes."""

    def changed(found: re.Match[str]) -> str:
        text = found[0]
        return text.replace(";", "|").replace(",", ";") if text[0] in ",{" else text

    return SPECIAL.sub(changed, formula)


class Session:
    """A document with the findings of its last verify; two documents know nothing of each other."""

    def __init__(self, context: Any, frame: Any) -> None:
        self.context, self.frame, self.document = context, frame, frame.getController().getModel()
        self.make: Callable[[str], Any] = lambda name: context.getServiceManager().createInstanceWithContext(
            name, context
        )
        self.findings: list[dict[str, Any]] = []
        self.says = ""
        self.running: subprocess.Popen[bytes] | None = None
        self.window: Window | None = None

    def show(self, says: str) -> None:
        """Show a sentence, and the findings."""
        if self.window is None:
            self.window = Window(self.make, self.frame.getContainerWindow(), self.go)
        self.says = says
        self.window.show(says, [line(finding) for finding in self.findings])

    def run(self, arguments: list[str], done: Callable[[int, str, str, str], None]) -> None:
        """Run motionbook on a copy of the document in memory; ``done`` gets its exit code, output and the folder."""
        if self.running is not None:
            self.show("motionbook is at work; Motion > Cancel ends it.")
            return
        folder = tempfile.mkdtemp(prefix="motionbook-")
        path = os.path.join(folder, "document.xlsx")
        self.document.storeToURL(uno.systemPathToFileUrl(path), (prop("FilterName", XLSX),))
        environment = {name: value for name, value in os.environ.items() if name not in OF_CALC}
        line = [PYTHON, "-m", "workbook", arguments[0], path, *arguments[1:]]
        flags = {"creationflags": 0x08000000} if os.name == "nt" else {}  # no console of its own
        try:
            process = subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       cwd=folder, env=environment, **flags)  # type: ignore[call-overload] # fmt: skip
        except OSError:
            shutil.rmtree(folder, ignore_errors=True)
            self.show(ABSENT)
            return
        self.running = process
        callback = self.make("com.sun.star.awt.AsyncCallback")

        def wait() -> None:
            out, err = (text.decode("utf-8", "replace") for text in process.communicate())
            callback.addCallback(Call(lambda: ended(out, err)), None)

        def ended(out: str, err: str) -> None:
            self.running = None
            try:
                if process.returncode not in (0, 1, 2, 3):
                    self.show("Cancelled." if process.returncode < 0 else ABSENT)
                elif "No module named" in err:
                    self.show(ABSENT)
                else:
                    done(process.returncode, out, err, folder)
            finally:
                shutil.rmtree(folder, ignore_errors=True)

        threading.Thread(target=wait, daemon=True).start()

    def verify(self) -> None:
        """Verify the document as it is in memory."""
        self.run(["verify", "--json"], self.verified)
        if self.running is not None and self.window is None:
            self.show("Verifying; Motion > Cancel ends it.")

    def verified(self, code: int, out: str, err: str, folder: str) -> None:
        """Show what came of it."""
        self.findings = []
        if code == 2 or not out.strip():
            self.show(" ".join(err.replace(os.path.join(folder, "document.xlsx"), "This document").split()) or ABSENT)
            return
        report = json.loads(out)
        self.findings = sorted(report["findings"][:MOST], key=lambda finding: finding["sheet"])
        failing = report["checks"]["failing"]
        own = f"of the machine's own checks {len(failing)} FAIL" if failing else "the machine's own checks hold"
        if report["agrees"]:
            self.show(f"OK: {report['compared']} formula cells compute what the engine computes; {own}.")
        else:
            self.show(f"FAIL: {len(report['findings'])} findings in {report['declared']} formula cells; {own}.")

    def cancel(self) -> None:
        """End what runs."""
        if self.running is not None:
            self.running.kill()

    def cell(self, finding: dict[str, Any]) -> Any:
        """Return the cell of a finding; None where it is about none."""
        sheets = self.document.getSheets()
        if not CELL.fullmatch(finding["cell"]) or not sheets.hasByName(finding["sheet"]):
            return None
        return sheets.getByName(finding["sheet"]).getCellRangeByName(finding["cell"])

    def go(self, number: int) -> None:
        """Go to the cell of a finding."""
        cell = self.cell(self.findings[number]) if 0 <= number < len(self.findings) else None
        if cell is not None:
            self.document.getCurrentController().select(cell)

    def mark(self) -> None:
        """Mark the cells of all findings with an edge, also on protected sheets; one undo takes all away."""
        self.clear()
        cells = [(cell, finding) for finding in self.findings if (cell := self.cell(finding)) is not None]

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

    def put_back(self) -> None:
        """Put the formulas of the findings in the selection back, or those of all where it has none."""
        chosen = self.document.getCurrentSelection()
        areas = [chosen] if hasattr(chosen, "getRangeAddress") else list(getattr(chosen, "RangeAddresses", ()))
        areas = [area.getRangeAddress() if hasattr(area, "getRangeAddress") else area for area in areas]
        wrong = [(self.cell(f), f["formula"]) for f in self.findings if f.get("formula")]
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
        self.show(f"Formulas put back: {done}. Verify again.{rest if closed else ''}")

    def regenerate(self) -> None:
        """Open a new document that is built from these entries."""
        self.run(["regenerate", "-o", "new.xlsx"], self.regenerated)

    def regenerated(self, code: int, out: str, err: str, folder: str) -> None:
        """Open it, or show why there is none."""
        path = os.path.join(folder, "new.xlsx")
        if not os.path.exists(path):
            self.show(" ".join(err.split()))
            return
        desktop = self.make("com.sun.star.frame.Desktop")
        desktop.loadComponentFromURL(uno.systemPathToFileUrl(path), "_blank", 0, (prop("AsTemplate", True),))

    def insert(self) -> None:
        """Open Calc's list of functions, where MOTION.* are."""
        helper = self.make("com.sun.star.frame.DispatchHelper")
        helper.executeDispatch(self.frame, ".uno:FunctionDialog", "", 0, ())


COMMANDS = "verify cancel mark clear put-back regenerate insert".split()
sessions: dict[str, Session] = {}
"""by the documents' own names of the moment"""


class Menu(unohelper.Base, XServiceInfo, XInitialization, XDispatchProvider, XDispatch):
    """The component that carries out the commands of the menu for a frame."""

    def __init__(self, context: Any) -> None:
        self.context = context
        self.frame: Any = None

    def initialize(self, arguments: Any) -> None:
        """Take the frame."""
        self.frame = arguments[0] if arguments else None

    def queryDispatch(self, url: Any, target: str, flags: int) -> Any:
        """Return itself for a command of the menu."""
        return self if url.Protocol == "motion:" and url.Path in COMMANDS else None

    def queryDispatches(self, requests: Any) -> tuple[Any, ...]:
        """Return itself for each command of the menu."""
        return tuple(self.queryDispatch(r.FeatureURL, r.FrameName, r.SearchFlags) for r in requests)

    def dispatch(self, url: Any, arguments: Any) -> None:
        """Carry out a command."""
        if self.frame is not None:
            name = self.frame.getController().getModel().RuntimeUID
            session = sessions.setdefault(name, Session(self.context, self.frame))
            getattr(session, url.Path.replace("-", "_"))()

    def addStatusListener(self, listener: Any, url: Any) -> None:
        """Take no notice: a command can always be given."""

    def removeStatusListener(self, listener: Any, url: Any) -> None:
        """Take no notice."""

    def getImplementationName(self) -> str:
        """Return the name that LibreOffice registers."""
        return IMPLEMENTATION

    def supportsService(self, name: str) -> bool:
        """Whether the component is such a service."""
        return name in SERVICES

    def getSupportedServiceNames(self) -> tuple[str, ...]:
        """Return the name of the service."""
        return SERVICES


g_ImplementationHelper = unohelper.ImplementationHelper()  # noqa: N816 - the name that LibreOffice looks for
g_ImplementationHelper.addImplementation(Menu, IMPLEMENTATION, SERVICES)
