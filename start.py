"""Set motionbook up and run it, with nothing but Python, 3.11 to 3.15; no arguments: the pages in the browser."""

import hashlib
import importlib.util
import os
import re
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

PYTHONS = tuple((3, minor) for minor in range(11, 16))  # for which the locked packages have wheels
if sysconfig.get_platform() == "win-arm64":
    PYTHONS = PYTHONS[1:]
ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
MACHINES = ROOT / "machines"  # which the pages show where nothing is asked for
STAMP, LOG = VENV / "set-up.txt", VENV / "set-up.log"
LOCKS = {"run": ROOT / "requirements.lock", "dev": ROOT / "requirements-dev.lock"}  # dev includes run
CHECKS = (
    "ruff format --check .",
    "ruff check .",
    "mypy",
    "lint-imports",
    "motionbook templates --check",
    "python .ci/commits.py",
)
OVER_CORES = ("-n", "auto", "--dist", "worksteal")  # neighbours stay together: they share their books
OFFLINE = re.compile("(NewConnection|NameResolution|ConnectTimeout|ReadTimeout|Proxy)Error")
USAGE = """{0} start.py                           design in the browser, machines of the folder machines beside start.py
{0} start.py build [MACHINE.toml] [-o BOOK.xlsx]   write the workbook into the current folder
{0} start.py COMMAND ...               any other motionbook command; COMMAND --help explains it
{0} start.py test --quick              tests in a minute: engine, printed figures, one book built and verified
{0} start.py test [PYTEST ARGUMENTS]   the tests of every day, as CI runs them
{0} start.py test --all [...]          and the long random and mutation runs, for a night
{0} start.py test --share [...]        every 16th test of the night, another part by each commit's hash
{0} start.py check                     format, lint, types, import rule, templates, subjects of commits
The first run sets motionbook up in the folder .venv beside start.py."""


def words(version: "tuple[int, int]") -> str:
    """Return a version as people write it."""
    return "{}.{}".format(*version)


def find_python(version: "tuple[int, int]") -> "str | None":
    """Return the path of a Python of a version that can set motionbook up: from the path, Windows' launcher, pyenv."""
    pyenv = Path(os.environ.get("PYENV_ROOT") or os.path.expanduser("~/.pyenv"), "versions")
    starts = [["python" + words(version)], ["py", "-" + words(version)]]
    starts += [[str(path)] for path in sorted(pyenv.glob(words(version) + ".*/bin/python"))]
    probe = "import ensurepip, sys, venv; print('{}.{}'.format(*sys.version_info), sys.executable)"
    for start in starts:
        try:
            said = subprocess.check_output([*start, "-c", probe], stderr=subprocess.DEVNULL, timeout=60)
        except (OSError, subprocess.SubprocessError):
            continue
        found, _, path = os.fsdecode(said).strip().partition(" ")
        if found == words(version):
            return path
    return None


def other_python(this: "tuple[int, int]") -> str:
    """Return the path of the newest Python that fits, and say that it is taken; RuntimeError if there is none."""
    fitting = f"{words(PYTHONS[0])} to {words(PYTHONS[-1])}"
    found = next(filter(None, map(find_python, reversed(PYTHONS))), None)
    if found is None:
        here = f"this is {words(this)} ({sys.executable}), and no other is found"
        raise RuntimeError(f"it runs on Python {fitting}; {here}; see www.python.org/downloads")
    print(f"This Python is {words(this)}, {fitting} will do: taking {found}", file=sys.stderr, flush=True)
    return found


def require(modules: "tuple[str, ...]" = ("venv", "ensurepip")) -> None:
    """Raise RuntimeError if this Python cannot set motionbook up, as one of the modules is missing."""
    for name in modules:
        if importlib.util.find_spec(name) is None:
            raise RuntimeError(f"this Python has no {name} (Debian, Ubuntu: sudo apt install python3-venv)")


def diagnosis(output: str) -> str:
    """Tell in one line why pip failed."""
    if OFFLINE.search(output):
        return f"no connection to the Python package index; connect, then run this again (details: {LOG})"
    errors = [line[6:].strip() for line in output.splitlines() if line.startswith("ERROR:")]
    return f"{errors[0] if errors else 'pip ended early'} (details: {LOG})"


def program(name: str) -> str:
    """Path of one of the environment's programs."""
    return str(VENV / "Scripts" / (name + ".exe") if os.name == "nt" else VENV / "bin" / name)


def pip_install(*arguments: str) -> None:
    """Install with the environment's own pip, silently; RuntimeError says why if it fails."""
    options = ["--no-input", "--disable-pip-version-check", "--retries=2", "install", "--no-user", *arguments]
    command = [program("python"), "-I", "-m", "pip", *options]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace")
    if done.returncode:
        LOG.write_text(done.stdout, encoding="utf-8")
        raise RuntimeError(diagnosis(done.stdout))


def set_up(kind: str) -> None:
    """Make .venv anew unless it was finished with this Python, in this place, from this metadata and lock."""
    files = [ROOT / "pyproject.toml", *LOCKS.values()]
    origin = "\0".join([sys.version, str(ROOT)] + [path.read_text(encoding="utf-8") for path in files])
    wanted = hashlib.sha256(origin.encode()).hexdigest()
    usable = STAMP.exists() and os.path.exists(program("python"))
    if usable and STAMP.read_text(encoding="utf-8") in (f"{wanted} {kind}", f"{wanted} dev"):
        return
    import venv  # not above: where it is missing, require() has to speak first

    print("Setting up (once, about a minute) …", file=sys.stderr, flush=True)
    venv.EnvBuilder(clear=True, with_pip=True, symlinks=os.name != "nt").create(VENV)
    pip_install("--only-binary=:all:", "--require-hashes", "-r", str(LOCKS[kind]))
    pip_install("--no-deps", "--no-build-isolation", "-e", str(ROOT))
    STAMP.write_text(f"{wanted} {kind}", encoding="utf-8")


def commit() -> str:
    """Return the hash of the commit that is checked out, or one of today's date where there is none."""
    done = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return done.stdout.decode().strip() or hashlib.sha1(time.strftime("%Y%m%d").encode()).hexdigest()


def chosen(arguments: "list[str]") -> "list[str]":
    """Return pytest's arguments: --quick, --all and --share as it knows them; a share draws the same for everybody."""
    night = ["-m", "", time.strftime("--hypothesis-seed=%Y%m%d")]
    tiers = {"--quick": ["-m", "quick and not nightly"], "--all": night}
    if arguments[:1] == ["--share"]:
        tiers["--share"] = ["-m", "nightly", f"--share={commit()}", "--hypothesis-seed=1"]
    return tiers.get(arguments[0], arguments[:1]) + arguments[1:] if arguments else []


def main(arguments: "list[str]") -> int:
    """Carry the arguments out; exit code 2 if the set-up fails, motionbook's code for what cannot be read."""
    command = arguments[0] if arguments else "serve"
    if command in ("-h", "--help"):
        print(USAGE.format("py" if os.name == "nt" else "python3"))
        return 0
    try:
        if sys.version_info[:2] not in PYTHONS:
            return subprocess.call([other_python(sys.version_info[:2]), __file__, *arguments])
        require()
        set_up("dev" if command in ("test", "check") else "run")
        if command == "test":
            return subprocess.call([program("pytest"), *OVER_CORES, *chosen(arguments[1:])], cwd=ROOT)
        if command == "check":
            failed = [job for job in CHECKS if subprocess.call([program(job.split()[0]), *job.split()[1:]], cwd=ROOT)]
            print("Failed: " + ", ".join(failed) if failed else "Every check passed.")
            return int(bool(failed))
        if not arguments:
            MACHINES.mkdir(exist_ok=True)
        return subprocess.call([program("motionbook"), *(arguments or ["serve", str(MACHINES)])])
    except (OSError, RuntimeError, subprocess.SubprocessError) as error:
        print(f"Set-up failed: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
