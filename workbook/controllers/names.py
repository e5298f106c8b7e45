"""The names of the targets, which the command's help lists without loading them."""

TARGETS = (
    "csv", "codesys", "codesys-table", "twincat", "twincat-table", "siemens", "siemens-points", "siemens-segments",
    "rockwell", "br", "kollmorgen", "sew", "lenze", "mitsubishi",
    "mitsubishi-ratio",
)  # fmt: skip
"""each a file in ``targets``, its - an underscore there"""
