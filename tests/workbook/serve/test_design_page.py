"""The design page in the system's Chromium, as people type: nothing typed is lost, whatever comes back meanwhile."""

import re
import shutil
import tomllib

import pytest

from tests.workbook.serve.chromium import Axe, expect
from tests.workbook.serve.conftest import LONG, answered, window
from workbook.template import FOLDER

TYPED = {
    "axes.1.phases.0.start": "92.0712", "axes.1.phases.0.stop": "141.25", "axes.1.phases.1.start": "301.0712",
    "axes.1.mechanism.lead": "21.0712", "axes.1.load.mass": "26.0712", "axes.1.load.friction": "0.0712",
    "axes.1.motor.inertia": "12.0712", "axes.1.motor.peak_torque": "51.0712",
}  # fmt: skip


@pytest.fixture
def wrapping(server):
    """A file of the committed machine, anew for each test."""
    path = server.root / "wrapping.toml"
    shutil.copy(FOLDER / "machine.toml", path)
    path.with_name("wrapping.toml.draft").unlink(missing_ok=True)
    return path


def opened(page, server, axis="MC02"):
    page.goto(f"http://{server.host}/edit/wrapping.toml")
    page.wait_for_selector("aside input")
    page.locator("nav .card", has_text=axis).click()


def field(page, path):
    return page.locator(f'input[data-path="{path}"]')


def enter(page, path, words):
    """Enter another value, and wait until it is answered."""
    field(page, path).fill(words)
    with answered(page):
        field(page, path).press("Enter")


def press(page, name):
    """Press a button that changes the design, and wait until it is answered."""
    with answered(page):
        page.get_by_role("button", name=name).click()


def judged(page):
    """Wait until the machine is judged for the first time."""
    expect(page.locator(".pill.wait")).to_have_count(0)


def saved(page, path):
    with page.expect_response("**/save"):
        page.keyboard.press("Control+S")
    expect(page.locator("header .file")).to_contain_text("· saved")
    return tomllib.loads(path.read_text(encoding="utf-8"))


def value_at(data, path):
    for part in path.split("."):
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data


def test_what_would_help_most_is_tried_and_undone(page, server, wrapping):
    opened(page, server)
    page.get_by_role("button", name="Faster …").click()
    rows = page.locator(".verdict .list button")
    expect(rows.first).to_contain_text("cycles/min (+", timeout=LONG)
    rows.first.click()
    expect(rows).to_have_count(0)
    assert value_at(saved(page, wrapping), "axes.0.phases.0.stop") == 90.0
    press(page, "Undo")
    assert value_at(saved(page, wrapping), "axes.0.phases.0.stop") == 80.0


@pytest.mark.parametrize("pause", [40, 90, 160, 300])
@pytest.mark.parametrize("is_finished", [True, False])
@pytest.mark.sample(2)
def test_no_digit_is_lost_at_any_pace_while_figures_come_back(page, server, wrapping, pause, is_finished):
    if not is_finished:
        text = wrapping.read_text(encoding="utf-8")
        wrapping.write_text(text.replace("lift = 80.0, ", ""), encoding="utf-8")
    opened(page, server)
    for path, words in TYPED.items():
        field(page, path).click()
        page.keyboard.press("Control+A")
        page.keyboard.type(words, delay=pause)
        page.keyboard.press("Tab")
    data = saved(page, wrapping)
    assert {path: value_at(data, path) for path in TYPED} == {path: float(words) for path, words in TYPED.items()}
    for path, words in TYPED.items():
        expect(field(page, path)).to_have_value(words)


def test_a_save_takes_the_field_one_is_in_and_esc_restores_it(page, server, wrapping):
    opened(page, server)
    field(page, "axes.1.load.mass").fill("31")
    page.keyboard.press("Escape")
    expect(field(page, "axes.1.load.mass")).to_have_value("25")
    field(page, "axes.1.load.mass").fill("31,5")
    assert value_at(saved(page, wrapping), "axes.1.load.mass") == 31.5
    assert not wrapping.with_name("wrapping.toml.draft").exists()


def test_what_is_wrong_is_told_below_the_field_and_never_in_the_file(page, server, wrapping):
    opened(page, server)
    before = wrapping.read_text(encoding="utf-8")
    enter(page, "axes.1.motor.peak_torque", "4o")
    expect(page.locator("aside .wrong")).to_contain_text("“4o”")
    enter(page, "axes.1.load.mass", "25000 g")
    expect(field(page, "axes.1.load.mass")).to_have_value("25")
    expect(field(page, "axes.1.motor.peak_torque")).to_have_value("4o")
    saved(page, wrapping)
    assert wrapping.read_text(encoding="utf-8") == before


def test_an_unfinished_axis_leaves_the_others(page, server, wrapping):
    opened(page, server)
    expect(page.locator(".pill")).to_contain_text("checks OK")  # lines are drawn anew with the pieces of their laws
    line = page.locator(".lane.selected .line").get_attribute("d")
    enter(page, "axes.1.phases.0.stop", "")
    assert page.locator(".lane.selected.stale .line").get_attribute("d") == line
    card = page.locator("nav .card", has_text="MC02")
    expect(card).to_contain_text("phase 1, to: missing")
    expect(page.locator(".pill")).to_have_text("1 to complete")
    expect(page.get_by_role("button", name="Faster …")).to_be_disabled()
    page.locator(".pill").click()
    expect(page.locator(".verdict .list")).to_have_count(1)
    page.keyboard.press("Escape")
    expect(page.locator(".verdict .list")).to_have_count(0)
    expect(page.locator("nav .card", has_text="MC01").locator(".use b").first).to_have_text("95 %")
    enter(page, "master.rate", "100")
    expect(page.locator("nav .card", has_text="MC01").locator(".use b").first).not_to_have_text("95 %")
    enter(page, "axes.1.phases.0.stop", "135")
    expect(page.locator(".pill")).to_contain_text("checks OK")


def test_changes_are_undone_from_a_field_and_redone(page, server, wrapping):
    opened(page, server)
    for words in ("26", "27"):
        enter(page, "axes.1.load.mass", words)
    for way, words in (("Control+Z", "26"), ("Control+Z", "25"), ("Control+Y", "26")):
        page.keyboard.press(way)
        expect(field(page, "axes.1.load.mass")).to_have_value(words)
    field(page, "axes.1.load.mass").press("ArrowUp")
    expect(field(page, "axes.1.load.mass")).to_have_value("27")
    page.get_by_role("button", name="Text").click()
    expect(page.locator("#text")).to_have_value(re.compile("mass = 27.0 {12}# kg"))


def test_the_entries_of_a_study_are_chosen_by_clicking_them_in_the_design(page, server, wrapping):
    opened(page, server)
    page.get_by_role("button", name="Study").click()
    field(page, "axes.1.phases.0.stop").click()
    page.locator("aside .law button").first.click()
    page.locator("aside label", has_text="Mass that travels").click()
    for _ in range(2):  # the second takes it back
        field(page, "axes.1.mechanism.efficiency").click()
    field(page, "axes.1.mechanism.lead").focus()
    page.keyboard.press("Enter")
    page.locator('[data-path="axes.1.mechanism.kind"]').click()
    expect(page.locator(".notice")).to_contain_text("Study of MC02, phase 1, to; MC02, phase 1, law")
    page.get_by_role("button", name="Choose goals").click()
    ticked = page.locator("input[name=vary]:checked")
    expect(ticked).to_have_count(4)
    assert [box.input_value() for box in ticked.all()] == [
        f"axes[2].{entry}" for entry in ("phases[1].stop", "phases[1].law", "mechanism.lead", "load.mass")
    ]
    expect(page.locator("p.disagrees")).to_have_text("No study varies: MC02, mechanism, kind.")


def test_what_cannot_be_read_is_told_in_place_of_the_page(page, server, wrapping):
    wrapping.write_bytes('title = "Ü"'.encode("latin-1"))
    page.goto(f"http://{server.host}/edit/wrapping.toml")
    expect(page.locator("#page")).to_contain_text("UTF-8")
    page.get_by_role("link", name="All machines").click()


def test_a_file_that_changed_on_disk_is_told_and_a_second_tab_cannot_overwrite_it(browser, page, server, wrapping):
    opened(page, server)
    with window(browser, server) as other:
        opened(other, server)
        enter(other, "axes.1.load.mass", "40")
        saved(other, wrapping)
        enter(page, "axes.1.load.mass", "50")
        expect(page.locator(".notice")).to_contain_text("changed on disk")
        with page.expect_response("**/save"):
            page.keyboard.press("Control+S")
        expect(page.locator(".notice")).to_contain_text("changed on disk")
        assert value_at(tomllib.loads(wrapping.read_text()), "axes.1.load.mass") == 40.0
        page.get_by_role("button", name="see the difference").click()
        expect(page.locator(".differ")).to_contain_text("mass = 40.0")
        page.get_by_role("button", name="keep mine").click()
        assert value_at(saved(page, wrapping), "axes.1.load.mass") == 50.0
        other.get_by_role("button", name="load theirs").click()
        expect(field(other, "axes.1.load.mass")).to_have_value("50")


def test_what_a_report_tells_leads_to_its_entry_or_to_what_it_names(page, server, wrapping):
    for at, path in (("axes.1.load.viscous", "axes.1.load.viscous"), ("Drive MC02: creeps", "axes.1.load.mass"),
                     ("revision", "revision"), ("Punch over cutter", "clearances.0.offset")):  # fmt: skip
        page.goto(f"http://{server.host}/edit/wrapping.toml?at={at}")
        expect(field(page, path)).to_be_visible()
    expect(page.locator("aside h2")).to_contain_text("Punch over cutter")


def test_a_catalogue_of_ones_own_is_a_table(page, server, wrapping):
    opened(page, server)
    page.locator("nav .item", has_text="Selection").click()
    page.get_by_role("button", name="own catalogue").first.click()
    page.get_by_role("button", name="begin with").click()
    page.get_by_role("button", name="copy motor 2").click()
    enter(page, "selection.motors.19.max_speed", "6500 rpm")
    page.get_by_label("close").click()
    expect(page.locator(".pill")).to_contain_text("checks OK")
    motors = saved(page, wrapping)["selection"]["motors"]
    assert (len(motors), motors[19]["max_speed"]) == (20, 6500.0)
    assert motors[19]["name"] not in [motor["name"] for motor in motors[:19]]


def test_what_was_not_saved_is_there_again_and_can_be_thrown_away(page, server, wrapping):
    opened(page, server)
    enter(page, "axes.1.load.mass", "33")
    page.on("dialog", lambda dialog: dialog.accept())
    opened(page, server)
    expect(field(page, "axes.1.load.mass")).to_have_value("33")
    page.get_by_role("button", name="throw them away").click()
    expect(field(page, "axes.1.load.mass")).to_have_value("25")


def test_axes_and_phases_are_added_copied_and_deleted(page, server, wrapping):
    opened(page, server)
    page.get_by_role("button", name="+ axis").click()
    expect(page.locator("aside h2")).to_contain_text("MC05")
    page.get_by_role("button", name="+ phase").click()
    expect(page.locator("aside tbody tr:not(.under)")).to_have_count(3)
    page.get_by_role("button", name="+ mechanism and motor").click()
    expect(page.locator("nav .card", has_text="MC05").locator(".use")).not_to_have_count(0)
    page.get_by_role("button", name="delete").click()
    expect(page.locator("nav .card")).to_have_count(4)
    expect(page.locator(".pill")).to_contain_text("checks OK", timeout=LONG)


PARTS = ("MC01", "MC02", "MC03", "MC04", "Punch over cutter", "Valve 3", "Film sensor", "Cycle", "Export", "Timing",
         "Selection", "Sizes")  # fmt: skip
BUTTONS = "aside button:not(.more):not(.in):not(:has-text('catalogue ▾'))"


@pytest.mark.sample(1)
@pytest.mark.parametrize("part", PARTS)
def test_every_button_leads_to_a_design_that_works_or_names_what_is_missing_in_its_field(page, server, wrapping, part):
    opened(page, server)
    chosen = page.locator("nav :is(.card, .item)", has_text=part).first
    chosen.click()
    for k in range(page.locator(BUTTONS).count()):
        with answered(page) as answer:
            page.locator(BUTTONS).nth(k).click()
        given = answer.value.json()
        if given["refused"]:
            expect(page.locator(".notice.bad")).to_have_count(1)
            page.get_by_label("close").click()
            continue
        if given["faults"]:
            expect(page.locator("aside .wrong").first).to_be_visible()
        with answered(page):
            page.get_by_role("button", name="Undo").click()
        expect(page.get_by_role("button", name="Undo")).to_be_disabled()
        chosen.click()


def test_the_page_fits_a_screen_without_scrolling_and_its_text_can_be_read(page, server, wrapping):
    opened(page, server)
    judged(page)
    for width, height in ((1440, 900), (1024, 768)):
        page.set_viewport_size({"width": width, "height": height})
        scroll = page.evaluate("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
        assert (scroll[0] <= width, scroll[1] <= height) == (True, True)
        sizes = page.evaluate(
            "[...document.querySelectorAll('#page *')].filter(e => e.textContent.trim() && e.getClientRects().length)"
            ".map(e => parseFloat(getComputedStyle(e).fontSize))"
        )
        assert min(sizes) >= 12.0


@pytest.mark.nightly
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_no_state_of_the_page_shuts_anybody_out_in_either_scheme_or_at_any_size(browser, server, wrapping, scheme):
    with window(browser, server, color_scheme=scheme) as page:
        opened(page, server)
        judged(page)
        for act in (
            lambda: None,
            lambda: enter(page, "axes.1.load.mass", "2x"),
            lambda: enter(page, "axes.1.phases.0.stop", ""),
            lambda: page.get_by_role("button", name="Text").click(),
            lambda: page.locator("aside .law button").first.click(),
            lambda: page.get_by_role("button", name="from the catalogue").last.click(),
        ):
            act()
            judged(page)
            found = Axe().run(page).response["violations"]
            assert [(one["id"], one["nodes"][0]["html"]) for one in found] == []
        for width, height in ((2560, 1440), (720, 450)):  # the last is 1440 × 900 at 200 %
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_any_of_the_kinds_of_machines_opens(page, server, wrapping):
    for name in ("flying-cutter", "indexing-overlap", "motion-laws"):
        shutil.copy(FOLDER / f"{name}.toml", server.root / f"{name}.toml")
        page.goto(f"http://{server.host}/edit/{name}.toml")
        page.wait_for_selector("nav .item")
        page.wait_for_selector("aside input")
        expect(page.locator(".pill")).to_have_text(re.compile("check"), timeout=LONG)
        page.wait_for_selector(".pictures svg")
