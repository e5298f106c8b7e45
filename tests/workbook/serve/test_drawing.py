"""The timing diagram and the charts in the system's Chromium: what a drag and a key propose, what is seen meanwhile."""

import re
from itertools import pairwise

import pytest

from tests.workbook.serve.chromium import Axe, expect
from tests.workbook.serve.conftest import drawn
from tests.workbook.serve.drawn import drawing

PICTURE = 20  # ms of the page's thread for each picture: fifty a second
MANY = 60


@pytest.fixture(scope="module")
def address():
    with drawing() as url:
        yield url


@pytest.fixture
def opened(browser, address):
    """Opens the drawing parts with so many axes; no error is logged."""
    errors, contexts = [], []

    def open_page(axes=5, **options):
        context = browser.new_context(**({"viewport": {"width": 1024, "height": 768}} | options))
        contexts.append(context)
        page = context.new_page()
        page.on(
            "console", lambda message: errors.append(message.text) if message.type in ("error", "warning") else None
        )
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(f"{address}?axes={axes}")
        page.wait_for_selector("#axis-1-from-0")
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert errors == []


def middle(page, selector):
    box = page.locator(selector).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def per_unit(page):
    """Picture points for a degree: between the two edges of the first phase, 90° and 135°."""
    return (middle(page, "#axis-1-to-0 circle")[0] - middle(page, "#axis-1-from-0 circle")[0]) / 45


def drag(page, place, x, y=0.0, end="", modifier=None):
    """Drag from a place by so many points; a key ends it where one is named. Return what the pointer was told last."""
    if modifier:
        page.keyboard.down(modifier)
    page.mouse.move(*place)
    page.mouse.down()
    page.mouse.move(place[0] + x / 2, place[1] + y / 2)
    page.mouse.move(place[0] + x, place[1] + y)
    drawn(page)
    words = re.sub(r" · [\d.]+ ms", "", page.locator(".bubble text").text_content())
    if end:
        page.keyboard.press(end)
    page.mouse.up()
    if modifier:
        page.keyboard.up(modifier)
    drawn(page)
    return words


def commits(page):
    return [
        {"/".join(map(str, one["path"])): one["value"] for one in changes} for changes in page.evaluate("state.commits")
    ]


def rest(page, selector):
    """A place of a span beside its line and handles."""
    box = page.locator(selector).bounding_box()
    return box["x"] + box["width"] * 0.75, box["y"] + box["height"] - 5


def test_a_drag_of_each_kind_is_one_entry_of_the_journal(opened):
    page = opened()
    unit = per_unit(page)
    before = page.locator(".lane.selected .line").get_attribute("d")
    words = drag(page, middle(page, "#axis-1-to-0 circle"), 20.3 * unit)
    assert (words, commits(page)) == ("to 155°", [{"axes/1/phases/0/stop": 155}])
    assert page.locator(".lane.selected .line").get_attribute("d") != before
    assert drag(page, rest(page, "#axis-1-span-0 rect"), 10.2 * unit) == "100 to 165°"
    lift = drag(page, middle(page, "#axis-1-lift-0 rect"), 0, -20)
    assert lift.startswith("lift 4")
    assert drag(page, middle(page, "#axis-1-shift-all text"), 7 * unit) == "later by 7°"
    assert drag(page, middle(page, "#axis-1-from-1 circle"), 3 * unit, modifier="Shift") == "later by 10°"
    assert drag(page, middle(page, "[id=switches-0-span-0] rect"), 5 * unit) == "25 to 100°"
    assert drag(page, middle(page, "[id=switches-1-from-0] circle"), -5 * unit) == "from 340°"
    assert [list(one) for one in commits(page)[1:]] == [
        ["axes/1/phases/0/start", "axes/1/phases/0/stop"], ["axes/1/phases/0/lift"], ["axes/1/shift"], ["axes/1/shift"],
        ["switches/0/on/0/start", "switches/0/on/0/stop"], ["switches/1/on/0/start"],
    ]  # fmt: skip


def test_a_drag_stops_at_its_neighbour_snaps_to_edges_and_goes_back_by_escape(opened):
    page = opened()
    unit = per_unit(page)
    edge = middle(page, "#axis-1-to-0 circle")
    before = page.evaluate("JSON.stringify(state.data.value)")
    assert drag(page, edge, 25 * unit, end="Escape") == "to 160°"
    assert page.evaluate("JSON.stringify(state.data.value)") == before
    assert (commits(page), page.locator(".bubble").count()) == ([], 0)
    assert drag(page, edge, 250 * unit, end="Escape") == "to 305° · Ctrl pushes phase 2"  # where the next begins
    page.mouse.move(*edge)
    assert drag(page, edge, -100 * unit, end="Escape") == "to 90.1°"
    assert drag(page, edge, 11.2 * unit, end="Escape") == "to 145°"  # where MC03 begins to move, not 146
    assert drag(page, edge, 11.2 * unit, end="Escape", modifier="Alt") == pytest.approx("to 146.2°")
    assert drag(page, rest(page, "#axis-1-span-1 rect"), 100 * unit, end="Escape") == "315 to 360°"
    page.mouse.click(*middle(page, "[id=axis-2-shift-all] + .span rect"))
    assert page.evaluate("state.selected.value") == {"axis": 2, "phase": 0}
    assert commits(page) == []


def test_a_drag_with_ctrl_pushes_its_neighbours_as_far_as_there_is_room(opened):
    page = opened()
    unit, edge = per_unit(page), middle(page, "#axis-1-to-0 circle")
    page.keyboard.down("Control")
    assert drag(page, edge, 175 * unit) == "to 310° · pushes phase 2"
    assert drag(page, middle(page, "#axis-1-from-1 circle"), -300 * unit) == "from 220° · pushes phase 1"
    assert drag(page, middle(page, "[id=switches-0-to-0] circle"), 110 * unit) == "to 205° · pushes bar 2"
    page.locator("#axis-1-from-1").focus()
    page.keyboard.press("Control+ArrowRight")
    assert commits(page) == [
        {"axes/1/phases/0/stop": 310, "axes/1/phases/1/start": 310, "axes/1/phases/1/stop": 355},
        {"axes/1/phases/1/start": 220, "axes/1/phases/0/start": 0, "axes/1/phases/0/stop": 220},
        {"switches/0/on/0/stop": 205, "switches/0/on/1/start": 205, "switches/0/on/1/stop": 220},
        {"axes/1/phases/1/start": 221},
    ]


def test_the_saved_design_forces_gaps_and_times_are_in_the_lanes(opened):
    page = opened(viewport={"width": 1440, "height": 900})
    unit = per_unit(page)
    assert page.locator(".lane .saved").count() == 0
    drag(page, middle(page, "#axis-1-to-0 circle"), 20 * unit)
    assert page.locator(".lane .saved").count() == 1
    assert drag(page, middle(page, "[id=axes-0-load-span-0] rect"), 12 * unit) == "212 to 252°"
    assert commits(page)[-1] == {"axes/0/load/windows/0/start": 212, "axes/0/load/windows/0/stop": 252}
    assert page.locator(".gap.bad .least").text_content() == "2 < 3 mm"
    assert {"360", "300"} <= set(page.locator(".scale text").all_text_contents())
    svg, lanes = page.locator(".lanes > svg:not(.scale)").bounding_box(), page.locator(".grid path").last.bounding_box()
    assert svg["x"] + svg["width"] - lanes["x"] < 20  # no room is left right of the end of the turn


def test_the_keyboard_does_what_a_drag_does(opened):
    page = opened()

    def press(selector, *keys):
        page.locator(selector).focus()
        for key in keys:
            page.keyboard.press(key)
            drawn(page)
        return commits(page)[-1]

    assert press("#axis-1-to-0", "ArrowRight", "PageUp", "Alt+ArrowLeft") == {"axes/1/phases/0/stop": 145.9}
    assert press("#axis-1-to-0", "End") == {"axes/1/phases/0/stop": 305}
    assert press("#axis-1-span-0", "ArrowLeft") == {"axes/1/phases/0/start": 89, "axes/1/phases/0/stop": 304}
    assert press("#axis-1-to-0", "End") == {"axes/1/phases/0/stop": 305}
    assert press("#axis-1-from-0", "Home") == {"axes/1/phases/0/start": 0}
    assert press("#axis-1-lift-0", "ArrowUp") == {"axes/1/phases/0/lift": 20.2}
    assert press("#axis-1-from-0", "Shift+ArrowLeft") == {"axes/1/shift": 359}
    assert press("[id=switches-0-to-1]", "ArrowRight") == {"switches/0/on/1/stop": 216}
    slider = page.locator("#axis-1-to-0")
    assert [slider.get_attribute(f"aria-{name}") for name in ("label", "valuenow", "valuetext", "valuemax")] == [
        "MC02, phase 1, to", "305", "305°", "305",
    ]  # fmt: skip
    page.locator("#axis-2-shift-all").focus()
    assert page.evaluate("state.selected.value") == {"axis": 2, "phase": None}


def test_handles_never_cover_one_another_and_the_nearer_is_taken(opened):
    page = opened()
    page.evaluate("""() => {
      const phase = (start, stop, lift) => ({ start, stop, lift, law: "MTP" });
      const phases = [phase(90, 92, 20), phase(92, 94, -20), phase(94, 96, 5), phase(null, 300, 5)];
      const axes = state.data.value.axes.map((axis, k) => (k === 1 ? { ...axis, phases } : axis));
      state.data.value = { ...state.data.value, axes };
    }""")
    page.wait_for_selector("#axis-1-to-2")
    page.wait_for_selector(".lane.selected .missing")  # a phase without its begin is told, and the others stay
    circles = page.locator(".lane.selected .handle circle, .lane.selected .handle rect")
    boxes = [circles.nth(n).bounding_box() for n in range(circles.count())]
    centres = sorted(box["x"] + box["width"] / 2 for box in boxes)
    assert len(centres) == 7
    assert min(b - a for a, b in pairwise(centres)) >= 14
    assert drag(page, middle(page, "#axis-1-from-2 circle"), 300, end="Escape") == "from 95.9°"
    assert drag(page, middle(page, "#axis-1-to-2 circle"), 300, end="Escape") != "from 95.9°"


def test_24_axes_scroll_below_the_scale_and_a_drag_follows_at_fifty_pictures_a_second(opened):
    page = opened(24)
    page.locator("#axis-23-shift-all").scroll_into_view_if_needed()
    lanes, scale = page.locator(".lanes").bounding_box(), page.locator(".scale").bounding_box()
    assert scale["y"] == pytest.approx(lanes["y"], abs=1)
    page.locator("#axis-1-shift-all").scroll_into_view_if_needed()
    drawn(page)
    place = middle(page, "#axis-1-to-0 circle")
    protocol = page.context.new_cdp_session(page)
    protocol.send("Performance.enable", {"timeDomain": "threadTicks"})

    def spent():
        metrics = protocol.send("Performance.getMetrics")["metrics"]
        return next(one["value"] for one in metrics if one["name"] == "TaskDuration")

    page.mouse.move(*place)
    page.mouse.down()
    before = spent()
    for n in range(MANY):
        page.mouse.move(place[0] + 2 * n, place[1])
    assert page.evaluate("state.proposals") > MANY / 2
    assert (spent() - before) / MANY * 1000 < PICTURE
    page.mouse.up()


def test_charts_have_one_cursor_a_zoom_and_a_choice(opened):
    page = opened(viewport={"width": 1440, "height": 900})
    plots = page.locator(".chart .u-over")
    expect(plots).to_have_count(6)
    x, y = middle(page, ".chart .u-over >> nth=0")
    place = (x + 20, y)  # beside where both designs pass 0
    page.mouse.move(*place)
    page.wait_for_function("() => state.cursor.value !== null")
    drawn(page)
    told = page.locator(".chart output").all_text_contents()
    assert all("saved" in words for words in told)
    assert " at " in told[3]  # torque, and the speed there
    assert page.locator(".cursor text").count() == 5
    seen = page.evaluate("state.cursor.value")
    page.mouse.down()
    page.mouse.move(place[0] + 60, place[1])
    page.mouse.up()
    drawn(page)
    x, y = middle(page, ".chart .u-over >> nth=1")
    other = (x + 20, y)
    page.mouse.move(*other)
    page.wait_for_function("limit => state.cursor.value > limit", arg=seen + 5)  # all charts show the same of the cycle
    page.mouse.dblclick(*place)
    for n in range(MANY):  # the other charts follow in the page's next picture
        page.mouse.move(other[0], other[1] + n % 2)
        drawn(page)
        if abs(page.evaluate("state.cursor.value") - seen) < 2:
            break
    assert page.evaluate("state.cursor.value") == pytest.approx(seen, abs=2)
    page.get_by_role("button", name="drive").click()
    expect(page.locator(".chart")).to_have_count(3)
    assert [words.split(" [")[0] for words in page.locator(".chart h3 span").all_text_contents()] == [
        "torque against speed",
        "motor torque",
        "power",
    ]


def test_a_chart_holds_all_of_its_line_as_it_grows(opened):
    page = opened(viewport={"width": 1440, "height": 900})
    page.evaluate("""() => {
      const { axes } = state.figures.value;
      const charts = axes[1].charts.map((chart) => ({ ...chart, y: chart.y.map((value) => 3 * value) }));
      state.figures.value = { axes: { ...axes, 1: { ...axes[1], charts } } };
    }""")
    expect(page.locator(".chart output").first).to_have_text("peak 3")
    page.evaluate("state.cursor.value = 45")  # where the torque is largest
    drawn(page)
    mark, plot = page.locator(".mark.point").bounding_box(), page.locator(".u-over:has(.point)").bounding_box()
    assert plot["y"] < mark["y"] + mark["height"] / 2 < plot["y"] + plot["height"]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_shuts_anybody_out(opened, scheme):
    page = opened(color_scheme=scheme)
    assert [
        one["id"]
        for one in Axe().run(page).response["violations"]
        if one["id"] not in ("page-has-heading-one", "region")
    ] == []
    words = "text, h2, h3, output, button"
    sizes = page.evaluate(f"[...document.querySelectorAll('{words}')].map((one) => getComputedStyle(one).fontSize)")
    assert min(float(size.removesuffix("px")) for size in sizes) >= 12
