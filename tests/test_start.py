"""start.py: what it refuses, what it makes anew, what it leaves alone."""

import ast
import importlib.util
import re
import sys
import venv
from pathlib import Path
from types import ModuleType
from typing import Any

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


@pytest.mark.parametrize("version", [(3, 6), (3, 10)])
def test_an_old_python_is_told_its_version_and_the_needed_one(start: ModuleType, version: tuple[int, int]) -> None:
    with pytest.raises(RuntimeError, match=rf"needs Python 3\.11 or newer, this is {version[0]}\.{version[1]} \("):
        start.require(version)


def test_a_python_without_ensurepip_is_told_what_to_install(start: ModuleType) -> None:
    with pytest.raises(RuntimeError, match=r"has no no_such_module \(.*python3-venv\)"):
        start.require((3, 11), ("venv", "no_such_module"))


def test_this_python_will_do(start: ModuleType) -> None:
    start.require(sys.version_info[:2])


def test_an_old_python_gets_one_line_and_exit_code_2(
    start: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "version_info", (3, 10, 4, "final", 0))
    assert start.main(["build"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n"), start.installed) == ("", 1, [])


@pytest.mark.parametrize("arguments", [[], ["--help"]])
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
    assert start.chosen(["--share", "-x"]) == ["-m", "nightly", "--share=0000001fcafe", "--hypothesis-seed=31", "-x"]
    monkeypatch.undo()
    assert re.fullmatch("[0-9a-f]{40}", start.commit())  # without a repository too


def test_a_missing_environment_is_made_and_a_finished_one_left_alone(start: ModuleType) -> None:
    assert sets_up(start, "run")
    assert not sets_up(start, "run")


def test_the_tests_environment_serves_the_commands_but_not_the_other_way_round(start: ModuleType) -> None:
    assert sets_up(start, "run")
    assert sets_up(start, "dev")
    assert not sets_up(start, "run")


@pytest.mark.parametrize("name", ["pyproject.toml", "requirements.lock", "requirements-dev.lock"])
def test_an_environment_of_another_lock_or_metadata_is_made_anew(start: ModuleType, name: str) -> None:
    sets_up(start, "dev")
    (start.ROOT / name).write_text("changed", encoding="utf-8")
    assert sets_up(start, "dev")


def test_an_environment_of_another_python_is_made_anew(start: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    sets_up(start, "run")
    monkeypatch.setattr(sys, "version", "3.99.0 (made up)")
    assert sets_up(start, "run")


def test_an_environment_whose_python_is_gone_is_made_anew(start: ModuleType) -> None:
    sets_up(start, "run")
    Path(start.program("python")).unlink()
    assert sets_up(start, "run")


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
