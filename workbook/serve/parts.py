"""Change a description on the design page: set an entry, add, copy or remove a part, each in its text."""

import re
from collections.abc import Mapping
from copy import deepcopy
from pathlib import Path
from typing import Any

from workbook.description.editing import edit_text
from workbook.entries.rules import KIND
from workbook.errors import InputError
from workbook.fields.paths import Place, get
from workbook.reading.descriptions import parse_toml
from workbook.serve.tables import key_at, required_entries, sections_at, unit_at
from workbook.serve.typed import value_of

Changes = list[tuple[Place, Any]]
TURN, LIFT, LAW = 360.0, 50.0, "MTP"
# the size of their sheet
ROOMS = {"phases": "phases", "parts": "rotors", "motors": "motors", "reducers": "reducers"}
SIZES = {"phases": 8, "rotors": 6, "motors": 22, "reducers": 18}  # of a description that tells none
NAMING = ("first", "second")  # entries of clearances that name an axis
MECHANISMS: dict[str, dict[str, Any]] = {
    "mm": {"kind": "lead screw", "lead": 20.0, "efficiency": 0.9},
    "°": {"kind": "rotary table"},
}
LEAST = 1e-9  # of the cycle: no room


class Change:
    """A change of a description: what it does to which entry, with what is typed."""

    def __init__(self, text: str, change: Mapping[str, Any]) -> None:
        self.text, self.data = text, parse_toml(text, Path("the description"))
        self.template = str(self.data.get("template"))
        self.place: Place = tuple(map(str, change["path"]))
        if self.place[-1:] in (("start",), ("stop",)) and isinstance(get(self.data, self.place[:-1]), list):
            # a time as [from, to]
            self.place = (*self.place[:-1], str(int(self.place[-1] == "stop")))
        self.do, self.value = str(change.get("do", "set")), change.get("value")
        if not self.place:
            raise InputError(["a change of what is expected; no path is given"])

    def done(self) -> str:
        """Return the text with the change; raise InputError with the sentence why it cannot be made."""
        work = {"set": self._set, "add": self._add, "copy": self._copy, "remove": self._remove}.get(self.do)
        if work is None:
            raise InputError([f"{self.do!r}: expected set, add, copy or remove"])
        try:
            changes = work()
        except (AttributeError, LookupError, TypeError, ValueError):
            raise InputError(["this cannot be done before the entries beside it are numbers and texts"]) from None
        return edit_text(self.text, changes)

    @property
    def length(self) -> float:
        """The length of the cycle in the unit of its places."""
        length = get(self.data, ("master", "cycle"))
        return float(length) if isinstance(length, int | float) and length > 0 else TURN

    def _set(self) -> Changes:
        """Return the changes that set an entry, a new kind of a table, or a name that others know."""
        key = key_at(self.template, self.data, self.place)
        value = self.value
        if isinstance(value, str):
            value = value_of(key, unit_at(key, self.data, self.place), value)
        elif isinstance(value, int) and not isinstance(value, bool) and key.expected.startswith("a number"):
            value = float(value)
        before = get(self.data, self.place)
        if value is None:
            return [(self.place, None)] if before is not None else []
        changes: Changes = [(self.place, value), *(self._room(len(value)) if isinstance(value, list) else ())]
        if key.name == KIND and self.place[-2:-1] == ("mechanism",):
            changes += self._of_kind(str(value))
        if key.name == "name" and self.place[0] == "axes" and len(self.place) == 3:
            changes += [(place, value) for place in self._naming(before)]
        return changes

    def _of_kind(self, kind: str) -> Changes:
        """Return the changes by which a table becomes one of another kind."""
        above = self.place[:-1]
        table = get(self.data, above, {})
        sections = [each for each in sections_at(self.template, above) if each.kind in ("", kind)]
        keys = [key for section in sections for key in section.keys]
        names = {key.name for key in keys}
        gone: Changes = [((*above, name), None) for name in table if name not in names and name != KIND]
        needed = {name: value for name, value in required_entries(keys).items() if name not in table and name != KIND}
        return gone + [((*above, name), value) for name, value in needed.items()]

    def _naming(self, name: Any) -> list[Place]:
        """Return the places of entries that name an axis."""
        places = [("clearances", str(k), entry) for k, row in enumerate(self.data.get("clearances", []))
                  for entry in NAMING if get(row, (entry,)) == name]  # fmt: skip
        return places + ([("selection", "axis")] if get(self.data, ("selection", "axis")) == name else [])

    def _add(self) -> Changes:
        """Return the changes that add a row or a table that works, or that names what is missing in its fields."""
        rows = get(self.data, self.place)
        match self.place:
            case ("axes",):
                return self._row(rows, new_axis(self._free(rows, "MC01"), self.length))
            case ("switches",):
                return self._row(rows, {"name": self._free(rows, "Switch 1"), "on": [[0.0, self.length / 4.0]]})
            case ("clearances",):
                return self._row(rows, self._clearance())
            case ("axes", number, "phases"):
                return self._insert(rows, self._phase(int(number)))
            case ("axes", number, "drive"):
                return self._drive(number)
            case ("laws", name):
                return [(self.place, {"family": name})]
        if rows is not None and not isinstance(rows, list):
            raise InputError([f"{self.place[-1]} is there already"])
        sections = sections_at(self.template, self.place)
        if sections and rows is None:
            keys = [key for each in sections if not each.kind for key in each.keys]
            return [(self.place, required_entries(keys))]
        key = key_at(self.template, self.data, self.place)
        row = required_entries(key.rows)
        if "name" in row:
            row["name"] = self._free(rows, f"New {self.place[-1].removesuffix('s')}")
        if not key.rows[2:] and all(each.required for each in key.rows):
            ends = [self.length * share for share in (0.5, 0.6)]
            return self._row(rows, ends if "°" in key.rows[0].unit else [*row.values()])
        return self._row(rows, row)

    def _row(self, rows: Any, row: Any) -> Changes:
        """Return the changes that put a row at the end of a list, with room for it on its sheet."""
        if not rows:
            return [(self.place, [row]), *self._room(1)]
        return [((*self.place, str(len(rows))), row), *self._room(len(rows) + 1)]

    def _insert(self, rows: Any, row: dict[str, Any]) -> Changes:
        """Return the changes that put a phase among others, by their order."""
        at = sum(1 for each in rows or [] if each.get("start", 0.0) < row["start"])
        moved = [*(rows or [])[:at], row, *(rows or [])[at:]]
        if at == len(rows or []):
            return self._row(rows, row)
        return [((*self.place, str(k)), each) for k, each in enumerate(moved) if k >= at] + self._room(len(moved))

    def _room(self, rows: int) -> Changes:
        """Return the change of a size that has no room for so many rows."""
        size = ROOMS.get(self.place[-1], "")
        held = get(self.data, ("sizes", size), SIZES.get(size, rows))
        return [(("sizes", size), rows)] if size and rows > held else []

    def _clearance(self) -> dict[str, Any]:
        """Return a clearance of the first two axes of the same unit."""
        axes = [(axis.get("name"), axis.get("unit", "mm")) for axis in self.data.get("axes", [])]
        pair = next(((a, b) for k, a in enumerate(axes) for b in axes[k + 1 :] if a[1] == b[1]), None)
        if pair is None:
            raise InputError(["a clearance is a gap of two axes in the same unit; add another axis first"])
        (first, _), (second, _) = pair
        name = self._free(self.data.get("clearances"), "Clearance 1")
        return {"name": name, "first": first, "second": second, "offset": 100.0}

    def _phase(self, number: int) -> dict[str, Any]:
        """Return a phase behind the last, else in the largest gap: it brings the axis back, or lifts it."""
        axis = get(self.data, ("axes", str(number)), {})
        rows = [row for row in axis.get("phases", []) if {"start", "stop"} <= row.keys()]
        begin, end = self._gap(rows)
        lifts = sum(row.get("lift", 0.0) for row in rows)
        back = axis.get("closes", "position") == "position" and abs(lifts) > LEAST
        law = next((row["law"] for row in reversed(rows) if row.get("law", "DWL") != "DWL"), LAW)
        last = rows[-1]["stop"] - rows[-1]["start"] if rows else end - begin
        stop = min(end, begin + max(last, LEAST))
        return {"start": begin, "stop": stop, "lift": -lifts if back else 10.0, "law": law}

    def _gap(self, rows: list[dict[str, Any]]) -> tuple[float, float]:
        """Return where a phase has room."""
        ends = [0.0, *(row["stop"] for row in rows)]
        gaps = [*zip(ends, [*(row["start"] for row in rows), self.length], strict=True)]
        begin, end = gaps[-1]
        if end - begin <= LEAST * self.length:
            begin, end = max(gaps, key=lambda gap: gap[1] - gap[0])
        if end - begin <= LEAST * self.length:
            raise InputError(["there is no room between the phases; make one of them shorter first"])
        return begin, end

    def _drive(self, number: str) -> Changes:
        """Return the changes that give an axis a mechanism of its unit and a motor of the catalogue."""
        axis = get(self.data, ("axes", number), {})
        changes: Changes = []
        if "mechanism" not in axis:
            changes.append((("axes", number, "mechanism"), dict(MECHANISMS[axis.get("unit", "mm")])))
        if "motor" not in axis:
            changes.append((("axes", number, "motor"), {"name": "Mitsubishi HG-KN13"}))
        return changes

    def _copy(self) -> Changes:
        """Return the changes that copy a row: under a free name, a phase into the next gap."""
        *above, _ = self.place
        rows, row = get(self.data, above), deepcopy(get(self.data, self.place))
        if not isinstance(rows, list) or row is None:
            raise InputError([f"{'.'.join(self.place)}: there is no such row"])
        self.place = tuple(above)
        if above[0] == "axes" and above[-1] == "phases":
            begin, end = self._gap(rows)
            return self._insert(rows, row | {"start": begin, "stop": min(end, begin + row["stop"] - row["start"])})
        if isinstance(row, dict) and "name" in row:
            row["name"] = self._free(rows, row["name"])
        return self._row(rows, row)

    def _remove(self) -> Changes:
        """Return the changes that remove an entry, row or table, and what names it."""
        if self.place[0] == "axes" and len(self.place) == 2:
            if not self.data.get("axes", [])[1:]:
                raise InputError(["a machine has one axis at least; add another before you remove this one"])
            naming = self._naming(get(self.data, (*self.place, "name")))
            rows = sorted(
                {place[:2] for place in naming}, key=lambda place: -int(place[1]) if place[1].isdigit() else 1
            )
            return [(self.place, None), *((place, None) for place in rows)]
        if get(self.data, self.place) is None:
            raise InputError([f"{'.'.join(self.place)}: there is no such entry"])
        return [(self.place, None)]

    def _free(self, rows: Any, name: str) -> str:
        """Return a name that no row of a table has: the name, or that with the next number."""
        taken = {str(row.get("name", "")).casefold() for row in rows or []}
        if name.casefold() not in taken:
            return name
        match = re.fullmatch(r"(.*?)(\d*)", name)
        begin, digits = (match[1], match[2]) if match else (name, "")
        begin = begin if digits else f"{begin} "
        number = int(digits or 2)
        while f"{begin}{number:0{len(digits)}}".casefold() in taken:
            number += 1
        return f"{begin}{number:0{len(digits)}}"


def new_axis(name: str, length: float) -> dict[str, Any]:
    """Return an axis that goes and comes back within a cycle of a length."""
    quarter = length / 4.0
    phases = [{"start": k * quarter, "stop": (k + 1.0) * quarter, "lift": lift, "law": LAW}
              for k, lift in ((0, LIFT), (2, -LIFT))]  # fmt: skip
    return {"name": name, "group": "Group", "phases": phases}


def apply_changes(text: str, changes: list[dict[str, Any]]) -> tuple[str, dict[str, str]]:
    """Return the text with the changes, in their order, and by path in JSON the sentences on those that are refused."""
    refused = {}
    for change in changes:
        if change.get("do") == "text":
            text = str(change["value"])
            continue
        try:
            text = Change(text, change).done()
        except InputError as error:
            refused[".".join(map(str, change.get("path", [])))] = str(error)
    return text, refused
