"""Print where the locked packages have wheels, by platform and Python; exit code 1 where another is missing than known.

uv resolves each lock as another machine would; nothing is installed, and of the index only its lists of files are read.
"""

import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from start import LOCKS, PYTHONS, words  # noqa: E402 - from the folder above

PLATFORMS = {
    "x86_64-manylinux_2_28": "Linux, x86-64",
    "aarch64-manylinux_2_28": "Linux, ARM",
    "x86_64-unknown-linux-musl": "Linux with musl, x86-64",
    "aarch64-unknown-linux-musl": "Linux with musl, ARM",
    "x86_64-apple-darwin": "macOS, x86-64",
    "aarch64-apple-darwin": "macOS, ARM",
    "x86_64-pc-windows-msvc": "Windows, x86-64",
    "aarch64-pc-windows-msvc": "Windows, ARM",
}
KNOWN = {(lock, "aarch64-pc-windows-msvc", (3, 11)): "no pyyaml" for lock in LOCKS}  # so start.py asks for 3.12 there
"""What has no wheel, by lock, platform and Python."""
OPTIONS = ["--dry-run", "--no-deps", "--only-binary=:all:", "--require-hashes", "--quiet"]


def find_wheels(lock: Path, platform: str, python: "tuple[int, int]") -> str:
    """Return ``all``, or which package has no wheel; raise RuntimeError where uv does not come to that."""
    uv = Path(sys.executable).with_name("uv")
    with tempfile.TemporaryDirectory() as empty:
        where = ["--target", empty, "--python-platform", platform, "--python-version", words(python)]
        done = subprocess.run([uv, "pip", "install", *OPTIONS, *where, "-r", lock], capture_output=True, text=True)
    missing = re.search(r"Because ([\w.-]+).* has no (?:usable )?wheels", done.stderr)
    if done.returncode and missing is None:
        raise RuntimeError((done.stderr.strip() or "uv failed").splitlines()[-1].strip())
    return f"no {missing[1]}" if missing else "all"


def main() -> int:
    """Print a table for each lock; say so, and end well, where the index cannot be reached."""
    surprises = []
    try:
        for name, lock in LOCKS.items():
            print(f"\n| {lock.name} |", *(f"{words(python)} |" for python in PYTHONS))
            print("|---|" + "---|" * len(PYTHONS))
            for platform, label in PLATFORMS.items():
                if name == "dev" and "musl" in platform:  # the tests' browser is not there, and no marker tells musl
                    continue
                with ThreadPoolExecutor() as pool:
                    found = dict(zip(PYTHONS, pool.map(partial(find_wheels, lock, platform), PYTHONS), strict=True))
                print(f"| {label} |", *(f"{wheels} |" for wheels in found.values()), flush=True)
                surprises += [f"{label}, {words(python)}: {wheels}" for python, wheels in found.items()
                              if wheels != KNOWN.get((name, platform, python), "all")]  # fmt: skip
    except RuntimeError as error:
        print(f"The wheels were not looked for: {error}")
        return 0
    print("\nOther than known: " + "; ".join(surprises) if surprises else "\nAll wheels but those known to be missing.")
    return int(bool(surprises))


if __name__ == "__main__":
    sys.exit(main())
