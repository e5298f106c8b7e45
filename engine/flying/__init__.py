"""Flying machining: in each cycle the tool is repositioned (0 to t_R), then works at line speed (t_R to t_C): S5."""
