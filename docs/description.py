"""Write what a description may say into description.md, from the models that check it.

.venv/bin/python -m docs.description            writes it
.venv/bin/python -m docs.description --check    fails where it is not what today's models say
"""

from __future__ import annotations

import sys
from pathlib import Path

from workbook.description.schema import page

PAGE = Path(__file__).with_suffix(".md")


def main() -> None:
    """Write the page, or compare it with the one that is kept."""
    fresh = page()
    if "--check" not in sys.argv:
        PAGE.write_text(fresh, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != fresh:
        sys.exit(f"{PAGE.name} is not up to date: run python -m docs.description")


if __name__ == "__main__":
    main()
