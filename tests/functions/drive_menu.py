"""Drive the menu Motion of a headless Calc over a pipe; run by LibreOffice's Python, prints what came of it as JSON."""

import json
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

    def __init__(self, context, path):
        self.manager, self.context = context.ServiceManager, context
        self.desktop = self.make("com.sun.star.frame.Desktop")
        self.document = self.desktop.loadComponentFromURL(path, "_blank", 0, ())
        self.frame = self.document.CurrentController.Frame

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

    def command(self, name):
        dispatch = self.make("com.sun.star.frame.DispatchHelper").executeDispatch
        self.in_main_thread(lambda: dispatch(self.frame, f"motion:{name}", "", 0, ()))

    def says(self):
        return self.in_main_thread(self.texts)

    def texts(self):
        """The texts of each window of the add-in."""
        toolkit = self.make("com.sun.star.awt.Toolkit")
        texts = []
        for i in range(toolkit.getTopWindowCount()):
            window = toolkit.getTopWindow(i).getAccessibleContext()
            if window.getAccessibleName() == "Motion":
                texts.append(texts_of(window, 0))
        return texts

    def answer(self, beginning):
        """The lines of the window, once its sentence is there."""
        for _ in range(2 * PATIENCE):
            (lines,) = self.says() or [[""]]
            if any(line.startswith(beginning) for line in lines):
                return list(dict.fromkeys(lines))
            time.sleep(0.5)
        return self.says()

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


def texts_of(context, depth):
    texts = [context.getAccessibleName()]
    if depth < 4:
        for i in range(min(context.getAccessibleChildCount(), 50)):
            texts += texts_of(context.getAccessibleChild(i).getAccessibleContext(), depth + 1)
    return [text for text in texts if text]


def damaged(context, path, folder):
    """Damage a document in memory, verify it, mark and unmark its findings, put the formula back."""
    driven, told = Driven(context, uno.systemPathToFileUrl(path)), {}
    driven.unprotect()
    cell = driven.cell("stamp_sum")
    told["formula"], cell.Value = cell.Formula, 1.0
    driven.command("verify")
    told["verified"] = driven.answer("FAIL")
    before = driven.stored(folder + "/before.ods")
    driven.command("mark")
    told["marked"], told["undo"] = driven.marks(), driven.document.UndoManager.CurrentUndoActionTitle
    driven.document.UndoManager.undo()
    told["undone"] = driven.marks()
    driven.document.UndoManager.redo()
    told["redone"] = driven.marks()
    driven.command("clear")
    told["cleared"], told["same"] = driven.marks(), before == driven.stored(folder + "/after.ods")
    driven.command("put-back")
    told["put back"], told["now"] = driven.answer("Formulas"), cell.Formula
    driven.document.UndoManager.undo()
    told["taken back"], told["url"] = cell.Value, driven.document.URL
    driven.document.close(True)
    return told


def other(context, beginning):
    """Verify a document that is no book of motionbook."""
    driven = Driven(context, "private:factory/scalc")
    driven.command("verify")
    told = driven.answer(beginning)
    driven.document.close(True)
    return told


if __name__ == "__main__":
    pipe, folder, beginning, *books = sys.argv[1:]
    context = connect(pipe)
    told = {"other": other(context, beginning), "books": [damaged(context, book, folder) for book in books]}
    context.ServiceManager.createInstanceWithContext("com.sun.star.frame.Desktop", context).terminate()
    print(json.dumps(told))
