"""What the noise of a small satellite's receiver should be (tests/foreign/books.py says which workbook)."""

from math import prod

from workbook.oracle import Oracle

book = Oracle("Noise of a receiver")
AS_ENTERED = (None, None)
VARIED = {  # stages counted from the last: the ranges (dB) of gain and noise figure; 0 dB where a stage is left out
    -12: ((-3, 0), AS_ENTERED),  # feed
    -7: ((10, 25), (0.2, 3)),  # amplifier
    -5: ((-6, 0), AS_ENTERED),  # attenuator
    -4: (AS_ENTERED, (4, 9)),  # mixer
    -1: (AS_ENTERED, (5, 10)),  # transceiver, whose gain is left blank
}


def ratio(decibels):
    """Return the ratio of two powers."""
    return 10 ** (decibels / 10)


def noise_factor(gains, factors):
    """Return the factor of a chain by Friis: F_1 + (F_2 − 1)/G_1 + (F_3 − 1)/(G_1 G_2) + …"""
    return 1 + sum((factor - 1) / prod(gains[:k]) for k, factor in enumerate(factors))


QUANTITIES = {  # of a stage: of T_0 (K), the gains before it, and the noise factors up to its own
    "F": lambda reference, gains, factors: factors[-1],
    "gain before": lambda reference, gains, factors: prod(gains),
    "T": lambda reference, gains, factors: reference * (factors[-1] - 1),
    "T/gain": lambda reference, gains, factors: reference * (factors[-1] - 1) / prod(gains),
    "(F - 1)/gain": lambda reference, gains, factors: (factors[-1] - 1) / prod(gains),
    "F of all": lambda reference, gains, factors: noise_factor(gains, factors),
    "T of all": lambda reference, gains, factors: reference * (noise_factor(gains, factors) - 1),
}


def of_decibels(quantity, before):
    """Return what gives a quantity of T_0 (K), of so many gains before, and of noise figures."""
    of = QUANTITIES[quantity]
    return lambda reference, *given: of(reference, [*map(ratio, given[:before])], [*map(ratio, given[before:])])


def passed(antenna, warm, *losses):
    """Return the temperature (K) of an antenna behind what is warm and weakens it."""
    return warm + (antenna - warm) * ratio(sum(losses))


def behind(front, own):
    """Return what gives the temperature (K) of an antenna with a receiver, of so many arguments for the antenna."""
    return lambda *given: passed(*given[:front]) + own(*given[front:])


FRIIS = {"H": "F", "I": "gain before", "J": "T", "K": "T/gain", "L": "(F - 1)/gain", "M": "F of all"}
OTHER = {"H": "F", "I": "T", "J": "gain before", "K": "T/gain"}
CHAINS = {  # sheet: the first row and number of stages, the columns, the cells of the total and of antenna and all
    "General": (10, 12, FRIIS, "K24", "K26"),
    "SME": (16, 10, OTHER, "K28", "K30"),
    "King": (16, 10, OTHER, "K28", "K30"),
    "Subtotal": (5, 9, FRIIS, "K16", None),
}
reference = {sheet: book.input(f"{sheet}!C4", "K", 270, 310) for sheet in ("General", "SME", "King")}
warm = reference | {"SME": book.input("SME!D4", "K", 280, 320)}

for sheet, (first, size, columns, sum_of_all, with_antenna) in CHAINS.items():
    rows, ranges = range(first, first + size), [VARIED.get(k, (AS_ENTERED,) * 2) for k in range(-size, 0)]
    gains = [book.input(f"{sheet}!D{row}", "dB", *one[0]) for row, one in zip(rows[:-1], ranges[:-1], strict=True)]
    figures = [book.input(f"{sheet}!E{row}", "dB", *one[1]) for row, one in zip(rows, ranges, strict=True)]
    known = reference.get(sheet, reference["General"])
    for k, row in enumerate(rows):
        book.output(f"{sheet}!G{row}", inputs=gains[k : k + 1])(lambda *gain: ratio(*gain) if gain else "")
        for column, quantity in columns.items():
            if (column, row) != ("J", 16) or sheet == "General":  # there the first gain is a number
                given, unit = [known, *gains[:k], *figures[: k + 1]], "K" if quantity[0] == "T" else ""
                book.output(f"{sheet}!{column}{row}", unit, inputs=given)(of_decibels(quantity, k))
    book.output(f"{sheet}!{sum_of_all}", "K", inputs=[known, *gains, *figures])(of_decibels("T of all", size - 1))
    if with_antenna is None:
        for column in "GHIJKLM":
            book.output(f"{sheet}!{column}14", inputs=[])(lambda: "")  # the last row is left blank
        continue
    source, losses = [book.input(f"{sheet}!D7", "K", 50, 300), warm[sheet]], []
    if sheet != "General":
        losses = [book.input(f"{sheet}!D10", "dB", -3, 0), book.input(f"{sheet}!D11", "dB")]
        for cell, given in (("E10", losses[:1]), ("E11", losses[1:]), ("E12", losses)):
            book.output(f"{sheet}!{cell}", inputs=given)(lambda *losses: ratio(sum(losses)))
        book.output(f"{sheet}!E13", "K", inputs=[*source, *losses])(passed)
    receiver = behind(2 + len(losses), of_decibels("T of all", size - 1))
    book.output(f"{sheet}!{with_antenna}", "K", inputs=[*source, *losses, known, *gains, *figures])(receiver)
