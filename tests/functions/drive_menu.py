"""Drive the menu Motion of a headless Calc over a pipe; run by LibreOffice's Python, prints what came of it as JSON.

drive_menu.py PIPE FOLDER PROGRAM PRESS MACHINE
drive_menu.py PIPE FOLDER PROGRAM LARGE
"""

import json
import os
import sys
import threading
import time
import zipfile

import uno
import unohelper
from com.sun.star.awt import XCallback
from com.sun.star.beans import PropertyValue

PATIENCE = 180  # seconds


def prop(name, value):
    made = PropertyValue()
    made.Name, made.Value = name, value
    return made


def connect(pipe):
    local = uno.getComponentContext()
    resolver = local.ServiceManager.createInstanceWithContext("com.sun.star.bridge.UnoUrlResolver", local)
    for _ in range(PATIENCE * 4):
        try:
            return resolver.resolve(f"uno:pipe,name={pipe};urp;StarOffice.ComponentContext")
        except Exception:
            time.sleep(0.25)
    raise SystemExit("Calc did not answer")


class Call(unohelper.Base, XCallback):
    """A call that Calc's main thread carries out, as it does those of a menu; other threads may not make windows."""

    def __init__(self, act):
        self.act, self.ended, self.result, self.failure = act, threading.Event(), None, None

    def notify(self, data):
        try:
            self.result = self.act()
        except Exception as error:  # raised again where it is waited for
            self.failure = error
        self.ended.set()


class Driven:
    """A document in Calc, and the commands of the menu on it."""

    def __init__(self, context, path="", document=None):
        self.manager, self.context = context.ServiceManager, context
        self.desktop = self.make("com.sun.star.frame.Desktop")
        url = uno.systemPathToFileUrl(path) if path else "private:factory/scalc"
        self.document = document or self.desktop.loadComponentFromURL(url, "_blank", 0, ())
        self.frame = self.document.CurrentController.Frame
        self.others = self.in_main_thread(self.windows)

    def make(self, name):
        return self.manager.createInstanceWithContext(name, self.context)

    def in_main_thread(self, act):
        call = Call(act)
        self.make("com.sun.star.awt.AsyncCallback").addCallback(call, None)
        if not call.ended.wait(PATIENCE):
            raise TimeoutError("Calc's main thread is not free")
        if call.failure is not None:
            raise call.failure
        return call.result

    def command(self, name, **arguments):
        given = tuple(prop(*argument) for argument in arguments.items())
        dispatch = self.make("com.sun.star.frame.DispatchHelper").executeDispatch
        self.in_main_thread(lambda: dispatch(self.frame, f"motion:{name}", "", 0, given))

    def windows(self):
        """The windows of the add-in."""
        toolkit = self.make("com.sun.star.awt.Toolkit")
        every = [toolkit.getTopWindow(i).getAccessibleContext() for i in range(toolkit.getTopWindowCount())]
        self.titles = [window.getAccessibleName() for window in every]
        return [window for window, title in zip(every, self.titles, strict=True) if title == "Motion"]

    def says(self):
        """The texts of the window of this document, which came after those that were there before."""
        return self.in_main_thread(lambda: [texts_of(window, 0) for window in self.own()])

    def own(self):
        return [window for window in self.windows() if window not in self.others]

    def answer(self, *beginnings):
        """The lines of the window, once its sentence begins so."""
        for _ in range(2 * PATIENCE):
            (lines,) = self.says() or [[""]]
            if any(line.startswith(beginnings) for line in lines):
                return list(dict.fromkeys(lines))
            time.sleep(0.5)
        return self.says()

    def verified(self):
        """The lines of the window, once the verdict is whole."""
        for _ in range(2 * PATIENCE):
            lines = self.answer("Agrees", "Disagrees", "This")
            if not any("are being compared" in line for line in lines):
                return lines
            time.sleep(0.5)
        return lines

    def clicked(self):
        """The cell to which a click on the first finding goes."""
        self.in_main_thread(lambda: list_of(self.own()[0]).selectAccessibleChild(0))
        return self.document.CurrentSelection.AbsoluteName

    def unprotect(self):
        for sheet in self.document.Sheets:
            sheet.unprotect("")

    def cell(self, name):
        return self.document.NamedRanges.getByName(name).getReferredCells().getCellByPosition(0, 0)

    def marks(self):
        shapes = [shape for sheet in self.document.Sheets for shape in sheet.DrawPage]
        return [s.Description for s in shapes if s.Name.startswith("motionbook finding")]

    def stored(self, path):
        self.document.storeToURL(uno.systemPathToFileUrl(path), (prop("FilterName", "calc8"),))
        with zipfile.ZipFile(path) as archive:
            return archive.read("content.xml")


def list_of(context):
    """The list among the parts of a window, which can be chosen from."""
    parts = [context.getAccessibleChild(i).getAccessibleContext() for i in range(context.getAccessibleChildCount())]
    chosen = [part for part in parts if hasattr(part, "selectAccessibleChild") and part.getAccessibleChildCount()]
    return chosen[0] if chosen else next(filter(None, map(list_of, parts)), None)


def texts_of(context, depth):
    texts = [context.getAccessibleName()]
    if depth < 4:
        for i in range(min(context.getAccessibleChildCount(), 50)):
            texts += texts_of(context.getAccessibleChild(i).getAccessibleContext(), depth + 1)
    return [text for text in texts if text]


def damaged(context, path, folder):
    """Damage a document in memory, verify it, go to its finding, mark and unmark it, put the formula back."""
    driven, came = Driven(context, path), {}
    driven.unprotect()
    cell = driven.cell("timing_period")
    came["formula"], cell.Value = cell.Formula, 1.0
    driven.command("verify")
    came["verified"] = driven.verified()
    came["went"] = driven.clicked()
    before = driven.stored(folder + "/before.ods")
    driven.command("mark")
    came["marked"], came["undo"] = driven.marks(), driven.document.UndoManager.CurrentUndoActionTitle
    driven.document.UndoManager.undo()
    came["undone"] = driven.marks()
    driven.document.UndoManager.redo()
    came["redone"] = driven.marks()
    driven.command("clear")
    came["cleared"], came["same"] = driven.marks(), before == driven.stored(folder + "/after.ods")
    driven.command("put-back")
    came["put back"], came["now"] = driven.answer("Formulas"), cell.Formula
    driven.document.UndoManager.undo()
    came["taken back"] = cell.Value
    return driven, came


def beside(context, path, first):
    """Cancel a verify of a second document, verify it as one types; the first has no notice of it."""
    driven, came = Driven(context, path), {}
    before = first.says()
    driven.command("verify")
    driven.command("cancel")
    came["cancelled"] = driven.answer("Cancelled")
    driven.command("typed")
    came["typed"] = driven.verified()
    driven.unprotect()
    rate = driven.cell("timing_rate")
    for value in (41.0, 42.0, 43.0):  # more than once before the moment is over
        rate.Value = value
    cell, formula = driven.cell("timing_period"), driven.cell("timing_period").Formula
    cell.Value = 1.0
    came["wrong"] = driven.answer("Disagrees")
    cell.Formula = formula
    came["right"] = driven.answer("Agrees")
    driven.command("typed")
    rate.Value = 44.0
    time.sleep(3)
    came["off"] = driven.says()[0]
    came["mixed"] = before[0] not in first.says()
    return driven, came


def exported(context, path, folder):
    """Export the axis of the sheet, of the phases under the cursor; none where neither is there."""
    driven = Driven(context, path)
    came, controller, name = {}, driven.document.CurrentController, driven.cell("axis1_name").String
    for place, beginning in (("book_layout", "No axis"), ("drive1_use_rms", "Exporting "), ("axis1", name)):
        controller.select(driven.cell(place))
        file = f"{folder}/{place}.csv"
        driven.command("export", File=uno.systemPathToFileUrl(file), To="csv")
        came[place] = [driven.answer(beginning)[1], os.path.exists(file)]
        driven.command("cancel")
    driven.document.close(True)
    return {"name": name, **came}


def regenerated(context, driven):
    """Regenerate a document with a sheet of one's own; return what is in the new one."""
    sheets = driven.document.Sheets
    sheets.insertNewByName("Mine", sheets.Count)
    sheets.getByName("Mine").getCellRangeByName("A1").Formula = "=timing_rate*2"
    before, known = sheets.Count, {document.RuntimeUID for document in driven.desktop.Components}
    driven.command("regenerate")
    for _ in range(2 * PATIENCE):
        others = [document for document in driven.desktop.Components if document.RuntimeUID not in known]
        if others:
            break
        time.sleep(0.5)
    new = Driven(context, document=others[0])
    came = {"url": new.document.URL, "sheets": new.document.Sheets.Count == before}
    came["own"] = new.document.Sheets.getByName("Mine").getCellRangeByName("A1").Value
    came["formula"] = new.cell("timing_period").Formula
    new.document.close(True)
    return came


def other(context, program):
    """Verify a document that is no book of motionbook; then without motionbook."""
    driven, came = Driven(context), {}
    driven.command("verify")
    came["no book"] = driven.answer("This document")
    os.rename(program, program + ".gone")
    driven.command("regenerate")
    came["absent"] = driven.answer("motionbook does not answer")
    os.rename(program + ".gone", program)
    driven.document.close(True)
    return came


def inserted(context):
    """Ask for a function; return the titles of the windows."""
    driven = Driven(context)
    driven.command("insert")
    for _ in range(40):
        driven.in_main_thread(driven.windows)
        titles = driven.titles
        if any("Function" in title for title in titles):
            break
        time.sleep(0.5)
    return titles


def large(context, folder, program, path):
    """Verify a large machine as it is and with a number over a formula; Calc's main thread is free meanwhile."""
    driven = Driven(context, path)
    driven.unprotect()
    driven.command("verify")
    came = {"meanwhile": driven.answer("Verifying", "Agrees"), "clean": driven.verified()}
    driven.cell("omega").Value = 1.0
    driven.command("verify")
    came["damaged"] = driven.answer("Disagrees")
    return came


def all_of_it(context, folder, program, press, machine):
    """Carry out every command."""
    came = {"other": other(context, program)}
    first, came["damaged"] = damaged(context, press, folder)
    second, came["beside"] = beside(context, press, first)
    came["regenerated"] = regenerated(context, second)
    for driven in (first, second):
        driven.document.close(True)
    came["exported"] = exported(context, machine, folder)
    came["left"] = [name for name in os.listdir(os.environ["TMPDIR"]) if name.startswith("motionbook-")]
    came["inserted"] = inserted(context)
    return came


if __name__ == "__main__":
    pipe, *rest = sys.argv[1:]
    context = connect(pipe)
    print(json.dumps((large if len(rest) == 3 else all_of_it)(context, *rest)), flush=True)
