"""Cases at the edges of what the functions take: empty cells, texts, errors, impossible parameters, all written out."""

import math
from itertools import chain

from engine.laws import law
from tests.functions.case import ANY_ERROR, DIV0, NA, NUM, VALUE, Case
from tests.functions.cases import CLASSIC, POLYNOMIAL_345
from workbook.functions.declarations import CODES

FAILED, MISSING = "=1/0", "=NA()"
MTP, TVP = (CLASSIC,), ((0.25, 0.75),)
BACKWARDS = ((0.5, -8.0, *[0.0] * 6), (0.5, 24.0, *[0.0] * 6))
TABLE = (("CUB", 4.0, 8.0), ("DWL", 2.0, None), (" acs", 2.0, -8.0))
GAP = (("CUB", 4.0, 8.0), (None, None, None), ("ACS", 2.0, -8.0))
OWN = POLYNOMIAL_345[0]
BLANK = (None,) * 8
HALVES = ((0.5, 4.0, *[None] * 6), (0.5, -4.0, *[None] * 6))
TURNS = 5000.0  # rad: more than coefficients are searched for, but nothing to search in a phase
FAULTY_PIECES = (
    *(((row,), NUM) for row in ((0.5, *OWN[1:]), (-1.0, *OWN[1:]), (None, *OWN[1:]), BLANK)),
    *((rows, NUM) for rows in ((OWN, OWN), (HALVES[0], BLANK), ((1.5, *OWN[1:]), (-0.5, *OWN[1:])))),
    *(((row,), VALUE) for row in ((*OWN[:7], "abc"), ("abc", *OWN[1:]), (0.5, "abc", *OWN[2:]))),
    *((rows, VALUE) for rows in ((OWN, (None, "abc", *[None] * 6)), ((0.0, *[None] * 6, "abc"), OWN))),
    *((rows, ANY_ERROR) for rows in (((*OWN[:7], MISSING),), (OWN, (None, FAILED, *[None] * 6)))),
)
"""Tables of pieces that are no law, one below the other or side by side, with the error of each."""


REFUSED = {
    "MSN": ((0.0, 0.25, 0.25), (0.5, -0.1, 0.5), (0.5, 0.25, 1.1)),
    "MTS": ((0.5, 2.0, 0.5), (0.5, 0.5, 0.5), (1.0, 1.0, 0.5), (0.5, "end", 1.1), (None, "end", 0.5)),
    "SCC": (
        (0.3, 0.3, 0.3, 0.3, 0.5),
        (0.0, 0.0, 0.0, 1.0, 0.5),
        (0.5, 0.0, 0.5, 0.0, 0.0),
        (-0.5, 1.0, 0.5, 0.0, 0.5),
    ),
    "HAC": ((0.5, 0.0), (0.5, "none"), (0.0, "end"), (0.5, 2.0)),
    "SGS": ((0.5, 0.0), (0.5, 1.1), (1.0, 0.5)),
}
"""Parameters that a law cannot have."""


def codes():
    yield from (Case("S", (code, 0.25, 0.0), 0.125) for code in ("ACS", "acs", " Acs "))
    yield from (Case("S", (code, 0.25, 0.0), VALUE) for code in ("XYZ", "", "ACS1", "parabolic", None, 5.0))
    yield from (Case(name, ("XYZ", 0.0), VALUE) for name in ("CV", "CA", "CARMS", "CJ"))
    yield Case("XI", ("XYZ", 0.5, 0.0), VALUE)


def abscissae():
    for name in "SVAJ":
        yield from (Case(name, ("CUB", xi, 0.0), NUM) for xi in (-0.1, 1.1, -1e-9, 1 + 1e-9, 1e300))
        yield Case(name, ("CUB", "abc", 0.0), VALUE)
        yield from (Case(name, ("CUB", *rest), error) for rest, error in (
            ((FAILED, 0.0), DIV0), ((MISSING, 0.0), NA), ((0.5, MISSING), NA)))  # fmt: skip
        yield Case(name, (MISSING, 0.5, 0.0), NA)
    yield from (Case("S", ("CUB", xi, 0.0), value) for xi, value in ((None, 0.0), (-1e-13, 0.0), (1 + 1e-13, 1.0)))
    yield Case("V", ("TVP", None, TVP), 0.0)
    yield from (Case("A", ("ACS", xi, 0.0), -4.0) for xi in (0.5, 0.5 - 1e-13, 1.0))
    yield from (Case("S", ("ACS", 0.5, p), 0.5) for p in (None, "none", 0.0, ((0.0, None), (None, 0.0))))
    yield from (Case("S", ("LIN", 0.5, p), 0.5) for p in (None, "none", 7.0, ((1.0, "two"), (None, 4.0))))


def left_out():
    """Without its parameters a law is as delivered."""
    for code in CODES:
        made = law(code)
        k = made.coefficients
        for name, value in zip("SVAJ", made.evaluate(0.3), strict=True):
            yield Case(name, (code, 0.3), value, 1e-10)
        if code != "DWL":
            yield Case("XI", (code, made.s(0.3)), 0.3, 1e-12)
        for name, value in (("CV", k.cv), ("CA", k.ca), ("CARMS", k.ca_rms), ("CJ", k.cj)):
            yield Case(name, (code,), value if math.isfinite(value) else NUM, 1e-8)
    yield from (Case("S", (code, 0.3), VALUE) for code in ("XYZ", None, 5.0))
    yield Case("S", (MISSING, 0.3), NA)
    yield Case("S", ("MTP", 1.5), NUM)


def heights():
    yield from (Case("XI", ("CIC", s, 0.0), NUM) for s in (-0.1, 1.1, -1e-9, 1 + 1e-9))
    yield from (Case("XI", ("CIC", s, 0.0), xi) for s, xi in ((None, 0.0), (0.0, 0.0), (1.0, 1.0), (1 + 1e-13, 1.0)))
    yield from (Case("XI", ("CIC", s, 0.0), error) for s, error in (("abc", VALUE), (FAILED, DIV0), (MISSING, NA)))
    yield from (Case("XI", ("DWL", s, 0.0), NUM) for s in (0.0, 0.5))
    yield Case("XI", ("OWN", 0.5, BACKWARDS), NUM)


def refused_parameters():
    """Parameters that no law takes, with the error of each."""
    for pair in ((0.75, 0.25), (0.0, 0.5), (0.5, 1.0), (-0.1, 0.5), (None, 0.5)):
        yield from ((code, (pair,), NUM) for code in ("TVP", "SRT"))
    yield from (("CIC", p, NUM) for p in (7.0, -0.1, 1.0, "start"))
    yield from ((code, p, VALUE) for code in ("CUB", "PO7") for p in (((0.5, 0.5),), ((1.0, "two"), (None, 4.0)), "x"))
    for code, bad in REFUSED.items():
        yield from ((code, (p,), NUM) for p in bad)
        yield code, (bad[0][:-1],), VALUE
        yield code, ((*bad[0], 0.5),), VALUE
        yield code, ((*bad[0][:-1], "abc"),), VALUE
    for p in (0.25, ((0.25,),), ((0.25, 0.5, 0.75),), ((0.25, "abc"),), "abc"):
        yield "TVP", p, VALUE
    yield "TVP", MISSING, NA
    yield "TVP", ((0.25, FAILED),), ANY_ERROR
    for durations in (
        (0.25, -0.25, 0.25, 0.25, 0.25, 0.0, 0.25),
        (0.125,) * 7,
        (0.0, 0.0, 0.0, 0.5, 0.0, 0.5, 0.0),
        (0.0, 0.5, 0.0, 0.5, 0.0, 0.0, 0.0),
    ):
        yield from ((code, (durations,), NUM) for code in ("MTP", "SCV"))
    for p in ((CLASSIC[:6],), ((*CLASSIC, 0.0),), (("a", *CLASSIC[1:]),), TVP):
        yield "MTP", p, VALUE
    yield "MTP", ((FAILED, *CLASSIC[1:]),), ANY_ERROR
    for p in (0.0, (OWN[:7],), ((*OWN, 0.0),), tuple((x,) for x in OWN)):
        yield "OWN", p, VALUE
    yield from (("OWN", rows, error) for rows, error in FAULTY_PIECES)


def parameters():
    for code, p, error in refused_parameters():
        yield from (Case(name, (code, 0.25, p), error) for name in ("S", "V", "A", "J", "XI"))
        yield from (Case(name, (code, p), error) for name in ("CV", "CA", "CARMS", "CJ"))
    yield from (
        Case("S", ("DHM", 0.5, p), v)
        for p, v in (
            ("end", 0.25),
            (" END", 0.25),
            (1.0, 0.25),
            ("start", 0.75),
            (-1.0, 0.75),
            (0.0, 0.25),
            (2.0, NUM),
            ("middle", VALUE),
        )
    )
    yield from (
        Case("CV", (code, (zeros,)), law(code).coefficients.cv, 1e-9)
        for code, zeros in (("MTP", (None,) * 7), ("MTP", (0.0,) * 7), ("TVP", (0.0,)), ("SCC", (None, 0.0)))
    )
    yield Case("S", ("TVP", 0.5, ((0.25,), (0.75,))), 0.5)
    yield Case("S", ("MTP", 0.5, tuple((d,) for d in CLASSIC)), 0.5)
    yield Case("S", ("MTP", 0.5, ((0.125, 0.25, 0.125, None, 0.125, 0.25, 0.125),)), 0.5)
    yield Case("S", ("OWN", 0.5, ((1.0, None, 60.0, -180.0, 120.0, None, None, None),)), 0.5)
    for name, value in (("S", 0.5), ("V", 1.875), ("XI", 0.5)):
        yield Case(name, ("OWN", 0.5, (*POLYNOMIAL_345, (None,) * 8)), value)
    yield Case("CJ", ("OWN", ((None,) * 8, *POLYNOMIAL_345, (None,) * 8)), 60.0)


def phases():
    for x, y, v, a in (
        (None, 0.0, 0.0, 3.0), (0.0, 0.0, 0.0, 3.0), (2.0, 4.0, 3.0, 0.0), (4.0, 8.0, 0.0, 0.0),
        (6.0, 8.0, 0.0, -8.0), (7.0, 4.0, -8.0, 8.0), (8.0, 0.0, 0.0, 8.0), (8.0 + 1e-12, 0.0, 0.0, 8.0),
    ):  # fmt: skip
        for name, value in (("POS", y), ("VEL", v), ("ACC", a)):
            yield Case(name, (x, TABLE), value, 1e-10)
            yield Case(name, (x, (*TABLE, (None,) * 3, (None,) * 3)), value, 1e-10)
    yield Case("POS", (1.0, (("TVP", 2.0, 4.0, 0.25, 0.75, "unused"),)), 2.0)
    yield Case("POS", (3.0, (("ACS", 2.0, 4.0, 0.5, "unused"), ("CUB", 2.0, 4.0, None, None))), 6.0)
    yield from (
        Case("POS", (1.0, ((code, 2.0, 4.0, *p),)), 2.0)
        for code in ("TVP", "MTP", "MSN", "SCC")
        for p in ((), (None,), (None, 0.0))
    )
    yield from handed_over()
    yield from own_phases()
    yield from dated()
    yield from later()
    for name in ("POS", "VEL", "ACC"):
        yield from (Case(name, (x, TABLE), NUM) for x in (-0.1, 8.1, -1e-9, 8.0 + 1e-9))
        yield from (Case(name, (x, TABLE), error) for x, error in (("abc", VALUE), (FAILED, DIV0), (MISSING, NA)))
        yield from (Case(name, (1.0, table), error) for table, error in refused_tables())


def handed_over():
    """A rise to the velocity of a line: half of the polynomial 3-4-5 rises 8/15 of V T. And what contradicts itself."""
    rise = ("PO5", 3.0, 3.2)
    line, back = ("LIN", 2.0, 4.0), ("CIC", 4.0, 4.0)
    for x, y, v in ((3.0, 3.2, 2.0), (4.0, 5.2, 2.0), (5.0, 7.2, 2.0), (7.0, 10.2, 1.0), (9.0, 11.2, 0.0)):
        for table in (
            (rise, line, back),
            (rise, ("via", 2.0, None), line, ("VIA", 2.0, 0.0), back, ("Via", None, None)),
        ):
            yield Case("POS", (x, table), y, 1e-12)
            yield Case("VEL", (x, table), v, 1e-12)
    passed = (("PO7", 1.0, 2.0, None), ("VIA", 3.0, -4.0, 5.0), ("PO7", 1.0, -2.0, None))
    yield from (Case(name, (1.0, passed), value, 1e-10) for name, value in (("POS", 2.0), ("VEL", 3.0), ("ACC", -4.0)))
    cubic = (("VIA", 1.0, None), ("CUB", 2.0, 3.0), ("VIA", -1.0, None))
    yield from (Case("VEL", (x, cubic), v, 1e-12) for x, v in ((0.0, 1.0), (2.0, -1.0)))
    moving = (("LIN", 1.0, 1.0), ("OWN", 2.0, 4.0, 1.0, 1.8, -2.4), ("LIN", 1.0, 2.2))  # at (0.5, 1.1) by its lift
    moving = tuple((*cells, *[None] * (11 - len(cells))) for cells in moving)
    for x, y, v in ((1.0, 1.0, 1.0), (2.0, 2.7, 2.2), (3.0, 5.0, 2.2), (4.0, 7.2, 2.2)):
        yield from (Case(name, (x, moving), value, 1e-12) for name, value in (("POS", y), ("VEL", v)))
    for table in (
        (*moving[:2], ("LIN", 1.0, 2.3, *[None] * 8)),
        (*moving[1:], moving[0]),
        (rise, ("VIA", 2.5, None), line),  # the line has another velocity
        (rise, ("VIA", 2.0, 0.1), line),
        (("DWL", 1.0, None), ("VIA", 1.0, None), rise),
        (rise, ("VIA", 1.0, None), ("VIA", 1.0, None), back),
        (("VIA", 1.0, None),),
        (("CUB", 1.0, 1.0), ("VIA", 1.0, 1.0), ("PO5", 1.0, 1.0)),  # a cubic has no prescribed acceleration
        (("PO5", 1.0, 1.0, None), ("VIA", 1.0, 1.0, 1.0), ("PO7", 1.0, 1.0, None)),
        (("DHM", 1.0, 1.0), line),
        ((*line, *BLANK), ("OWN", 1.0, 1.0, *OWN)),
        (("PO5", 1.0, 1.0, 0.4), ("LIN", 1.0, 1.0, None)),
    ):
        yield from (Case(name, (0.5, table), NUM) for name in ("POS", "VEL", "ACC"))
    yield Case("POS", (0.5, (rise, ("VIA", "abc", None), back)), VALUE)
    yield Case("POS", (0.5, (("PO7", 1.0, 1.0, None), ("VIA", 1.0, 1.0, "abc"), ("PO7", 1.0, 1.0, None))), VALUE)


def dated():
    """Phases from, to, as a workbook has them: rests around them, a line that hands over, parameters, any abscissa."""
    first, line, last = (40.0, 43.0, 3.2, "PO5"), (43.0, 45.0, 4.0, " lin"), (50.0, 52.0, -8.0, "TVP")
    own = [(*row, *[None] * 8) for row in (first, line)]
    for table in (
        (first, line, (45.0, 47.0, 2.0, "CIC"), last),
        ((*first, None), (*line, "unused"), (45.0, 47.0 + 1e-10, 2.0, "CIC", 0.5), (*last, 0.0), (None,) * 5),
        (*own, (45.0, 47.0, 2.0, "PO5", *[None] * 8), (50.0, 52.0, -8.0, "OWN", *OWN)),
    ):
        for x, y, v in (
            (None, 0.0, 0.0), (-9.0, 0.0, 0.0), (40.0, 0.0, 0.0), (43.0, 3.2, 2.0), (44.0, 5.2, 2.0),
            (47.5, 9.2, 0.0), (50.0, 9.2, 0.0), (51.0, 5.2, None), (52.0, 1.2, 0.0), (360.0, 1.2, 0.0),
        ):  # fmt: skip
            yield Case("POS", (x, table), y, 1e-9)
            if v is not None:
                yield Case("VEL", (x, table), v, 1e-9)
    jumps = ((10.0, 12.0, 4.0, "ACS", None), (12.0, 14.0, -4.0, "ACS", 0.25))
    for x, a in ((9.9, 0.0), (10.0, 4.0), (11.5, -4.0), (12.1, -8.0), (13.9, 8.0 / 3.0), (14.0, 0.0), (15.0, 0.0)):
        yield Case("ACC", (x, jumps), a, 1e-9)
    for table, error in (
        (((10.0, 12.0, 4.0),), VALUE),
        (((10.0, 12.0, 4.0, "XYZ"),), VALUE),
        (((10.0, 12.0, 4.0, None),), VALUE),
        (((10.0, 12.0, 4.0, 5.0),), VALUE),
        (((10.0, 12.0, "abc", "CUB"),), VALUE),
        ((("from", "to", "lift", "law"), (10.0, 12.0, 4.0, "CUB")), VALUE),
        (((10.0, 12.0, 4.0, "CUB"), (12.0, 1.0, None, "via")), VALUE),
        (((10.0, 12.0, 4.0, "TVP", 0.5, "abc"),), VALUE),
        (((10.0, 12.0, 4.0, "CUB"), (11.0, 14.0, 4.0, "CUB")), NUM),
        (((12.0, 10.0, 4.0, "CUB"),), NUM),
        (((10.0, 10.0, 4.0, "CUB"),), NUM),
        (((10.0, 12.0, 4.0, "DWL"),), NUM),
        (((10.0, 12.0, 4.0, "CUB"), (20.0, 24.0, 4.0, "TVP"), (14.0, 16.0, 4.0, "CUB")), NUM),
        (((10.0, 12.0, FAILED, "CUB"),), ANY_ERROR),
    ):
        yield from (Case(name, (11.0, table), error) for name in ("POS", "VEL", "ACC"))
    yield Case("POS", ("abc", jumps), VALUE)
    yield Case("POS", (MISSING, jumps), NA)


def later():
    """A motion that is later by a shift, once or cycle by cycle, as an axis of a workbook goes."""
    book = ((40.0, 43.0, 3.2, "PO5"), (43.0, 45.0, 4.0, "LIN"), (45.0, 47.0, 2.0, "CIC"), (50.0, 52.0, -8.0, "TVP"))
    for x, shift, cycle, y, v in (
        (44.0, None, None, 5.2, 2.0), (344.0, 300.0, None, 5.2, 2.0), (10.0, 300.0, 0.0, 0.0, 0.0),
        (344.0, 300.0, 360.0, 5.2, 2.0), (340.0, 300.0, 360.0, 0.0, 0.0), (352.0, 300.0, 360.0, 1.2, 0.0),
        (10.0, 300.0, 360.0, 0.0, 0.0), (-16.0, 300.0, 360.0, 4.0, 2.0), (704.0, 300.0, 360.0, 6.4, 2.0),
        (44.0, -360.0, 360.0, 6.4, 2.0), (4.0, 12.0, 52.0, 4.0, 2.0), (96.0, None, 52.0, 6.4, 2.0),
    ):  # fmt: skip
        yield Case("POS", (x, book, shift, cycle), y, 1e-9)
        yield Case("VEL", (x, book, shift, cycle), v, 1e-9)
    there = (("ACS", 2.0, 4.0), ("ACS", 2.0, -4.0))
    yield from (
        Case("POS", (x, there, 1.0), y) for x, y in ((1.0, 0.0), (3.0, 4.0), (5.0, 0.0), (0.5, NUM), (5.5, NUM))
    )
    for x, y, v, a in ((0.0, 2.0, -4.0, 4.0), (0.25, 1.125, -3.0, 4.0), (2.0, 2.0, 4.0, -4.0), (7.0, 4.0, 0.0, -4.0)):
        yield from (Case(n, (x, there, 1.0, 4.0), value, 1e-9) for n, value in (("POS", y), ("VEL", v), ("ACC", a)))
    yield Case("POS", (5.0, there, None, 4.0), 2.0, inline=True)
    for table, shift, cycle, error in (
        (there, 1.0, 10.0, NUM), (there, 1.0, 3.0, NUM), (there, 0.0, -4.0, NUM), (book, 0.0, 51.0, NUM),
        (((-1.0, 2.0, 1.0, "CUB"),), 0.0, 360.0, NUM), (book, "abc", 360.0, VALUE), (book, 0.0, "abc", VALUE),
        (book, ((1.0,), (2.0,)), 360.0, VALUE), (book, 0.0, ((1.0, 2.0),), VALUE),
    ):  # fmt: skip
        yield from (Case(name, (0.0, table, shift, cycle), error) for name in ("POS", "VEL", "ACC"))


def own_phases():
    """Rows of the engineer's own law: the polynomial 3-4-5, and the two halves of the constant acceleration."""
    own = ("own ", 2.0, 4.0)
    for table in (
        ((*own, *OWN),),
        ((*own, 1.0, None, *OWN[2:5], None, None, None),),
        ((*own, *OWN, *["unused"] * 7),),
        ((*own, *BLANK, *OWN, *BLANK, 0.5),),
        ((*own, *OWN), ("TVP", 2.0, 4.0, 0.25, 0.75, *["unused"] * 6)),
    ):
        for name, x, value in (("POS", 1.0, 2.0), ("VEL", 1.0, 3.75), ("ACC", 1.0, 0.0), ("ACC", 0.5, 5.625)):
            yield Case(name, (x, table), value, 1e-12)
    first, second = HALVES
    for pieces in ((first, second), (first, BLANK, second), (BLANK, first, (0.0, *[9.0] * 7), second, BLANK)):
        table = (("CUB", 4.0, 8.0, *BLANK * len(pieces)), (*own, *chain(*pieces)))
        for x, y, v, a in (
            (4.0, 8.0, 0.0, 4.0),
            (5.0, 10.0, 4.0, -4.0),
            (5.5, 11.5, 2.0, -4.0),
            (6.0, 12.0, 0.0, -4.0),
        ):
            yield from (Case(n, (x, table), value, 1e-12) for n, value in (("POS", y), ("VEL", v), ("ACC", a)))
    turning = (1.0, 0.0, 0.0, 0.0, 0.0, TURNS**2, TURNS, 0.0)
    yield Case("POS", (2.0, ((*own, *turning),)), 4.0 * (TURNS - math.sin(TURNS)), 1e-8)
    yield Case("S", ("OWN", 1.0, (turning,)), TURNS - math.sin(TURNS), 1e-8)


def refused_tables():
    """Tables that are no motion, with the error of each."""
    for table in (0.0, "CUB", (("CUB", 4.0),), ((None,) * 3,) * 2, GAP):
        yield table, VALUE
    for row in (("XYZ", 4.0, 8.0), (5.0, 4.0, 8.0), (None, 4.0, 8.0), ("CUB", "abc", 8.0), ("CUB", 4.0, "abc"),
                ("TVP", 4.0, 8.0, 0.5), ("MTP", 4.0, 8.0, *CLASSIC[:6]), ("HAC", 4.0, 8.0, 0.5, "side"),
                ("TVP", 4.0, 8.0, 0.25, "abc"), ("OWN", 4.0, 8.0), ("OWN", 4.0, 8.0, *OWN[:7])):  # fmt: skip
        yield (row,), VALUE
    for row in (("CUB", 0.0, 8.0), ("CUB", -4.0, 8.0), ("CUB", None, 8.0), ("DWL", 4.0, 8.0),
                ("TVP", 4.0, 8.0, 0.75, 0.25), ("MSN", 4.0, 8.0, None, 0.25, 0.25), ("OWN", 0.0, 8.0, *OWN),
                ("OWN", 4.0, 8.0, *HALVES[0], *HALVES[1][:-1])):  # fmt: skip
        yield (row,), NUM
    yield ((("CUB", 4.0, 8.0)), ("ACS", 0.0, 8.0)), NUM  # also where the phase is not the one asked for
    for rows, error in FAULTY_PIECES:
        pieces = tuple(chain(*rows))
        yield (("OWN", 4.0, 8.0, *pieces),), error
        yield (("CUB", 4.0, 8.0, *[None] * len(pieces)), ("OWN", 4.0, 8.0, *pieces)), error
    yield MISSING, NA
    yield (("CUB", 4.0, FAILED),), ANY_ERROR
    yield (("OWN", 4.0, 8.0, *OWN, FAILED),), ANY_ERROR


def sums():
    yield from (Case("JRED", (j, i), value) for j, i, value in ((0.5, 2.0, 2.0), (0.5, -2.0, 2.0), (None, 2.0, 0.0)))
    yield Case("JRED", (((1.0, None),), ((2.0, 3.0),)), 4.0)
    yield from (Case("RMS", (v, t), value) for v, t, value in ((-3.0, 2.0, 3.0), (((1.0, None),), ((1.0, 3.0),), 0.5)))
    for name in ("JRED", "RMS"):
        yield Case(name, (((1.0, 2.0),), ((1.0, 2.0, 3.0),)), VALUE)
        yield Case(name, (((1.0, 2.0),), ((1.0,), (2.0,))), VALUE)
        yield Case(name, (((1.0, 2.0),), 1.0), VALUE)
        yield Case(name, (((1.0, "abc"),), ((1.0, 2.0),)), VALUE)
        yield Case(name, (1.0, "abc"), VALUE)
        yield Case(name, (MISSING, 1.0), NA)
        yield Case(name, (1.0, FAILED), DIV0)
        yield Case(name, (((1.0, 2.0),), ((1.0, FAILED),)), ANY_ERROR)
    yield Case("JRED", (((1.0, -2.0),), ((1.0, 2.0),)), NUM)
    yield from (Case("RMS", (((1.0, 2.0),), (t,)), NUM) for t in ((0.0, 0.0), (3.0, -1.0), (None, None)))


def inline():
    """Arguments written in the formula instead of in cells."""
    yield Case("S", ("acs", 0.25, 0), 0.125, inline=True)
    yield Case("S", ("TVP", 0.5, TVP), 0.5, inline=True)
    yield Case("S", ("MTP", 0.5, MTP), 0.5, inline=True)
    yield Case("CV", ("OWN", POLYNOMIAL_345), 1.875, inline=True)
    yield Case("POS", (1, (("OWN", 2, 4, *OWN),)), 2.0, inline=True)
    yield Case("JRED", (((1, 2),), ((1, 3),)), 19.0, inline=True)
    yield Case("RMS", (((3, 4),), ((1, 1),)), 12.5**0.5, inline=True)
    yield Case("S", ("acs", "=1/0", 0), DIV0, inline=True)


def edge_cases():
    """Every case of this file, in order."""
    return [*codes(), *abscissae(), *left_out(), *heights(), *parameters(), *phases(), *sums(), *inline()]
