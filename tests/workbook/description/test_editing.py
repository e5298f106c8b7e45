"""Descriptions changed entry by entry: the entry changes, and no other line, comment or space."""

import tomllib

import pytest

from workbook.description.editing import edit_text
from workbook.errors import InputError
from workbook.fields.paths import put
from workbook.template import FOLDER

TEXT = (FOLDER / "machine.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("master", "rate"), 180.0),
        (("axes", "1", "phases", "0", "law"), "CIC"),
        (("axes", "1", "phases", "1", "stop"), 348.0),
        (("axes", "0", "reducer", "ratio"), 10.0),
        (("axes", "3", "shift"), 330.0),
        (("switches", "0", "on", "1", "0"), 201.0),
    ],
)
def test_one_entry_changes_in_one_line_and_comments_stay(path, value):
    changed = edit_text(TEXT, iter([(path, value)]))
    lines = [(one, other) for one, other in zip(TEXT.split("\n"), changed.split("\n"), strict=True) if one != other]
    assert len(lines) == 1
    before, after = (line.partition("#")[1:] for line in lines[0])
    assert before == after
    put(data := tomllib.loads(TEXT), path, value)
    assert tomllib.loads(changed) == data


def test_an_entry_is_added_and_taken_away():
    path = ("axes", "2", "motor", "rated_torque")
    more = edit_text(TEXT, iter([(path, 12.0)]))
    put(data := tomllib.loads(TEXT), path, 12.0)
    assert tomllib.loads(more) == data
    less = edit_text(TEXT, iter([(("axes", "1", "group"), None)]))
    assert "group" not in tomllib.loads(less)["axes"][1]


def test_what_does_not_lead_to_an_entry_is_told():
    for text, path in ((TEXT, ("axes", "9", "name")), (TEXT, ("title", "x")), ("a = ", ("a",))):
        with pytest.raises(InputError):
            edit_text(text, iter([(path, 1.0)]))


@pytest.mark.parametrize(
    "line", ["rate = 90.0     # a minute", 'name = "A # 1"   # of the #2', "on = [[9.0, 1.0]]  # °"]
)
@pytest.mark.parametrize("value", [100.0, 7.5, "B # 2", 1234567.0])
def test_a_comment_keeps_its_column_where_there_is_room(line, value):
    changed = edit_text(f"{line}\n", iter([((line.partition(" ")[0],), value)])).rstrip("\n")
    before, after = line.rindex(" # "), changed.rindex(" # ")
    assert changed[after:] == line[before:]
    assert after == before or (after > before and changed[after - 1] != " ")


def test_blanks_in_a_text_stay():
    assert edit_text('name = "A   # 1"\n', iter([(("name",), "BB   # 1")])) == 'name = "BB   # 1"\n'
