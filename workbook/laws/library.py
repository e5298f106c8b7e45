"""The engine's laws of a book, by code."""

from __future__ import annotations

from engine.laws import Law
from engine.laws.sampled import SampledPieceLaw as OwnLaw
from workbook.laws.entries import Laws
from workbook.laws.registry import FAMILIES

__all__ = ["OwnLaw", "laws"]


def laws(given: Laws, intervals: int) -> dict[str, Law]:
    """Return the engine's laws by code, in the order of the Laws sheet; the own law is sampled in ``intervals``."""
    return {one.code: one.page.law(getattr(given, one.code, None), intervals) for one in FAMILIES}
