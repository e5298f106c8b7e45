"""The targets in order, and the claims about each one's format with their documents."""

import tomllib
from pathlib import Path

CLAIMS = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
TARGETS = tuple(name for name in CLAIMS if not name.endswith(" switches"))
