"""Overlap of two motions, which lets the second take longer by beginning before the first has ended.

A transfer (S2: the indexing mill) brings the part; a tool (S2: the die) enters when the part is there, dwells,
and is out before the next transfer. Angles are of the master shaft, in rad; the transfer begins at 0. Tools at several
stations make a schedule each over the same transfer: each may collide with the transfer, none with another tool.
"""
