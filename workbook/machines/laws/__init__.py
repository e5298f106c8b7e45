"""Motion laws compared: coefficients side by side, curves in common charts, the demands of each."""
