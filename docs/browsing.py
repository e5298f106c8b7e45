"""Make the pictures of the pages in the browser for docs/browser.md; needs Chromium.

.venv/bin/python -m docs.browsing
"""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from playwright.sync_api import Page, Playwright, sync_playwright

from workbook.template import FOLDER

HERE = Path(__file__).parent
ADDRESS = re.compile(r"http://\S+")
SIZE = {"width": 1440, "height": 900}
LONG = 300_000
"""ms: a study is worked out"""


def design(page: Page, root: str) -> None:
    """Show an axis with its entries and charts, and what comes of an edge that is moved."""
    page.goto(f"{root}/edit/machine.toml")
    page.locator(".card", has_text="MC02").click()
    page.locator(".handle").nth(1).focus()
    for _ in range(6):
        page.keyboard.press("ArrowRight")
    page.wait_for_load_state("networkidle")


def study(page: Page, root: str) -> None:
    """Show the front of the study in docs."""
    page.goto(f"{root}/study/study.toml")
    page.get_by_role("button", name="Begin").click()
    page.wait_for_selector("[data-from] svg")


def new(page: Page, root: str) -> None:
    """Show how a designer's day begins: an empty machine that has a name."""
    page.goto(f"{root}/#new")
    page.get_by_label("Name of the machine").fill("Cartoner")
    page.get_by_label("Name of its axis").fill("LIFT")


def motor(page: Page, root: str) -> None:
    """Show the motors of the catalogue with what each comes to in an axis of the cartoner."""
    page.goto(f"{root}/edit/cartoner.toml")
    page.locator(".card", has_text="PUSH").click()
    page.get_by_role("button", name="from the catalogue").last.click()
    page.wait_for_selector("dialog td.good")


def built(page: Page, root: str) -> None:
    """Show the verdict on the cartoner's book where it is built."""
    page.goto(f"{root}/edit/cartoner.toml")
    page.get_by_role("button", name="Build workbook").click()
    page.wait_for_selector(".notice form")


def verified(page: Page, root: str) -> None:
    """Show the report on that book, whose checks that fail lead to the design."""
    built(page, root)
    page.locator(".notice").get_by_role("button", name="Verify").click()
    page.wait_for_selector("text=every formula cell computes")


DAY = {"browser-new.png": new, "browser-motor.png": motor, "browser-built.png": built, "browser-verified.png": verified}
PICTURES = {"browser-edit.png": design, "browser-study.png": study} | DAY


def main(wanted: list[str]) -> None:
    """Take each picture, or those that are named, of a folder that is served."""
    shown = {name: show for name, show in PICTURES.items() if not wanted or name in wanted}
    if not shown:
        return
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        shutil.copy(FOLDER / "machine.toml", folder)
        shutil.copy(HERE.parent / "tests" / "workbook" / "serve" / "cartoner.toml", folder)
        text = (HERE / "study.toml").read_text(encoding="utf-8")
        Path(folder, "study.toml").write_text(text.replace("../templates/", ""), encoding="utf-8")
        command = [sys.executable, "-u", "-m", "workbook", "serve", folder, "--no-browse"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
            try:
                take(shown, driver, server)
            finally:  # else the block would wait for the server for ever
                server.send_signal(signal.SIGINT)


def take(shown: Mapping[str, Callable[[Page, str], None]], driver: Playwright, server: subprocess.Popen[str]) -> None:
    """Take pictures of the pages of a server that has just begun."""
    found = ADDRESS.search(server.stdout.readline() if server.stdout else "")
    address = found[0] if found else ""
    browser = driver.chromium.launch(executable_path=shutil.which("chromium") or shutil.which("google-chrome"))
    page = browser.new_page(viewport=SIZE)  # type: ignore[arg-type]
    page.set_default_timeout(LONG)
    page.goto(address)
    for name, show in shown.items():
        show(page, address.partition("/?")[0])
        page.screenshot(path=HERE / name)
        print(f"Made {HERE / name}")
    browser.close()


if __name__ == "__main__":
    main(sys.argv[1:])
