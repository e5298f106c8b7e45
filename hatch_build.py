"""Put the descriptions of templates/ into the package workbook of a wheel, and what comes with them."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

PLACE = "workbook/shipped"
SHIPPED = ("*.toml", "*.csv", "motion-functions.*")  # a command builds the other workbooks


class Descriptions(BuildHookInterface[Any]):
    """Adds them to a wheel; an editable installation finds them where they are."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Name the place of each file in the wheel."""
        if version != "editable":
            files = (path for pattern in SHIPPED for path in sorted(Path(self.root, "templates").glob(pattern)))
            build_data["force_include"] |= {str(path): f"{PLACE}/{path.name}" for path in files}
