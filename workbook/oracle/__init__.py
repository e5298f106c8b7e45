"""Verify a workbook of one's own: its inputs and outputs declared in Python, compared at many values of the inputs.

A file of declarations gives an :class:`Oracle`; ``motionbook verify BOOK.xlsx --against FILE.py`` runs it.
"""

from workbook.oracle.declarations import Input, Oracle, Output, Table

__all__ = ["Input", "Oracle", "Output", "Table"]
