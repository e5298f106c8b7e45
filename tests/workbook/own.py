"""What engineers add to a book: formulas of every kind beside its tables and on sheets of their own, tables, charts."""

import openpyxl
from openpyxl.chart import LineChart, Reference
from openpyxl.comments import Comment
from openpyxl.formatting.rule import ColorScaleRule, DataBarRule, FormulaRule
from openpyxl.styles import PatternFill
from openpyxl.utils import get_column_letter, quote_sheetname
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.datavalidation import DataValidation
from openpyxl.worksheet.formula import ArrayFormula
from openpyxl.worksheet.table import Table

MINE = "My own notes"
FIGURES = ((1, "a", 0.5), (2, "b", 0.25), (3, "c", 0.125), (None, None, None))

FORMULAS = (
    'IFERROR(1/0,"none")', "IFNA(NA(),0)", "1/0", "NA()", "#REF!+1", '"text"+1', "SQRT(-1)", "NOSUCHFUNCTION(1)",
    "VLOOKUP(2,{at}A1:C4,3,FALSE)", "HLOOKUP(1,{at}A1:C4,2,FALSE)", 'SUMIF({at}A1:A4,">1",{at}C1:C4)',
    'SUMIFS({at}C1:C4,{at}A1:A4,">1")', 'COUNTIFS({at}B1:B4,"a")', 'AVERAGEIF({at}A1:A4,">0")',
    'TEXT({at}C1,"0.00")', 'TEXT(TODAY(),"yyyy-mm-dd")', "SUBTOTAL(9,{at}A1:A4)", "AGGREGATE(9,6,{at}A1:A4)",
    "TODAY()", "NOW()", "RAND()", "RANDBETWEEN(1,6)", "OFFSET({at}A1,1,0)", 'INDIRECT("A1")', "SUM({at}A:A)",
    "SUM({at}1:1)", "SUM(A:C 1:3)", "MAX({first}!A:XFD)", "{first}!A1", "SUM('{one}:{two}'!A1)",
    "COUNT('{one}:{two}'!$B$2:$C$9)", "[1]Sheet1!A1", "'[other book.xlsx]Sheet1'!$A$1", 'HYPERLINK("#A1","there")',
    "LEFT({at}B1,1)&MID({at}B2,1,1)", 'CONCATENATE("a",{at}B1)', "ROWS({at}A1:A4)*COLUMNS({at}A1:C4)", "ROW()",
    "COLUMN()", "MEDIAN({at}A1:A3)", "STDEV({at}A1:A3)", "PRODUCT({at}A1:A3)", "SUMSQ({at}A1:A3)", "MOD(-3,2)",
    "ROUNDUP(1.2,0)", 'VALUE("1.5")', "ISERROR(1/0)", 'CELL("row",A1)', 'INFO("system")',
    "LOOKUP(2,{at}A1:A3,{at}C1:C3)", "DATE(2026,1,31)", "TRUE", "TRUE()", '""', '{at}A1&""', "{{1,2;3,4}}",
    "SUM({{1,2,3}})", "INDEX({at}A1:C4,0,1)", "_xlfn.XLOOKUP(2,{at}A1:A4,{at}C1:C4)",
    "_xlfn.LET(_xlpm.x,5,_xlpm.x*2)", "_xlfn.LAMBDA(_xlpm.x,_xlpm.x+1)(1)", '_xlfn.TEXTJOIN(",",TRUE,{at}B1:B3)',
    "_xlfn.CONCAT({at}B1:B3)", "_xlfn.IFS(TRUE,1)", "_xlfn.SWITCH(1,1,2)", "_xlfn.MAXIFS({at}A1:A4,{at}A1:A4,1)",
    "_xlfn.STDEV.S({at}A1:A3)", "_xlfn._xlws.FILTER({at}A1:A4,{at}A1:A4>1)", "_xlfn._xlws.SORT({at}A1:A4)",
    "_xlfn.UNIQUE({at}B1:B4)", "_xlfn.SEQUENCE(3)", "_xlfn.XMATCH(2,{at}A1:A4)", "_xlfn.ANCHORARRAY({at}E1)",
    "_xlfn.SINGLE({at}A1:A4)", "my_broken+1", "my_rate*2", "my_constant", "my_formula", "my_list", "no_such_name",
    "SUM(Figures[size])", "Figures[[#This Row],[size]]", "SUM(Figures[#All])", "COUNTA(Figures[#Headers])",
    "SUM({any})", "MAX({any})*2", 'IFERROR(VLOOKUP(1,{any},1,FALSE),"–")', 'COUNTIF({any},">0")', "{cell}",
    "{cell}*1000", "SUM(-{cell}^2,1)", "{cell}%", "MMULT({at}A1:A3,{at}A1:C1)", "TRANSPOSE({at}A1:A3)",
    "FREQUENCY({at}A1:A3,{at}A1:A3)", "LINEST({at}A1:A3,{at}C1:C3)", "DSUM({at}A1:C4,1,{at}A1:A2)",
    "PMT(0.01,12,1000)", 'GETPIVOTDATA("x",{at}A1)', 'WEBSERVICE("none")', "1E999", "10^400", "{self}", "{self}+1",
)  # fmt: skip
"""Without =; ``at`` is the engineer's own sheet, ``first`` the book's first one, ``any`` and ``cell`` are declared."""


def texts(row, letter, sheets, named):
    """The formulas as they stand in a column of a sheet, from a row on."""
    quoted = [quote_sheetname(title) for title in sheets]
    words = {
        "at": f"{quote_sheetname(MINE)}!", "first": quoted[0], "one": sheets[1].replace("'", "''"),
        "two": sheets[-1].replace("'", "''"), "any": named[0], "cell": named[1],
    }  # fmt: skip
    return [f"={formula.format(self=f'{letter}{row + i}', **words)}" for i, formula in enumerate(FORMULAS)]


def names(workbook, named):
    """Names of the engineer's own: broken, a constant, a formula, a list, of the book and of a sheet."""
    own = {
        "my_broken": "#REF!", "my_gone": "Gone!#REF!", "my_rate": named[1], "my_constant": "9.81",
        "my_other": "[1]Rates!$A$1",
        "my_formula": f"SUM({named[0]})*2", "my_list": '{1,2,3}', "my_column": f"{quote_sheetname(MINE)}!$A:$A",
        "my_twice": "_xlfn.LAMBDA(_xlpm.x,2*_xlpm.x)",
    }  # fmt: skip
    for name, text in own.items():
        workbook.defined_names[name] = DefinedName(name, attr_text=text)
    workbook[MINE].defined_names["my_own"] = DefinedName("my_own", attr_text="#REF!")


def beside(page, sheets, named):
    """Formulas of every kind, to the right of all that a sheet holds; return how many."""
    column = page.max_column + 2
    written = texts(5, get_column_letter(column), sheets, named)
    for row, text in enumerate(written, 5):
        page.cell(row, column, text)
    spill = f"{get_column_letter(column + 1)}5:{get_column_letter(column + 1)}7"
    page[spill.split(":")[0]] = ArrayFormula(spill, "=ROW(1:3)*2")
    page.cell(5, column + 2, "#N/A")
    page.cell(6, column + 2, "=1+1").comment = Comment("mine", "me")
    page.conditional_formatting.add(
        f"{get_column_letter(column)}5:{get_column_letter(column)}40", DataBarRule("min", 0, "max", 0, "FF638EC6")
    )
    return len(written) + 2


def fill(path, target, named):
    """Write a copy of a book with own cells beside the tables of each sheet and on a sheet; return how many formulas.

    ``named`` are a declared range and a declared cell of numbers, with their sheet.
    """
    workbook = openpyxl.load_workbook(path)
    sheets = list(workbook.sheetnames)
    mine = workbook.create_sheet(MINE, 1)
    for row, values in enumerate((("size", "word", "share"), *FIGURES), 1):
        for column, value in enumerate(values, 1):
            mine.cell(row, 20 + column, value)
    for row, values in enumerate(FIGURES, 1):
        for column, value in enumerate(values, 1):
            mine.cell(row, column, value)
    mine.add_table(Table(displayName="Figures", ref="U1:W4"))
    mine["Y2"] = "=Figures[[#This Row],[size]]*2"
    mine["E1"] = ArrayFormula("E1:E4", "=_xlfn.SEQUENCE(4)")
    names(workbook, named)
    count = sum(beside(page, sheets, named) for page in workbook.worksheets) + 2
    decorated(mine)
    workbook.save(target)
    return count


def decorated(page):
    """A chart, rules, a validation, a comment, merged cells of the engineer's own."""
    chart = LineChart()
    chart.add_data(Reference(page, min_col=1, min_row=1, max_row=4))
    page.add_chart(chart, "J20")
    page.conditional_formatting.add(
        "A1:C4", ColorScaleRule(start_type="min", start_color="FFFFFF", end_type="max", end_color="00FF00")
    )
    page.conditional_formatting.add("A1:C4", FormulaRule(formula=["ISERROR(A1)"], fill=PatternFill(bgColor="FF0000")))
    rule = DataValidation("list", formula1="=my_list")
    rule.add("D1")
    page.add_data_validation(rule)
    page["A1"].comment = Comment("mine", "me")
    page.merge_cells("A10:C12")
    page.row_dimensions[3].hidden = True
