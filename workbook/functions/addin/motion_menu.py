"""The menu *Motion* of Calc: the document in memory verified by motionbook in a process of its own, and its findings.

A copy goes into a temporary folder; nothing is written beside the document, and no macro of it is run.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import tempfile
import threading
from functools import partial
from typing import Any, Callable

import uno
import unohelper
from com.sun.star.beans import PropertyValue
from com.sun.star.frame import FeatureStateEvent, XDispatch, XDispatchProvider
from com.sun.star.lang import XInitialization
from com.sun.star.util import XModifyListener
from motion_functions.findings import Findings
from motion_functions.service import Service
from motion_functions.window import Window, ask_file, certificate, line
from motion_functions.work import Call, Work
from motionbook_python import TARGETS

XLSX, COPY = "Calc MS Excel 2007 XML", "document.xlsx"
MOST = 2000  # findings that are listed and marked
MOMENT = 1.0  # seconds without a change, after which it is verified as one types
ABSENT = "motionbook does not answer. Install it as its README says, write this add-in anew by: motionbook addin"
NO_AXIS = "No axis is under the cursor: go to the sheet of its drive, or to its phases on the sheet Timing."


def without_copy(text: str) -> str:
    """Return a text of motionbook in a line, the copy of the document called as it is for the user."""
    return " ".join(re.sub(r"\S*" + re.escape(COPY), "This document", text).split())


def prop(name: str, value: object) -> PropertyValue:
    """Return a named value."""
    made = PropertyValue()
    made.Name, made.Value = name, value
    return made


class Session(unohelper.Base, XModifyListener):
    """A document with its latest verdict; two documents know nothing of each other."""

    def __init__(self, context: Any, frame: Any, uid: str) -> None:
        self.uid, self.frame, self.document = uid, frame, frame.getController().getModel()
        self.make: Callable[[str], Any] = lambda name: context.getServiceManager().createInstanceWithContext(
            name, context
        )
        self.later = self.make("com.sun.star.awt.AsyncCallback")
        self.findings = Findings(self.document)
        self.says = self.doing = ""  # the sentence on the document; the command at work
        self.digest = self.copied = b""  # of the copy that was verified last, and of the latest
        self.is_verifying = self.is_typed = False
        self.timer = threading.Timer(MOMENT, self.rested)
        self.watch: Work | None = None  # stays, and verifies each copy of the document
        self.command: Work | None = None
        self.window: Window | None = None
        self.listeners: list[tuple[Any, Any, Any]] = []
        self.document.addModifyListener(self)

    def show(self, says: str) -> None:
        """Show a sentence, and the findings."""
        if self.window is None:
            self.window = Window(
                self.make, self.frame.getContainerWindow(), self.findings.go, partial(self.typed, True)
            )
        self.says = says
        self.window.show(says, [line(finding) for finding in self.findings.each])
        self.tell_state()

    def begin(self, arguments: list[str], ended: Callable[..., None], heard: Any = None) -> Work | None:
        """Begin a command on a copy of the document in memory; None where there is no motionbook."""
        folder = tempfile.mkdtemp(prefix="motionbook-")
        self.copy(folder)
        try:
            return Work(arguments, folder, self.later, ended, heard)
        except OSError:
            shutil.rmtree(folder, ignore_errors=True)
            self.show(ABSENT)
            return None

    def copy(self, folder: str) -> None:
        """Write the document as it is in memory into a folder."""
        path = os.path.join(folder, COPY)
        self.document.storeToURL(uno.systemPathToFileUrl(path), (prop("FilterName", XLSX),))
        with open(path, "rb") as data:
            self.copied = hashlib.sha256(data.read()).digest()

    def fail(self, code: int, err: str) -> None:
        """Show why a command did not do what it is for."""
        is_told = code in (1, 2, 3) and err.strip() and "No module named" not in err
        self.show(without_copy(err) if is_told else ABSENT)

    def verify(self) -> None:
        """Verify the document as it is in memory, by a process that stays and keeps what did not change."""
        before = self.digest if self.watch is not None else b""
        if self.watch is None:
            self.watch = self.begin(["watch", COPY, "--json", "--until-eof"], self.unwatched, self.heard)
        else:
            self.copy(self.watch.folder)
        if self.watch is not None:
            is_new, self.digest = before != self.copied, self.copied
            self.is_verifying = self.is_verifying or is_new
            # of the same bytes it tells nothing more
            self.show("Verifying; Motion > Cancel ends it." if is_new else self.says)

    def heard(self, text: str) -> None:
        """Show a verdict: the first is on the values alone."""
        verdict = json.loads(text)
        self.findings.each = sorted(verdict["findings"][:MOST], key=lambda finding: finding["sheet"])
        self.is_verifying = not verdict["whole"]
        self.show(without_copy(verdict["sentence"]))

    def unwatched(self, code: int, out: str, err: str, folder: str) -> None:
        """Show why the process ended that should stay."""
        self.watch, self.is_verifying = None, False
        self.fail(code, err)

    def typed(self, is_closed: bool = False) -> None:
        """Verify a moment after each change from now on, or no longer: also where its window is closed."""
        self.is_typed = not (self.is_typed or is_closed)
        if self.is_typed:
            self.verify()
        self.tell_state()

    def modified(self, event: object) -> None:
        """Begin to wait for the end of changes, which is when nothing changed for a moment."""
        if self.is_typed:
            self.timer.cancel()
            self.timer = threading.Timer(MOMENT, self.rested)
            self.timer.daemon = True
            self.timer.start()

    def rested(self) -> None:
        """Let the main thread verify what was changed."""
        self.later.addCallback(Call(lambda: self.verify() if self.is_typed else None), None)

    def disposing(self, event: object) -> None:
        """End all work for the document: it is closed."""
        sessions.pop(self.uid, None)
        self.is_typed = False
        self.end()

    def end(self) -> None:
        """End all work."""
        for work in filter(None, (self.watch, self.command)):
            work.end()
        self.watch, self.command, self.is_verifying = None, None, False

    def cancel(self) -> None:
        """End what runs."""
        if self.is_verifying or self.command is not None:
            self.end()
            self.show("Cancelled.")

    def tell_state(self) -> None:
        """Tell the menu whether it verifies as one types, and whether there is work to cancel."""
        for menu, listener, url in self.listeners:
            event = FeatureStateEvent()
            event.Source, event.FeatureURL = menu, url
            event.IsEnabled = url.Path != "cancel" or self.is_verifying or self.command is not None
            event.State = self.is_typed if url.Path == "typed" else None
            listener.statusChanged(event)

    def mark(self) -> None:
        """Mark the cells of all findings."""
        self.findings.mark()

    def clear(self) -> None:
        """Take all marks away."""
        self.findings.clear()

    def put_back(self) -> None:
        """Put formulas back, and show what came of it."""
        self.show(self.findings.put_back())

    def run(self, doing: str, arguments: list[str], done: Callable[..., None]) -> None:
        """Run a command on a copy of the document, a single one at once."""

        def ended(*how: Any) -> None:
            self.command = None
            done(*how)

        if self.command is None:
            self.doing, self.command = doing, self.begin(arguments, ended)
        if self.command is not None:
            self.show(f"{self.doing}; Motion > Cancel ends it.")

    def regenerate(self) -> None:
        """Open a new document that is built from these entries, own sheets carried over."""

        def regenerated(code: int, out: str, err: str, folder: str) -> None:
            path = os.path.join(folder, "new.xlsx")
            if not os.path.exists(path):
                self.fail(code, err)
                return
            url, new = uno.systemPathToFileUrl(path), (prop("AsTemplate", True),)
            self.make("com.sun.star.frame.Desktop").loadComponentFromURL(url, "_blank", 0, new)
            self.show(without_copy(err or out))

        self.run("Regenerating", ["regenerate", COPY, "-o", "new.xlsx"], regenerated)

    def export(self, file: str = "", to: str = "") -> None:
        """Write the cam table of the axis under the cursor; which file and for which controller is asked."""
        axis = self.findings.axis()
        if not axis:
            self.show(NO_AXIS)
            return
        if not file:
            title = os.path.splitext(self.document.getTitle())[0]
            file, kind = ask_file(self.make, f"{title}-{axis}", {kind: suffix for kind, (_, suffix) in TARGETS.items()})
            to = TARGETS[kind][0] if file else ""
        if file:
            path = uno.fileUrlToSystemPath(file)
            options = ["--axis", axis, "--to", to, "-o", path, "--force", "--json"]
            self.run(f"Exporting {axis}", ["export", COPY, *options], self.exported)

    def exported(self, code: int, out: str, err: str, folder: str) -> None:
        """Show the certificate of a cam table."""
        if code or not out.strip():
            self.fail(code, err)
            return
        (table,) = json.loads(out)
        self.show(certificate(table) + " " + without_copy(err))

    def insert(self) -> None:
        """Open Calc's list of functions, where MOTION.* are."""
        helper = self.make("com.sun.star.frame.DispatchHelper")
        helper.executeDispatch(self.frame, ".uno:FunctionDialog", "", 0, ())


COMMANDS = "verify typed cancel mark clear put-back regenerate export insert".split()
sessions: dict[str, Session] = {}
"""by the documents' own names of the moment"""


class Menu(Service, XInitialization, XDispatchProvider, XDispatch):
    """The component that carries out the commands of the menu for a frame."""

    NAME, SERVICES = "motionbook.Menu", ("com.sun.star.frame.ProtocolHandler",)

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
        """Carry out a command, with arguments that a macro gives it."""
        if self.frame is not None:
            given = {argument.Name.lower(): argument.Value for argument in arguments if argument.Name in ("File", "To")}
            getattr(self.session(), url.Path.replace("-", "_"))(**given)

    def session(self) -> Session:
        """Return the session of the frame's document."""
        name = self.frame.getController().getModel().RuntimeUID
        if name not in sessions:
            sessions[name] = Session(self.context, self.frame, name)
        return sessions[name]

    def addStatusListener(self, listener: Any, url: Any) -> None:
        """Tell a listener of the menu the state of a command from now on."""
        session = self.session()
        session.listeners.append((self, listener, url))
        session.tell_state()

    def removeStatusListener(self, listener: Any, url: Any) -> None:
        """Tell a listener nothing more."""
        for session in sessions.values():
            session.listeners = [known for known in session.listeners if known[1] != listener]


g_ImplementationHelper = unohelper.ImplementationHelper()  # noqa: N816 - the name that LibreOffice looks for
g_ImplementationHelper.addImplementation(Menu, Menu.NAME, Menu.SERVICES)
