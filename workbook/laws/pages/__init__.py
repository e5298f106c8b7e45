"""The page of each law: its parameters, its pieces with the textbook equation of each, its coefficients."""

from workbook.laws.page import LawPage, law_sheet
from workbook.laws.pages import acs, cic, cub, mtp, tvp

PAGES = (acs.PAGE, tvp.PAGE, cic.PAGE, cub.PAGE, mtp.PAGE)

__all__ = ["PAGES", "LawPage", "law_sheet"]
