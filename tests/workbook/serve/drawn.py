"""The drawing parts of the page alone in a browser: a server of their files, and a design with figures for them."""

import json
import tomllib
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from math import cos, pi, sin
from pathlib import Path
from threading import Thread
from urllib.parse import parse_qs, urlsplit

ROOT = Path(__file__).parents[3]
PAGE = "/tests/workbook/serve/drawing/"
POLICY = "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'self'; img-src 'self'"
SMOOTH = [{"from": 0, "to": 1, "x": [0, 0, 0, 10, -15, 6]}]  # the 345 polynomial
ANGLES = range(0, 361, 2)
GAP = {"name": "Punch over cutter", "unit": "mm", "x": [0, 180, 360], "y": [9, 2, 9], "least": 2, "at": 180, "need": 3,
       "ok": False}  # fmt: skip


def chart(key, title, unit, heights, limits=(), across=None, points=()):
    values = {"x": across or list(ANGLES), "y": heights, "x_title": "rpm" if across else "°", "at": list(ANGLES)}
    return {"key": key, "title": title, "unit": unit, "limits": list(limits), "points": list(points)} | values


def charts(size=1.0):
    wave = [size * sin(2 * angle * pi / 180) for angle in ANGLES]
    speed = [3000 * size * cos(angle * pi / 180) for angle in ANGLES]
    peak = {"value": 48, "label": "peak 48 Nm", "kind": "peak"}
    steady = {"value": 16, "label": "continuous 16 Nm", "kind": "continuous"}
    fast = {"value": 4500, "label": "4500 rpm", "kind": "speed"}
    root = {"x": 1200, "y": 13.7, "label": "RMS 13.7 Nm"}
    torque = [30 * value for value in wave]
    both = [limit | {"value": sign * limit["value"]} for limit in (peak, steady, fast) for sign in (1, -1)]
    return [
        chart("v", "velocity", "m/s", wave),
        chart("a", "acceleration", "m/s²", [70 * value for value in wave]),
        chart("j", "jerk", "m/s³", [900 * value for value in wave]),
        chart("Tn", "torque against speed", "Nm", torque, both, speed, [root]),
        chart("T", "motor torque", "Nm", torque, both[:4]),
        chart("P", "power", "kW", [value + 0.2 for value in wave]),
    ]


def fixture(count):
    """The machine template's axes, repeated to as many as asked, with its switches."""
    given = tomllib.loads((ROOT / "templates" / "machine.toml").read_text(encoding="utf-8"))
    data = given | {"axes": [given["axes"][k % 4] | {"name": f"MC{k + 1:02}"} for k in range(count)]}
    data["axes"][0]["load"] = {"windows": [{"start": 200, "stop": 240}]}
    figures, saved = (
        {"axes": {k: {"error": None, "stale": False, "start": 0, "charts": charts(size),
                      "pieces": [SMOOTH] * len(axis["phases"])} for k, axis in enumerate(data["axes"])},
         "gaps": {"0": GAP}}
        for size in (1.0, 0.8)
    )  # fmt: skip
    return {"data": data, "figures": figures, "saved": saved | {"data": data}}


class Files(SimpleHTTPRequestHandler):
    """The repository's files under the policy of the server, and the fixture."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".js": "text/javascript"}

    def end_headers(self):
        self.send_header("Content-Security-Policy", POLICY)
        super().end_headers()

    def do_GET(self):
        asked = urlsplit(self.path)
        if not asked.path.endswith("fixture.json"):
            super().do_GET()
            return
        body = json.dumps(fixture(int(parse_qs(asked.query).get("axes", ["5"])[0]))).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        """Say nothing."""


@contextmanager
def drawing():
    """The address of the page of the drawing parts; `?axes=24` for as many."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Files, directory=ROOT))
    Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}{PAGE}drawing.html"
    server.shutdown()
