"""Settings for all tests."""

from hypothesis import settings

import workbook  # noqa: F401 - before openpyxl, whose choice of an XML writer it makes

# A test's verdict must not hang on the speed of the machine; all else stays as hypothesis chose it.
settings.register_profile("untimed", settings.default, deadline=None)
settings.load_profile("untimed")
