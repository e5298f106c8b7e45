"""start.py: what it refuses, what it makes anew, what it leaves alone."""

import ast
import importlib.util
import os
import re
import sys
import tomllib
import venv
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest.mock import Mock

import pytest

SOURCE = Path(__file__).parents[1] / "start.py"


@pytest.fixture
def start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """start.py in a folder of its own, with an installer that only notes what it is asked for."""
    copy = tmp_path / "start.py"
    copy.write_bytes(SOURCE.read_bytes())
    for name in ("pyproject.toml", "requirements.lock", "requirements-dev.lock"):
        (tmp_path / name).write_text(name, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("start", copy)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(venv, "EnvBuilder", fake_builder(module))
    monkeypatch.setattr(module, "installed", [], raising=False)
    monkeypatch.setattr(module, "pip_install", lambda *arguments: module.installed.append(arguments))
    return module


def fake_builder(start: ModuleType) -> type:
    class Builder:
        def __init__(self, **options: Any) -> None:
            assert options["clear"], "an unfinished environment must not be built upon"

        def create(self, folder: Path) -> None:
            python = Path(start.program("python"))
            python.parent.mkdir(parents=True, exist_ok=True)
            python.touch()
            start.STAMP.unlink(missing_ok=True)

    return Builder


def sets_up(start: ModuleType, kind: str) -> bool:
    start.installed.clear()
    start.set_up(kind)
    return bool(start.installed)


def test_start_parses_under_the_oldest_grammar_that_python_can_still_check() -> None:
    ast.parse(SOURCE.read_text(encoding="utf-8"), feature_version=(3, 7))


def stand_in(program: Path, answer: str, asked_by: str = "-c") -> Path:
    """A program that answers with its version and path if it is asked, and else notes how it is started."""
    program.parent.mkdir(parents=True, exist_ok=True)
    asked = f'[ "$1" = {asked_by} ] && echo "{answer}" && exit 0'
    program.write_text(f'#!/bin/sh\n{asked}\necho "$@" >"{program}.started"\nexit 7\n', encoding="utf-8")
    program.chmod(0o755)
    return program


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A machine without any Python: its folder ``bin`` is the path, its folder ``pyenv`` is where pyenv keeps them."""
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path / "pyenv"))
    return tmp_path


needs_a_shell = pytest.mark.skipif(os.name == "nt", reason="the stand-ins are scripts of a shell")
TOO_OLD, TOO_NEW = (3, 10, 4, "final", 0), (3, 99, 0, "alpha", 0)


@needs_a_shell
@pytest.mark.parametrize("version", [TOO_OLD, TOO_NEW])
def test_another_python_takes_over_from_one_that_does_not_fit(
    start: ModuleType, machine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    version: tuple[object, ...],
) -> None:  # fmt: skip
    fitting = stand_in(machine / "bin/python3.12", f"3.12 {machine}/bin/python3.12")
    monkeypatch.setattr(sys, "version_info", version)
    assert start.main(["build", "a b.toml"]) == 7
    started = Path(f"{fitting}.started").read_text(encoding="utf-8")
    assert started == f"{start.__file__} build a b.toml\n"
    out, err = capsys.readouterr()
    assert (out, err) == ("", f"This Python is 3.{version[1]}, 3.11 to 3.15 will do: taking {fitting}\n")
    assert start.installed == []


@needs_a_shell
def test_pythons_are_found_on_the_path_by_the_launcher_and_in_pyenv(start: ModuleType, machine: Path) -> None:
    stand_in(machine / "bin/python3.11", "3.11 /of the path")
    stand_in(machine / "bin/py", "3.12 /launched", asked_by="-3.12")
    stand_in(machine / "bin/python3.13", "", asked_by="nothing")  # fails, as pyenv's own stand-ins do
    stand_in(machine / "pyenv/versions/3.13.0/bin/python", "3.13 /of pyenv")
    stand_in(machine / "bin/python3.14", "3.9 /another than its name says")
    found = [start.find_python(version) for version in start.PYTHONS]
    assert found == ["/of the path", "/launched", "/of pyenv", None, None]


@pytest.mark.parametrize("version", [TOO_OLD, TOO_NEW])
def test_a_python_that_does_not_fit_and_is_alone_is_told_which_would_in_one_line(
    start: ModuleType, machine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    version: tuple[object, ...],
) -> None:  # fmt: skip
    monkeypatch.setattr(sys, "version_info", version)
    assert start.main(["build"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n"), start.installed) == ("", 1, [])
    assert re.search(rf"it runs on Python 3\.11 to 3\.15; this is 3\.{version[1]} \(.*, and no other is found", err)


def test_a_python_without_ensurepip_is_told_what_to_install(start: ModuleType) -> None:
    with pytest.raises(RuntimeError, match=r"has no no_such_module \(.*python3-venv\)"):
        start.require(("venv", "no_such_module"))


def test_this_python_will_do(start: ModuleType) -> None:
    start.require()
    assert sys.version_info[:2] in start.PYTHONS


def test_start_takes_the_pythons_that_the_project_is_for(start: ModuleType) -> None:
    project = tomllib.loads((SOURCE.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">={start.words(start.PYTHONS[0])}"


def test_without_arguments_the_pages_of_a_folder_beside_it_open(
    start: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    call = Mock(return_value=0)
    monkeypatch.setattr(start.subprocess, "call", call)
    assert start.main([]) == 0
    call.assert_called_once_with([start.program("motionbook"), "serve", str(start.ROOT / "machines")])
    assert (start.ROOT / "machines").is_dir()


@pytest.mark.parametrize("arguments", [["-h"], ["--help"]])
def test_usage_needs_no_set_up(start: ModuleType, arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert start.main(arguments) == 0
    assert {"build", "test", "check", "--quick", "--all", "--share"} <= set(capsys.readouterr().out.split())
    assert start.installed == []


@pytest.mark.parametrize(
    ("given", "passed"),
    [
        ([], []),
        (["-k", "name", "tests/engine"], ["-k", "name", "tests/engine"]),
        (["--quick"], ["-m", "quick and not nightly"]),
        (["--quick", "-x"], ["-m", "quick and not nightly", "-x"]),
    ],
)
def test_the_tiers_are_marks_of_pytest(start: ModuleType, given: list[str], passed: list[str]) -> None:
    assert start.chosen(given) == passed


def test_a_night_runs_all_with_a_seed_that_can_be_given_again(start: ModuleType) -> None:
    *every, seed, again = start.chosen(["--all", "--hypothesis-seed=7"])
    assert every == ["-m", ""]
    assert re.fullmatch(r"--hypothesis-seed=20\d{6}", seed)
    assert again == "--hypothesis-seed=7"  # pytest takes the last


def test_a_share_of_a_night_hangs_on_the_commit_alone(start: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(start, "commit", lambda: "0000001fcafe")
    assert start.chosen(["--share", "-x"]) == ["-m", "nightly", "--share=0000001fcafe", "--hypothesis-seed=1", "-x"]
    monkeypatch.undo()
    assert re.fullmatch("[0-9a-f]{40}", start.commit())  # without a repository too


CHANGES = {
    "nothing": lambda start, patch: None,
    "pyproject.toml": lambda start, patch: (start.ROOT / "pyproject.toml").write_text("changed", encoding="utf-8"),
    "requirements.lock": lambda start, patch: start.LOCKS["run"].write_text("changed", encoding="utf-8"),
    "requirements-dev.lock": lambda start, patch: start.LOCKS["dev"].write_text("changed", encoding="utf-8"),
    "another Python": lambda start, patch: patch.setattr(sys, "version", "3.99.0 (made up)"),
    "no Python any more": lambda start, patch: Path(start.program("python")).unlink(),
}


@pytest.mark.parametrize("change", CHANGES)
def test_an_environment_is_made_and_made_anew_where_what_it_was_made_of_is_another(
    start: ModuleType, monkeypatch: pytest.MonkeyPatch, change: str
) -> None:
    assert sets_up(start, "dev")
    CHANGES[change](start, monkeypatch)
    assert sets_up(start, "dev") == (change != "nothing")


def test_the_tests_environment_serves_the_commands_but_not_the_other_way_round(start: ModuleType) -> None:
    assert sets_up(start, "run")
    assert sets_up(start, "dev")
    assert not sets_up(start, "run")


def test_an_interrupted_set_up_is_repaired_by_the_next_run(start: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: str) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(start, "pip_install", interrupted)
        assert start.main(["build"]) == 130
    assert sets_up(start, "run")


def test_a_lost_connection_is_named_and_any_other_failure_quoted(start: ModuleType) -> None:
    offline = "WARNING: Retrying after NameResolutionError(...)\nERROR: No matching distribution found for rich"
    assert "no connection" in start.diagnosis(offline)
    full = "Collecting numpy\nERROR: Could not install packages due to an OSError: No space left on device\n"
    assert start.diagnosis(full).startswith("Could not install packages due to an OSError: No space left on device")
    assert start.diagnosis("").startswith("pip ended early")
