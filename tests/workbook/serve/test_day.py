"""A designer's day: a cartoner of six axes from a sheet of paper, in the browser alone, until a controller has it."""

import re
import tomllib
from pathlib import Path

import pytest

from tests.workbook.serve.chromium import expect
from tests.workbook.serve.conftest import LONG, answered
from workbook.reading.descriptions import read_machine

LONGER = {"arm": "swinging arm"}  # what a table is called on its button
PAPER = Path(__file__).with_name("cartoner.toml")


def enter(page, path, value):
    """Enter a value where the page has a field for it; what is seldom needed is opened first."""
    where = page.locator(f'aside [data-path="{path}"]')
    more = page.locator("aside button.more[aria-expanded=false]")
    while not where.count():
        if more.count():
            more.first.click()
        else:
            where.or_(more).first.wait_for()
    if where.evaluate("element => element.tagName") == "SELECT":
        with answered(page):
            where.select_option(str(value))
    elif where.evaluate("element => element.tagName") == "BUTTON":
        if not where.inner_text().startswith(str(value)):
            where.click()
            with answered(page):
                page.get_by_role("option", name=re.compile(rf"^{value} ")).click()
    elif where.input_value() != str(value):
        where.fill(str(value))
        with answered(page):
            where.press("Enter")


def press(page, name):
    """Press a button of the entries, and wait until it is answered."""
    with answered(page):
        page.locator("aside").get_by_role("button", name=name, exact=True).last.click()


def rows(page, path, given, one):
    """Make the rows of a list as many as are given, and enter them."""
    there = page.locator(f'aside :is(tr, .block):has([data-path^="{path}."])')
    more = page.locator("aside button.more[aria-expanded=false]")
    while not page.get_by_role("button", name=f"+ {one}", exact=True).count():
        more.first.click()
    while (count := there.count()) != len(given):
        press(page, f"+ {one}" if count < len(given) else f"remove {one} {count}")
        expect(there).not_to_have_count(count)
    for k, row in enumerate(given):
        for name, value in dict(row).items() if isinstance(row, dict) else enumerate(row):
            enter(page, f"{path}.{k}.{name}", value)


def table(page, path, given):
    """Enter a table: first its kind, its lists and tables last."""
    for name, value in sorted(given.items(), key=lambda item: item[0] != "kind"):
        if isinstance(value, dict):
            if not page.locator(f'aside [data-path^="{path}.{name}."]').count():
                press(page, f"+ {LONGER.get(name, name)}")
            if name == "motor" and "name" not in value:
                press(page, "enter figures")
            table(page, f"{path}.{name}", value)
        elif isinstance(value, list):
            rows(page, f"{path}.{name}", value, name.removesuffix("s"))
        elif name == "name" and path.endswith(("motor", "reducer")):
            section = page.locator("aside section").filter(
                has=page.locator(f"h3:has-text('{path.rpartition('.')[2]}')")
            )
            section.last.get_by_role("button", name="from the catalogue").click()
            page.get_by_label("Filter").fill(value[:12])
            with answered(page):
                page.get_by_role("button", name=value, exact=True).click()
        else:
            enter(page, f"{path}.{name}", value)


def new_machine(page, server, name, axis):
    """Begin an empty machine on the first page, and wait for its design."""
    page.goto(f"http://{server.host}/")
    form = page.locator("form", has_text="Empty, with one axis")
    form.get_by_label("Name of the machine").fill(name)
    form.get_by_label("Name of its axis").fill(axis)
    form.get_by_role("button").click()
    page.wait_for_selector("aside input")


def part(page, words):
    page.locator("nav .item", has_text=words).click()


@pytest.mark.nightly
def test_a_cartoner_is_designed_built_verified_and_exported_without_text_or_terminal(page, server):
    page.set_default_timeout(5 * LONG)
    wanted = tomllib.loads(PAPER.read_text(encoding="utf-8"))
    new_machine(page, server, wanted["title"], wanted["axes"][0]["name"])
    path = server.root / f"{wanted['title']}.toml"
    for k, axis in enumerate(wanted["axes"]):
        if k:
            with answered(page):
                page.get_by_role("button", name="+ axis").click()
            expect(page.locator("aside h2")).to_contain_text("MC01")
        press(page, "+ mechanism and motor")
        table(page, f"axes.{k}", axis)
    for name, one in (("switches", "switch"), ("clearances", "clearance")):
        for k, row in enumerate(wanted[name]):
            with answered(page):
                page.get_by_role("button", name=f"+ {one}").click()
            expect(page.locator(f'aside [data-path="{name}.{k}.name"]')).to_have_count(1)
            table(page, f"{name}.{k}", row)
    part(page, "Cycle, power")
    table(page, "power", wanted["power"])
    enter(page, "revision", wanted["revision"])
    enter(page, "master.rate", wanted["master"]["rate"])
    part(page, "Selection")
    table(page, "selection", wanted["selection"])
    page.keyboard.press("Control+S")
    expect(page.locator("header .file")).to_contain_text("· saved")
    mine, theirs = (read_machine(one).model_dump(exclude={"laws"}) for one in (path, PAPER))
    assert mine == theirs
    expect(page.locator("header .pill.FAIL")).to_have_count(1, timeout=5 * LONG)  # the belt's motor is too weak at 90
    part(page, "Cycle, power")
    enter(page, "master.rate", 85)
    enter(page, "limits.inertia_ratio", 12)  # the arm's load has eleven times the inertia of its motor
    expect(page.locator("header .pill.OK")).to_have_count(1, timeout=5 * LONG)
    page.get_by_role("button", name="Build workbook").click()
    page.wait_for_selector(f'a[href="/file/{wanted["title"]}.xlsx"]')
    page.goto(f"http://{server.host}/")
    page.locator("tr", has_text=f"{wanted['title']}.xlsx").get_by_role("button", name="Verify").click()
    page.wait_for_selector("text=None: every formula cell computes what the engine computes")
    page.goto(f"http://{server.host}/controller/{wanted['title']}.xlsx")
    page.select_option("#axis", "PUSH")
    page.select_option("#target", "siemens")
    page.get_by_role("button", name="Export").click()
    with page.expect_download() as file:
        page.get_by_role("link", name="Download").click()
    assert file.value.suggested_filename == f"{wanted['title']}-PUSH.scl"
