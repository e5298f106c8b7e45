"""motionbook serve, running on a folder with the cutting machine in small tables."""

import http.client
import os
import re
import signal
import subprocess
import sys
from contextlib import contextmanager
from functools import partial
from urllib.parse import urlencode, urlsplit

import pytest

from tests import cutting
from tests.workbook.serve.chromium import CHROMIUM, expect, sync_playwright
from workbook.build import build
from workbook.reading.descriptions import write_machine
from workbook.serve.handler import COOKIE
from workbook.writing.output_files import write_text

LONG = 60_000  # ms: a workbook is built, or verified
WIDE = 1440

RATE = "master.rate"
ENDLESS = {"result": "drive1_rms", "what": "minimise", "value": "", "way": "full", "designs": "9", "key": RATE,
           "values": "30 to 60 in 1000000", "vary": RATE}  # fmt: skip
"""a study that is interrupted"""

BOUNDARY = "----boundary"
ADDRESS = re.compile(r"Open http://(127\.0\.0\.1:\d+)/\?token=(\S+) ")


class Answer:
    """What the server answered."""

    def __init__(self, response):
        self.code, self.headers, self.body = response.status, response.headers, response.read()


class Server:
    """The command as a browser asks it."""

    def __init__(self, root, host, token):
        self.root, self.host, self.token = root, host, token

    def ask(self, path, body=None, cookie=None, origin=None, **headers):
        """Ask as the browser does; a body is posted."""
        headers = {"Cookie": f"{COOKIE}={self.token if cookie is None else cookie}", "Host": self.host} | headers
        if body is not None:
            headers["Origin"] = origin or f"http://{self.host}"
            headers.setdefault("Content-Type", "application/x-www-form-urlencoded")
        connection = http.client.HTTPConnection(self.host, timeout=300)
        connection.request("GET" if body is None else "POST", path, body, headers)
        answer = Answer(connection.getresponse())
        connection.close()
        return answer

    def form(self, **fields):
        return urlencode(fields, doseq=True)

    def upload(self, path, field, name, data, **fields):
        part = f'--{BOUNDARY}\r\nContent-Disposition: form-data; name="'
        head = "".join(f'{part}{key}"\r\n\r\n{value}\r\n' for key, value in fields.items())
        head += f'{part}{field}"; filename="{name}"\r\n\r\n'
        body = head.encode() + data + f"\r\n--{BOUNDARY}--\r\n".encode()
        return self.ask(path, body, **{"Content-Type": f"multipart/form-data; boundary={BOUNDARY}"})


@contextmanager
def serving(root):
    """The command, running on a folder; Ctrl+C ends it."""
    command = [sys.executable, "-u", "-m", "workbook", "serve", str(root), "--no-browse"]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # tests in the background ignore Ctrl+C
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, preexec_fn=heard) as process:
        found = ADDRESS.match(process.stdout.readline())
        yield Server(root, found[1], found[2])
        process.send_signal(signal.SIGINT)
        try:
            assert process.wait(20) == 0
        finally:
            process.kill()


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """The command, running on a folder with the cutting machine in small tables."""
    root = tmp_path_factory.mktemp("serve") / "machines"
    root.mkdir()
    (root.parent / "secret.toml").write_text("outside")
    machine = cutting.small(cycle=12, law=4)
    write_text(root / "cutting.toml", write_machine(machine))
    write_text(root / "live.toml", write_machine(machine))
    build(machine, root / "cutting.xlsx")
    with serving(root) as running:
        yield running


@pytest.fixture(scope="module")
def browser():
    """The system's Chromium, ended with the module: while it is driven, no other test can begin a loop of asyncio."""
    if CHROMIUM is None and "CI" not in os.environ:
        pytest.skip("Chromium, or the Python package playwright, is not on this machine")
    expect.set_options(timeout=LONG)
    with sync_playwright() as driver:
        one = driver.chromium.launch(executable_path=CHROMIUM)
        yield one
        one.close()


@contextmanager
def window(browser, server, **more):
    """A page that opened the printed address; at the end no request has left the host, and no error was logged."""
    context = browser.new_context(viewport={"width": WIDE, "height": 900}, **more)
    context.set_default_timeout(LONG)
    said, asked = [], []
    context.on("request", lambda request: asked.append(urlsplit(request.url).netloc))
    context.on("console", lambda message: said.append(message.text) if message.type in ("error", "warning") else None)
    context.on("weberror", lambda error: said.append(str(error.error)))
    one = context.new_page()
    context.add_cookies([{"name": COOKIE, "value": server.token, "url": f"http://{server.host}"}])
    yield one
    context.close()
    assert set(asked) == {server.host}
    assert [line for line in said if "status of 400" not in line] == []


def drawn(page):
    """Wait until what was done is in the picture."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


@contextmanager
def answered(page):
    """Wait until a change of the design that is made meanwhile is answered, and drawn."""
    with page.expect_response("**/change") as answer:
        yield answer
    answer.value.finished()
    drawn(page)


@pytest.fixture
def page(browser, server):
    with window(browser, server) as one:
        yield one
