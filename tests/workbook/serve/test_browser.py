"""The pages in the system's Chromium, by a person's steps; nothing leaves the host, nothing shuts anybody out."""

import re
import shutil

import pytest

from tests.workbook.serve.chromium import Axe
from tests.workbook.serve.conftest import LONG
from workbook.reading.descriptions import read_machine

NARROW, WIDE = 1024, 1600


def opened(page, server, path):
    """Go to a page, and wait for what its script fetches."""
    page.goto(f"http://{server.host}{path}")
    if path.startswith("/edit"):
        page.wait_for_selector("aside input")
        page.wait_for_selector(".pill:not(.wait)")


def verified(page, server, path):
    """The report of a workbook from elsewhere."""
    opened(page, server, "/")
    page.set_input_files("#book", path)
    with page.expect_navigation():  # the page before has headings too
        page.locator("form[action='/upload'] button").click()
    page.wait_for_selector("h2")
    return page.locator("body").inner_text()


def test_a_new_machine_is_built_verified_and_exported(page, server, tmp_path):
    shutil.copy(server.root / "live.toml", server.root / "mine.toml")
    opened(page, server, "/edit/mine.toml")
    field = page.locator('[data-path="axes.0.phases.0.stop"]')
    field.fill("79")
    field.press("Enter")
    page.get_by_role("button", name="Build workbook").click()
    with page.expect_download() as book:
        page.locator('.notice a[href="/file/mine.xlsx"]').click()
    book.value.save_as(tmp_path / "mine.xlsx")
    compared = page.locator("footer form[action='/compare'] input")
    assert [field.input_value() for field in compared.all()] == ["mine.xlsx", "mine.toml"]
    assert read_machine(server.root / "mine.toml").axes[0].phases[0].stop == 79.0
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


def row(page, name):
    return page.locator("tr", has_text=name)


def verify(page):
    row(page, "cutting.xlsx").get_by_role("button", name="Verify").click()
    page.wait_for_selector("text=None: every formula cell computes what the engine computes")


def compare(page):
    page.select_option("#old", "live.toml")
    page.select_option("#other", "cutting.xlsx")
    with page.expect_navigation():
        page.get_by_role("button", name="Compare").click()


def export(page):
    row(page, "cutting.xlsx").get_by_role("link", name="Controller").click()
    page.select_option("#axis", "MC03")
    page.get_by_role("button", name="Export").click()
    page.wait_for_selector("svg")


def study(page):
    page.locator("article", has_text="live.toml").get_by_role("link", name="Study", exact=True).click()
    for k, name in enumerate(("drive1_rms", "axis1.j.1")):
        page.get_by_label("Result").nth(k).fill(name)
    page.locator("summary", has_text="MC01, phase 1").click()
    page.locator("input[name=vary][value='axes[1].phases[1].law']").check()
    page.get_by_role("button", name="Show").click()
    page.get_by_role("button", name="Begin").click()
    page.wait_for_selector("[data-from] svg", timeout=2 * LONG)


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
    assert [(one["id"], one["nodes"][0]["html"]) for one in found] == []


def test_a_design_prints_as_one_page(page, server):
    opened(page, server, "/print/live.toml")
    pdf = page.pdf(prefer_css_page_size=True)
    assert re.findall(rb"/Type\s*/Pages\b.*?/Count (\d+)|/Count (\d+).*?/Type\s*/Pages\b", pdf, re.S)
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == 1
