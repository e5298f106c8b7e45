"""The design page in Chromium: pictures a second of a drag, edits to figures, the first picture, the folder."""

import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from playwright.sync_api import Page, sync_playwright
from rich.console import Console
from rich.table import Table

from benchmarks.serve import description, serving

SIZES = (4, 5, 24)
ROUNDS, MOVES, FILES = 20, 120, 35
LANE, EDGE = ".lane .line", "#axis-0-to-0"
GOALS = {"the axis": {4: 0.1, 5: 0.1, 24: 0.3}, "all": {4: 0.3, 5: 0.3, 24: 1.0}}
"""seconds from an edit to the figures of its axis and of all, by the number of axes"""
DRAG = """async ([x, y, moves]) => {
  const svg = document.querySelector(".lanes > svg:not(.scale)");
  const seen = new Set();
  const begin = performance.now();
  for (let n = 0; n < moves; n += 1) {
    const clientX = x + 4 + n % 40 + n / 100;
    svg.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY: y, bubbles: true, altKey: true }));
    await Promise.race([requestAnimationFrame, (done) => setTimeout(done, 1000)].map((wait) => new Promise(wait)));
    seen.add(n + document.querySelector(".bubble text")?.textContent);
  }
  return (seen.size * 1000) / (performance.now() - begin);
}"""
"""moves the pointer once for each picture that the browser draws; returns pictures a second"""


def timed(act: Callable[[], Any]) -> float:
    """Return how long something takes (s)."""
    begin = time.perf_counter()
    act()
    return time.perf_counter() - begin


def pictures_of_drag(page: Page) -> float:
    """Return how many pictures a second follow an edge that is dragged; it is put back."""
    page.locator(EDGE).focus()
    box = page.locator(f"{EDGE} circle").bounding_box() or {}
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    rate = page.evaluate(DRAG, [x, y, MOVES])
    page.keyboard.press("Escape")
    page.mouse.up()
    return float(rate)


def edit(page: Page, number: int) -> tuple[float, float]:
    """Return how long the figures of an axis, and then of all, take from a key on (s)."""
    begin = time.perf_counter()
    # both waits have an end, which that for a response's own end has not
    with page.expect_request_finished(lambda request: request.url.endswith("/figures")):
        with page.expect_request_finished(lambda request: request.url.endswith("/change")):
            page.locator(EDGE).press("ArrowLeft" if number % 2 else "ArrowRight")
        axis = time.perf_counter() - begin
    return axis, time.perf_counter() - begin


def opened(page: Page, host: str, name: str) -> None:
    """Open a design, and wait for its first picture."""
    page.goto(f"http://{host}/edit/{name}")
    page.wait_for_selector(LANE)


def measure(page: Page, host: str, axes: int, table: Table) -> None:
    """Add the rows of a machine of so many axes."""
    firsts = [timed(lambda: opened(page, host, f"machine{axes}.toml")) for _ in range(3)]
    table.add_row(f"first picture, {axes} axes", f"{median(firsts):.2f} s", "0.5 s")
    table.add_row(f"drag of an edge, {axes} axes", f"{pictures_of_drag(page):.0f} pictures/s", "50 pictures/s")
    for name in (f"machine{axes}.toml", f"missing{axes}.toml"):
        opened(page, host, name)
        page.wait_for_timeout(1500)
        times = zip(*(edit(page, number) for number in range(ROUNDS)), strict=True)
        lacks = ", an entry missing" if name.startswith("missing") else ""
        for what, taken in zip(GOALS, times, strict=True):
            goal = f"{GOALS[what].get(axes, 1.0)} s"
            table.add_row(f"an edit to the figures of {what}, {axes} axes{lacks}", f"{median(taken):.3f} s", goal)


def main() -> None:
    """Print what the page takes, each beside its goal."""
    table = Table("What", "Median", "Goal", title="The design page")
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        for axes in SIZES:
            text = description(axes)
            for file, words in (
                (f"machine{axes}", text),
                (f"missing{axes}", text.replace("peak_torque = 900.0", "", 1)),
            ):
                Path(name, f"{file}.toml").write_text(words, encoding="utf-8")
        for number in range(FILES - 2 * len(SIZES)):
            Path(name, f"other{number}.toml").write_text(text.replace("rate = 200", f"rate = {100 + number}"))
        browser = driver.chromium.launch(executable_path=shutil.which("chromium") or shutil.which("google-chrome"))
        with serving(Path(name)) as (host, token):
            page = browser.new_page(viewport={"width": 1440, "height": 900})
            page.set_default_timeout(300_000)
            page.goto(f"http://{host}/?token={token}")
            home = [timed(lambda: page.goto(f"http://{host}/", wait_until="domcontentloaded")) for _ in range(5)]
            table.add_row(f"a folder of {FILES} to its list", f"{median(home):.2f} s", "0.3 s")
            for axes in SIZES:
                measure(page, host, axes, table)
        browser.close()
    Console().print(table)


if __name__ == "__main__":
    main()
