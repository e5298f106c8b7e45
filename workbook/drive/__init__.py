"""Blocks of a drive that several machines use: what it is entered as, its limits in cells.

Names and tables begin with ``@``, the scope of the drive (``drive_``, ``act_``): a sheet places the blocks within
``sheet.scoped``, so that a book can have several drives.
"""
