"""The page of each law: its parameters, its pieces with the textbook equation of each, its coefficients."""

from workbook.sheets.laws import acs, cic, cub, mtp, tvp
from workbook.sheets.laws.page import LawPage, law_sheet

PAGES = (acs.PAGE, tvp.PAGE, cic.PAGE, cub.PAGE, mtp.PAGE)

__all__ = ["PAGES", "LawPage", "law_sheet"]
