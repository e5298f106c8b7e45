"""The cutter's drive and its choice: the engine's values in cells, verdicts, catalogues from CSV, the round trip."""

import math
import random

import openpyxl
import pytest
import tomli_w
from typer.testing import CliRunner

from engine.selection.pair_matrix import RANKS
from engine.selection.task import accelerating_factor
from tests.mutation import draw_flying
from tests.workbook.cells import computed, disagreeing
from workbook.build import build, read_inputs
from workbook.cli import app
from workbook.errors import InputError, ReadError
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.selection.catalogue_files import committed_motors, committed_reducers, read_motors, read_reducers
from workbook.selection.entries import Limits
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.witnesses.pycel.model import PycelModel

TEMPLATE = TEMPLATES["flying-cutter"]
HEAVY = {
    "line_speed": 103.5, "product_length": 450.0, "law": "CIC",
    "drum": {"tools": 1.0, "radius": 134.0, "tool_angle": 30.0},
    "load": {"inertia": 11640.0, "mass": 0.0, "torque": 67.0},
    "lengths": {"shortest": 250.0, "longest": 1500.0},
}  # fmt: skip
"""a drum with one tool, of the inertia, the radius and the torque of S1's feeding rollers"""
MOTORS, REDUCERS = FOLDER / "motors.csv", FOLDER / "reducers.csv"
MOTOR_HEAD = "name,inertia_kgcm2,rated_torque_Nm,peak_torque_Nm,max_speed_rpm"
FALLING = {"max_speed": 1700.0, "full_torque_to": 10.0, "end_torque": 1.0}
HALF_HEAD = MOTOR_HEAD + ",torque_at_max_speed_Nm"
REDUCER_HEAD = "name,reduction,efficiency"
STRONG = [
    {"name": "small", "inertia": 40.0, "rated_torque": 60.0, "peak_torque": 300.0, "max_speed": 3000.0, "mass": 20.0},
    {"name": "large", "inertia": 200.0, "rated_torque": 180.0, "peak_torque": 600.0, "max_speed": 3000.0, "mass": 70.0},
    {"name": "twin", "inertia": 200.0, "rated_torque": 180.0, "peak_torque": 600.0, "max_speed": 3000.0, "mass": 70.0},
]
FIVE = STRONG + [STRONG[0] | {"name": name} for name in "ab"]
OWN_MOTOR = """
[[selection.motors]]
name = "own"
inertia = 1.0
rated_torque = 1.0
peak_torque = 2.0
max_speed = 3.0
"""
BOXES = [
    {"name": "i 5", "reduction": 5.0, "efficiency": 0.95, "inertia": 10.0, "max_torque": 2000.0, "mass": 15.0},
    {"name": "i 8", "reduction": 8.0, "efficiency": 0.95, "max_torque": 2000.0, "mass": 15.0},
    {"name": "i 5 weak", "reduction": 5.0, "efficiency": 0.95, "inertia": 10.0, "max_torque": 500.0, "mass": 5.0},
]


def machine(**choice):
    """A heavy drum in small tables, with a choice."""
    data = read_machine(TEMPLATE.description).model_dump()
    data["sizes"] |= {"cycle": 72, "law": 4, "motors": 4, "reducers": 4}
    data["cutter"] |= HEAVY
    data["limits"] = {name: value for name, value in choice.items() if name in Limits.model_fields}
    chosen = {name: value for name, value in choice.items() if name not in Limits.model_fields}
    data["selection"] = {"motors": STRONG, "reducers": BOXES} | chosen
    return TEMPLATE.model.model_validate(data)


@pytest.mark.parametrize(("rank", "named"), [(rank, k % 2) for k, rank in enumerate(RANKS)])
@pytest.mark.sample(2)
def test_every_cell_agrees_with_the_engine(rank, named):
    pair = {"motor": "large", "reducer": "i 8"} if named else {}
    assert disagreeing(TEMPLATE, machine(rank=rank, torque_factor=1.5, **pair))[0] == []


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.sample(2)
def test_random_machines_and_catalogues_agree_too(seed):
    drawn = random.Random(seed)
    data = draw_flying.varied(machine().model_dump(), drawn)
    assert disagreeing(TEMPLATE, TEMPLATE.model.model_validate(data))[0] == []


def test_the_committed_catalogues_say_where_each_figure_is_from():
    for row in (*committed_motors(), *committed_reducers()):
        assert row.source, row.name
    assert len(committed_motors()) >= 8
    assert len(committed_reducers()) >= 8


@pytest.mark.parametrize(
    ("name", "kilowatts_per_second"),
    [
        ("Mitsubishi HG-KN13", 12.9),
        ("Mitsubishi HG-KN73", 44.5),
        ("Yaskawa SGM7A-15A", 120),
        ("Yaskawa SGM7A-40A", 165),
        ("Yaskawa SGM7A-70A", 404),
        ("Yaskawa SGM7G-20A", 50.9),
    ],
)
def test_motors_have_the_power_rate_that_their_makers_print(name, kilowatts_per_second):
    """α is what makers call the power rate: printed beside torque and inertia, it shows that both were read right."""
    motor = next(m for m in committed_motors() if m.name == name)
    alpha = float(accelerating_factor(motor.rated_torque, motor.inertia * 1e-4))
    assert alpha / 1000 == pytest.approx(kilowatts_per_second, rel=0.02)  # torque is printed with two figures


def test_pairs_with_the_reducer_out_of_the_picture_are_those_whose_ratio_lies_in_the_range():
    boxes = [{"name": f"i {i}", "reduction": float(i), "efficiency": 1.0} for i in (3, 6, 12, 25)]
    wide = {"greatest_margin": 1e6, "inertia_ratio": 1e6}
    strong = [row | {"peak_torque": 1e4} for row in STRONG]
    value = computed(TEMPLATE, machine(motors=strong, reducers=boxes, **wide))
    low, high, verdict = (value("ratios", c)[:3] for c in ("low", "tau_max", "verdict"))
    for r, box in enumerate(boxes, 1):
        inside = [verdict[m] == "yes" and low[m] <= 1 / box["reduction"] <= high[m] for m in range(3)]
        assert [word == "yes" for word in value(f"sel_word{r}", "v")[:3]] == inside
    assert 0 < value("sel_usable") < 12


def test_a_rank_without_figures_is_said_in_words():
    value = computed(TEMPLATE, machine(rank="cost"))
    assert value("sel_message") == "no usable pair has what it is ranked by"
    assert (value("sel_usable") > 0, value("sel_count"), value("sel_motor")) == (True, 0, "none")
    assert value("sel_ok") == "FAIL"


def test_no_motor_at_all_is_said_in_words():
    weak = [row | {"rated_torque": 0.5} for row in STRONG]
    value = computed(TEMPLATE, machine(motors=weak))
    assert value("sel_message") == "no pair can do it"
    assert set(value("ratios", "verdict")) == {"too weak", "–"}
    assert (set(value("sel_best", "motor")), value("drive_motor")) == ({"–"}, "small")
    assert {value(name) for name in ("sel_ok", "drive_ok_rms")} == {"FAIL"}


def test_a_load_that_goes_on_at_one_speed_leaves_nothing_to_select():
    data = machine().model_dump()
    data["cutter"]["product_length"] = 2 * math.pi * 134.0
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(data))
    assert (value("sel_moves"), value("sel_beta"), set(value("ratios", "verdict"))) == (0, 0, {"–"})


@pytest.mark.parametrize(
    ("change", "failing"),
    [
        ({"motors": [STRONG[1] | {"rated_torque": 50.0}]}, "drive_ok_rms"),
        ({"motors": [STRONG[1] | {"rated_torque": 110.0, "peak_torque": 115.0}]}, "drive_ok_peak"),
        ({"motors": [STRONG[1] | FALLING]}, "drive_ok_curve"),
        ({"motors": [STRONG[1] | {"max_speed": 1500.0}]}, "drive_ok_speed"),
        ({"reducers": [BOXES[0] | {"max_speed": 1500.0}]}, "drive_ok_reducer_speed"),
        ({"reducers": [BOXES[0] | {"max_torque": 400.0}]}, "drive_ok_reducer_peak"),
    ],
)
def test_each_check_of_step_7_can_fail(change, failing):
    choice = {"motors": STRONG, "reducers": BOXES} | change
    first = {"motor": choice["motors"][0]["name"], "reducer": choice["reducers"][0]["name"]}
    value = computed(TEMPLATE, machine(**first, **change))
    assert (value(failing), value("drive_ok_told")) == ("FAIL", "OK")


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({"motor": "nobody"}, "selection.motor: no motor of the catalogue is named 'nobody'; expected one of "),
        (
            {"motors": [STRONG[0], STRONG[0]]},
            "selection.motors[2].name (counted from 1): a second motor is named 'small'; expected",
        ),
        ({"motors": [STRONG[0] | {"name": "a*"}]}, "selection.motors[1].name (counted from 1): holds *"),
        ({"motors": FIVE}, "selection.motors: 5 rows do not fit into 4; raise sizes.motors"),
    ],
)
def test_entries_that_cannot_be(change, line, tmp_path):
    path = tmp_path / "machine.toml"
    data = machine().model_dump(exclude_none=True)
    data["selection"] |= change
    path.write_text(tomli_w.dumps(data))
    with pytest.raises(InputError) as found:
        read_machine(path)
    assert line in str(found.value)


def csv(tmp_path, *lines, name="motors.csv"):
    path = tmp_path / name
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ([MOTOR_HEAD, "A,0.01,x,3,3000"], "line 2, column rated_torque_Nm: found 'x'; expected a number"),
        ([MOTOR_HEAD, "A,0.01,2,3,3000", ",0.01,2,3,1"], "line 3, column name: empty; expected a text of 1 to 60"),
        ([MOTOR_HEAD, "=A,1,2,3,3000"], "line 2, column name: found '=A'; expected a text of 1 to 60 characters"),
        ([MOTOR_HEAD, "A,1,2,3,3000,4"], "line 2: 6 cells; expected 5, as in the head"),
        ([MOTOR_HEAD + ",colour", "A,1,2,3,3000,red"], "line 1: unknown column 'colour'; expected one of name, "),
        ([MOTOR_HEAD + ",name", "A,1,2,3,3000,B"], "line 1: column name stands there twice"),
        (["name,inertia_kgcm2", "A,1"], "line 1: column rated_torque_Nm is missing"),
        ([MOTOR_HEAD], "there is no product below the head; expected one a line"),
    ],
)
def test_faults_of_a_catalogue_name_file_line_and_column(lines, expected, tmp_path):
    path = csv(tmp_path, *lines)
    with pytest.raises((InputError, ReadError)) as found:
        read_motors(path)
    assert str(found.value).startswith(f"{path}: ")
    assert expected in str(found.value)


def test_every_fault_of_a_catalogue_is_told_at_once(tmp_path):
    path = csv(tmp_path, REDUCER_HEAD, "A,x,0.9", "B,5,much", "C,5,0.9")
    with pytest.raises(InputError) as found:
        read_reducers(path)
    assert [line.split(": ")[1] for line in found.value.lines] == [
        "line 2, column reduction",
        "line 3, column efficiency",
    ]


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (
            [MOTOR_HEAD, "A,0.02,180,600,3000", "B,-1,2,3,3000"],
            "motors[2].inertia (counted from 1): -1; expected a number greater than 0",
        ),
        (
            [MOTOR_HEAD, "A,0.02,180,600,3000", "B,0.01,2,3,"],
            "motors[2].max_speed (counted from 1): expected",
        ),
        ([HALF_HEAD, "A,0.02,180,600,3000,1"], "half of the torque–speed curve is empty"),
    ],
)
@pytest.mark.sample(1)
def test_a_catalogue_with_figures_that_cannot_be_is_built_and_fails(lines, said, tmp_path):
    """So is one of a description that is unfinished itself: what was entered stays, there and in the book."""
    gap = tmp_path / "gap.toml"
    gap.write_text(TEMPLATE.description.read_text().replace("radius = 120.0", "radius = 0.0", 1))
    out, rest = tmp_path / "book.xlsx", ["--motors", str(csv(tmp_path, *lines)), "--force", "-o"]
    whole = CliRunner().invoke(app, ["build", str(TEMPLATE.description), *rest, str(out)])
    assert (whole.exit_code, said in " ".join(whole.output.split())) == (3, True), whole.output
    both = CliRunner().invoke(app, ["build", str(gap), *rest, str(out)])
    assert "cutter.drum.radius: 0; expected a number greater than 0" in " ".join(both.output.split())
    assert CliRunner().invoke(app, ["verify", str(out)]).exit_code == 3


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b""])
def test_a_file_that_is_no_catalogue(content, tmp_path):
    path = tmp_path / "motors.csv"
    path.write_bytes(content)
    with pytest.raises(ReadError, match=r"expected a (catalogue|head)"):
        read_motors(path)
    with pytest.raises(ReadError, match="no such file"):
        read_motors(tmp_path / "other.csv")


def test_semicolons_and_decimal_commas_as_spreadsheets_save_them(tmp_path):
    plain = csv(tmp_path, MOTOR_HEAD, "A,0.01,2.5,3,3000")
    other = csv(tmp_path, "\ufeff" + MOTOR_HEAD.replace(",", ";"), "A;0,01;2,5;3;3000", "", name="other.csv")
    assert read_motors(plain) == read_motors(other)


def test_build_takes_catalogues_and_inputs_gives_them_back(tmp_path):
    motors = csv(
        tmp_path, MOTOR_HEAD + ",source", "A,0.02,180,600,3000,somewhere", "B,0.004,60,300,3000,", name="m.csv"
    )
    reducers = csv(tmp_path, REDUCER_HEAD, "X,5,0.95", "Y,8,0.9", name="r.csv")
    out = tmp_path / "book.xlsx"
    options = ["--motors", str(motors), "--reducers", str(reducers), "-o", str(out)]
    ran = CliRunner().invoke(app, ["build", str(TEMPLATE.description), *options])
    assert ran.exit_code == 3, ran.output  # neither motor can do it
    given, notes = read_inputs(out)
    assert notes == []
    assert [row.model_dump(exclude_none=True) for row in given.selection.motors] == read_motors(motors)
    assert [row.model_dump(exclude_none=True) for row in given.selection.reducers] == read_reducers(reducers)
    assert (given.selection.motor, given.selection.reducer) == (None, None)
    again = tmp_path / "again.xlsx"
    build(given, again)
    assert read_inputs(again)[0] == given


def test_catalogues_beside_a_description_are_taken_unless_it_has_its_own(tmp_path):
    text = TEMPLATE.description.read_text()
    path = tmp_path / "machine.toml"
    path.write_text(text)
    csv(tmp_path, MOTOR_HEAD, "A,0.02,180,600,3000")
    assert [m.name for m in read_machine(path).selection.motors] == ["A"]
    assert read_machine(path).selection.rank == "smallest motor"
    path.write_text(f'{text}\n[selection]\nmotor = "A"\n')
    assert read_machine(path).selection.motor == "A"
    path.write_text(text + OWN_MOTOR)
    assert [m.name for m in read_machine(path).selection.motors] == ["own"]


def test_large_catalogues_get_larger_tables(tmp_path):
    many = csv(tmp_path, MOTOR_HEAD, *(f"motor {i},0.02,180,600,3000" for i in range(40)))
    assert read_machine(TEMPLATE.description, motors=many).sizes.motors == 40
    more = csv(tmp_path, MOTOR_HEAD, *(f"motor {i},0.02,180,600,3000" for i in range(101)))
    with pytest.raises(InputError, match="101 products; expected at most 100"):
        read_machine(TEMPLATE.description, motors=more)


def test_a_template_without_a_choice_of_motor_says_so():
    with pytest.raises(InputError, match="indexing-overlap chooses no motor; --motors cannot be used"):
        read_machine(TEMPLATES["indexing-overlap"].description, motors=MOTORS)


def test_figure_11_has_a_logarithmic_axis_and_a_line_for_each_product(book):
    chart = openpyxl.load_workbook(book)["Ratios"]._charts[0]
    assert chart.y_axis.scaling.logBase == 10
    bars = [s.errBars.errDir for s in chart.series if s.errBars]
    assert bars == ["y", "x"]


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    """A book as built, whose drive has a pair that is named."""
    path = tmp_path_factory.mktemp("built") / "book.xlsx"
    build(machine(motor="small", reducer="i 5"), path)
    return path


def edited(path, out, *changes):
    """A copy of a workbook in which the cells beside texts of a sheet hold something else."""
    book = openpyxl.load_workbook(path)
    for title, text, down, column, value in changes:
        sheet = book[title]
        row = next(r for r in range(sheet.max_row, 0, -1) if sheet.cell(r, 2).value == text)
        sheet.cell(row + down, column).value = value
    book.save(out)
    return out


def test_a_product_typed_into_an_empty_row_is_ranked_and_carried_over(tmp_path, book):
    figures = (("added", 2), (150.0, 3), (170.0, 5), (900.0, 7), (3000.0, 8))
    changes = [("Catalogue", "twin", 1, column, value) for value, column in figures]
    report = verify(edited(book, tmp_path / "edited.xlsx", *changes))
    assert report.findings == []
    given, _ = read_inputs(tmp_path / "edited.xlsx")
    assert [m.name for m in given.selection.motors] == ["small", "large", "twin", "added"]
    assert computed(TEMPLATE, given)("sel_best", "motor")[0] == "added"


@pytest.mark.parametrize(
    ("change", "line"),
    [
        (("Catalogue", "large", 0, 2, "small"), "(motor): a second motor is named 'small'; expected a name of"),
        (("Drive", "Motor of the catalogue", 0, 4, "x"), "no motor of the catalogue is named 'x'; expected one of "),
    ],
)
def test_what_cannot_be_in_a_workbook_is_named_by_its_cell(change, line, tmp_path, book):
    with pytest.raises(InputError) as found:
        read_inputs(edited(book, tmp_path / "edited.xlsx", change))
    assert f"edited.xlsx: {change[0]}!" in str(found.value)
    assert line in str(found.value)


def test_a_motor_that_is_not_in_the_catalogue_fails_a_check_and_shows_no_errors(tmp_path, book):
    edited(book, tmp_path / "edited.xlsx", ("Drive", "Motor of the catalogue", 0, 4, "nothing"))
    values = PycelModel(openpyxl.load_workbook(tmp_path / "edited.xlsx")).evaluate()
    shown = [value for (sheet, _, _), value in values.items() if sheet == "Drive"]
    assert "a name is not in the catalogue; expected one of its names, or an empty cell" in shown
    assert [v for v in shown if isinstance(v, str) and v.startswith("#")] == []
