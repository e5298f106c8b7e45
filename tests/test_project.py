"""What the project promises about itself: its files, its locks, the README's commands."""

import re
import runpy
import subprocess
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
LOCKS = {"requirements.lock": ["build"], "requirements-dev.lock": ["build", "dev"]}
PACKAGE_INDEX = re.compile(
    r"\b(?:pypi|pythonhosted|npmjs|crates|debian)\.(?:org|io)\b|--(?:extra-)?index[-]url|--find[-]links"
)
OWN_PATH = re.compile(r"(?<![\w.~/-])/(?:home|root|Users|work)/")
PIN = re.compile(r"(?P<name>[a-z0-9-]+)==\S+(?: ; .+)? \\")


def pins(lock: str) -> list[Requirement]:
    lines = (ROOT / lock).read_text(encoding="utf-8").splitlines()
    return [Requirement(line.removesuffix(" \\")) for line in lines if PIN.fullmatch(line)]


def declared(lock: str) -> list[Requirement]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    texts = list(project["project"]["dependencies"])
    for group in LOCKS[lock]:
        texts += project["dependency-groups"][group]
    return [Requirement(text) for text in texts]


def tracked_texts() -> Iterator[tuple[str, str]]:
    listing = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, encoding="utf-8")
    if listing.returncode:
        pytest.skip("not a git checkout: nothing says which files are the project's")
    for name in filter(None, listing.stdout.split("\0")):
        try:
            yield name, (ROOT / name).read_text(encoding="utf-8")
        except (UnicodeDecodeError, FileNotFoundError):
            continue  # a workbook or a picture; or deleted and not yet committed


@pytest.mark.parametrize("pattern", [PACKAGE_INDEX, OWN_PATH], ids=["package index", "path of one's own machine"])
def test_no_tracked_text_names_a(pattern: re.Pattern[str]) -> None:
    found = [f"{name}: {match[0]}" for name, text in tracked_texts() for match in pattern.finditer(text)]
    assert found == []


@pytest.mark.parametrize(
    "command",
    [f"{python} start.py {rest}" for python in ("python3", "py") for rest in ("build", "test", "test --quick")],
)
def test_the_readme_gives_each_set_up_command(command: str) -> None:
    assert command in (ROOT / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("lock", LOCKS)
def test_a_lock_pins_exactly_what_pyproject_asks_for(lock: str) -> None:
    text = (ROOT / lock).read_text(encoding="utf-8")
    blocks = re.findall(r"^([a-z0-9-]+)==[^\n]*\n((?:[ ]+[^\n]*\n)+)", text, re.MULTILINE)
    asked_for = {name for name, block in blocks if "motionbook (pyproject.toml" in block}
    assert asked_for == {canonicalize_name(wanted.name) for wanted in declared(lock)}
    for wanted in declared(lock):
        for python in (f"3.{minor}" for minor in range(11, 16)):
            here = {"python_version": python, "python_full_version": f"{python}.0"}
            if wanted.marker is None or wanted.marker.evaluate(here):
                found = [pin for pin in pins(lock) if canonicalize_name(pin.name) == canonicalize_name(wanted.name)]
                (pin,) = (pin for pin in found if pin.marker is None or pin.marker.evaluate(here))
                (version,) = (item.version for item in pin.specifier)
                assert version in wanted.specifier, f"{pin} in {lock}, {wanted} in pyproject.toml"


@pytest.mark.parametrize("lock", LOCKS)
def test_a_lock_holds_pins_with_hashes_and_nothing_else(lock: str) -> None:
    lines = (ROOT / lock).read_text(encoding="utf-8").splitlines()
    content = [line for line in lines if not line.lstrip().startswith("#")]
    hashes = re.compile(r"    --hash=sha256:[0-9a-f]{64}(?: \\)?")
    assert [line for line in content if not PIN.fullmatch(line) and not hashes.fullmatch(line)] == []
    unhashed = [
        a for a, b in zip(content, [*content[1:], ""], strict=True) if PIN.fullmatch(a) and not hashes.fullmatch(b)
    ]
    assert unhashed == []


def test_the_tests_run_on_the_very_versions_that_users_get() -> None:
    run, dev = ({str(pin) for pin in pins(lock)} for lock in LOCKS)
    assert run - dev == set()


@pytest.mark.parametrize("folder", ["benchmarks", "docs"])
def test_what_is_run_by_hand_finds_all_that_it_imports(folder: str) -> None:
    pytest.importorskip("ironcalc", reason="it has no wheel for every Python, and docs/functions.py asks it")
    for path in (ROOT / folder).glob("*.py"):
        runpy.run_path(str(path), run_name="imported")


RECIPES = [f"docs/recipes/{path.name}" for path in sorted((ROOT / "docs/recipes").glob("*.md"))]
GUIDES = ["README.md", "CONTRIBUTING.md", *(f"docs/{path.name}" for path in sorted((ROOT / "docs").glob("*.md")))]


@pytest.mark.parametrize("guide", ["README.md", "CONTRIBUTING.md", *RECIPES])
def test_the_files_that_a_guide_names_are_there(guide: str) -> None:
    named = set(re.findall(r"`((?:engine|workbook|tests|benchmarks|docs)/[\w/.]+)`", (ROOT / guide).read_text("utf-8")))
    made_up = {name for name in named if re.search("NAME|press", name)}
    assert [name for name in sorted(named - made_up) if not (ROOT / name).exists()] == []


@pytest.mark.parametrize("guide", [*GUIDES, *RECIPES])
def test_the_links_of_a_guide_lead_to_files(guide: str) -> None:
    page = ROOT / guide
    links = re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    missing = [link for link in links if not link.startswith("http") and not (page.parent / link).exists()]
    assert missing == []


def test_the_index_of_the_docs_names_every_page() -> None:
    index = (ROOT / "docs/README.md").read_text(encoding="utf-8")
    pages = {path.name for path in (ROOT / "docs").glob("*.md")} - {"README.md"}
    pages |= {one.removeprefix("docs/") for one in RECIPES}
    assert {page for page in pages if f"]({page})" not in index} == set()


def test_the_readme_is_short() -> None:
    assert len((ROOT / "README.md").read_text(encoding="utf-8").split()) <= 1200


@pytest.mark.parametrize(
    ("subject", "is_fine"),
    [("Mend the night", True), ("Bring a press", True), ("Pass over empty rows", True), ("Mended the night", False),
     ("Adds a press", False), ("A press", False), ("tests: mend", False), ("Mend it.", False), ("Mend " * 15, False)],
)  # fmt: skip
def test_a_subject_of_a_commit_is_a_short_imperative(subject: str, is_fine: bool) -> None:
    fault_of = runpy.run_path(str(ROOT / ".ci/commits.py"))["fault_of"]
    assert (fault_of(subject.strip()) == "") is is_fine
