"""motionbook: workbooks of machine motion, generated, verified cell by cell, read back."""
