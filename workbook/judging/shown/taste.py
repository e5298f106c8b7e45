"""What may differ from a fresh build because it is taste: one list of permissions, and the bounds of each.

All else is a finding where a verdict, a figure, its unit or its label may be read otherwise, and else a notice.
"""

import re

from workbook.judging.report import NOTICE, SHOWN

YES, NO = ("1", "true"), ("0", "false")

# Fonts, sizes and colours

FONTS = frozenset([
    "aptos", "arial", "arialmt", "bahnschrift", "calibri", "cambria", "candara", "carlito", "caladea", "consolas",
    "constantia", "corbel", "courier", "dejavu", "franklin", "garamond", "georgia", "gill", "helvetica", "inter",
    "liberation", "lucida", "meiryo", "microsoft", "ms", "noto", "open", "palatino", "roboto", "segoe", "simsun",
    "source", "tahoma", "times", "trebuchet", "ubuntu", "verdana", "yu", "century", "book", "cantarell", "lato",
])  # fmt: skip
"""those in which people write, by their first words; in others it is a notice"""
SIGNS = ("wingdings", "webdings", "symbol", "marlett", "opensymbol", "zapfdingbats", "bookshelf symbol")
"""fonts that show other signs for letters: a finding"""
SYMBOLS = 2  # the character set of such fonts
LEAST_SIZE, SMALL = 4.0, 6.0  # points of a font that cannot be read, and that can hardly
UNSEEN, FAINT = 1.3, 2.0  # contrasts below which a text is hidden, or hard to see; ours have 2.5 and more
MOST_INDENT = 15  # steps of about three spaces

# Number formats: decimals, separators, exponents, a sign for negative numbers, colours, the symbol, the unit

NEARLY = frozenset({"", "+", "≈", "~", "ca.", "approx."})  # before a number
DASHES = "-−–—"

# Words: translated ones, and other spellings of a unit

QUIET = ("equation", "note")  # reworded, these are nobody's concern; exchanged, they are
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")  # what a translation leaves as it is

# Sheets and windows

LEAST_WIDTH, LEAST_HEIGHT = 1.0, 3.0  # of columns in characters, of rows in points
LEAST_ZOOM = 30  # per cent
MOST_FROZEN = {"xSplit": 12, "ySplit": 45}  # columns and rows that a window must hold whole
ALIKE = 0.5  # of the texts of a sheet, from which on another looks like it
SETTINGS = (
    ("workbookPr", "date1904", NO, SHOWN, "dates counted from 1904"),
    ("workbookPr", "showObjects", ("all",), SHOWN, "charts not shown"),
    ("workbookView", "visibility", ("visible",), NOTICE, "a hidden window"),
    ("workbookView", "showSheetTabs", YES, NOTICE, "tabs not shown"),
    ("sheetView", "showFormulas", NO, SHOWN, "formulas in place of values"),
    ("sheetView", "showZeros", YES, SHOWN, "zeros hidden"),
    ("sheetView", "rightToLeft", NO, NOTICE, "from right to left"),
)
"""elements and attributes of settings, what they may be, and what is told of all else"""
PAGE = frozenset([
    "AlternateContent", "autoFilter", "cellWatches", "colBreaks", "cols", "conditionalFormatting",
    "dataValidations", "dimension", "drawing", "drawingHF", "extLst", "headerFooter", "hyperlinks",
    "ignoredErrors", "legacyDrawing", "legacyDrawingHF", "mergeCells", "pageMargins", "pageSetup", "phoneticPr",
    "printOptions", "protectedRanges", "rowBreaks", "sheetData", "sheetFormatPr", "sheetPr", "sheetProtection",
    "sheetViews", "sortState", "tableParts",
])  # fmt: skip
"""the elements of a worksheet that are judged elsewhere, or change nothing of what is read"""

# Charts: colours, widths, legend, grid, ticks, place

LEAST_CHART, SMALL_CHART = 0.12, 0.4  # of the width or the height of a fresh build: hardly to be seen, small
BEHIND = 0.5  # of a chart that another drawing may cover
CHART = frozenset([
    "alpha", "auto", "autoTitleDeleted", "axId", "axPos", "backward", "baseTimeUnit", "bodyPr", "bubble3D",
    "c14:style", "category", "chart", "chartSpace", "c", "crossAx", "crossBetween", "crosses", "crossesAt",
    "dLbl", "dLblPos", "dLbls", "date1904", "dPt", "defRPr", "delete", "dispBlanksAs", "dispEq", "dispRSqr",
    "effectLst", "endParaRPr", "errBarType", "errBars", "errDir", "errValType", "ext", "extLst", "f",
    "formatCode", "formatting", "forward", "grouping", "h", "hMode", "headerFooter", "idx", "invertIfNegative",
    "lang", "layout", "layoutTarget", "legend", "legendPos", "ln", "lstStyle", "lvl", "majorGridlines",
    "majorTickMark", "majorUnit", "manualLayout", "marker", "max", "min", "minorGridlines", "minorTickMark",
    "minorUnit", "noEndCap", "noFill", "noMultiLvlLbl", "numCache", "numFmt", "numRef", "order", "orientation",
    "overlay", "p", "pPr", "pageMargins", "pageSetup", "plotArea", "plotVisOnly", "plus", "printSettings",
    "protection", "prstDash", "pt", "ptCount", "r", "rPr", "rich", "round", "roundedCorners", "scaling",
    "scatterChart", "scatterStyle", "schemeClr", "selection", "separator", "ser", "showBubbleSize", "showCatName",
    "showDLblsOverMax", "showLeaderLines", "showLegendKey", "showPercent", "showSerName", "showVal", "size",
    "smooth", "solidFill", "spPr", "srgbClr", "strCache", "strRef", "style", "sysClr", "symbol", "t",
    "tickLblPos", "title", "tx", "txPr", "uniqueId", "v", "valAx", "varyColors", "w", "wMode", "x", "xMode",
    "xVal", "y", "yMode", "yVal", "latin", "ea", "cs", "cap", "miter", "bevel", "headEnd", "tailEnd", "logBase",
    "lumMod", "lumOff", "clrMapOvr", "AlternateContent", "Choice", "Fallback", "shade", "tint", "avLst",
    "prstGeom", "xfrm", "gapWidth",
])  # fmt: skip
"""the elements by which programs write an XY chart"""
