"""Show a document with a fault, verified, and the menu Motion open; run by LibreOffice's Python for docs.menu."""

import sys
import time

from drive_menu import Driven, connect

MENU_BAR, POSITION = 35, 3  # AccessibleRole, PosSize


def part(context, is_wanted, depth=4):
    """Return the first part of a window that is wanted."""
    for i in range(min(context.getAccessibleChildCount(), 40)):
        child = context.getAccessibleChild(i).getAccessibleContext()
        if is_wanted(child):
            return child
        below = part(child, is_wanted, depth - 1) if depth else None
        if below is not None:
            return below
    return None


if __name__ == "__main__":
    pipe, path = sys.argv[1:]
    driven = Driven(connect(pipe), path)
    driven.frame.getContainerWindow().setPosSize(0, 0, 1280, 800, 15)
    driven.unprotect()
    cell = driven.cell("drive1_use_rms")
    driven.document.CurrentController.select(cell)
    cell.Value = 0.5
    driven.command("typed")
    driven.verified()
    toolkit = driven.make("com.sun.star.awt.Toolkit")
    tops = [toolkit.getTopWindow(i) for i in range(toolkit.getTopWindowCount())]
    (own,) = (top for top in tops if top.getAccessibleContext().getAccessibleName() == "Motion")
    own.setPosSize(60, 440, 0, 0, POSITION)
    window = driven.frame.getContainerWindow().getAccessibleContext()
    bar = part(window, lambda child: child.getAccessibleRole() == MENU_BAR)
    motion = part(bar, lambda child: child.getAccessibleName() == "Motion", 0)
    motion.doAccessibleAction(0)
    time.sleep(3)
