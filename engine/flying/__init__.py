"""Flying machining: the tool follows the line while it works, and catches up or waits before the next product.

A cycle re-positions first (0 to t_R), then works at line speed (t_R to t_C), as the integrals of S5 run.
"""
