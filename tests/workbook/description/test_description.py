"""A description without guessing: every key is explained, in a new description, a schema and a page."""

import re
import tomllib

import pytest

from docs.description import PAGE
from tests import cutting
from tests.workbook.description.validate import wrong
from workbook.build import committed_descriptions
from workbook.commands import make
from workbook.description.commented import commented_description, example_of
from workbook.description.keys import sections
from workbook.description.schema import any_schema, page, schema
from workbook.errors import InputError, WriteError
from workbook.laws.registry import CODES
from workbook.reading.descriptions import make_machine, read_machine
from workbook.templates import TEMPLATES


@pytest.fixture(scope="module", params=TEMPLATES)
def template(request):
    return TEMPLATES[request.param]


def keys_of(template):
    found = [key for section in sections(template) for key in section.keys]
    return found + [row for key in found for row in key.rows]


def paths(data, above=""):
    """Every key of a description, rows alike."""
    for name, value in data.items():
        path = f"{above}.{name}".strip(".")
        rows = value if isinstance(value, list) else []
        if isinstance(value, dict):
            yield from paths(value, path)
        elif any(isinstance(row, dict) for row in rows):
            for row in rows:
                yield from paths(row, f"{path}.*")
        else:
            yield path


def test_a_new_description_is_the_committed_one_with_every_key(template, tmp_path):
    text = commented_description(template, "./x.json")
    path = tmp_path / "new.toml"
    path.write_text(text, encoding="utf-8")
    made, example = read_machine(path), read_machine(template.description)
    assert getattr(made, "axes", None) == getattr(example, "axes", [])[:2] or made == example
    assert [key.path for key in keys_of(template) if not re.search(rf"\b{key.name}\b", text)] == []
    assert max(map(len, text.splitlines())) < 300  # a row of a table stands in one line


def test_the_description_of_two_axes_has_about_a_hundred_lines_and_then_what_is_rarely_needed():
    first, _, rest = commented_description(TEMPLATES["machine"], "./x.json").partition("# Rarely needed.")
    assert first.count("\n") < 80
    assert all(line.startswith("#") for line in rest.splitlines()[1:] if line)


def test_examples_are_of_a_real_machine(template):
    """Every key has one, within its rules, or else its default: no number that no one would enter."""
    for key in keys_of(template):
        assert example_of(key) not in (None, "", []), key.path
    numbers = [example_of(key) for key in keys_of(template) if isinstance(example_of(key), float | int)]
    assert max(numbers) < 1e4


def test_its_optional_keys_may_go(template):
    """All that a remark calls optional is left out, and a machine is read all the same."""
    data = read_machine(template.description).model_dump(exclude_none=True)
    laws = data["laws"]
    for key in keys_of(template):
        *above, last = key.path.split(".")
        if not key.required and not above:
            data.pop(last, None)
    data["laws"] = {name: entry for name, entry in laws.items() if name not in CODES}
    data.pop("sizes")
    assert make_machine(template, data, str).title == read_machine(template.description).title


def test_every_key_says_what_it_means(template):
    keys = keys_of(template)
    assert [key.path for key in keys if len(key.meaning) < 2 or not key.expected] == []
    described = {key.path for key in keys}
    data = read_machine(template.description).model_dump()
    data["laws"] = {name: entry for name, entry in data["laws"].items() if name in CODES}  # others are as their family
    tables = {path.rpartition(".")[0] for path in described}  # which may be left out whole
    assert set(paths(data)) - described - tables == set()


def test_the_schema_takes_the_committed_descriptions_and_refuses_faults(template):
    made = schema(template)
    for file in committed_descriptions():
        data = tomllib.loads(file.read_text(encoding="utf-8"))
        if data["template"] == template.name:
            assert wrong(made, made, data) == []
            assert wrong(made, made, data | {"titel": "x"}) == [".titel"]
            assert wrong(made, made, data | {"title": 5}) == [".title"]
            assert wrong(made, made, data | {"sizes": {"cycle": 2}}) == [".sizes.cycle"]
            assert wrong(made, made, {k: v for k, v in data.items() if k != "title"}) == [".title"]
            assert wrong(made, made, data | {"laws": {"soft": {"family": "MTP"}, "ACS": {"share": 0.4}}}) == []
            assert wrong(made, made, data | {"laws": {"ACS": {"shares": 0.4}}}) == [".laws.ACS.shares"]


def test_one_schema_serves_all_templates():
    made = any_schema()
    for file in committed_descriptions():
        data = tomllib.loads(file.read_text(encoding="utf-8"))
        assert wrong(made, made, data) == []
        assert wrong(made, made, data | {"title": 5}) == [".title"]
    assert wrong(made, made, {"template": "mill"}) == [".template"]


def test_the_schema_explains_units():
    made = schema(TEMPLATES["machine"])
    rate = made["$defs"]["Master"]["properties"]["rate"]
    assert rate["description"] == "Production rate [cycles/min]: a number greater than 0; optional"
    assert rate["examples"] == [200.0]


def test_the_page_is_up_to_date():
    assert PAGE.read_text(encoding="utf-8") == page(), "run python -m docs.description"


def test_new_writes_a_description_and_its_schema_and_overwrites_nothing(tmp_path, capsys):
    target = tmp_path / "mine.toml"
    make.new("indexing-overlap", target, False)
    first = target.read_text(encoding="utf-8")
    assert first.startswith("#:schema ./indexing-overlap.schema.json\n")
    beside = tmp_path / "indexing-overlap.schema.json"
    assert beside.exists()
    make.new("indexing-overlap", tmp_path / "other.toml", False)  # the schema is there already, and the same
    with pytest.raises(WriteError, match="exists"):
        make.new("indexing-overlap", target, False)
    beside.write_text("{}", encoding="utf-8")
    with pytest.raises(WriteError, match="exists"):
        make.new("indexing-overlap", tmp_path / "third.toml", False)
    assert not (tmp_path / "third.toml").exists()
    make.new("indexing-overlap", target, True)
    assert beside.read_text(encoding="utf-8") != "{}"


def test_schema_goes_to_the_terminal_or_a_file(tmp_path, capsys):
    make.schema("flying-cutter", None, False)
    assert '"flying-cutter"' in capsys.readouterr().out
    make.schema(None, tmp_path / "all.json", False)
    assert (tmp_path / "all.json").exists()


def test_an_unknown_template_is_told_with_the_known_ones(tmp_path):
    with pytest.raises(InputError, match=r"no template is named 'mill'; expected one of .*motion-laws"):
        make.new("mill", tmp_path / "x.toml", False)


def test_errors_name_what_is_optional(tmp_path):
    path = tmp_path / "x.toml"
    text = cutting.DESCRIPTION.read_text(encoding="utf-8")
    path.write_text(text.replace("lift = 300.0", 'lift = "much"') + "colour = 3\n", encoding="utf-8")
    with pytest.raises(InputError) as refused:
        read_machine(path)
    said = str(refused.value)
    assert "found 'much'; expected a number (optional)" in said
    assert "selection.colour: unknown entry; expected one of motors, reducers, rank, greatest_margin" in said
    assert "axis, falling (all optional)" in said
