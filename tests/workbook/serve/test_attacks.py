"""What nobody may do to the server: fill it, stop it, or leave its work behind."""

import asyncio
import io
import os
import socket
import time
import zipfile
from contextlib import suppress
from pathlib import Path
from urllib.parse import quote

import pytest

from tests import cutting
from tests.workbook.serve.conftest import ENDLESS, serving
from workbook.reading.descriptions import write_machine
from workbook.serve.app import GET, POST
from workbook.serve.work import Done, Work
from workbook.writing.output_files import write_text


def test_an_upload_of_a_gigabyte_is_refused_before_it_is_sent(server):
    host, _, port = server.host.partition(":")
    head = (f"POST /upload HTTP/1.1\r\nHost: {server.host}\r\nOrigin: http://{server.host}\r\n"
            f"Cookie: motionbook={server.token}\r\nContent-Length: {10**9}\r\n\r\n")  # fmt: skip
    with socket.create_connection((host, int(port)), timeout=20) as connection:
        connection.sendall(head.encode())
        assert b"200 OK" not in connection.recv(1000)
    assert server.ask("/").code == 200


def test_a_zip_bomb_is_told_and_harms_nobody(server):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file:
        file.writestr("xl/workbook.xml", bytes(300_000_000))
    answer = server.upload("/upload", "book", "bomb.xlsx", packed.getvalue()).body.decode()
    assert "Cannot be read" in answer
    assert server.ask("/").code == 200


OUTSIDE = ("../secret.toml", "/etc/passwd", "..\\secret.toml", ".hidden.toml", "link.toml", "secret\0.toml")
FIELDS = ("name", "old", "new", "as", "study", "axis", "target", "template", "do", "kind", "pick", "points", "text")


@pytest.mark.parametrize("path", sorted(GET | POST))
def test_no_parameter_leads_out_of_the_folder_and_no_stranger_is_answered(server, path):
    link = server.root / "link.toml"
    if not link.is_symlink():
        link.symlink_to(server.root.parent / "secret.toml")
    before = sorted(server.root.parent.rglob("*"))
    for name in OUTSIDE if path in POST or "NAME" in path else ():
        body = server.form(**dict.fromkeys(FIELDS, name)) if path in POST else None
        answer = server.ask(path.replace("NAME", quote(name, safe="")), body)
        assert (answer.code in (200, 400, 404), b"outside" in answer.body) == (True, False)
    address = path.replace("NAME", "live.toml")
    if "(" not in address:
        body = server.form(name="live.toml") if path in POST else None
        assert [server.ask(address, body, **more).code for more in ({"cookie": ""}, {"Host": "evil.example"})] == [
            403
        ] * 2
        assert body is None or server.ask(address, body, origin="http://evil.example").code == 403
    assert sorted(server.root.parent.rglob("*")) == before


def test_a_thousand_requests_at_once_are_answered(server):
    host, _, port = server.host.partition(":")
    head = f"GET /state/live.toml HTTP/1.1\r\nHost: {server.host}\r\nCookie: motionbook={server.token}\r\n\r\n"

    async def ask():
        reader, writer = await asyncio.open_connection(host, int(port))
        writer.write(head.encode())
        answered = await reader.readline()
        writer.close()
        return answered

    async def ask_all():
        return await asyncio.gather(*(ask() for _ in range(1000)))

    assert set(asyncio.run(ask_all())) == {b"HTTP/1.1 200 OK\r\n"}


@pytest.mark.parametrize("wrong", ["Origin: http://evil.example", "Cookie: motionbook=wrong", ""])
def test_a_body_is_refused_by_its_header_and_a_slow_one_holds_nobody_up(server, wrong):
    host, _, port = server.host.partition(":")
    right = {"Host": server.host, "Origin": f"http://{server.host}", "Cookie": f"motionbook={server.token}"}
    right |= dict([wrong.split(": ")]) if wrong else {}
    head = "".join(f"{name}: {value}\r\n" for name, value in right.items())
    with socket.create_connection((host, int(port)), timeout=60) as connection:
        connection.sendall(f"POST /upload HTTP/1.1\r\n{head}Content-Length: 50000000\r\n\r\nbook=".encode())
        if wrong:
            assert b"403" in connection.recv(1000)
        for _ in range(5):
            assert server.ask("/state/live.toml").code == 200
            if not wrong:
                connection.sendall(b"x")


def test_a_study_of_what_lies_outside_the_folder_is_refused(server):
    (server.root / "far.toml").write_text(
        'title = "Far"\nbase = "../secret.toml"\n[[vary]]\nkey = "master.rate"\nvalues = [1]'
    )
    for answer in (server.ask("/progress/far.toml"), server.ask("/begin", server.form(name="far.toml"))):
        assert (answer.code, "plain name" in answer.body.decode()) == (400, True)
    (server.root / "far.toml").unlink()


def test_a_hundred_commands_wait_for_their_turn(monkeypatch):
    running, most = [0], []

    async def slow(self, arguments, folder):
        running[0] += 1
        most.append((running[0], self.waiting))
        await asyncio.sleep(0)  # by turns of the loop, however slow the machine is
        running[0] -= 1
        return Done(0, arguments[0])

    async def all_at_once():
        work = Work(2)
        return await asyncio.gather(*(work.run(f"{k}") for k in range(100))), work.waiting

    monkeypatch.setattr(Work, "_run", slow)
    done, waiting = asyncio.run(all_at_once())
    assert [one.text for one in done] == [f"{k}" for k in range(100)]
    assert max(count for count, _ in most) == 2
    assert max(count for _, count in most) == 98
    assert waiting == 0


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="the processes of a machine are listed in /proc")
def test_a_command_ends_with_the_wait_for_it(server):
    host, _, port = server.host.partition(":")
    body, kind = server.form(name="cutting.toml"), "application/x-www-form-urlencoded"
    head = (f"POST /build HTTP/1.1\r\nHost: {server.host}\r\nOrigin: http://{server.host}\r\nContent-Type: {kind}\r\n"
            f"Cookie: motionbook={server.token}\r\nContent-Length: {len(body)}\r\n\r\n{body}")  # fmt: skip
    before, ours = {path.name for path in server.root.iterdir()}, f"build\0{server.root}".encode()
    with socket.create_connection((host, int(port)), timeout=20) as connection:
        connection.sendall(head.encode())
        while not any(ours in words_of(pid) for pid in pids()):
            time.sleep(0.05)
    while any(ours in words_of(pid) for pid in pids()):
        time.sleep(0.1)
    assert {path.name for path in server.root.iterdir()} == before


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="the processes of a machine are listed in /proc")
def test_a_study_ends_with_the_server_and_its_parts_stay(tmp_path):
    write_text(tmp_path / "long.toml", write_machine(cutting.small(cycle=12, law=4)))
    with serving(tmp_path) as server:
        server.ask("/study", server.form(name="long.toml", **ENDLESS))
        server.ask("/begin", server.form(name="long-study.toml"))
        while not [*tmp_path.glob("*.parts/part-*.json")]:
            assert "data-again" in server.ask("/progress/long-study.toml").body.decode()
            time.sleep(0.2)
        (session,) = {os.getsid(pid) for pid in pids() if b"long-study.toml" in words_of(pid)}
        assert len(of_session(session)) >= 1
    for _ in range(50):
        if not of_session(session):
            break
        time.sleep(0.1)
    assert of_session(session) == []
    assert [*tmp_path.glob("*.parts/part-*.json")]


def pids():
    """The processes of this machine."""
    return [int(process.name) for process in Path("/proc").iterdir() if process.name.isdigit()]


def words_of(pid):
    """The words with which a process was called; none of one that has ended."""
    with suppress(OSError):
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    return b""


def of_session(session):
    """The processes of a session that have not ended: a study and its workers."""
    found = []
    for pid in pids():
        with suppress(OSError):
            if os.getsid(pid) == session and words_of(pid):
                found.append(pid)
    return found
