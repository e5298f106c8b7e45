"""Cells that are something else than they look, and formulas that hide or hang on what nobody sees."""

import re
from collections import defaultdict
from collections.abc import Iterator

from workbook.audit.finding import Finding, Sure, many
from workbook.audit.lines import Lines, cell_text
from workbook.audit.view import calls
from workbook.book.address import Address
from workbook.book.columns import Node
from workbook.errors import quoted
from workbook.reading.files import MOST_READ
from workbook.witnesses.calibration import QUICK, Evaluators, present
from workbook.witnesses.pycel.model import PycelModel, require_working

LINK = re.compile(r"\[([^\[\]]+)\](?:[\w.]*!|[^\[\]'!]*'!)")  # a table's column has no ! behind it
VOLATILE = frozenset("OFFSET INDIRECT NOW TODAY RAND RANDBETWEEN RANDARRAY CELL INFO".split())
BLANKS = frozenset("ISBLANK COUNTA COUNT COUNTIF COUNTBLANK ISNUMBER IFERROR IFNA N ISERROR IF".split())
LOOK_UPS = frozenset("VLOOKUP HLOOKUP LOOKUP XLOOKUP MATCH XMATCH INDEX INDIRECT".split())


def text_number(text: str) -> float | None:
    """Return the number that a text looks like; None where it is no number."""
    plain = text.strip().replace("\u00a0", "").replace(" ", "").replace("−", "-").lstrip("'")
    if plain.count(",") == 1 and "." not in plain:
        plain = plain.replace(",", ".")
    try:
        return float(plain) if plain and plain[-1].isdigit() and plain[0] in "+-.0123456789" else None
    except ValueError:
        return None


def texts(lines: Lines) -> Iterator[Finding]:
    """Yield texts that look like numbers where numbers are expected: sums leave them out."""
    view = lines.view
    alike = {cell for cell, text in view.texts.items() if text_number(text) is not None}
    for cell in sorted(alike):
        sides = [cell._replace(row=cell.row + k) for k in (-1, 1) if cell.row + k]
        readers = [r for r in view.readers.get(cell, ()) if not view.forms[r].functions & LOOK_UPS]
        codes = any(side in alike for side in sides)
        others = readers or ([] if codes else [side for side in sides if view.figure(side)])
        if others:
            why = f"{view.texts[cell]!r} is a text"
            yield Finding(cell, "text-number", why, "high", cell_text(view, others[0]))


def blanks(lines: Lines) -> Iterator[Finding]:
    """Yield empty cells that formulas read as zero."""
    view = lines.view
    for empty, readers in sorted(view.readers.items()):
        judged = [r for r in readers if not view.forms[r].functions & BLANKS and not view.forms[r].texts]  # A1="x"
        if judged and view.empty(empty) and empty not in view.contents.arrays:
            reader = min(judged)
            why = f"{reader.a1} on {reader.sheet} reads an empty cell"
            yield Finding(empty, "blank", why, sure_of_blank(lines, empty, reader), cell_text(view, reader))


def sure_of_blank(lines: Lines, empty: Address, reader: Address) -> Sure:
    """Return how sure it is that an empty cell should not be: a list has room for more, a series begins with none."""
    view = lines.view
    near = [empty._replace(row=empty.row + k) for k in (-1, 1) if empty.row + k]
    inside = all(view.figure(c) for c in near)
    first = reader.row == empty.row + 1 and (empty._replace(row=reader.row - 1), True) not in lines.members
    if any(c in view.readers and view.empty(c) for c in near) and not inside:
        return "low"
    if is_unfilled(lines, empty, reader):
        return "low"
    return "high" if inside or view.beside(empty) else "low" if first else "medium"


def is_unfilled(lines: Lines, empty: Address, reader: Address) -> bool:
    """Whether nothing that a formula reads is filled in, or its copies have empty cells too."""
    view, read = lines.view, [a.first for a in lines.view.forms[reader].areas]
    if len(read) > 1 and all(map(view.empty, read)):
        return True
    copies = [s.cells for down in (True, False) if (s := lines.members.get((reader, down)))]
    columns = [{view.forms[c].areas[read.index(empty)].first for c in cells} for cells in copies]
    return any(sum(map(view.empty, column)) > 1 for column in columns)


def hidden_errors(lines: Lines) -> Iterator[Finding]:
    """Yield formulas that give a number for every error, whatever its reason."""
    view = lines.view
    met = set()
    for cell, form in view.forms.items():
        if "IFERROR" not in form.functions or form.skeleton in met:
            continue
        for node in view.calls(cell):
            if node.value == "IFERROR" and len(node.parts) == 2 and hides(node):
                met.add(form.skeleton)
                why = f"every error becomes {node.parts[1].value:g}, and goes on as a value"
                yield Finding(cell, "hidden-error", why, "medium", view.text(cell))
                break


def hides(node: Node) -> bool:
    """Whether a call of IFERROR gives a number for what is no look-up and may fail by a fault."""
    inner = {call.value for call in calls(node.parts[0])}
    return not inner & LOOK_UPS and node.parts[1].kind == "number"


def circles(lines: Lines) -> Iterator[Finding]:
    """Yield the first cell of each circular reference."""
    for circle in lines.view.order[1]:
        why = f"it needs its own value: {', '.join(c.a1 for c in circle[:6])}{many(circle)}"
        yield Finding(circle[0], "circular", why, "high", lines.view.text(circle[0]))


def links(lines: Lines) -> Iterator[Finding]:
    """Yield the first formula that reads another file, for each such file."""
    view, reading = lines.view, defaultdict[str, list[Address]](list)
    for cell in view.contents.failed:
        text = view.text(cell)
        if linked := LINK.search(text):
            reading[linked[1]].append(cell)
    for cells in reading.values():
        why = "it reads another file, which may be gone or changed" + many(cells)
        yield Finding(cells[0], "link", why, "medium", view.text(cells[0]))


def volatile(lines: Lines) -> Iterator[Finding]:
    """Yield the first formula of a sheet that changes by itself, or reads cells that nobody sees named."""
    view, calling = lines.view, defaultdict[tuple[str, frozenset[str], bool], list[Address]](list)
    for cell, form in view.forms.items():
        if names := form.functions & VOLATILE:
            dates = names <= {"TODAY", "NOW"} and cell not in view.read
            calling[cell.sheet, names, dates].append(cell)
    for (_, names, dates), cells in calling.items():
        why = f"{', '.join(sorted(names))} is volatile: no trace shows what it reads, or its value changes by itself"
        sure: Sure = "low" if dates else "medium"
        yield Finding(cells[0], "volatile", why + many(cells), sure, view.text(cells[0]))


def hidden(lines: Lines) -> Iterator[Finding]:
    """Yield the first formula that reads figures of a hidden sheet, for each such sheet."""
    view = lines.view
    left = {s.title for s in view.file.workbook.worksheets if s.sheet_state != "visible"}
    for cell, form in view.forms.items() if left else ():
        for area in form.areas:
            if area.sheet in left and area.sheet != cell.sheet and any(map(view.figure, view.within(area))):
                left.discard(area.sheet)
                why = f"it reads the hidden sheet {area.sheet}"
                yield Finding(cell, "hidden", why, "medium", view.text(cell))


def stale(lines: Lines) -> Iterator[Finding]:
    """Yield saved values that are not what the formula gives, as two evaluators compute it."""
    file, view = lines.view.file, lines.view
    if not file.has_results or file.contents.cells_read > MOST_READ:
        return
    require_working()
    evaluators = Evaluators(file, PycelModel(file.contents), present(QUICK), {})
    for cell, value in evaluators.stale.items():
        by = " and ".join(evaluators.trusted[cell])
        why = f"{quoted(file.saved[cell])} was saved, and by {by} the formula gives {quoted(value)}"
        yield Finding(cell, "stale", why, "high" if file.is_evidence else "medium", view.text(cell))


RULES = (texts, blanks, hidden_errors, circles, links, volatile, hidden, stale)
