"""Compare two workbooks or descriptions of a machine."""

from pathlib import Path

from workbook.differences.design import compare, read
from workbook.errors import AGREES, DISAGREES, InputError
from workbook.reports import differences as told
from workbook.reports import page
from workbook.reports.terminal import ERR, OUT, say, say_json, shown


def diff(old: Path, new: Path, as_json: bool, html: Path | None, force: bool) -> int:
    """Tell what differs between two books or descriptions; return the exit code."""
    page.ready(html, (".html",), force)
    with ERR.status(shown(f"Comparing {old} and {new} …")):
        before, after = read(old), read(new)
    if before.machine.template != after.machine.template:
        kinds = f"{old} is of the template {before.machine.template}, {new} of {after.machine.template}"
        raise InputError([f"{kinds}; expected two of one template"])
    found = compare(before, after)
    page.write(html, lambda: told.page(before, after, found), force)
    if as_json:
        say_json(told.data(found))
    elif found.same:
        say(OUT, "The same machine")
    else:
        told.show(OUT, found)
    return AGREES if found.same else DISAGREES
