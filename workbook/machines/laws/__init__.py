"""Motion laws compared: coefficients side by side, curves over one another, what each costs."""
