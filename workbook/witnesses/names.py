"""The names of the witnesses, for those who need not load them."""

NAMES = ("pycel", "formualizer", "formulon", "ironcalc", "libreoffice", "saved")
ALL = "all"
"""all of them that are on this machine"""
