"""A component of the add-in, as LibreOffice registers it."""

from __future__ import annotations

import unohelper
from com.sun.star.lang import XServiceInfo


class Service(unohelper.Base, XServiceInfo):
    """A component with its name and the names of its services."""

    NAME: str
    SERVICES: tuple[str, ...]

    def getImplementationName(self) -> str:
        """Return the name that LibreOffice registers."""
        return self.NAME

    def supportsService(self, name: str) -> bool:
        """Whether the component is such a service."""
        return name in self.SERVICES

    def getSupportedServiceNames(self) -> tuple[str, ...]:
        """Return the names of the services."""
        return self.SERVICES
