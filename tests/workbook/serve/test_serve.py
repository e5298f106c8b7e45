"""motionbook in the browser: each page by a person's steps, and what strangers must not be able to do."""

import json
import re
import shutil
import subprocess
import sys
import time
import zipfile
from urllib.parse import quote, unquote

import openpyxl
import pytest

from tests.workbook.serve.conftest import ENDLESS
from workbook.differences.design import read_design
from workbook.reading.descriptions import read_machine
from workbook.reports.cams import percent
from workbook.reports.differences import figure
from workbook.reports.study import figure as figure_of
from workbook.serve.home import groups_of_files
from workbook.serve.shown import short
from workbook.studies.plan import read_study

SAVED = {"name": "cutting.toml", "as": "cutting.toml"}

# --- a person's steps


def test_a_tampered_book_from_elsewhere_gets_the_report_of_the_command(server):
    book = openpyxl.load_workbook(server.root / "cutting.xlsx")
    sheet, cell = book.defined_names["drive1_tmax"].attr_text.replace("$", "").replace("'", "").split("!")
    book[sheet][cell] = "=1+1"
    book.save(server.root.parent / "tampered.xlsx")
    report = server.upload(
        "/upload", "book", "tampered.xlsx", (server.root.parent / "tampered.xlsx").read_bytes()
    ).body.decode()
    assert f"{sheet}!{cell}" in report
    assert "the formula is not the one that was generated" in report
    assert not (server.root / "tampered.xlsx").exists()


def test_the_page_to_print_has_the_results_of_the_design(server):
    page = server.ask("/print/live.toml").body.decode()
    found = read_design(server.root / "live.toml")
    assert found.machine.title in page
    for one in found.results().values():
        if one.place.startswith("Summary"):
            assert f">{short(one.value)}<" in page


def test_a_verified_book_is_taken_into_edit(server):
    report = server.ask("/verify", server.form(name="cutting.xlsx")).body.decode()
    assert 'action="/inputs"' in report
    done = server.ask("/inputs", server.form(name="cutting.xlsx"))
    entered = read_machine(server.root / done.headers["Location"].removeprefix("/edit/"))
    assert entered == read_machine(server.root / "live.toml")


def test_a_design_builds_its_own_book_and_keeps_what_is_the_engineers(server):
    shutil.copy(server.root / "live.toml", server.root / "own.toml")
    book = server.root / "own.xlsx"
    assert b"own.xlsx" in server.ask("/build", server.form(name="own.toml")).body
    opened = openpyxl.load_workbook(book)
    opened.create_sheet("Mine")["A1"] = 7
    opened.save(book)
    edited = book.read_bytes()
    told = server.ask("/build", server.form(name="own.toml"), Accept="application/json")
    assert json.loads(told.body)["book"] == "own.xlsx"
    assert openpyxl.load_workbook(book)["Mine"]["A1"].value == 7
    (kept,) = (server.root / ".bin").glob("* own.xlsx")
    assert kept.read_bytes() == edited
    kept.unlink()
    book.write_bytes(b"no book")
    assert json.loads(server.ask("/build", server.form(name="own.toml"), Accept="application/json").body)["code"] == 2
    assert book.read_bytes() == b"no book"


def test_the_first_page_tells_what_a_description_comes_to_and_keeps_it_by_its_contents(server):
    path = server.root / "told.toml"
    shutil.copy(server.root / "live.toml", path)
    path.write_text(path.read_text(encoding="utf-8").replace("lift = 80.0", f"lift = 80.0{time.time_ns()}"), "utf-8")
    assert 'data-from="/brief/told.toml"' in server.ask("/").body.decode()
    found = read_design(path)
    rate = next(one for one in found.results().values() if one.label == "Production rate")
    told = server.ask("/brief/told.toml").body.decode()
    assert f"<p>Production rate {rate.value:g} cycles/min; " in told
    assert f"{sum(one.value == 'FAIL' for one in found.checks().values()) or ''}" in told
    assert "<polyline" in told
    home = server.ask("/").body.decode()
    assert 'data-from="/brief/told.toml"' not in home
    assert server.ask("/favicon.ico").headers["Content-Type"] == "image/svg+xml"
    assert told.strip() in home
    path.write_text("title = 3", encoding="utf-8")
    assert "to complete" in server.ask("/brief/told.toml").body.decode()
    path.unlink()


def test_books_and_studies_stand_with_their_design(tmp_path):
    for name, title in (("a.toml", "Press"), ("b.toml", "Saw"), ("c.toml", "Press")):
        (tmp_path / name).write_text(f'title = "{title}"', encoding="utf-8")
    (tmp_path / "x.toml").write_text('title = "Study"\nbase = "b.toml"\n[[vary]]\nkey = "k"', encoding="utf-8")
    for name, title in (("a-2.xlsx", "Press"), ("other.xlsx", "Saw"), ("alone.xlsx", "Gone")):
        with zipfile.ZipFile(tmp_path / name, "w") as book:
            book.writestr("docProps/core.xml", f"<dc:title>{title}</dc:title>")
    (tmp_path / "no.xlsx").write_bytes(b"no book")
    groups = groups_of_files(sorted(tmp_path.iterdir()))
    told = [(group.title, group.design and group.design.path.name, [each.path.name for each in group.others])
            for group in groups]  # fmt: skip
    assert told == [("Gone", None, ["alone.xlsx"]), ("no", None, ["no.xlsx"]), ("Press", "a.toml", ["a-2.xlsx"]),
                    ("Press", "c.toml", []), ("Saw", "b.toml", ["other.xlsx", "x.toml"])]  # fmt: skip


def test_an_empty_machine_has_the_axis_that_is_named(server):
    done = server.ask("/new", server.form(template="", name="Füller 1.2", axis="Ram"))
    path = server.root / unquote(done.headers["Location"].removeprefix("/edit/"))
    assert (path.name, [axis.name for axis in read_machine(path).axes]) == ("Füller 1.2.toml", ["Ram"])
    assert server.ask("/new", server.form(template="", name="mine.xlsx", axis="Ram")).code == 400
    path.unlink()


def test_two_machines_are_compared_as_by_the_command(server):
    text = (server.root / "cutting.toml").read_text(encoding="utf-8")
    (server.root / "other.toml").write_text(text.replace("lift = 80.0", "lift = 84.0"), encoding="utf-8")
    page = server.ask("/compare", server.form(old="cutting.toml", new="other.toml")).body.decode()
    files = [str(server.root / name) for name in ("cutting.toml", "other.toml")]
    ran = subprocess.run([sys.executable, "-m", "workbook", "diff", *files, "--json"], capture_output=True, check=False)
    changes = [one for kind in json.loads(ran.stdout).values() if isinstance(kind, list) for one in kind]
    assert any("MC03" in one["place"] for one in changes)
    assert 'data-design="other.toml"' in page
    assert re.search(r'data-at="axes\.2\.phases\.\d\.lift"', page)
    for one in changes:
        assert f">{figure(one['old'])}<" in page
        assert f">{figure(one['new'])}<" in page


def test_an_axis_is_exported_as_by_the_command_and_read_back(server, tmp_path):
    assert ">MC03<" in server.ask("/controller/cutting.xlsx").body.decode()
    asked = {"axis": "MC03", "target": "siemens", "points": "auto", "a": "2"}
    page = server.ask("/export", server.form(name="cutting.xlsx", **asked)).body.decode()
    command = ["export", server.root / "cutting.xlsx", "--axis", "MC03", "--to", "siemens", "--tolerance", "a=2%"]
    ran = [sys.executable, "-m", "workbook", *map(str, command), "-o", tmp_path / "file.scl", "--json"]
    (told,) = json.loads(subprocess.run(ran, capture_output=True, check=True).stdout)
    assert server.ask("/file/cutting-MC03.scl").body == (tmp_path / "file.scl").read_bytes()
    assert f"{told['points']} points" in page
    figures = told["rules"]["quintics"]
    assert all(f">{one['largest']:.3g}<" in page and f">{percent(one['share'])}<" in page for one in figures.values())
    assert "error of the acceleration over the cycle" in page
    file = server.ask("/file/cutting-MC03.scl").body
    server.upload("/read", "table", "back.scl", file, target="siemens")
    (axis,) = read_machine(server.root / "back.toml").axes
    meant = read_machine(server.root / "cutting.toml").axes[2].phases
    assert [one.lift for one in axis.phases if one.lift] == pytest.approx([one.lift for one in meant if one.lift])


def test_a_study_is_chosen_followed_and_its_best_design_edited(server, tmp_path):
    form = server.ask("/vary/live.toml").body.decode()
    law, rate = "axes[1].phases[1].law", "master.rate"
    assert f'value="{law}"' in form
    assert 'value="drive1_rms"' in form
    asked = {"result": ["drive1_rms", "axis1.j.1"], "what": ["minimise"] * 2, "value": ["", ""], "way": "full",
             "designs": "9", "key": [law, rate], "values": ["all", "50, 60"], "vary": [law, rate]}  # fmt: skip
    begun = server.ask("/study", server.form(name="live.toml", **asked))
    assert (begun.code, begun.headers["Location"]) == (302, "/study/live-study.toml")
    assert re.search(r"<p>\d+ designs", server.ask("/progress/live-study.toml").body.decode())
    server.ask("/begin", server.form(name="live-study.toml"))
    page = server.ask("/study/live-study.toml").body.decode()
    assert "live-study.toml" in page
    assert 'href="/edit/live.toml"' in page
    panel = finished(server, "live-study.toml")
    known = json.loads((server.root / "live-study.json").read_text(encoding="utf-8"))
    assert f"{known['designs']:,} designs, {known['feasible']:,} feasible" in panel
    assert panel.count('<a href="/edit/live.toml?study=live-study.toml&amp;pick=') == 2 * len(known["best"])
    best = known["best"][0]
    assert figure_of(best["results"]["drive1_rms"]) in panel
    assert 'data-pick="1"' in server.ask("/edit/live.toml?study=live-study.toml&pick=1").body.decode()
    opened = json.loads(server.ask("/open", server.form(name="live.toml", study="live-study.toml", pick=1)).body)
    (tmp_path / "picked.toml").write_text(opened["text"])
    picked = read_machine(tmp_path / "picked.toml")
    assert (picked.axes[0].phases[0].law, picked.master.rate) == (best["entries"][law], best["entries"][rate])


def finished(server, name):
    """What the page of a study shows when it is done."""
    for _ in range(240):
        panel = server.ask(f"/progress/{name}").body.decode()
        if "data-again" not in panel:
            return panel
        time.sleep(0.25)
    raise AssertionError(panel)


def test_a_phase_that_varies_takes_its_room_from_another_one(server):
    form = server.ask("/vary/live.toml").body.decode()
    stop, other = "axes[3].phases[1].stop", "axes[3].phases[2]"
    assert f'aria-label="{stop}: takes its room from"' in form
    assert f'<option value="{read_machine(server.root / "live.toml").selection.motors[0].name}">' in form
    asked = {"result": "axis3.v.1", "what": "results", "value": "", "way": "full", "designs": "9", "key": [stop],
             "values": ["200, 210"], "takes": [other], "vary": [stop]}  # fmt: skip
    assert server.ask("/study", server.form(name="cutting.toml", **asked)).code == 302
    assert read_study(server.root / "cutting-study.toml").space.dimensions[0].takes == ("axes", "2", "phases", "1")
    (server.root / "cutting-study.toml").unlink()


def test_a_study_is_cancelled_and_goes_on(server):
    shutil.copy(server.root / "live.toml", server.root / "long.toml")
    server.ask("/study", server.form(name="long.toml", **ENDLESS))
    server.ask("/begin", server.form(name="long-study.toml"))
    folder = server.root / "long-study.csv.parts"
    while len([*folder.glob("part-*.json")]) < 2:
        assert "data-again" in server.ask("/progress/long-study.toml").body.decode()
        time.sleep(0.2)
    busy = server.ask("/begin", server.form(name="live-study.toml"))
    assert "long-study.toml is at work" in busy.body.decode()
    server.ask("/cancel", server.form(name="long-study.toml"))
    panel = finished(server, "long-study.toml")
    assert "Go on" in panel
    assert "Interrupted" in panel
    server.ask("/begin", server.form(name="long-study.toml"))
    assert "data-again" in server.ask("/progress/long-study.toml").body.decode()
    server.ask("/cancel", server.form(name="long-study.toml"))
    finished(server, "long-study.toml")


def test_a_study_of_what_there_is_not_is_refused_and_not_written(server):
    answer = server.ask("/study", server.form(name="cutting.toml", **ENDLESS | {"result": "drive1_rns"}))
    assert (answer.code, "no result is named" in answer.body.decode()) == (400, True)
    assert not (server.root / "cutting-study.toml").exists()


def test_a_file_that_changed_meanwhile_is_not_overwritten(server):
    answer = server.ask("/save", server.form(**SAVED, state="0" * 64, text="lost"), Accept="application/json")
    assert answer.code == 400
    assert json.loads(answer.body)["error"] == "cutting.toml changed on disk since it was opened"
    assert (server.root / "cutting.toml").read_text(encoding="utf-8") != "lost"


@pytest.mark.parametrize("changes", ["", "[", "{}", "[1]", '[{"do": "add"}]'])
def test_changes_that_are_none_are_refused(server, changes):
    answer = server.ask("/change", server.form(name="live.toml", text="", changes=changes), Accept="application/json")
    assert (answer.code, "expected a list of changes" in json.loads(answer.body)["error"]) == (400, True)


def test_line_ends_and_mark_of_a_file_are_kept(server):
    text = (server.root / "live.toml").read_text(encoding="utf-8")
    path = server.root / "windows.toml"
    path.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    opened = json.loads(server.ask("/open", server.form(name=path.name)).body)
    assert opened["text"] == text
    faster = re.sub(r"(?m)^rate = .*", "rate = 55.0", text)
    server.ask("/save", server.form(name=path.name, text=faster, state=opened["state"], **{"as": path.name}))
    assert path.read_bytes() == b"\xef\xbb\xbf" + faster.replace("\n", "\r\n").encode()


# --- strangers


def test_only_who_has_the_token_is_answered(server):
    first = server.ask(f"/?token={server.token}", cookie="")
    assert (first.code, first.headers["Location"]) == (302, "/")
    assert "HttpOnly" in first.headers["Set-Cookie"]
    assert "SameSite=Strict" in first.headers["Set-Cookie"]


def test_hostile_names_and_titles_are_text(server):
    (server.root / "<b>bold<b>.toml").write_text("x")
    home = server.ask("/")
    assert b"<b>" not in home.body
    assert "script-src 'self';" in home.headers["Content-Security-Policy"]
    assert "default-src 'none'" in home.headers["Content-Security-Policy"]


def test_files_are_duplicated_renamed_and_deleted_into_a_bin_whatever_they_are_called(server):
    for name in ("a#b.toml", "100%.toml", "größe ä.toml"):
        server.ask("/keep", server.form(name="live.toml", do="duplicate", **{"as": name}))
        assert quote(name, safe="") in server.ask("/").body.decode()
        assert server.ask(f"/file/{quote(name, safe='')}").body == (server.root / "live.toml").read_bytes()
        server.ask("/keep", server.form(name=name, do="rename", **{"as": f"new {name}"}))
        assert (server.root / f"new {name}").exists()
        server.ask("/keep", server.form(name=f"new {name}", do="delete", **{"as": ""}))
        assert not (server.root / f"new {name}").exists()
    assert len([*(server.root / ".bin").iterdir()]) == 3
    for name in ("NUL", "com1.toml", "../mine", "a/b", ".hidden"):
        assert server.ask("/keep", server.form(name="live.toml", do="duplicate", **{"as": name})).code == 400
