"""Drives that are worked out place by place: of a ratio that depends on the load's position, or viscous friction.

driven      the engine's view of such a drive
worked      the same over the stretches and sections of its motion
changing    what a ratio that changes adds to that
kinds       each mechanism in cells: its entries, its size, angle and ratio at a position
places      the drive at a place of the motion, in cells
cut         stretches, where power turns round in them, sections
found       extremes and integrals of sections
sheet       what its sheet has in place of a drive of constant ratios
"""
