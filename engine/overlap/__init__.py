"""Overlap of two motions: how much longer the second may take when it begins before the first has ended.

A transfer (S2: the indexing mill) brings the part; a tool (S2: the die) enters when the part is there, dwells,
and is out before the next transfer. Angles are of the master shaft, in rad; the transfer begins at 0. Tools at several
stations are as many schedules over the same transfer: each meets the transfer, none another tool.
"""
