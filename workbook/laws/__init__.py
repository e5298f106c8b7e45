"""The families of motion laws in a workbook: their entries, their pieces as formulas, how they are sampled."""
