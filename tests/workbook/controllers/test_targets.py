"""Each target: files small enough to read, parsers that share nothing with its reader, limits, and damaged files."""

import json
import re
import time
from pathlib import Path
from xml.dom import minidom

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine import law
from engine.cams import interpolation
from engine.cams.certificate import certify
from engine.motion import Motion, Phase
from engine.motion.profile import profile_of_motion
from tests.workbook.controllers.examples import FOUR, X, Y, handed, random_axis
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.table import Table
from workbook.controllers.tabulation import automatic, certify_table, reread, table_at, tabulate
from workbook.controllers.target import COUNTED, CamExport, header, parse_table, read_table
from workbook.controllers.texts import REAL
from workbook.errors import MotionbookError, TargetError
from workbook.template_outputs import CamAxis

GOLDEN = Path(__file__).parent / "golden"
NUMBER = r"(-?\d+\.?\d*(?:[eE]-?\d+)?)"


def floats(pattern: str, text: str) -> np.ndarray:
    return np.array([[float(one) for one in np.atleast_1d(row)] for row in re.findall(pattern, text)])


def decorated(text: str) -> np.ndarray:
    """Master, slave and type of each element of an L5X tag, by another parser."""
    tag = minidom.parseString(text).getElementsByTagName("Tag")[0]
    members = tag.getElementsByTagName("DataValueMember")
    rows = np.array([float(one.getAttribute("Value")) for one in members]).reshape(-1, 3)
    packed = json.loads(tag.getElementsByTagName("Data")[0].firstChild.data)
    assert packed == rows.tolist()
    return rows


def fields(names: str) -> str:
    return "".join(rf".*?{name}\s*:=\s*{NUMBER}" for name in names.split())


PARSERS = {
    "csv": lambda text: np.loadtxt(text.splitlines(), delimiter=";"),
    "codesys": lambda text: floats(rf"dX := {NUMBER}, dY := {NUMBER}, dV := {NUMBER}, dA := {NUMBER}", text),
    "codesys-table": lambda text: floats(rf"\[{NUMBER}, {NUMBER}\]", text),
    "twincat": lambda text: floats(fields("MasterPos SlavePos SlaveVelo SlaveAcc"), text),
    "twincat-table": lambda text: np.fromstring(text.split(":= [")[1].split("]")[0], sep=",").reshape(-1, 2),
    "siemens": lambda text: floats(fields("leadingValue followingValue velocityRatio accelerationRatio"), text),
    "siemens-points": lambda text: floats(fields("x y"), text),
    "rockwell": decorated,
    "kollmorgen": lambda text: floats(rf"{NUMBER};{NUMBER};SPLINE", text),
    "sew": lambda text: np.loadtxt(text.splitlines()[1:], delimiter=";"),
    "lenze": lambda text: np.loadtxt(text.splitlines(), comments="//"),
    "mitsubishi": lambda text: np.loadtxt(text.splitlines(), delimiter=";") * [1e-5, 1e-4],
}  # fmt: skip


@pytest.mark.parametrize("name", TARGETS)
def test_a_file_is_what_it_was(name: str) -> None:
    """Golden files: what changes in a format is seen in the difference of a file that can be read."""
    one = target(name)
    found = one.write(handed(one)).encode()
    assert found == (GOLDEN / f"{name}{one.suffix}").read_bytes()
    assert len(found) < 4000
    assert found == one.write(handed(one)).encode()


@pytest.mark.parametrize("name", PARSERS)
def test_another_parser_finds_the_points(name: str) -> None:
    one = target(name)
    rows = PARSERS[name](one.write(handed(one)))
    meant = FOUR.profile.at(rows[:, 0])
    assert set(X) <= set(np.round(rows[:, 0], 9))
    assert rows[:, 1] == pytest.approx(meant.y, abs=1e-4)
    assert rows[[0, 1], 1] == pytest.approx(Y[:2])
    if rows.shape[1] >= 4:
        assert rows[:, 2] == pytest.approx(meant.y1, abs=1e-12)
        assert rows[:-1, 3] == pytest.approx(meant.y2[:-1], abs=1e-12)


def test_another_parser_finds_the_stroke_ratios() -> None:
    one = target("mitsubishi-ratio")
    head, *ratios = [line for line in one.write(handed(one)).split() if re.fullmatch(r"-?\d+", line)]
    x = np.linspace(0.0, 360.0, 257)[1:]
    assert (head, len(ratios)) == ("256", 256)
    assert np.array(ratios, dtype=float) * 30.0 / 1e9 == pytest.approx(FOUR.profile.at(x, left=True).y, abs=2e-8)


def test_the_polynomials_of_br_and_of_segments_are_the_motion() -> None:
    br = target("br")
    text = br.write(handed(br))
    assert "MasterPeriod := 3600000; " in text
    u = 0.5 * np.diff(np.insert(floats(fields("X"), text.split("PolynomialNumber")[1])[:, 0], 0, 0.0))
    rows = floats(fields("A B C D E F G"), text.split("PolynomialNumber")[1])
    found = [np.polynomial.polynomial.polyval(at, row) for at, row in zip(u, rows, strict=True)]
    middles = np.array([45.0, 135.0, 270.0])
    assert np.array(found) == pytest.approx(FOUR.profile.at(middles).y * 1e4, rel=1e-5)
    segments = target("siemens-segments")
    text = segments.write(handed(segments))
    rows = floats(fields("xmin xmax a0 a1 a2 a3 a4 a5 a6"), text)
    found = [np.polynomial.polynomial.polyval(0.5 * (row[1] - row[0]), row[2:]) for row in rows]
    assert np.array(found) == pytest.approx(FOUR.profile.at(middles).y)


@pytest.mark.parametrize("name", TARGETS)
@pytest.mark.parametrize("seed", [0, *(pytest.param(k, marks=pytest.mark.nightly) for k in range(1, 4))])
def test_what_is_read_back_is_what_was_certified(name: str, seed: int) -> None:
    one, axis = target(name), random_axis(seed)
    made = automatic(one, axis, {one.tolerance[-1][0]: 0.05})
    text = one.write(CamExport(made.table, "demo", (), ("°", "mm")))
    table = reread(one, text, made.table)
    assert table.x.tolist() == made.table.x.tolist()
    assert table.y == pytest.approx(made.table.y, abs=1e-12 * np.abs(made.table.y).max())
    back = certify_table(one, table, axis.profile)
    for order in "yvaj":
        assert back.share(order) == pytest.approx(made.share(order), rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("name", ["codesys", "twincat", "siemens", "br", "siemens-segments"])
def test_where_the_acceleration_jumps_a_point_stands_on_either_side(name: str) -> None:
    motion = Motion([Phase(law("ACS"), 50.0, 90.0), Phase(law("dwell"), 0.0, 90.0), Phase(law("ACS"), -50.0, 180.0)])
    one, axis = target(name), CamAxis("jumps", profile_of_motion(motion), "°", "mm")
    made = automatic(one, axis, {"v": 0.001})
    assert made.share("v") <= 0.001
    assert made.share("y") <= 1e-5
    assert made.points <= 12


@pytest.mark.parametrize("name", ["codesys", "twincat", "siemens", "br", "csv"])
def test_a_jump_stands_at_its_point_where_numbers_round_its_place(name: str) -> None:
    """At 1/30 and 1/6 of 0.3 s: a place that is rounded down had the acceleration before it, and 5.5 % of the lift."""
    trapezoid = law("TVP", rise_end=1 / 6, fall_start=5 / 6)
    motion = Motion([Phase(trapezoid, 8.0, 0.2), Phase(law("dwell"), 0.0, 0.1)])
    one, axis = target(name), CamAxis("jumps", profile_of_motion(motion), "s", "mm", repeats=False)
    made = automatic(one, axis, dict(one.tolerance))
    assert made.share("y") < 1e-6
    assert made.share("v") < 1e-3


@pytest.mark.parametrize("name", ["codesys", "siemens", "csv", "br", "twincat-table", "sew"])
def test_where_the_velocity_jumps_the_position_is_kept_all_the_same(name: str) -> None:
    motion = Motion([Phase(law("LIN"), 30.0, 90.0), Phase(law("dwell"), 0.0, 90.0), Phase(law("LIN"), -30.0, 180.0)])
    one, axis = target(name), CamAxis("kinks", profile_of_motion(motion), "°", "mm")
    assert automatic(one, axis, {"a": 0.01}).share("y") <= 0.01


@given(seed=st.integers(0, 10**6))
@settings(max_examples=3)
def test_exact_laws_go_into_segments_exactly(seed: int) -> None:
    axis, one = random_axis(seed), target("siemens-segments")
    made = automatic(one, axis, {"a": 1e-9})
    exact = one.exact(axis.profile).all()
    assert not exact or all(made.share(order) <= 1e-9 for order in "yva")


@pytest.mark.parametrize("name", TARGETS)
def test_limits_are_refused_by_reason(name: str) -> None:
    one = target(name)
    for n in (one.points[0] - 1, one.points[1] + 1):
        with pytest.raises(TargetError, match=f"expected {one.points[0]:,} to {one.points[1]:,}"):
            tabulate(one, FOUR, n)


def test_numbers_beyond_a_kind_are_refused_by_point() -> None:
    with pytest.raises(TargetError, match=r"point 2: 1e\+39 is beyond what REAL holds"):
        REAL.rounded(np.array([0.0, 1e39]))
    one = target("rockwell")
    with pytest.raises(TargetError, match=r"point 2: x is 1 after 1; expected the master to rise"):
        table_at(one, FOUR.profile, np.array([1.0, 1.0 + 1e-9]), ("°", "mm"))


def test_a_kollmorgen_profile_needs_something_above_0() -> None:
    one = target("kollmorgen")
    given = handed(one)
    below = CamExport(type(given.table)(given.table.x, -given.table.y - 1.0), "demo", (), ("°", "mm"))
    with pytest.raises(TargetError, match="no y is above 0"):
        one.write(below)


# Damaged and hostile files


def outcome(text: str, one) -> Table | str:
    """What comes of a text: the table, or the line that refuses it."""
    try:
        return parse_table(text, one)
    except TargetError as error:
        return str(error)


@pytest.mark.parametrize("name", TARGETS)
def test_a_file_that_is_cut_off_is_refused_or_was_whole(name: str) -> None:
    one = target(name)
    given = handed(one)
    told = header(len(given.table.x), "something", False, given.units)
    text = one.write(CamExport(given.table, "demo", (told,), given.units))
    whole = parse_table(text, one)
    for cut in range(0, len(text), max(7, len(text) // 60)):
        found = outcome(text[:cut], one)
        if isinstance(found, str):
            assert "\n" not in found
        else:
            assert found.x.tolist() == whole.x.tolist() or not COUNTED.search(text[:cut])


@pytest.mark.parametrize("name", TARGETS)
@pytest.mark.parametrize(
    "wrong",
    [*"nan NaN inf 1e999 1e20 0x10 --1 abc 9_0.0 \u0669\u0660 \uff19\uff10 9\u00b2".split(" "), "", "1" * 400],
)
def test_what_is_no_number_is_refused_in_a_line(name: str, wrong: str) -> None:
    one = target(name)
    text = one.write(handed(one))
    places = [
        found.span()
        for found in re.finditer(r"(?<![\d.\w])90\.0(?![\d])|9000000(?!\d)|(?<!\d)900000\.0|7496(?!\d)", text)
    ]
    assert places
    for begin, end in places[:1]:
        with pytest.raises(TargetError) as said:
            parse_table(text[:begin] + wrong + text[end:], one)
        assert "\n" not in str(said.value)


@pytest.mark.parametrize("name", [name for name in TARGETS if name != "mitsubishi-ratio"])
def test_masters_that_do_not_rise_are_refused(name: str) -> None:
    one = target(name)
    text = one.write(handed(one))
    for other in ("180.0", "200.0", "0.0"):
        changed = re.sub(r"(?<![\d.\w])90\.0(?![\d])", other, text)
        changed = re.sub(r"(?<!\d)9000000(?!\d)", other.replace(".0", "00000"), changed)
        changed = re.sub(r"(?<!\d)900000\.0", other.replace(".0", "0000.0"), changed)
        assert changed != text
        with pytest.raises(TargetError, match=r"rise|does not begin|differ"):
            parse_table(changed, one)


def test_mixed_signs_counts_and_widths_are_refused() -> None:
    csv, sew = target("csv"), target("sew")
    for text, said in (
        ("0;0\n1,5;1\n2.5;3\n", "both . and ,"),
        ("0;0\n1;1;2\n", "3 columns; expected 2"),
        ("0;0;0;0;0;0\n1;1;1;1;1;1\n", "6 columns; expected 2 or 3 or 4 or 5"),
        ("", "no line of numbers"),
        ("x;y\n", "no line of numbers"),
        ("0;0\nend\n", "'end' is no number"),
        ("0;0\n", "1 points; expected 2"),
    ):
        with pytest.raises(TargetError, match=re.escape(said)):
            csv.read(text)
    with pytest.raises(TargetError, match="5 points are told, 2 follow"):
        sew.read("5\n0;0\n1;1\n")
    assert csv.read("x;y\n0,5;1,25\n1,5;2\n").y.tolist() == [1.25, 2.0]
    assert csv.read("0 1\n1 2\n").x.tolist() == [0.0, 1.0]
    assert csv.read("0,1\n1,2\n").y.tolist() == [1.0, 2.0]
    assert csv.read("0\t1,5\n1\t2,5\n").y.tolist() == [1.5, 2.5]


def test_a_header_of_hyphens_leaves_xml_well_formed() -> None:
    one = target("rockwell")
    text = one.write(handed(one)._replace(header=("a---b ----> -", "--")))
    assert parse_table(text, one).x.tolist() == parse_table(one.write(handed(one)), one).x.tolist()


def test_xml_from_elsewhere_and_what_is_no_text_are_refused(tmp_path) -> None:
    rockwell = target("rockwell")
    text = rockwell.write(handed(rockwell))
    with pytest.raises(TargetError, match="not well-formed"):
        rockwell.read("no XML")
    with pytest.raises(TargetError, match="differ"):
        rockwell.read(text.replace("[90.0,15.0", "[91.0,15.0"))
    with pytest.raises(TargetError, match="0 tags of type CAM"):
        rockwell.read("<Tags/>")
    (tmp_path / "binary").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(MotionbookError, match="not a text"):
        read_table(tmp_path / "binary", target("csv"))


def test_a_calculated_profile_is_read_as_its_polynomials() -> None:
    """The rows of the reference, worked out there: a clamped spline through (0,0) and (120,30), 2 elements."""
    rows = (
        "[[2,0,0,0,0,1,0,0,0,0,1064374545,286331153,-1091423146,2023406815],"
        "[2,1079902208,0,1077805056,0,1,0,0,1070596096,0,-1084157679,286331153,0,0],"
        "[2,1080950784,0,1077805056,0,1,0,0,0,0,0,0,0,0],[0,1080950784,0,1077805056,0,1,0,0,0,0,0,0,0,0]]"
    )
    text = f'<Tags><Tag Name="P" DataType="CAM_PROFILE"><Data Format="L5K"><![CDATA[{rows}]]></Data></Tag></Tags>'
    table = target("rockwell").read(text)
    assert table.x.tolist() == [0.0, 120.0, 240.0]
    assert table.profile is not None
    assert table.profile.at(np.array([60.0])).y == pytest.approx([11.25])
    assert table.profile.at(np.array([120.0]), left=True).y == pytest.approx([30.0])
    assert table.profile.at(np.array([180.0]), left=True).y[0] > 30.0


BOMBS = {
    "comments": "(*" * 250_000, "word": "a" * 500_000, "spaces": " " * 500_000, "brackets": "[" * 500_000,
    "lines": "\n" * 500_000, "initialisers": ":= [" * 120_000, "assignments": "dX := 1, " * 50_000,
    "elements": f"<Tags>{'<a/>' * 250_000}</Tags>", "digits": "1" * 500_000, "pairs": f"Table := [{'[1,2],' * 80_000}",
}  # fmt: skip


@pytest.mark.parametrize("bomb", BOMBS)
def test_no_text_keeps_a_reader_busy(bomb: str) -> None:
    """What grows with the square of its length would take minutes; eight megabytes at most are read of a file."""
    begin = time.process_time()
    for name in TARGETS:
        with pytest.raises(TargetError):
            parse_table(BOMBS[bomb], target(name))
    assert time.process_time() - begin < 10.0


@pytest.mark.parametrize("seed", range(3))
def test_sew_is_bound_by_every_slope_that_a_cubic_may_have(seed: int) -> None:
    """Parabolas, lines between neighbours and means of chords, by their own formulas: at equal steps one inside."""
    sew, axis = target("sew"), random_axis(seed)
    made = automatic(sew, axis, dict(sew.tolerance))
    x, y = made.table.x, made.table.y
    assert np.ptp(np.diff(x)) < 1e-9
    h, m = np.diff(x), np.diff(y) / np.diff(x)
    means = (m[1:] + m[:-1]) / 2
    slopes = [(h[1:] * m[:-1] + h[:-1] * m[1:]) / (h[1:] + h[:-1]), (y[2:] - y[:-2]) / (x[2:] - x[:-2]), means]
    for one in slopes:
        inner = interpolation.hermite(x, y, np.concatenate([m[:1], one, m[-1:]]))
        off = certify(axis.profile, inner).deviations
        assert off[0].share <= made.share("y") + 1e-9
        assert off[1].share <= made.share("v") + 1e-9
    at = axis.profile.at(np.linspace(0.0, 360.0, 100_001))
    by_jerk = h[0] ** 2 * np.abs(at.y3).max() / (3 * np.abs(at.y1).max())
    assert made.share("v") < by_jerk * (1 + 1e-3)
