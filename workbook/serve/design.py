"""A design that is edited: its faults by entry, its figures axis by axis, the verdict on the whole of it."""

import json
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from workbook.entries.design import RefusedError, fault_line
from workbook.entries.machine import Fault
from workbook.errors import MotionbookError
from workbook.fields.paths import get, split
from workbook.reading.descriptions import make_machine, parse_toml, template_named
from workbook.selection.entries import COMMITTED
from workbook.serve.shown import design, failing, pictures
from workbook.serve.words import sentence, spoken
from workbook.templates import AnyTemplate

MARK = "\0"  # ends the key in the line of a fault
CONTEXT = ("template", "master", "laws", "gravity", "creep_forces", "power", "limits", "sizes")
# of these a machine without drives has none
OF_DRIVES = ("gravity", "creep_forces", "power", "limits")
OF_MOTION = ("name", "group", "unit", "closes", "smoothness", "shift", "position", "phases")
PRODUCTS = ("motors", "reducers", "falling")
REMEMBERED = 100  # axes whose figures are remembered
W_PER_KW = 1000.0
ENDS = ("first", "second")  # of a clearance: entries that name axes
PICTURES = 4
PART = 0.1  # s of work after which other work may come between


class Judged(NamedTuple):
    """A machine whose entries go together, if they do, and the faults of a description by the keys of its entries."""

    machine: Any
    faults: dict[str, str]


def judge_entries(template: AnyTemplate, data: dict[str, Any]) -> Judged:
    """Return the machine of a description, or its faults by their keys."""
    try:
        machine = make_machine(template, data, str, by_code=True)
        noted: Sequence[Any] = machine.design.faults
    except RefusedError as error:
        machine, noted = None, [*error.faults, *error.numbers]
    faults = dict[str, str]()
    for fault in noted:
        key, _, line = fault_line(fault, template.model, lambda key: f"{key}{MARK}").partition(f"{MARK}: ")
        is_missing = isinstance(fault, Fault) and fault.is_missing
        faults.setdefault(key, f"missing: {line}" if is_missing else line)
    return Judged(None if faults else machine, faults)


class Edited:
    """A description as it is edited: its data, its faults by entry, and the figures of those axes that have none."""

    def __init__(self, text: str) -> None:
        self.text, self.data = text, parse_toml(text, Path("the description"))
        self.template = template_named(self.data.get("template"), "template")
        axes = self.data.get("axes") if self.template.live else None
        self.axes = axes if isinstance(axes, list) else []
        self.faults = dict[str, str]()
        self.own = [self._axis(k, axis) for k, axis in enumerate(self.axes)]
        self.faults |= judge_entries(self.template, self.data).faults
        self.faults = {key: sentence(line) for key, line in self.faults.items()}

    def _axis(self, k: int, axis: Any) -> Judged:
        """Return an axis judged by itself; its faults are noted."""
        own = judged_axis(self.template.name, self._alone(axis))
        for key, line in own.faults.items():
            if key.startswith("axes.0"):
                self.faults.setdefault(f"axes.{k}{key.removeprefix('axes.0')}", line)
        return own

    def _alone(self, *axes: Any, **more: Any) -> str:
        """Return the description of a machine of some axes alone."""
        data = {key: self.data[key] for key in CONTEXT if key in self.data}
        if not all(isinstance(axis, Mapping) and "mechanism" in axis for axis in axes):
            data = {key: value for key, value in data.items() if key not in OF_DRIVES}
        choice = self.data.get("selection")
        chosen = {key: choice[key] for key in PRODUCTS if key in choice} if isinstance(choice, Mapping) else {}
        return as_json(data | {"title": "-", "selection": chosen, "axes": axes} | more)

    def gaps(self, chosen: int | None = None) -> dict[str, Any]:
        """Return the gaps of clearances of finished axes by their numbers: all, or those of an axis."""
        numbers = {str(axis.get("name")): k for k, axis in enumerate(self.axes) if isinstance(axis, Mapping)}
        every = dict[str, Any]()
        for k, row in enumerate(rows if isinstance(rows := self.data.get("clearances"), list) else ()):
            ends = [numbers.get(str(get(row, (end,)))) for end in ENDS]
            if None not in ends and chosen in (None, *ends):
                alone = self._alone(*(motion_of(self.axes[end]) for end in ends if end is not None), clearances=[row])
                every |= {str(k): gap for gap in gap_figures(self.template.name, alone)}
        return every

    def products(self, k: int, kind: str) -> dict[str, Any]:
        """Return the use of each motor or reducer in an axis, by names; of an unfinished axis nothing."""
        axis, live = self.axes[k], self.template.live
        first = (
            get(self.data, ("selection", f"{kind}s", "0", "name")) or COMMITTED[f"{kind}s"]()[0].model_dump()["name"]
        )
        tried = (judged_axis(self.template.name, self._alone(each)) for each in (axis, axis | {kind: {"name": first}}))
        machine = next((own.machine for own in tried if own.machine), None)
        if live is None or machine is None or machine.axes[0].mechanism is None or machine.axes[0].motor is None:
            return {}
        figures: dict[str, Any] = live.product_figures(machine, kind == "motor")
        return figures

    def figures(self, k: int) -> dict[str, Any]:
        """Return the figures of an axis, or what is wrong with it: of a faulty drive those of the motion remain."""
        axis, own = self.axes[k], self.own[k]
        if not own.faults:
            return axis_figures(self.template.name, self._alone(axis)) | {"error": None, "stale": False}
        key, line = next(iter(own.faults.items()))
        key = f"axes.{k}{key.removeprefix('axes.0')}" if key.startswith("axes.0") else key
        wrong = {"error": f"{spoken(split(key), self.data, short=key[:5] == 'axes.')}: {sentence(line)}", "stale": True}
        if isinstance(axis, Mapping) and not any(
            split(key)[2:3] in [(name,) for name in OF_MOTION] for key in own.faults
        ):
            alone = self._alone(motion_of(axis))
            if not judged_axis(self.template.name, alone).faults:
                return axis_figures(self.template.name, alone) | wrong
        return wrong

    def machine(self) -> dict[str, Any]:
        """Return the machine's rate, the highest that all its axes hold and why, and its peak power (kW)."""
        drives = [(axis.get("name", ""), own) for axis, own in zip(self.axes, map(self.figures, range(len(self.axes))),
                  strict=True) if "power" in own]  # fmt: skip
        limited = [(own["highest"], f"{name}: {own['reason']}") for name, own in drives if own["highest"] is not None]
        highest = min(limited, default=(None, ""))
        share = 1.0 if "power.efficiency" in self.faults else get(self.data, ("power", "efficiency"), 1.0)
        return {
            "rate": get(self.data, ("master", "rate")),
            "highest": {"value": highest[0], "reason": highest[1]} if limited else None,
            "peak_power": peak_power([own for _, own in drives], share) if drives else None,
        }


def peak_power(drives: list[dict[str, Any]], efficiency: float) -> float:
    """Return the largest power that drives take from the mains (kW): on a common bus, and beside it those apart."""
    on, beside = ([own for own in drives if own["own_rate"] is apart] for apart in (False, True))
    most = sum(own["power"]["peak"] for own in beside) / efficiency
    if on:
        power = np.array([own["power"]["sampled"] for own in on])
        drawn = np.where(power > 0.0, power / efficiency, power * efficiency).sum(axis=0)
        burnt = [max(0.0, -own["power"]["low"]) * efficiency for own in on]
        proves = [own["power"]["peak"] / efficiency - sum(burnt) + low for own, low in zip(on, burnt, strict=True)]
        most += max(0.0, float(drawn.max()), *proves)
    return float(most / W_PER_KW)


def motion_of(axis: Mapping[str, Any]) -> dict[str, Any]:
    """Return an axis without its drive."""
    return {name: axis[name] for name in OF_MOTION if name in axis}


def as_json(data: Any) -> str:
    """Return data as a text by which it is remembered."""
    return json.dumps(data, default=str)


@lru_cache(REMEMBERED)
def judged_axis(template: str, data: str) -> Judged:
    """Return a machine of one axis, judged, from its JSON."""
    return judge_entries(template_named(template, "template"), json.loads(data))


@lru_cache(REMEMBERED)
def axis_figures(template: str, data: str) -> dict[str, Any]:
    """Return the figures of an axis that has no faults."""
    live, machine = template_named(template, "template").live, judged_axis(template, data).machine
    return live.axis_figures(machine)[0] if live else {}


@lru_cache(REMEMBERED)
def gap_figures(template: str, data: str) -> list[dict[str, Any]]:
    """Return the gaps of the clearances of a machine, from its JSON; none where it has faults."""
    live, machine = template_named(template, "template").live, judged_axis(template, data).machine
    return live.gap_figures(machine) if live and machine else []


@lru_cache(4)
def edited_design(text: str) -> Edited:
    """Return the design of a text."""
    return Edited(text)


def figures(text: str, chosen: int, machine: bool = True) -> dict[str, Any]:
    """Return the figures of the chosen axis, or of all axes and the machine; none of a text that is no TOML."""
    try:
        design = edited_design(text)
    except MotionbookError:
        return {"axes": {}}
    axes = {}
    for k in range(len(design.axes)):
        if machine or k == chosen:
            dropped = ("power",) if k == chosen else ("power", "charts")
            axes[str(k)] = {key: value for key, value in design.figures(k).items() if key not in dropped}
    whole = {"machine": design.machine(), "data": design.data} if machine else {}
    return {"axes": axes, "gaps": design.gaps(None if machine else chosen)} | whole


def worked_out(text: str, first: int) -> int | None:
    """Work figures of axes out for a while, which are remembered; return the next axis, None behind the last."""
    begin = time.perf_counter()
    with suppress(MotionbookError):
        design = edited_design(text)
        for k in range(first, len(design.axes)):
            design.figures(k)
            if time.perf_counter() - begin > PART:
                return k + 1
    return None


def products(text: str, k: int, kind: str) -> dict[str, Any]:
    """Return the use of each motor or reducer of the catalogue in an axis of a text, by its name."""
    return edited_design(text).products(k, kind)


def verdict(name: str, text: str) -> dict[str, Any]:
    """Return the checks of the book that a text describes; pictures of a kind of machine whose axes have none live."""
    try:
        whole = edited_design(text)
        shown = None if whole.faults else design(name, text)
    except MotionbookError as error:
        return judgement("unfinished", [{"sentence": str(error)}])
    if shown is None:
        lines = [(split(key), line) for key, line in whole.faults.items()]
        checks = [{"sentence": f"{spoken(path, whole.data)}: {line}", "path": list(path)} for path, line in lines]
        return judgement("unfinished", checks)
    fails = [{"sentence": ": ".join(filter(None, row[1:]))} for row in failing(shown)]
    drawn = [] if whole.axes else pictures(shown, PICTURES)
    return judgement("FAIL" if fails else "OK", fails, drawn) | {"number": len(shown.checks())}


def judgement(verdict: str, checks: list[dict[str, Any]], pictures: Sequence[str] = ()) -> dict[str, Any]:
    """Return a verdict as the page has it, with the checks that fail or entries that are missing, and their number."""
    return {"verdict": verdict, "number": len(checks), "checks": checks, "pictures": pictures}
