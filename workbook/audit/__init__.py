"""Faults of a workbook that can be named from the workbook alone: each a rule of its own in a register.

Each finding says at which cell, why, how sure, and what the neighbours have. Nothing is evaluated but for saved values.
"""

from workbook.audit.register import Audit, audit

__all__ = ["Audit", "audit"]
