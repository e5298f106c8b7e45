"""Choice of motor and reducer by S5: catalogues, the load's task, the ratios that a motor accepts. SI units.

τ = ω_L/ω_M throughout. Whole catalogues against one load are :mod:`engine.selection.pair_matrix`.
"""
