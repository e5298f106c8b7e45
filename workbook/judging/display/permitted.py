"""What may differ from a fresh build because it is taste: one list of permissions, and the bounds of each.

All else is a finding where a verdict, a figure, its unit or its label may be read otherwise, and else a notice.
"""

import re

from workbook.judging.report import NOTICE, SHOWN

YES, NO = ("1", "true"), ("0", "false")

# Fonts, sizes and colours

FONTS = frozenset(["aptos", "arial", "arialmt", "bahnschrift", "calibri", "cambria", "candara", "carlito", "caladea",
    "consolas", "constantia", "corbel", "courier", "dejavu", "franklin", "garamond", "georgia", "gill", "helvetica",
    "inter", "liberation", "lucida", "meiryo", "microsoft", "ms", "noto", "open", "palatino", "roboto", "segoe",
    "simsun", "source", "tahoma", "times", "trebuchet", "ubuntu", "verdana", "yu", "century", "book", "cantarell",
    "lato"])  # those in which people write, by their first words; in others it is a notice  # fmt: skip
# fonts that show other signs for letters: a finding
SIGNS = ("wingdings", "webdings", "symbol", "marlett", "opensymbol", "zapfdingbats", "bookshelf symbol")
LEAST_SIZE, SMALL, LARGE = 4.0, 6.0, 72.0  # points of a font that cannot be read, and that can hardly
UNSEEN, FAINT = 1.3, 2.0  # contrasts below which a text is hidden, or hard to see; ours have 2.5 and more
PLAIN = (None, False, "baseline")
LOOKS = (  # attributes of a cell's look, what they may be, and what is told of all else
    ("font", "strike", PLAIN, SHOWN, "struck out"),
    ("font", "charset", (*range(2), *range(3, 256), None), SHOWN, "in the signs of a symbol font"),
    *(("font", name, PLAIN, NOTICE, f"written with the effect {name}")
      for name in ("outline", "shadow", "condense", "extend", "vertAlign")),
    ("border", "diagonalUp", PLAIN, SHOWN, "crossed out"),
    ("border", "diagonalDown", PLAIN, SHOWN, "crossed out"),
    ("alignment", "horizontal", (None, "general", "left", "center", "right", "centerContinuous", "distributed",
                                 "justify"), SHOWN, "repeated over its cell"),
    ("alignment", "horizontal", (None, "general", "left", "center", "right", "centerContinuous", "fill"), NOTICE,
     "spread over its cell"),
    ("alignment", "indent", range(16), SHOWN, "indented out of its cell"),  # in steps of about three spaces
    ("alignment", "relativeIndent", range(16), NOTICE, "indented out of its cell"),
    ("alignment", "textRotation", (0, None), NOTICE, "turned"),
    ("alignment", "readingOrder", (0, 1, None), NOTICE, "from right to left"),
    ("alignment", "shrinkToFit", PLAIN, NOTICE, "shrunk to its cell"),
)  # fmt: skip

# Number formats: decimals, separators, exponents, a sign for negative numbers, colours, the symbol, the unit

NEARLY = frozenset({"", "+", "≈", "~", "ca.", "approx."})  # before a number
DASHES = "-−–—"

# Words: translated ones, and other spellings of a unit

QUIET = ("equation", "note")  # reworded, these are nobody's concern; exchanged, they are
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")  # what a translation leaves as it is
GAP = re.compile(r"\s{9}")  # blanks and lines that push a text out of its cell

# Sheets and windows

LEAST_WIDTH, LEAST_HEIGHT = 1.0, 3.0  # of columns in characters, of rows in points
ALIKE = 0.5  # of the texts of a sheet, from which on another looks like it
ZOOMS = ("zoomScale", "zoomScaleNormal", "zoomScaleSheetLayoutView", "zoomScalePageLayoutView")
SETTINGS = (  # elements and attributes of settings, what they may be, and what is told of all else
    ("workbookPr", "date1904", NO, SHOWN, "dates counted from 1904"),
    ("workbookPr", "showObjects", ("all",), SHOWN, "charts not shown"),
    ("workbookView", "visibility", ("visible",), NOTICE, "a hidden window"),
    ("workbookView", "minimized", NO, NOTICE, "a hidden window"),
    ("workbookView", "showSheetTabs", YES, NOTICE, "tabs not shown"),
    ("sheetView", "showFormulas", NO, SHOWN, "formulas in place of values"),
    ("sheetView", "showZeros", YES, SHOWN, "zeros hidden"),
    ("sheetView", "rightToLeft", NO, NOTICE, "from right to left"),
    *(("sheetView", name, [0, *range(30, 401)], NOTICE, "too small to be read") for name in ZOOMS),
    ("pane", "xSplit", range(13), NOTICE, "frozen beyond a window"),
    ("pane", "ySplit", range(46), NOTICE, "frozen beyond a window"),
)
# the elements of a worksheet that are judged elsewhere, or change nothing of what is read
PAGE = frozenset(["AlternateContent", "autoFilter", "cellWatches", "colBreaks", "cols", "conditionalFormatting",
    "dataValidations", "dimension", "drawing", "extLst", "headerFooter", "hyperlinks", "ignoredErrors", "legacyDrawing",
    "mergeCells", "pageMargins", "pageSetup", "phoneticPr", "printOptions", "protectedRanges", "rowBreaks", "sheetData",
    "sheetFormatPr", "sheetPr", "sheetProtection", "sheetViews", "sortState"])  # fmt: skip
NEWER = frozenset(["dataValidations", "ignoredErrors"])  # such elements for newer programs, in an ``extLst``
CODES = re.compile(r'&(?:"[^"]*"|[0-9]+|.)')  # of headers and footers

# Charts: colours, widths, legend, grid, ticks, place

LEAST_CHART, SMALL_CHART = 0.12, 0.4  # of the width or the height of a fresh build: hardly to be seen, small
BEHIND, OVER = 0.5, 0.25  # of a chart that another drawing may cover, and that its title or legend may have
ALTERING = ("backwards", "log", "scaled")  # of what is said of an axis, that which is a finding
CHART = frozenset([  # the elements by which programs write an XY chart, besides those of a fresh build
    "AlternateContent", "Choice", "Fallback", "alpha", "auto", "autoTitleDeleted", "avLst", "axId", "axPos", "bevel",
    "bodyPr", "bubble3D", "c", "c14:style", "cap", "chart", "chartSpace", "clrMapOvr", "crossAx", "crossBetween",
    "crosses", "crossesAt", "cs", "dLbl", "dLblPos", "dLbls", "dPt", "date1904", "defRPr", "delete", "dispBlanksAs",
    "ea", "effectLst", "endParaRPr", "ext", "extLst", "f", "formatCode", "h", "hMode", "headEnd", "headerFooter", "idx",
    "invertIfNegative", "lang", "latin", "layout", "layoutTarget", "legend", "legendPos", "ln", "lstStyle", "lumMod",
    "lumOff", "majorGridlines", "majorTickMark", "majorUnit", "manualLayout", "marker", "max", "min", "minorGridlines",
    "minorTickMark", "minorUnit", "miter", "noFill", "numCache", "numFmt", "numRef", "order", "orientation", "overlay",
    "p", "pPr", "pageMargins", "pageSetup", "plotArea", "plotVisOnly", "printSettings", "protection", "prstDash",
    "prstGeom", "pt", "ptCount", "r", "rPr", "rich", "round", "roundedCorners", "scaling", "scatterChart",
    "scatterStyle", "schemeClr", "separator", "ser", "shade", "showBubbleSize", "showCatName", "showDLblsOverMax",
    "showLeaderLines", "showLegendKey", "showPercent", "showSerName", "showVal", "size", "smooth", "solidFill", "spPr",
    "srgbClr", "strCache", "strRef", "style", "symbol", "sysClr", "t", "tailEnd", "tickLblPos", "tint", "title", "tx",
    "txPr", "uniqueId", "v", "valAx", "varyColors", "w", "wMode", "x", "xMode", "xVal", "xfrm", "y", "yMode", "yVal",
])  # fmt: skip
