"""motionbook: workbooks of machine motion, generated, verified cell by cell, read back."""

__version__ = "0.1.0"
