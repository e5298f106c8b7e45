"""motionbook in a process of its own, beside Calc; what comes of it is told in the main thread of Calc."""

from __future__ import annotations

import os
import shutil
import subprocess
import threading
from typing import Any, Callable

import unohelper
from com.sun.star.awt import XCallback
from motionbook_python import PYTHON

OF_CALC = ("PYTHONPATH", "PYTHONHOME", "LD_LIBRARY_PATH", "URE_BOOTSTRAP", "UNO_PATH")  # no business of another Python


class Call(unohelper.Base, XCallback):
    """A call that the main thread of Calc carries out when it is free."""

    def __init__(self, act: Callable[[], None]) -> None:
        self.act = act

    def notify(self, data: object) -> None:
        """Carry the call out."""
        self.act()


class Work:
    """A command of motionbook at work in a temporary folder, which goes with it.

    ``ended`` gets its exit code, output, errors and folder; with ``heard``, which gets each line of its output, it is a
    watch. Raises OSError where there is no such Python.
    """

    def __init__(self, arguments: list[str], folder: str, later: Any, ended: Callable[..., None], heard: Any) -> None:
        self.folder, self.later, self.ended, self.heard = folder, later, ended, heard
        environment = {name: value for name, value in os.environ.items() if name not in OF_CALC}
        flags = {"creationflags": 0x08000000} if os.name == "nt" else {}  # no console of its own
        self.process = subprocess.Popen(
            [PYTHON, "-m", "workbook", *arguments],
            stdin=subprocess.PIPE,  # a watch ends with it, also where Calc has crashed
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=folder,
            env=dict(environment, PYTHONIOENCODING="utf-8"),
            **flags,  # type: ignore[call-overload]
        )
        threading.Thread(target=self.listen, args=(folder,), daemon=True).start()

    def listen(self, folder: str) -> None:
        """Pass on what it prints, in a thread, until it has ended."""
        for text in self.process.stdout if self.heard else ():
            self.tell(self.heard, text.decode("utf-8", "replace"))
        out, err = (text.decode("utf-8", "replace") for text in self.process.communicate())
        if not self.folder:  # what is at work can hold its folder
            shutil.rmtree(folder, ignore_errors=True)
        self.tell(self.finish, self.process.returncode, out, err)

    def tell(self, act: Callable[..., None], *arguments: object) -> None:
        """Let the main thread carry out an act, unless the work is ended until then."""
        self.later.addCallback(Call(lambda: act(*arguments) if self.folder else None), None)

    def finish(self, *how: object) -> None:
        """Tell how the command ended."""
        try:
            self.ended(*how, self.folder)
        finally:
            self.end()

    def end(self) -> None:
        """End it, and take its folder away."""
        stdin, self.process.stdin = self.process.stdin, None  # the thread does not close it twice
        if self.heard:
            stdin.close()
        else:
            self.process.kill()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder = ""
