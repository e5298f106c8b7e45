"""Flying machining: a cycle re-positions first (0 to t_R), then works at line speed (t_R to t_C), as in S5."""
