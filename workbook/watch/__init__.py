"""``motionbook watch``: the verdict on a workbook each time it is saved, on the terminal and on a page."""
