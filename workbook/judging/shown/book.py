"""All that a book displays, against a fresh build of the same inputs.

What differs is taste by a short list of permissions (decimals, widths, fonts and colours that can be read, places of
charts, translated words, what programs write by themselves), a finding where a verdict, a figure, its unit or its label
may be read otherwise, and else a notice.
"""

from pydantic import BaseModel

from workbook.judging.matching import Match
from workbook.judging.report import LAYOUT, Report
from workbook.judging.shown.charts import charts
from workbook.judging.shown.looks import Looks, Told, seen
from workbook.judging.shown.rules import Rules, validations
from workbook.judging.shown.views import in_view, links, pages
from workbook.judging.shown.words import words
from workbook.reading.contents import Cells


def displayed(match: Match, model: type[BaseModel], computed: Cells, report: Report) -> None:
    """Enter into a report what a reader of the book is told otherwise, and as notices what is reworded or gone.

    ``model`` is that of the machine's entries; ``computed`` are the values of the formula cells; where there are none,
    the engine's are taken.
    """
    told = Told()
    cells = list(seen(match, words(match, report)))
    links(match, told)
    looks = Looks(match, model, told)
    rules = Rules(match, looks, told, torn=any(found.kind == LAYOUT for found in report.findings))
    rules.judge(cells)
    for one in cells:
        looks.judge(one, coloured=one.verdict and rules.has_verdicts(one))
    seen_pages = pages(match)
    in_view(match, seen_pages, computed, cells, report, told)
    charts(match, seen_pages, report)
    validations(match, model, report)
    told.enter(report)
