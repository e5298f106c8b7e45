"""motionbook: workbooks of machine motion, generated, verified cell by cell, read back."""

import os

# openpyxl writes other bytes where lxml happens to be installed; it reads this once, when first imported
os.environ.setdefault("OPENPYXL_LXML", "False")

__version__ = "0.1.0"
