"""Whether two workbook files are the same, part by part.

Everything must be equal to the byte, but for the saved results of formulas and the points of charts: another machine's
sine may round the last digit differently, so these may differ by a few units in the last place.
"""

import math
import re
import zipfile
from itertools import zip_longest
from pathlib import Path

CACHED = re.compile(rb'(</f>|<pt idx="\d+">)<v>([^<]*)</v>')
LAST_PLACES = 1e-12


def same_book(one: Path, other: Path) -> bool:
    """Compare two files."""
    with zipfile.ZipFile(one) as a, zipfile.ZipFile(other) as b:
        if a.namelist() != b.namelist():
            return False
        return all(same_part(a.read(name), b.read(name)) for name in a.namelist())


def same_part(one: bytes, other: bytes) -> bool:
    """Compare one part: the text around cached results exactly, the results nearly."""
    if one == other:
        return True
    if CACHED.sub(rb"\1", one) != CACHED.sub(rb"\1", other):
        return False
    pairs = zip_longest(CACHED.findall(one), CACHED.findall(other), fillvalue=(b"", b""))
    return all(near(a[1], b[1]) for a, b in pairs)


def near(one: bytes, other: bytes) -> bool:
    """Whether two cached results agree but for rounding."""
    if one == other:
        return True
    try:
        return math.isclose(float(one), float(other), rel_tol=LAST_PLACES, abs_tol=LAST_PLACES)
    except ValueError:
        return False
