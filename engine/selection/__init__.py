"""Selection of motor and reducer by S5, τ = ω_L/ω_M: catalogues, the load's task, ratios, pairs. SI units."""
