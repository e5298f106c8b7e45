"""Saves of a watched book, as programs write them: each has its verdict, and none is told of a file half written."""

import asyncio
import hashlib
import io
import os
import random

import pytest
from openpyxl import load_workbook

from tests.workbook import press
from tests.workbook.judging.test_warm import cell_named
from workbook.build import build
from workbook.judging.warm import WarmBook
from workbook.watch import saves
from workbook.watch.saves import Saves


class Here:
    """Work that is done in this process, which knows the press."""

    async def in_worker(self, function, *arguments):
        await asyncio.sleep(0)
        return function(*arguments)


@pytest.fixture
def book(tmp_path, monkeypatch):
    path = tmp_path / "press.xlsx"
    monkeypatch.setattr(saves, "PAUSE", 0.01)
    with press.registered() as machine:
        build(machine, path)
        yield path


async def in_pieces(path, data, draw):
    """Write a file over the old one in pieces, as openpyxl does."""
    with path.open("wb") as file:
        for begin in range(0, len(data), 20_000):
            file.write(data[begin : begin + 20_000])
            file.flush()
            yield
            await asyncio.sleep(draw.random() * 0.02)


async def beside(path, data, draw):
    """Write another file and rename it, as Excel and LibreOffice do; the lock file comes and goes."""
    lock, other = path.with_name(f"~${path.name}"), path.with_name("A1B2C3.tmp")
    lock.write_bytes(b"user")
    other.write_bytes(data)
    yield
    os.replace(other, path)
    await asyncio.sleep(draw.random() * 0.02)
    lock.unlink()
    yield


@pytest.mark.parametrize("count", [10, pytest.param(200, marks=pytest.mark.nightly)])
def test_each_save_at_a_random_moment_has_its_verdict(book, count):
    draw, told = random.Random(3), []

    async def save_often():
        watched = Saves(Here(), lambda path, verdict: told.append(verdict))
        judging = asyncio.create_task(watched.judge_each())
        workbook = load_workbook(book)
        for number in range(count):
            friction, is_wrong = round(draw.uniform(0.1, 4.0), 3), draw.random() < 0.3
            cell_named(workbook, "drive1_friction").value = friction
            cell_named(workbook, "timing_period").value = "=61/timing_rate" if is_wrong else "=60/timing_rate"
            saved = io.BytesIO()
            workbook.save(saved)
            digest = hashlib.sha256(saved.getvalue()).hexdigest()
            async for _ in draw.choice((in_pieces, beside))(book, saved.getvalue(), draw):
                watched.note(book)
            for _ in range(draw.randrange(3)):  # as of OneDrive
                watched.note(book)
            while not (told and told[-1].whole and told[-1].outcome.sha256 == digest):
                await asyncio.sleep(0.005)
            assert told[-1].outcome.verdict == ("disagrees" if is_wrong else "agrees"), number
            if number and not is_wrong:
                labels = {change.label: change.new for change in told[-1].changes.entries}
                assert labels in ({}, {"Friction": friction})
        judging.cancel()

    asyncio.run(asyncio.wait_for(save_often(), 24 * count))
    assert all(verdict.outcome.report for verdict in told)
    assert len({verdict.outcome.sha256 for verdict in told if verdict.whole}) == count
    assert sum(verdict.whole for verdict in told) == count


def test_what_a_save_changed_is_told_entries_and_results(book):
    told = []

    async def save_once_more():
        watched = Saves(Here(), lambda path, verdict: told.append(verdict))
        judging = asyncio.create_task(watched.judge_each())
        for rate in (30.0, 60.0):
            workbook = load_workbook(book)
            cell_named(workbook, "timing_rate").value = rate
            workbook.save(book)
            before = len(told)
            watched.note(book)
            while not (len(told) > before and told[-1].whole):
                await asyncio.sleep(0.005)
        judging.cancel()

    asyncio.run(asyncio.wait_for(save_once_more(), 60))
    changes = told[-1].changes
    assert [(change.label, change.old, change.new) for change in changes.entries] == [
        ("Speed of the master", 30.0, 60.0)
    ]
    assert ("Cycle time", 2.0, 1.0) in [(change.label, change.old, change.new) for change in changes.results]


def test_a_fault_of_our_own_is_told_and_does_not_end_the_watch(book, monkeypatch):
    told = []

    def fails(self, path):
        raise KeyError("a fault of our own")

    async def save():
        watched = Saves(Here(), lambda path, verdict: told.append(verdict))
        judging = asyncio.create_task(watched.judge_each())
        with monkeypatch.context() as broken:
            broken.setattr(WarmBook, "judge_values", fails)
            watched.note(book)
            while not told:
                await asyncio.sleep(0.005)
        book.write_bytes(edited_bytes(book))
        watched.note(book)
        while not (told[-1].whole and told[-1].outcome.verdict == "agrees"):
            await asyncio.sleep(0.005)
        judging.cancel()

    asyncio.run(asyncio.wait_for(save(), 60))
    assert "failed inside motionbook (KeyError: 'a fault of our own')" in told[0].outcome.reason


def edited_bytes(book):
    workbook, saved = load_workbook(book), io.BytesIO()
    cell_named(workbook, "timing_rate").value = 31.0
    workbook.save(saved)
    return saved.getvalue()


def test_a_book_that_is_gone_or_no_workbook_does_not_take_the_verdict_away(book):
    told = []

    async def spoil():
        watched = Saves(Here(), lambda path, verdict: told.append(verdict))
        judging = asyncio.create_task(watched.judge_each())
        watched.note(book)
        while not (told and told[-1].whole):
            await asyncio.sleep(0.005)
        book.unlink()
        watched.note(book)
        await asyncio.sleep(0.5)
        assert watched.verdicts[book] is told[-1]
        book.write_bytes(b"PK, but not to its end")
        watched.note(book)
        while told[-1].outcome.verdict != "unreadable":
            await asyncio.sleep(0.005)
        judging.cancel()

    asyncio.run(asyncio.wait_for(spoil(), 60))
    assert [verdict.outcome.verdict for verdict in told[-1:]] == ["unreadable"]
