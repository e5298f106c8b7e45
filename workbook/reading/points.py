"""What need not be read: the rows of sheets, which the guard has met, and the numbers a chart was saved with."""

import io
import re
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any

from workbook.reading.rows import Rows

CHART = re.compile(r"/?xl/charts/[^/]*\.xml")
DRAWING = re.compile(r"/?xl/drawings/[^/]*\.xml")
NOTHING_DRAWN = b'<d:wsDr xmlns:d="http://schemas.openxmlformats.org/drawingml/2006/spreadsheetDrawing"/>'
POINT = re.compile(rb"<((?:\w+:)?)pt [^<>]*><\1v>[^<>]*</\1v></\1pt>")


def without_points(part: str, data: bytes) -> bytes:
    """Return a part of a workbook; of a chart without its saved points."""
    return POINT.sub(b"", data) if CHART.fullmatch(part) else data


def without_rows(data: bytes, rows: Rows) -> bytes:
    """Return a worksheet's part without its rows; as it is where they do not lie where the guard met them."""
    tag = rows.own[1].encode()
    begin, end = rows.span
    if data[begin : begin + 1 + len(tag)] != b"<" + tag or data[end : end + 2 + len(tag)] != b"</" + tag:
        return data
    return data[:begin] + b"<" + tag + b">" + data[end:]


class Bare(zipfile.ZipFile):
    """A workbook's archive whose sheets hold neither rows nor drawings."""

    def __init__(self, path: Path, rows: Mapping[str, Rows]) -> None:
        super().__init__(path)
        self.rows = rows

    def open(self, name: str | zipfile.ZipInfo, *args: Any, **how: Any) -> IO[bytes]:
        """Open a part for reading."""
        part = name if isinstance(name, str) else name.filename
        if DRAWING.fullmatch(part):
            return io.BytesIO(NOTHING_DRAWN)
        stream = super().open(name, *args, **how)
        if part not in self.rows:
            return stream
        with stream:
            return io.BytesIO(without_rows(stream.read(), self.rows[part]))
