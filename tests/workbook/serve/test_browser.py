"""The pages in the system's Chromium, by a person's steps; nothing leaves the host, nothing shuts anybody out."""

import re
import shutil
from urllib.parse import urlsplit

import pytest

from tests.workbook.serve.chromium import Axe, expect
from workbook.reading.descriptions import read_machine
from workbook.serve.live import design

SMALL = "\n[sizes]\ncycle = 12\nlaw = 4\n"
SERIOUS = ("serious", "critical")
NARROW, WIDE = 1024, 1600
LONG = 60_000  # ms: a workbook is built, or verified
STEP = 600  # ms without a change: what comes then is another step to be undone


@pytest.fixture
def page(browser, server):
    """A page that opened the printed address; at the end no request has left the host, and no error was logged."""
    context = browser.new_context(viewport={"width": WIDE, "height": 1000})
    context.set_default_timeout(LONG)
    said, asked = [], []
    context.on("request", lambda request: asked.append(urlsplit(request.url).netloc))
    context.on("console", lambda message: said.append(message.text) if message.type in ("error", "warning") else None)
    context.on("weberror", lambda error: said.append(str(error.error)))
    one = context.new_page()
    one.goto(f"http://{server.host}/?token={server.token}")
    yield one
    context.close()
    assert set(asked) == {server.host}
    assert said == []


def opened(page, server, path):
    """Go to a page, and wait for what its script fetches."""
    page.goto(f"http://{server.host}{path}")
    if path.startswith("/edit"):
        page.wait_for_selector("#live table")
        page.wait_for_selector("#form input")


def text_of(page):
    return page.locator("#text").input_value()


def shown(page, words):
    """Wait until the panel has these words."""
    expect(page.locator("#live")).to_contain_text(words, timeout=LONG)


def verified(page, server, path):
    """The report of a workbook from elsewhere."""
    opened(page, server, "/")
    page.set_input_files("#book", path)
    with page.expect_navigation():  # the page before has headings too
        page.locator("form[action='/upload'] button").click()
    page.wait_for_selector("h2")
    return page.locator("body").inner_text()


def test_a_new_machine_is_dragged_built_verified_and_exported(page, server, tmp_path):
    page.locator(".gallery > div", has_text="Machine").first.get_by_label("Name").fill("mine")
    page.locator(".gallery > div", has_text="Machine").first.get_by_role("button").click()
    page.wait_for_selector("#live .edge")
    with page.expect_response("**/live"):
        page.locator("#text").fill(re.sub(r"(?s)\[(selection|sizes)\].*?\n\n", "", text_of(page)) + SMALL)
    shown(page, "Highest rate")
    edge = page.locator('.edge[data-edge="MC02 135"]')
    box = edge.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 + 6, box["y"], steps=4)
    page.mouse.up()
    expect(page.locator("#undo")).to_be_enabled()
    stop = design("mine.toml", text_of(page)).machine.axes[1].phases[0].stop
    assert 136.0 <= stop <= 160.0
    page.get_by_role("button", name="Save and build").click()
    with page.expect_download() as book:
        page.get_by_role("link", name="Download").click()
    book.value.save_as(tmp_path / "mine.xlsx")
    assert read_machine(server.root / "mine.toml").axes[1].phases[0].stop == stop
    assert "None: every formula cell computes what the engine computes" in verified(
        page, server, tmp_path / "mine.xlsx"
    )
    opened(page, server, "/controller/mine.xlsx")
    page.select_option("#axis", "MC02")
    page.select_option("#target", "siemens")
    page.get_by_role("button", name="Export").click()
    with page.expect_download() as file:
        page.get_by_role("link", name="Download").click()
    assert file.value.suggested_filename == "mine-MC02.scl"


def test_a_lane_is_shifted_by_its_name_and_by_keys_each_in_one_step(page, server):
    opened(page, server, "/edit/live.toml")
    before = text_of(page)
    name = page.locator(".lane").first
    axis = name.text_content()
    box = name.bounding_box()
    page.mouse.move(box["x"] + 5, box["y"] + 5)
    page.mouse.down()
    for far in (10, 20, 30):
        page.mouse.move(box["x"] + 5 + far, box["y"] + 5)
        page.wait_for_timeout(STEP)
    page.mouse.up()
    lane = page.locator(f'.lane[data-edge="{axis} lane"]')
    expect(lane).not_to_have_attribute("aria-valuenow", "0", timeout=LONG)
    shift = design("live.toml", text_of(page)).machine.axes[0].shift
    assert 5.0 <= shift <= 60.0
    page.wait_for_timeout(STEP)
    lane.focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    assert design("live.toml", text_of(page)).machine.axes[0].shift == shift + 3.0
    page.wait_for_timeout(STEP)
    edge = page.locator(f'.edge[data-edge^="{axis} "]').first
    edge.focus()
    page.keyboard.press("Shift+ArrowLeft")
    assert design("live.toml", text_of(page)).machine.axes[0].shift == shift + 2.0
    for _ in range(3):
        page.locator("#undo").click()
    assert text_of(page) == before


def test_a_dragged_edge_leaves_the_comment_of_its_line_where_it_is(page, server):
    opened(page, server, "/edit/live.toml")
    edge = page.locator(".edge").nth(1)
    places = edge.get_attribute("data-places").split(" ")
    assert places
    text = text_of(page)
    end = text.index("\n", int(places[0].split("-")[1]))
    with page.expect_response("**/live"):
        page.locator("#text").fill(f"{text[:end]}     # kept{text[end:]}")
    column = next(line.index("# kept") for line in text_of(page).split("\n") if "# kept" in line)
    shown(page, "Highest rate")
    key = edge.get_attribute("data-edge")
    page.locator(f'.edge[data-edge="{key}"]').focus()
    for _ in range(12):
        page.keyboard.press("ArrowRight")
    (line,) = [line for line in text_of(page).split("\n") if "# kept" in line]
    assert line.index("# kept") == column
    assert line not in text
    design("live.toml", text_of(page))


def test_a_design_is_edited_by_the_keyboard_alone(page, server):
    shutil.copy(server.root / "live.toml", server.root / "keys.toml")
    opened(page, server, "/edit/keys.toml")
    before = text_of(page)
    tabbed(page, "#part")
    page.keyboard.type("master")
    field = '#form input[aria-label="Production rate"]'
    page.wait_for_selector(field)
    tabbed(page, field)
    page.keyboard.press("Control+A")
    page.keyboard.type("150")
    page.keyboard.press("Enter")
    expect(page.locator("#text")).to_have_value(re.compile(r"rate = 150\.0"))
    tabbed(page, ".edge")
    value = page.locator(".edge:focus").get_attribute("aria-valuenow")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".edge:focus")).to_have_attribute("aria-valuenow", f"{float(value) + 1:g}", timeout=LONG)
    for _ in range(2):
        page.keyboard.press("Control+Z")
    assert text_of(page) == before
    page.keyboard.press("Control+Y")
    assert "rate = 150.0" in text_of(page)
    tabbed(page, "button[value=edit]")
    with page.expect_navigation():
        page.keyboard.press("Enter")
    assert read_machine(server.root / "keys.toml").master.rate == 150.0


def test_a_copied_row_is_the_part_that_is_shown_and_the_text_is_scrolled_to_it(page, server):
    opened(page, server, "/edit/live.toml")
    page.select_option("#part", label="axes[2] MC02")
    page.get_by_role("button", name='Copy ["axes", "1"]').click()
    copied = len(read_machine(server.root / "live.toml").axes)
    expect(page.locator(f"""#form input[data-path='["axes", "{copied}", "name"]']""")).to_have_value("MC02")
    assert page.locator("#part").input_value() == f'["axes", "{copied}"]'
    page.select_option("#part", label="axes[3] MC03")
    lines = text_of(page)[: text_of(page).index('name = "MC03"')].count("\n") - 1
    assert page.locator("#text").evaluate("t => t.scrollTop / t.scrollHeight * t.value.split('\\n').length") == (
        pytest.approx(lines, abs=2.0)
    )


def tabbed(page, selector):
    """Press Tab until an element is focused that a selector finds."""
    for _ in range(400):
        if page.evaluate("selector => document.activeElement.matches(selector)", selector):
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"Tab does not reach {selector}")


def verify(page):
    page.locator("tr", has_text="cutting.xlsx").get_by_role("button", name="Verify").click()
    page.wait_for_selector("text=None: every formula cell computes what the engine computes")


def compare(page):
    page.select_option("#old", "live.toml")
    page.select_option("#new", "cutting.xlsx")
    page.get_by_role("button", name="Compare").click()
    page.wait_for_selector("h1")


def export(page):
    page.locator("tr", has_text="cutting.xlsx").get_by_role("link", name="Controller").click()
    page.select_option("#axis", "MC03")
    page.get_by_role("button", name="Export").click()
    page.wait_for_selector("svg")


def study(page):
    page.locator("tr", has_text="live.toml").get_by_role("link", name="Study").click()
    for k, name in enumerate(("drive1_rms", "axis1.j.1")):
        page.get_by_label("Result").nth(k).fill(name)
    page.locator("summary", has_text="axes[1].phases[1] ").click()
    page.locator("input[name=vary][value='axes[1].phases[1].law']").check()
    page.get_by_role("button", name="Begin").click()
    page.wait_for_selector("#study svg", timeout=2 * LONG)


PAGES = ("/", "/edit/live.toml", "/controller/cutting.xlsx", "/vary/live.toml", "/print/live.toml", compare)
LATER = [pytest.param(step, marks=pytest.mark.nightly) for step in (verify, export, study)]  # which take their time


@pytest.mark.parametrize("what", [*PAGES, *LATER])
def test_a_page_fits_narrow_and_wide_windows_and_shuts_nobody_out(page, server, what):
    opened(page, server, what if isinstance(what, str) else "/")
    if callable(what):
        what(page)
    for width in (WIDE, NARROW):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    found = Axe().run(page).response["violations"]
    assert [(one["id"], one["nodes"][0]["html"]) for one in found if one["impact"] in SERIOUS] == []


def test_a_design_prints_as_one_page(page, server):
    opened(page, server, "/print/live.toml")
    pdf = page.pdf(prefer_css_page_size=True)
    assert re.findall(rb"/Type\s*/Pages\b.*?/Count (\d+)|/Count (\d+).*?/Type\s*/Pages\b", pdf, re.S)
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == 1
